use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, FRAC_PI_6, PI, TAU};

use proptest::prelude::*;

use super::*;

/// A grid of points of a surface given by its parametric form.
fn grid(at: impl Fn(f64, f64) -> Point, s: (f64, f64), t: (f64, f64)) -> Vec<Point> {
    let step = |(low, high): (f64, f64), k: u32| low + (high - low) * f64::from(k) / 24.0;
    (0..25)
        .flat_map(|i| (0..25).map(move |j| (i, j)))
        .map(|(i, j)| at(step(s, i), step(t, j)))
        .collect()
}

fn area(patch: &Patch) -> f64 {
    let corner = |index: u32| patch.vertices[index as usize];
    patch
        .triangles
        .iter()
        .map(|&[a, b, c]| {
            let (a, b, c) = (corner(a), corner(b), corner(c));
            (b - a).cross(&(c - a)).norm() / 2.0
        })
        .sum()
}

fn marked(patch: &Patch, wanted: Mark) -> Vec<[Point; 2]> {
    let lines = patch.lines.iter().filter(|(mark, _)| *mark == wanted);
    lines.map(|(_, ends)| *ends).collect()
}

fn check(surface: &Surface, points: &[Point], expected_area: f64) -> Patch {
    let patch = Patch::new(surface, points).unwrap();
    for (vertex, normal) in patch.vertices.iter().zip(&patch.normals) {
        assert!(
            surface.distance(vertex) < 1e-9,
            "{vertex} is off the surface"
        );
        assert!(
            surface.normal(vertex).dot(normal) > 1.0 - 1e-9,
            "normal at {vertex}"
        );
    }
    let area = area(&patch);
    // Facets are chords: they cover a little less.
    assert!(
        area <= expected_area * (1.0 + 1e-9) && area > expected_area * 0.99,
        "area {area} for {expected_area}"
    );
    patch
}

#[test]
fn a_plane_is_covered_by_the_hull_of_its_points() {
    let plane = Surface::Plane(Plane::new(Point::new(0.0, 0.0, 3.0), Vector::z()));
    let points = grid(|x, y| Point::new(x, y, 3.0), (0.0, 4.0), (-1.0, 2.0));
    let patch = check(&plane, &points, 12.0);
    assert_eq!(marked(&patch, Mark::Rim).len(), 4);
}

#[test]
fn half_a_cylinder_is_half_a_cylinder() {
    let cylinder = Surface::Cylinder(Cylinder::new(Point::new(1.0, 2.0, 0.0), Vector::z(), 2.0));
    let at = |z: f64, t: f64| Point::new(1.0 + 2.0 * t.cos(), 2.0 + 2.0 * t.sin(), z);
    let patch = check(&cylinder, &grid(at, (5.0, 8.0), (0.0, PI)), 3.0 * 2.0 * PI);
    let [[from, to]] = marked(&patch, Mark::Axis)[..] else {
        panic!("one axis");
    };
    assert!(from.z < 5.0 && to.z > 8.0 && (from.x, from.y) == (1.0, 2.0));
    let [[from, to]] = marked(&patch, Mark::Radius)[..] else {
        panic!("one radius");
    };
    assert!((nalgebra::distance(&from, &to) - 2.0).abs() < 1e-12);
}

#[test]
fn a_whole_cylinder_has_a_rim_at_its_ends_only() {
    let cylinder = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 1.0));
    let at = |z: f64, t: f64| Point::new(t.cos(), t.sin(), z);
    let patch = check(&cylinder, &grid(at, (0.0, 1.0), (0.0, TAU)), TAU);
    for [from, to] in marked(&patch, Mark::Rim) {
        assert_eq!(from.z, to.z);
    }
}

#[test]
fn a_cone_has_its_apex_marked() {
    let apex = Point::new(0.0, 0.0, 1.0);
    let cone = Surface::Cone(Cone::new(apex, Vector::z(), FRAC_PI_6));
    let slope = FRAC_PI_6.tan();
    let at = |h: f64, t: f64| Point::new(h * slope * t.cos(), h * slope * t.sin(), 1.0 + h);
    // Lateral area between two heights: π (r₁ + r₂) times the slant length.
    let expected = PI * 3.0 * slope / FRAC_PI_6.cos();
    let patch = check(&cone, &grid(at, (1.0, 2.0), (0.0, TAU)), expected);
    assert_eq!(marked(&patch, Mark::Centre), [[apex, apex]]);
    let below = grid(at, (-2.0, -1.0), (0.3, 1.2));
    check(&cone, &below, expected * 0.9 / TAU);
}

