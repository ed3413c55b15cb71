use super::*;
use crate::random::Random;
use crate::surface::Cone;

const NOISE: f64 = 0.02;

/// A tenth of points off like a neighbour's among those of a surface within noise.
fn noisy(surface: &Surface, near: impl Fn(f64, f64) -> Point) -> Vec<Point> {
    let mut random = Random::new(5, 0);
    (0..400)
        .map(|i| {
            let foot = surface.foot(&near(random.unit(), random.unit()));
            let off = if i % 10 == 0 {
                6.0 * NOISE
            } else {
                NOISE * random.normal()
            };
            foot + surface.normal(&foot).into_inner() * off
        })
        .collect()
}

/// A face that is a quarter of the way around an axis through (1, 2, 3).
fn around(axis: Vector) -> (Point, impl Fn(f64, f64) -> Point) {
    let origin = Point::new(1.0, 2.0, 3.0);
    let axis = Direction::new_normalize(axis);
    let first = across(&axis).into_inner();
    let second = axis.cross(&first);
    let near = move |s: f64, t: f64| {
        let (sin, cos) = libm::sincos(1.5 * s);
        origin + (first * cos + second * sin) * 3.3 + axis.into_inner() * t
    };
    (origin, near)
}

#[test]
fn what_shares_an_axis_is_found_among_points_of_others() {
    let axis = Vector::new(0.2, -0.3, 1.0);
    let (origin, near) = around(axis);
    let mut known = Known::default();
    known.add(&Surface::Cylinder(Cylinder::new(origin, axis, 9.0)));
    let apex = origin - axis.normalize() * 4.0;
    let truths = [
        (Surface::Cylinder(Cylinder::new(origin, axis, 3.0)), 1),
        (Surface::Cone(Cone::new(apex, axis, 0.6)), 2),
        (Surface::Torus(Torus::new(origin, axis, 3.0, 0.8)), 3),
    ];
    for (truth, parameters) in truths {
        let points = noisy(&truth, &near);
        let held: Vec<Held> = known
            .held(|kind| kind == truth.kind(), &points, NOISE)
            .collect();
        let found = held.iter().find(|it| it.parameters == parameters).unwrap();
        let farthest = points
            .iter()
            .map(|it| found.surface.distance(&truth.foot(it)));
        let farthest = farthest.fold(0.0, f64::max);
        assert!(farthest < 0.5 * NOISE, "{truth:?}: {farthest}");
        assert_eq!(found.choices, 1);
    }
}

#[test]
fn what_shares_a_direction_is_a_plane_across_it_or_a_cylinder_along_it() {
    let axis = Vector::new(0.1, 0.9, -0.2);
    let (origin, near) = around(axis);
    let mut known = Known::default();
    known.add(&Surface::Plane(Plane::new(Point::origin(), axis)));
    for (truth, parameters) in [
        (Surface::Plane(Plane::new(origin, axis)), 1),
        (Surface::Cylinder(Cylinder::new(origin, axis, 3.0)), 3),
    ] {
        let points = noisy(&truth, &near);
        let held: Vec<Held> = known
            .held(|kind| kind == truth.kind(), &points, NOISE)
            .collect();
        assert_eq!(held.len(), 1);
        assert_eq!(held[0].parameters, parameters);
        let off = points
            .iter()
            .map(|it| held[0].surface.distance(&truth.foot(it)));
        assert!(off.fold(0.0, f64::max) < 0.5 * NOISE);
    }
}

#[test]
fn what_is_the_same_is_remembered_once() {
    let mut known = Known::default();
    let axis = Vector::new(0.2, -0.3, 1.0);
    let cylinder = |along: f64, radius: f64| {
        Surface::Cylinder(Cylinder::new(
            Point::new(1.0, 2.0, 3.0) + axis * along,
            axis,
            radius,
        ))
    };
    for (along, radius) in [(0.0, 1.0), (5.0, 2.0), (-3.0, 1.0)] {
        known.add(&cylinder(along, radius));
    }
    known.add(&Surface::Plane(Plane::new(Point::new(7.0, 0.0, 0.0), axis)));
    assert_eq!((known.directions.len(), known.axes.len()), (1, 1));
    let elsewhere = Cylinder::new(Point::origin(), axis, 1.0);
    known.add(&Surface::Cylinder(elsewhere));
    assert_eq!((known.directions.len(), known.axes.len()), (1, 2));
}
