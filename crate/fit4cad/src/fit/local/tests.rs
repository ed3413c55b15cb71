//! Patches of a few dozen points and the surfaces through them.

use super::*;
use crate::surface::Cone;

const TOLERANCE: f64 = 1e-6;
const COUNT: usize = 28;

/// Points of the unit square that lie evenly and on no lattice: multiples of the golden ratio
/// against an even stride.
fn spots() -> impl Iterator<Item = (f64, f64)> {
    (0..COUNT).map(|i| {
        let turn = i as f64 * 0.618_033_988_749_895;
        ((i as f64 + 0.5) / COUNT as f64, turn.fract())
    })
}

/// A patch of a surface of revolution about an oblique axis: `profile` gives the radius and height
/// at a share of the patch, `angle` is how far it reaches around the axis.
fn revolved(angle: f64, profile: impl Fn(f64) -> (f64, f64)) -> Vec<Point> {
    let first = crate::surface::across(&axis());
    let second = axis().cross(&first);
    spots()
        .map(|(s, t)| {
            let (radius, height) = profile(s);
            let (sin, cos) = (angle * t).sin_cos();
            centre()
                + (first.into_inner() * cos + second * sin) * radius
                + axis().into_inner() * height
        })
        .collect()
}

fn centre() -> Point {
    Point::new(0.4, -1.1, 0.7)
}

fn axis() -> Direction {
    Direction::new_normalize(Vector::new(0.3, -0.2, 1.0))
}

fn plane() -> (Surface, Vec<Point>) {
    let truth = Surface::Plane(Plane::new(centre(), axis().into_inner()));
    let first = crate::surface::across(&axis()).into_inner();
    let second = axis().cross(&first);
    let patch = spots().map(|(s, t)| centre() + first * s + second * (2.0 * t));
    (truth, patch.collect())
}

fn cylinder(angle: f64) -> (Surface, Vec<Point>) {
    let truth = Cylinder::new(centre(), axis().into_inner(), 1.5);
    let patch = revolved(angle, |s| (1.5, s));
    (Surface::Cylinder(truth), patch)
}

fn cone() -> (Surface, Vec<Point>) {
    let truth = Cone::new(centre(), axis().into_inner(), 0.4);
    let patch = revolved(1.5, |s| ((1.0 + s) * 0.4f64.tan(), 1.0 + s));
    (Surface::Cone(truth), patch)
}

fn sphere() -> (Surface, Vec<Point>) {
    let patch = revolved(1.2, |s| (1.5 * (0.2 + s).cos(), 1.5 * (0.2 + s).sin()));
    (Surface::Sphere(Sphere::new(centre(), 1.5)), patch)
}

/// The outer side of a fillet.
fn torus() -> (Surface, Vec<Point>) {
    let truth = Torus::new(centre(), axis().into_inner(), 2.0, 0.5);
    let tube = |s: f64| {
        (
            2.0 + 0.5 * (1.5 * s - 0.4).cos(),
            0.5 * (1.5 * s - 0.4).sin(),
        )
    };
    (Surface::Torus(truth), revolved(0.5, tube))
}

/// The first surface of the family that every point of the patch agrees with.
fn through(kind: SurfaceType, patch: &[Point]) -> Option<Surface> {
    starts(kind, patch)
        .iter()
        .find_map(|start| polish(start, patch, TOLERANCE, patch.len()))
        .map(|(surface, _)| surface)
}

/// Whether two surfaces are one: they are equally far from points around the patch, not only on it.
fn assert_same(found: &Surface, truth: &Surface, patch: &[Point]) {
    let around = |p: &Point| [p + Vector::x() * 0.1, p - Vector::y() * 0.1];
    for point in patch.iter().flat_map(around) {
        let apart = (found.distance(&point) - truth.distance(&point)).abs();
        assert!(apart < 1e-4, "off by {apart:e}: {found:?} is not {truth:?}");
    }
}

#[test]
fn an_exact_patch_of_every_family_gives_its_surface() {
    for (truth, patch) in [plane(), cylinder(1.5), cone(), sphere(), torus()] {
        let found = through(truth.kind(), &patch).unwrap_or_else(|| panic!("no {truth:?}"));
        assert_same(&found, &truth, &patch);
    }
}

#[test]
fn a_patch_lies_on_no_simpler_surface_than_its_own() {
    for (truth, patch) in [cylinder(1.5), cone(), sphere(), torus()] {
        let own = degrees_of_freedom(truth.kind());
        for kind in SurfaceType::ALL {
            if degrees_of_freedom(kind) < own {
                assert_eq!(through(kind, &patch), None, "{truth:?}");
            }
        }
    }
}

