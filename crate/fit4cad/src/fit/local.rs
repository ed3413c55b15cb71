//! Surfaces through a small neighbourhood: the votes of the randomised Hough transform, and the
//! minimal hypotheses of primitive growing.
//!
//! Some ten to thirty points determine a surface of any of the five families. Closed-form solutions
//! start from two sides: algebraic fits (quadric, sphere), which see a thin cylinder whole, and the
//! curvatures of a height function over the tangent plane, which see a patch of a large surface.
//! [`polish`] turns a start into the least-squares surface of the points that agree with it.

use nalgebra::{Matrix2, SMatrix, SVector, SymmetricEigen};

use super::least_squares::{self, Loss, degrees_of_freedom};
use super::quadric::Quadric;
use crate::cloud::normals::Spread;
use crate::cloud::{Ball, Direction, Point, Vector};
use crate::surface::{Cylinder, Plane, Sphere, Surface, SurfaceType, Torus};

/// Local shape at the middle of a patch: what is left of the surface to second order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curvature {
    /// Point of the surface at the middle of the patch.
    pub point: Point,
    /// Unit normal there.
    pub normal: Direction,
    /// Principal curvatures, the larger in absolute value first; positive where the surface bends
    /// towards the normal.
    pub values: [f64; 2],
    /// Principal directions that belong to them.
    pub directions: [Direction; 2],
    /// Root mean square residual, corrected for the six coefficients.
    pub error: f64,
}

impl Curvature {
    /// Fits h = c₀ + c₁x + c₂y + c₃x² + c₄xy + c₅y² over the plane of the patch. `None` for fewer
    /// than seven points, or points near a line.
    pub fn of(patch: &[Point]) -> Option<Self> {
        if patch.len() < 7 {
            return None;
        }
        let spread = Spread::of(patch.iter())?;
        let scale = spread.variances[2].sqrt();
        let [normal, second, first] = spread.directions;
        let mut matrix = SMatrix::<f64, 6, 6>::zeros();
        let mut right = SVector::<f64, 6>::zeros();
        let (mut heights, mut rows) = (Vec::new(), Vec::new());
        for point in patch {
            let offset = (point - spread.centroid) / scale;
            let (x, y, h) = (offset.dot(&first), offset.dot(&second), offset.dot(&normal));
            let row = SVector::from([1.0, x, y, x * x, x * y, y * y]);
            matrix.ger(1.0, &row, &row, 1.0);
            right.axpy(h, &row, 1.0);
            heights.push(h);
            rows.push(row);
        }
        let c = matrix.cholesky()?.solve(&right);
        let squares: f64 = rows
            .iter()
            .zip(heights)
            .map(|(row, h)| (row.dot(&c) - h).powi(2))
            .sum();
        let stretch = (1.0 + c[1] * c[1] + c[2] * c[2]).sqrt();
        // Weingarten map: inverse of the first fundamental form times the second.
        let metric = Matrix2::new(
            1.0 + c[1] * c[1],
            c[1] * c[2],
            c[1] * c[2],
            1.0 + c[2] * c[2],
        );
        let bending = Matrix2::new(2.0 * c[3], c[4], c[4], 2.0 * c[5]) / (stretch * scale);
        // In an orthonormal basis of the tangent plane the map is symmetric.
        let factor = metric.cholesky()?.l();
        let inverse = factor.try_inverse()?;
        let eigen = SymmetricEigen::new(inverse * bending * inverse.transpose());
        let (first, second, up) = (first.into_inner(), second.into_inner(), normal.into_inner());
        let tangents = [first + up * c[1], second + up * c[2]];
        let direction = |i: usize| {
            let v = inverse.transpose() * eigen.eigenvectors.column(i);
            Direction::try_new(tangents[0] * v[0] + tangents[1] * v[1], f64::MIN_POSITIVE)
        };
        let values = eigen.eigenvalues;
        let (big, small) = if values[0].abs() >= values[1].abs() {
            (0, 1)
        } else {
            (1, 0)
        };
        Some(Self {
            point: spread.centroid + up * (c[0] * scale),
            normal: Direction::try_new(up - first * c[1] - second * c[2], f64::MIN_POSITIVE)?,
            values: [values[big], values[small]],
            directions: [direction(big)?, direction(small)?],
            error: (squares / (patch.len() - 6) as f64).sqrt() * scale / stretch,
        })
    }
}

/// Points beyond its degrees of freedom that must agree with a local solution: with fewer, points
/// on two faces and their edge find something that passes through all of them.
pub const SPARE: usize = 3;

/// The curved families that closed forms start well.
pub const CURVED: [SurfaceType; 3] = [
    SurfaceType::Sphere,
    SurfaceType::Cylinder,
    SurfaceType::Cone,
];

/// The families of the sheets of thin walls.
pub const SHEETS: [SurfaceType; 4] = [
    SurfaceType::Plane,
    SurfaceType::Sphere,
    SurfaceType::Cylinder,
    SurfaceType::Cone,
];

