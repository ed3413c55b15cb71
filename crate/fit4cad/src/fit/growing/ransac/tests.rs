//! Minimal sets with known surfaces, and regions of two known surfaces.

use std::f64::consts::FRAC_PI_2;

use super::super::slippage::{Invariance, Slippage};
use super::*;
use crate::cloud::Cloud;
use crate::surface::{SurfaceType, Torus};

fn found(kind: SurfaceType, set: &[Oriented; 3]) -> Surface {
    through(set).into_iter().find(|s| s.kind() == kind).unwrap()
}

/// Points of a surface near the given ones, with exact normals.
fn on(surface: &Surface) -> [Oriented; 3] {
    [[1.0, 0.2, 0.3], [0.9, -0.5, 0.6], [0.7, 0.6, -0.2]].map(|[x, y, z]| {
        let foot = surface.foot(&Point::new(x, y, z));
        (foot, surface.normal(&foot).into_inner())
    })
}

#[test]
fn minimal_sets_with_exact_normals_give_exact_surfaces() {
    let axis = Vector::new(0.2, -0.1, 1.0);
    let centre = Point::new(0.1, 0.2, -0.4);
    for surface in [
        Surface::Plane(Plane::new(centre, axis)),
        Surface::Sphere(Sphere::new(centre, 1.3)),
        Surface::Cylinder(Cylinder::new(centre, axis, 0.8)),
        Surface::Cone(Cone::new(Point::new(0.1, 0.2, -3.0), axis, 0.3)),
    ] {
        let found = found(surface.kind(), &on(&surface));
        for point in [Point::new(1.0, 2.0, 0.5), Point::new(-0.5, 1.5, 0.7)] {
            let difference = found.distance(&point) - surface.distance(&point);
            assert!(difference.abs() < 1e-12, "{surface:?} {found:?}");
        }
    }
}

#[test]
fn a_rarer_surface_takes_more_draws() {
    assert_eq!(draws_needed(5, 5), 1);
    assert_eq!(draws_needed(100, 5), 59);
    assert_eq!(draws_needed(1_000_000, 5), MOST_DRAWS);
}

/// Spacing of the points below.
const STEP: f64 = 0.05;

/// A lattice over [0, width] × [0, length] with this spacing.
fn lattice(width: f64, length: f64, at: impl Fn(f64, f64) -> Point) -> Vec<Point> {
    let count = |size: f64| (size / STEP).round() as u32;
    let (columns, rows) = (count(width), count(length));
    let step = |i: u32, n: u32, size: f64| f64::from(i) / f64::from(n) * size;
    (0..=columns)
        .flat_map(|i| (0..=rows).map(move |j| (step(i, columns, width), step(j, rows, length))))
        .map(|(u, v)| at(u, v))
        .collect()
}

/// A quarter of a cylinder of radius 1 about the y axis moved to (0, 0, 1), from the bottom on.
fn quarter(length: f64) -> Vec<Point> {
    lattice(FRAC_PI_2, length, |angle, y| {
        Point::new(angle.sin(), y, 1.0 - angle.cos())
    })
}

/// Which surfaces a region of all points of a cloud is split into, and how many points each has.
fn split_whole(points: Vec<Point>) -> Vec<Candidate> {
    let cloud = Cloud::new(points);
    let mut search = Search::new(&cloud, &Parameters::default(), 1);
    let region: Vec<u32> = (0..cloud.len() as u32).collect();
    split(&mut search, &region, 0.0, &mut ()).unwrap();
    let mut found = search.into_accepted();
    found.sort_by_key(|candidate| candidate.surface.kind());
    found
}

/// Whether two surfaces are one, to 1e-9 in a box around the clouds below.
fn is_same(found: &Surface, truth: &Surface) -> bool {
    let corners = [-2.0, 1.5].map(|x| [-1.5, 2.0].map(|y| [-1.0, 2.5].map(|z| [x, y, z])));
    found.kind() == truth.kind()
        && corners.iter().flatten().flatten().all(|&[x, y, z]| {
            let corner = Point::new(x, y, z);
            (found.distance(&corner) - truth.distance(&corner)).abs() < 1e-9
        })
}

