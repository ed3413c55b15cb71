//! The steps of a search on clouds whose faces are known.

use std::f64::consts::TAU;

use super::*;
use crate::cloud::Vector;
use crate::surface::{Cylinder, Plane, Sphere};

/// Width of the faces below, in points.
const WIDTH: i32 = 21;

fn lattice(at: impl Fn(f64, f64) -> Point) -> Vec<Point> {
    (0..WIDTH * WIDTH)
        .map(|i| at(f64::from(i % WIDTH), f64::from(i / WIDTH)))
        .collect()
}

/// Two square faces with spacing one that meet in the edge x = z = 0, which the first one, z = 0,
/// holds the points of.
fn corner() -> Cloud {
    let top = lattice(|x, y| Point::new(x, y, 0.0));
    let side = lattice(|z, y| Point::new(0.0, y, -1.0 - z));
    Cloud::new([top, side].concat())
}

fn top() -> Surface {
    Surface::Plane(Plane::new(Point::origin(), Vector::z()))
}

fn side() -> Surface {
    Surface::Plane(Plane::new(Point::origin(), Vector::x()))
}

fn search(cloud: &Cloud) -> Search<'_> {
    Search::new(cloud, &Parameters::default(), 1)
}

/// Indices of the points for which something holds.
fn indices(cloud: &Cloud, holds: impl Fn(&Point) -> bool) -> Vec<u32> {
    (0u32..)
        .zip(cloud.points())
        .filter_map(|(i, point)| holds(point).then_some(i))
        .collect()
}

#[test]
fn a_flood_stops_at_the_edge_and_takes_it_along() {
    let cloud = corner();
    let mut search = search(&cloud);
    for (surface, face) in [
        (top(), indices(&cloud, |p| p.z == 0.0)),
        (side(), indices(&cloud, |p| p.x == 0.0)),
    ] {
        let seed = face[face.len() / 2];
        let mut reached = search.flood(&surface, &[seed], usize::MAX);
        reached.sort_unstable();
        assert_eq!(reached, face);
    }
}

#[test]
fn a_flood_leaves_out_seeds_off_the_surface_and_ends_once_over_its_limit() {
    let cloud = corner();
    let mut search = search(&cloud);
    let deep = indices(&cloud, |p| p.z < -5.0);
    assert!(search.flood(&top(), &deep, usize::MAX).is_empty());
    let seed = indices(&cloud, |p| p.z == 0.0)[220];
    let reached = search.flood(&top(), &[seed], 40);
    // The last point looked at may bring along all of its neighbours.
    assert!((40..40 + search.graph.count()).contains(&reached.len()));
}

#[test]
fn a_patch_grows_over_its_face_from_a_few_seeds() {
    let cloud = corner();
    let mut search = search(&cloud);
    let face = indices(&cloud, |p| p.z == 0.0);
    let seeds = &face[220..224];
    let grown = search.grow(&top(), seeds).unwrap();
    assert_eq!(grown.support, face);
    assert!(grown.error < 1e-12);
}

/// A closed tube of radius five, capped on top.
#[test]
fn a_cylinder_grows_around_its_axis_and_not_over_the_cap() {
    let mut points = Vec::new();
    for turn in 0..32 {
        let (sin, cos) = (f64::from(turn) * TAU / 32.0).sin_cos();
        points.extend((0..=12).map(|z| Point::new(5.0 * cos, 5.0 * sin, -f64::from(z))));
    }
    let disc = lattice(|x, y| Point::new(x - 10.0, y - 10.0, 0.0));
    points.extend(disc.into_iter().filter(|p| p.coords.norm() < 4.6));
    let cloud = Cloud::new(points);
    let tube = indices(&cloud, |p| (p.x.hypot(p.y) - 5.0).abs() < 1e-9);
    let near: Vec<u32> = indices(&cloud, |p| p.x > 4.5 && (-8.0..=-4.0).contains(&p.z));
    let start = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 5.0));
    let grown = search(&cloud).grow(&start, &near).unwrap();
    assert_eq!(grown.support, tube);
}

#[test]
fn only_connected_points_support_a_candidate() {
    let left = lattice(|x, y| Point::new(x, y, 0.0));
    let right = lattice(|x, y| Point::new(x + 30.0, y, 0.0));
    let cloud = Cloud::new([left, right].concat());
    let grown = search(&cloud).grow(&top(), &[200, 201, 221, 222]).unwrap();
    assert_eq!(grown.support, indices(&cloud, |p| p.x < 25.0));
}