/// Starts for the surfaces of the given family through a patch; most are wrong, which costs
/// nothing but the time to see it.
pub fn starts(kind: SurfaceType, patch: &[Point]) -> Vec<Surface> {
    let mut surfaces = Vec::new();
    match kind {
        SurfaceType::Plane => {
            surfaces.extend(Spread::of(patch.iter()).map(|spread| {
                Surface::Plane(Plane::new(spread.centroid, spread.normal().into_inner()))
            }));
            let band = BAND * Ball::of(patch).radius;
            surfaces
                .extend(plane_through_seed(patch, band).map(|(plane, _)| Surface::Plane(plane)));
        }
        SurfaceType::Sphere => surfaces.extend(algebraic_sphere(patch).map(Surface::Sphere)),
        SurfaceType::Cylinder | SurfaceType::Cone => {
            if let Some(quadric) = Quadric::of(patch) {
                surfaces.extend(match kind {
                    SurfaceType::Cylinder => quadric.cylinder().map(Surface::Cylinder),
                    _ => quadric.cone().map(Surface::Cone),
                });
            }
            if kind == SurfaceType::Cylinder {
                surfaces.extend(Curvature::of(patch).and_then(|c| curved_cylinder(&c)));
            }
        }
        SurfaceType::Torus => {
            if let Some(curvature) = Curvature::of(patch) {
                tori(&curvature, &mut surfaces);
            }
            // Polishing a torus takes longer than measuring how far off it starts.
            surfaces.sort_by_cached_key(|surface| {
                let squares: f64 = patch.iter().map(|p| surface.distance(p).powi(2)).sum();
                // The bits of a float that is not negative are ordered as it is.
                squares.to_bits()
            });
            surfaces.truncate(TORUS_STARTS);
        }
    }
    surfaces
}

/// As [`starts`]; for a cone also those nearest to the cylinders through the patch, as a slim cone is
/// nearly one.
pub fn hypotheses(kind: SurfaceType, patch: &[Point]) -> Vec<Surface> {
    let mut surfaces = starts(kind, patch);
    if kind == SurfaceType::Cone {
        let cylinders = starts(SurfaceType::Cylinder, patch);
        let cones = cylinders.iter().filter_map(|start| match start {
            Surface::Cylinder(near) => least_squares::fit_cone_near(near, patch, Loss::Squares),
            _ => None,
        });
        surfaces.extend(cones.map(|fitted| fitted.surface));
    }
    surfaces
}

/// The plane through the first point of a patch and two of the next few that most of the patch lies
/// on to `tolerance`, and how many points that is. Unlike a mean over the patch it is not misled by
/// the other sheet of a thin wall.
pub fn plane_through_seed(patch: &[Point], tolerance: f64) -> Option<(Plane, usize)> {
    let (seed, others) = patch.split_first()?;
    let near = &others[..others.len().min(8)];
    let mut best: Option<(Plane, usize)> = None;
    for (i, first) in near.iter().enumerate() {
        for second in &near[i + 1..] {
            let (u, v) = (first - seed, second - seed);
            let normal = u.cross(&v);
            // Nearly in line, they say nothing about the plane.
            if normal.norm() < 0.2 * u.norm() * v.norm() || normal.norm() == 0.0 {
                continue;
            }
            let plane = Plane::new(*seed, normal);
            let on = patch
                .iter()
                .filter(|p| (p.coords.dot(&plane.normal) - plane.offset).abs() <= tolerance)
                .count();
            if best.as_ref().is_none_or(|(_, most)| on > *most) {
                best = Some((plane, on));
            }
        }
    }
    best
}

/// Half the thickness, in radii of a patch, of a band that holds its plane and not much else.
const BAND: f64 = 0.028;
/// Starts of a torus worth polishing.
const TORUS_STARTS: usize = 4;

/// The sphere |x|² = 2 c·x + (r² - |c|²), linear in its unknowns.
fn algebraic_sphere(patch: &[Point]) -> Option<Sphere> {
    let origin = Spread::of(patch.iter())?.centroid;
    let scale = Ball::of(patch).diameter();
    let mut matrix = SMatrix::<f64, 4, 4>::zeros();
    let mut right = SVector::<f64, 4>::zeros();
    for point in patch {
        let offset = (point - origin) / scale;
        let row = SVector::from([2.0 * offset.x, 2.0 * offset.y, 2.0 * offset.z, 1.0]);
        matrix.ger(1.0, &row, &row, 1.0);
        right.axpy(offset.norm_squared(), &row, 1.0);
    }
    let solution = matrix.cholesky()?.solve(&right);
    let centre = Vector::new(solution[0], solution[1], solution[2]);
    let radius = (solution[3] + centre.norm_squared()).sqrt();
    radius
        .is_finite()
        .then(|| Sphere::new(origin + centre * scale, radius * scale))
}

/// The cylinder that bends as the patch does: its axis runs along the direction of least curvature.
fn curved_cylinder(curvature: &Curvature) -> Option<Surface> {
    let bend = curvature.values[0];
    (bend.abs() > f64::MIN_POSITIVE).then(|| {
        let centre = curvature.point + curvature.normal.into_inner() / bend;
        Surface::Cylinder(Cylinder::new(
            centre,
            curvature.directions[1].into_inner(),
            1.0 / bend.abs(),
        ))
    })
}