/// The class of two surfaces together, from their true normals.
fn class(points: &[Point], surfaces: &[Surface]) -> Invariance {
    let nearest = |point: &Point| {
        let by_distance =
            |a: &&Surface, b: &&Surface| a.distance(point).total_cmp(&b.distance(point));
        surfaces.iter().min_by(by_distance).unwrap()
    };
    let normals: Vec<Vector> = points
        .iter()
        .map(|point| nearest(point).normal(point).into_inner())
        .collect();
    Slippage::of(points, &normals).unwrap().class
}

#[test]
fn regions_of_two_surfaces_are_split_into_exactly_these() {
    let floor = lattice(1.0, 2.0, |x, y| Point::new(-x, y, 0.0));
    let round = Surface::Cylinder(Cylinder::new(Point::new(0.0, 0.0, 1.0), Vector::y(), 1.0));
    let level = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
    // A cylinder of radius 1 about the z axis, and a fillet outward from its foot.
    let turned = |radius: f64, angle: f64, z: f64| {
        let (sin, cos) = angle.sin_cos();
        Point::new(radius * cos, radius * sin, z)
    };
    let wall = lattice(FRAC_PI_2, 1.0, |angle, z| turned(1.0, angle, 0.5 + z));
    let fillet = lattice(2.0, 0.5 * FRAC_PI_2, |angle, arc| {
        let (sin, cos) = (arc / 0.5).sin_cos();
        turned(1.5 - 0.5 * cos, angle * FRAC_PI_2 / 2.0, 0.5 - 0.5 * sin)
    });
    let upright = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 1.0));
    let blend = Surface::Torus(Torus::new(Point::new(0.0, 0.0, 0.5), Vector::z(), 1.5, 0.5));
    // A ball of radius 0.8 beside the quarter of a cylinder.
    let ball = Sphere::new(Point::new(-1.1, 1.0, 0.3), 0.8);
    let cap = lattice(1.5, 1.5, |u, v| {
        let (u, v) = (u - 0.75, v - 0.75);
        ball.centre + Vector::new(-v.cos() * u.cos(), u.sin() * v.cos(), v.sin()) * 0.8
    });
    for (class_of_both, parts, surfaces) in [
        (Invariance::Prismatic, [floor, quarter(2.0)], [level, round]),
        (Invariance::Revolute, [wall, fillet], [upright, blend]),
        (
            Invariance::Complex,
            [quarter(2.0), cap],
            [round, Surface::Sphere(ball)],
        ),
    ] {
        let sizes = parts.each_ref().map(Vec::len);
        let points = parts.concat();
        assert_eq!(class(&points, &surfaces), class_of_both);
        let found = split_whole(points);
        assert_eq!(found.len(), 2, "{class_of_both:?} {found:?}");
        for (surface, size) in surfaces.iter().zip(sizes) {
            let match_of = found.iter().find(|it| is_same(&it.surface, surface));
            let support = match_of.map(|it| it.support.len());
            assert!(
                support.is_some_and(|count| count >= size),
                "{surface:?} {found:?}"
            );
        }
    }
}

#[test]
fn support_is_connected_even_where_one_surface_goes_on_elsewhere() {
    let near = lattice(1.0, 1.0, |x, y| Point::new(x, y, 0.0));
    let far = near
        .iter()
        .map(|p| p + Vector::new(2.0, 0.0, 0.0))
        .collect();
    let count = near.len() as u32;
    let mut found = split_whole([near, far].concat());
    found.sort_by_key(|candidate| candidate.support[0]);
    let supports: Vec<Vec<u32>> = found.into_iter().map(|it| it.support).collect();
    assert_eq!(
        supports,
        [
            (0..count).collect(),
            (count..2 * count).collect::<Vec<u32>>()
        ]
    );
}

#[test]
fn a_free_form_region_is_left_as_it_is() {
    let wavy = lattice(2.0, 2.0, |x, y| {
        Point::new(x, y, 0.2 * (2.0 * x).sin() * (3.0 * y + x).cos())
    });
    assert_eq!(split_whole(wavy), []);
}