#[test]
fn accepted_points_are_explained_and_no_longer_a_candidates_own() {
    let cloud = corner();
    let mut search = search(&cloud);
    let face = indices(&cloud, |p| p.z == 0.0);
    let wall = indices(&cloud, |p| p.x == 0.0);
    let first = search.grow(&top(), &face[220..224]).unwrap();
    assert_eq!(search.own(&first), face.len());
    assert!(!search.is_known(SurfaceType::Plane, &face[..4]));
    search.accept(first);
    assert!(face.iter().all(|&i| search.is_explained(i)));
    assert!(search.is_known(SurfaceType::Plane, &face[..4]));
    assert!(!search.is_known(SurfaceType::Plane, &wall[..40]));
    let second = search.grow(&side(), &wall[300..304]).unwrap();
    // The edge is held by the first.
    assert_eq!(search.own(&second), second.support.len() - WIDTH as usize);
    let edge = indices(&cloud, |p| p.x == 0.0 && p.z == 0.0)[10];
    let near = search.unexplained_near(edge, 5);
    assert_eq!(near.len(), 5);
    assert!(near.iter().all(|&i| search.point(i).z < 0.0));
}

#[test]
fn a_row_is_thinner_than_a_strip_and_a_strip_than_a_patch() {
    let cloud = corner();
    let mut search = search(&cloud);
    let mut thickness = |holds: fn(&Point) -> bool| {
        search.thickness(&Candidate {
            surface: top(),
            support: indices(&cloud, holds),
            error: 0.0,
        })
    };
    let row = thickness(|p| p.z == 0.0 && p.x == 10.0);
    let strip = thickness(|p| p.z == 0.0 && (10.0..=11.0).contains(&p.x));
    let patch = thickness(|p| p.z == 0.0);
    assert!((row - 2.0).abs() < 0.5, "{row}");
    assert!((strip - 5.0).abs() < 0.5, "{strip}");
    assert!((7.5..=8.0).contains(&patch), "{patch}");
}

#[test]
fn a_line_and_a_point_beside_it_are_a_row_and_two_lines_are_none() {
    let cloud = corner();
    let search = search(&cloud);
    let is_row = |holds: fn(&Point) -> bool| {
        search.is_row(&Candidate {
            surface: top(),
            support: indices(&cloud, holds),
            error: 0.0,
        })
    };
    assert!(is_row(
        |p| p.z == 0.0 && (p.x == 10.0 || p.x == 11.0 && p.y == 4.0)
    ));
    assert!(!is_row(|p| p.z == 0.0 && (p.x == 10.0 || p.x == 11.0)));
}

/// A plane and a vast sphere through the same points: the plane is simpler. With a point more the
/// sphere is worth nearly as much still; with a tenth more it wins.
#[test]
fn of_candidates_worth_nearly_the_same_the_simplest_is_best() {
    let cloud = corner();
    let search = search(&cloud);
    let candidate = |surface, count: u32| Candidate {
        surface,
        support: (0..count).collect(),
        error: 1e-9,
    };
    let sphere = Surface::Sphere(Sphere::new(Point::new(0.0, 0.0, -50.0), 50.0));
    for (more, best) in [(1, SurfaceType::Plane), (20, SurfaceType::Sphere)] {
        let rivals = vec![candidate(sphere, 200 + more), candidate(top(), 200)];
        assert_eq!(search.best(rivals).unwrap().surface.kind(), best);
    }
    assert_eq!(search.best(Vec::new()), None);
}

#[test]
fn surfaces_that_nobody_would_call_by_their_name_are_not_plausible() {
    let cloud = corner();
    let search = search(&cloud);
    let tube = |radius| Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), radius));
    assert!(search.is_plausible(&tube(5.0)));
    assert!(!search.is_plausible(&tube(31.0 * search.scale.diameter)));
    assert!(!search.is_plausible(&tube(search.scale.tolerance)));
    assert!(!search.is_plausible(&tube(f64::NAN)));
}

#[test]
fn a_long_row_of_points_grows_no_patch_and_two_rows_do() {
    let row = |y: f64| (0..500).map(move |i| Point::new(f64::from(i), y, 0.0));
    let seeds: Vec<u32> = (0..8).collect();
    let one = Cloud::new(row(0.0).collect());
    assert_eq!(search(&one).grow(&top(), &seeds), None);
    let two = Cloud::new(row(0.0).chain(row(1.0)).collect());
    let patch = search(&two).grow(&top(), &seeds).unwrap();
    assert_eq!(patch.support.len(), 1000);
}