/// Tori that bend as the patch does. One principal direction runs around the tube, the other
/// around the axis; the axis meets the normal at the centre of curvature of the latter (Meusnier)
/// and lies in the plane of the normal and the former. Its slope in that plane is a matter of third
/// derivatives: several are tried.
fn tori(curvature: &Curvature, surfaces: &mut Vec<Surface>) {
    const SLOPES: [f64; 4] = [0.0, 0.25, 0.5, 0.75];
    let normal = curvature.normal.into_inner();
    for (tube, other) in [(0, 1), (1, 0)] {
        let (bend, turn) = (curvature.values[tube], curvature.values[other]);
        if bend.abs() <= f64::MIN_POSITIVE {
            continue;
        }
        let centre = curvature.point + normal / bend;
        let minor = 1.0 / bend.abs();
        let meridian = curvature.directions[tube].into_inner();
        for slope in SLOPES {
            let (sin, cos) = libm::sincos(slope * std::f64::consts::PI);
            let axis = meridian * cos + normal * sin;
            if turn.abs() > 1e-3 * bend.abs() {
                let meeting = curvature.point + normal / turn;
                let foot = meeting + axis * (centre - meeting).dot(&axis);
                let major = (centre - foot).norm();
                surfaces.push(Surface::Torus(Torus::new(foot, axis, major, minor)));
            }
        }
        // At the top of the tube the normal is parallel to the axis, which is then anywhere.
        for major in [1.5, 3.0, 8.0] {
            for side in [-1.0, 1.0] {
                let foot = centre + meridian * (side * major * minor);
                surfaces.push(Surface::Torus(Torus::new(
                    foot,
                    normal,
                    major * minor,
                    minor,
                )));
            }
        }
    }
}

/// The least-squares surface of those points of a patch that agree with a start to `tolerance`,
/// and which they are. `None` where fewer than `needed` do.
///
/// Others than the best of the patch are given less and less say. On the right track the median
/// distance collapses from round to round; where it does not, no surface is hidden in the patch,
/// and most hypotheses end there.
pub fn polish(
    start: &Surface,
    patch: &[Point],
    tolerance: f64,
    needed: usize,
) -> Option<(Surface, Vec<usize>)> {
    let mut surface = least_squares::approximate(start, patch, Loss::Squares)?.surface;
    let mut distances = Vec::with_capacity(patch.len());
    let mut last = f64::INFINITY;
    for _ in 0..ROBUST_ROUNDS {
        distances.clear();
        distances.extend(patch.iter().map(|point| surface.distance(point)));
        let median = super::quantile::quantile(&mut distances, 0.5);
        let largest = distances.iter().copied().fold(0.0, f64::max);
        if largest <= tolerance {
            break;
        }
        if median > tolerance.max(0.5 * last) {
            return None;
        }
        last = median;
        let cut_off = (3.0 * median).max(2.0 * tolerance);
        surface = least_squares::approximate(&surface, patch, Loss::Biweight(cut_off))?.surface;
        if cut_off <= 2.0 * tolerance {
            break;
        }
    }
    let agreeing: Vec<usize> = (0..patch.len())
        .filter(|&i| surface.distance(&patch[i]) <= tolerance)
        .collect();
    let needed = needed.max(degrees_of_freedom(surface.kind()) + 1);
    (agreeing.len() >= needed).then_some((surface, agreeing))
}

const ROBUST_ROUNDS: usize = 6;

/// The surfaces of the given family through one sheet of a thin wall both of whose sheets a patch holds,
/// each with its points of the patch: the sheet of the first point. A surface through all points runs
/// between the sheets, so its sides tell them apart. Only those that `spare` points beyond the degrees
/// of freedom, and most of the sheet, agree with to `tolerance`.
pub fn through_sheet(
    kind: SurfaceType,
    patch: &[Point],
    tolerance: f64,
    spare: usize,
) -> impl Iterator<Item = (Surface, Vec<usize>)> {
    hypotheses(kind, patch)
        .into_iter()
        .filter_map(move |start| {
            let between = least_squares::approximate(&start, patch, Loss::Squares)?.surface;
            let is_above = |point: &Point| between.signed_distance(point) > 0.0;
            let above = is_above(patch.first()?);
            let (places, beyond): (Vec<usize>, Vec<usize>) =
                (0..patch.len()).partition(|&place| is_above(&patch[place]) == above);
            let polished = |places: &[usize]| {
                let sheet: Vec<Point> = places.iter().map(|&place| patch[place]).collect();
                let needed = (degrees_of_freedom(kind) + spare).max(2 * sheet.len() / 3);
                polish(&between, &sheet, tolerance, needed)
            };
            let (surface, agreeing) = polished(&places)?;
            // A plane is on one side of any bent face beside it: both sheets of a flat wall are flat.
            if kind == SurfaceType::Plane {
                polished(&beyond)?;
            }
            Some((surface, agreeing.iter().map(|&i| places[i]).collect()))
        })
}

#[cfg(test)]
mod tests;
