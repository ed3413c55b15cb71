//! Surfaces of a type that points may lie on.

use nalgebra::{Matrix3, Matrix6, SMatrix, SVector, SymmetricEigen, Vector6};

use crate::cloud::normals::{Spread, estimate_normals};
use crate::cloud::{Direction, Point, Vector};
use crate::fit::local;
use crate::surface::{Cone, Cylinder, Surface, SurfaceType, Torus, across};

/// Neighbours that normals are estimated from: few follow the surface, many see through noise.
const NEIGHBOURS: [usize; 2] = [12, 64];

/// Starts of a type, most of them wrong.
pub(super) fn of(kind: SurfaceType, axes: &[Axis], points: &[Point]) -> Vec<Surface> {
    let mut surfaces = local::hypotheses(kind, points);
    if matches!(
        kind,
        SurfaceType::Cylinder | SurfaceType::Cone | SurfaceType::Torus
    ) {
        for axis in axes {
            about(kind, axis, points, &mut surfaces);
        }
    }
    surfaces
}

/// A line that a surface of revolution may be about.
pub(super) struct Axis {
    point: Point,
    direction: Direction,
}

/// Lines that points and normals tell: the principal axes; the direction across the normals, as of a
/// cylinder; and the axes of the rotations that slide the points over themselves best (Pottmann and
/// Randrup 1998).
pub(super) fn axes(points: &[Point]) -> Vec<Axis> {
    let Some(spread) = Spread::of(points.iter()) else {
        return Vec::new();
    };
    let through_middle = |direction| Axis {
        point: spread.centroid,
        direction,
    };
    let mut axes: Vec<Axis> = spread.directions.into_iter().map(through_middle).collect();
    for count in NEIGHBOURS {
        let count = count.min(points.len() / 4);
        if count < 4 {
            continue;
        }
        let normals = estimate_normals(points, count);
        let mut matrix = Matrix3::zeros();
        let mut lines = Matrix6::zeros();
        for (point, normal) in points.iter().zip(&normals) {
            matrix += normal.into_inner() * normal.transpose();
            let moment = point.coords.cross(normal);
            let line = Vector6::new(moment.x, moment.y, moment.z, normal.x, normal.y, normal.z);
            lines += line * line.transpose();
        }
        let eigen = SymmetricEigen::new(matrix);
        let across_normals = eigen.eigenvectors.column(eigen.eigenvalues.imin());
        axes.extend(Direction::try_new(across_normals.into(), 1e-9).map(through_middle));
        let eigen = SymmetricEigen::new(lines);
        let mut order = [0, 1, 2, 3, 4, 5];
        order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
        for place in order.into_iter().take(3) {
            let motion = eigen.eigenvectors.column(place);
            let turn = Vector::new(motion[0], motion[1], motion[2]);
            let advance = Vector::new(motion[3], motion[4], motion[5]);
            let squared = turn.norm_squared();
            // Hardly a rotation, its axis is far away and its direction that of nothing.
            if squared > 1e-4
                && let Some(direction) = Direction::try_new(turn, 1e-9)
            {
                axes.push(Axis {
                    point: Point::from(turn.cross(&advance) / squared),
                    direction,
                });
            }
        }
    }
    axes
}

/// The surfaces of a type about an axis, or about the parallel to it around which the points lie in a
/// circle.
fn about(kind: SurfaceType, axis: &Axis, points: &[Point], surfaces: &mut Vec<Surface>) {
    let u = across(&axis.direction).into_inner();
    let v = axis.direction.cross(&u);
    let flat = points.iter().map(|point| {
        let offset = point - axis.point;
        [offset.dot(&u), offset.dot(&v)]
    });
    let round = circle(flat);
    let parallel = round.map(|([x, y], _)| axis.point + u * x + v * y);
    for point in [Some(axis.point), parallel].into_iter().flatten() {
        let profile: Vec<[f64; 2]> = points
            .iter()
            .map(|it| {
                let offset = it - point;
                let height = offset.dot(&axis.direction);
                let radius = (offset - axis.direction.into_inner() * height).norm();
                [radius, height]
            })
            .collect();
        let direction = axis.direction.into_inner();
        surfaces.extend(match kind {
            SurfaceType::Cylinder => {
                let radius = profile.iter().map(|[radius, _]| radius).sum::<f64>();
                let radius = radius / profile.len() as f64;
                Some(Surface::Cylinder(Cylinder::new(point, direction, radius)))
            }
            SurfaceType::Cone => slope(&profile).map(|(height, angle)| {
                Surface::Cone(Cone::new(point + direction * height, direction, angle))
            }),
            SurfaceType::Torus => {
                circle(profile.iter().copied()).map(|([radius, height], tube)| {
                    let centre = point + direction * height;
                    Surface::Torus(Torus::new(centre, direction, radius.abs(), tube))
                })
            }
            SurfaceType::Plane | SurfaceType::Sphere => None,
        });
    }
}

/// The circle of least algebraic error: its middle and radius.
fn circle(points: impl Iterator<Item = [f64; 2]>) -> Option<([f64; 2], f64)> {
    let mut matrix = SMatrix::<f64, 3, 3>::zeros();
    let mut right = SVector::<f64, 3>::zeros();
    for [x, y] in points {
        let row = SVector::from([2.0 * x, 2.0 * y, 1.0]);
        matrix.ger(1.0, &row, &row, 1.0);
        right.axpy(x * x + y * y, &row, 1.0);
    }
    let solution = matrix.cholesky()?.solve(&right);
    let radius = (solution[2] + solution[0].powi(2) + solution[1].powi(2)).sqrt();
    radius
        .is_finite()
        .then_some(([solution[0], solution[1]], radius))
}

/// The height of the apex and the half-angle of the cone through a profile, by the line of least
/// squares.
fn slope(profile: &[[f64; 2]]) -> Option<(f64, f64)> {
    let count = profile.len() as f64;
    let mean = |axis: usize| profile.iter().map(|it| it[axis]).sum::<f64>() / count;
    let (radius, height) = (mean(0), mean(1));
    let (mut rr, mut rh, mut hh) = (0.0, 0.0, 0.0);
    for [r, h] in profile {
        let (r, h) = (r - radius, h - height);
        rr += r * r;
        rh += r * h;
        hh += h * h;
    }
    // The principal direction of the profile, which may be steep or flat.
    let angle = 0.5 * libm::atan2(2.0 * rh, hh - rr);
    let tangent = libm::tan(angle);
    (tangent.abs() > 1e-6 && tangent.is_finite())
        .then(|| (height - radius / tangent, libm::atan(tangent.abs())))
}