#[test]
fn a_cap_of_a_sphere_is_round_whichever_way_it_faces() {
    let centre = Point::new(1.0, 1.0, 1.0);
    let sphere = Surface::Sphere(Sphere::new(centre, 2.0));
    let at = |down: f64, t: f64| {
        centre + Vector::new(down.cos(), down.sin() * t.cos(), down.sin() * t.sin()) * 2.0
    };
    let expected = TAU * 4.0 * (1.0 - FRAC_PI_4.cos());
    let all_around = (0.0, TAU * 24.0 / 25.0);
    let patch = check(&sphere, &grid(at, (0.0, FRAC_PI_4), all_around), expected);
    assert_eq!(marked(&patch, Mark::Centre), [[centre, centre]]);
}

#[test]
fn a_fillet_is_a_quarter_of_a_torus_tube() {
    let torus = Surface::Torus(Torus::new(Point::origin(), Vector::z(), 5.0, 1.0));
    let at = |turn: f64, t: f64| {
        let radius = 5.0 + turn.cos();
        Point::new(radius * t.cos(), radius * t.sin(), turn.sin())
    };
    let patch = check(
        &torus,
        &grid(at, (0.0, FRAC_PI_2), (0.0, PI)),
        PI * (5.0 * FRAC_PI_2 + 1.0),
    );
    let lengths: Vec<f64> = marked(&patch, Mark::Radius)
        .iter()
        .map(|[from, to]| nalgebra::distance(from, to))
        .collect();
    assert!((lengths[0] - 5.0).abs() < 1e-9 && (lengths[1] - 1.0).abs() < 1e-9);
}

#[test]
fn an_axis_far_away_is_not_marked() {
    let radius = 577_350.0;
    let cylinder = Surface::Cylinder(Cylinder::new(
        Point::new(radius, 0.0, 0.0),
        Vector::z(),
        radius,
    ));
    let points = grid(|y, z| Point::new(0.0, y, z), (0.0, 1.0), (0.0, 1.0));
    let patch = Patch::new(&cylinder, &points).unwrap();
    assert!((area(&patch) - 1.0).abs() < 1e-3);
    assert!(patch.lines.iter().all(|(mark, _)| *mark == Mark::Rim));
}

#[test]
fn nothing_finite_is_no_patch() {
    let sphere = Surface::Sphere(Sphere::new(Point::origin(), 1.0));
    assert_eq!(Patch::new(&sphere, &[]), None);
    assert_eq!(Patch::new(&sphere, &[Point::new(f64::NAN, 0.0, 0.0)]), None);
}

proptest! {
    #[test]
    fn a_patch_of_any_points_is_finite_and_its_indices_are_in_range(
        kind in 0..5,
        points in prop::collection::vec(prop::array::uniform3(-10.0_f64..10.0), 1..20),
        axis in prop::array::uniform3(-1.0_f64..1.0),
        radii in prop::array::uniform2(0.0_f64..5.0),
    ) {
        let points: Vec<Point> = points.into_iter().map(Point::from).collect();
        let axis = Vector::from(axis);
        let centre = Point::new(1.0, 2.0, 3.0);
        let surface = match kind {
            0 => Surface::Plane(Plane::new(centre, axis)),
            1 => Surface::Cylinder(Cylinder::new(centre, axis, radii[0])),
            2 => Surface::Cone(Cone::new(centre, axis, radii[0] / 5.0 * FRAC_PI_2)),
            3 => Surface::Sphere(Sphere::new(centre, radii[0])),
            _ => Surface::Torus(Torus::new(centre, axis, radii[0], radii[1])),
        };
        if let Some(patch) = Patch::new(&surface, &points) {
            prop_assert_eq!(patch.vertices.len(), patch.normals.len());
            for corner in patch.triangles.iter().flatten() {
                prop_assert!((*corner as usize) < patch.vertices.len());
            }
        }
    }
}