#[test]
fn thirty_degrees_of_a_cylinder_are_enough() {
    let (truth, patch) = cylinder(30f64.to_radians());
    let found = through(SurfaceType::Cylinder, &patch).unwrap();
    assert_same(&found, &truth, &patch);
}

#[test]
fn a_free_form_patch_gives_nothing() {
    let patch: Vec<Point> = spots()
        .map(|(s, t)| Point::new(s, t, 0.2 * (7.0 * s + 2.0 * t * t).sin() * (5.0 * t).cos()))
        .collect();
    for kind in SurfaceType::ALL {
        for start in starts(kind, &patch) {
            assert_eq!(polish(&start, &patch, TOLERANCE, COUNT / 2), None);
        }
    }
}

#[test]
fn points_that_are_off_are_left_out_and_do_not_bend_the_surface() {
    let (truth, mut patch) = cylinder(1.5);
    for i in [3, 11, 20] {
        patch[i] += Vector::new(0.05, 0.02, -0.04);
    }
    let (found, agreeing) = starts(SurfaceType::Cylinder, &patch)
        .iter()
        .find_map(|start| polish(start, &patch, TOLERANCE, COUNT / 2))
        .unwrap();
    assert_same(&found, &truth, &patch);
    let others: Vec<usize> = (0..COUNT).filter(|i| ![3, 11, 20].contains(i)).collect();
    assert_eq!(agreeing, others);
}

/// Two sheets of a wall, a twentieth of their width apart: the plane between them holds no point.
#[test]
fn the_plane_through_the_seed_is_not_misled_by_the_other_sheet() {
    let mut patch: Vec<Point> = spots()
        .enumerate()
        .map(|(i, (s, t))| Point::new(s, t, if i % 2 == 0 { 0.0 } else { 0.05 }))
        .collect();
    // As in a cloud, where a patch is a point and its neighbours.
    let seed = patch[COUNT / 2];
    patch.sort_by(|a, b| (a - seed).norm().total_cmp(&(b - seed).norm()));
    let (plane, on) = plane_through_seed(&patch, 1e-9).unwrap();
    assert_eq!(on, COUNT / 2);
    assert!((plane.normal.z - 1.0).abs() < 1e-12 && plane.offset.abs() < 1e-12);
}

/// Every other point of a patch moved along the normal by a twentieth of its width.
#[test]
fn a_sheet_of_a_curved_wall_is_told_from_the_other() {
    for (truth, patch) in [cylinder(1.5), cone(), sphere()] {
        let moved = |(i, p): (usize, &Point)| p + truth.normal(p).into_inner() * [0.0, 0.05][i % 2];
        let wall: Vec<Point> = patch.iter().enumerate().map(moved).collect();
        let alone = starts(truth.kind(), &wall)
            .iter()
            .find_map(|start| polish(start, &wall, TOLERANCE, COUNT / 2));
        assert_eq!(alone, None);
        let mut found = through_sheet(truth.kind(), &wall, TOLERANCE, SPARE);
        let (found, on) = found.next().unwrap();
        assert_same(&found, &truth, &patch);
        assert!(on.iter().all(|i| i % 2 == 0) && on.len() > COUNT / 3);
    }
}

/// h = x² + y²/4 has the principal curvatures 2 and ½ at the origin.
#[test]
fn the_curvatures_of_a_paraboloid_are_those_at_its_apex() {
    let patch: Vec<Point> = (0..25)
        .map(|i| (f64::from(i % 5 - 2) * 0.05, f64::from(i / 5 - 2) * 0.05))
        .map(|(x, y)| Point::new(x, y, x * x + 0.25 * y * y))
        .collect();
    let shape = Curvature::of(&patch).unwrap();
    let up = shape.normal.z.signum();
    assert!((shape.values[0] * up - 2.0).abs() < 1e-9, "{shape:?}");
    assert!((shape.values[1] * up - 0.5).abs() < 1e-9, "{shape:?}");
    assert!((shape.directions[0].x.abs() - 1.0).abs() < 1e-9);
    assert!(shape.point.coords.norm() < 1e-9 && shape.error < 1e-9);
}

#[test]
fn too_few_points_have_no_curvature_and_a_line_no_shape() {
    let line: Vec<Point> = (0..COUNT).map(|i| Point::new(i as f64, 0.0, 0.0)).collect();
    assert_eq!(Curvature::of(&sphere().1[..6]), None);
    assert_eq!(Curvature::of(&line), None);
    assert_eq!(plane_through_seed(&line, TOLERANCE), None);
}
