//! The stages on clouds whose faces are known by construction. Spacing is one.

use super::super::least_squares;
use super::*;
use crate::cloud::{Cloud, Point, Vector};
use crate::surface::{Cylinder, Plane, Surface, SurfaceType};

/// Points at whole coordinates of a rectangle of the plane z = `height`.
fn sheet(
    x: std::ops::RangeInclusive<i32>,
    y: std::ops::RangeInclusive<i32>,
    height: f64,
) -> Vec<Point> {
    x.flat_map(|x| {
        y.clone()
            .map(move |y| Point::new(f64::from(x), f64::from(y), height))
    })
    .collect()
}

fn level(height: f64) -> Surface {
    Surface::Plane(Plane::new(Point::new(0.0, 0.0, height), Vector::z()))
}

fn upright(x: f64) -> Surface {
    Surface::Plane(Plane::new(Point::new(x, 0.0, 0.0), Vector::x()))
}

/// Which points a surface is grown from.
type IsSeed = fn(&Point) -> bool;

/// Runs the stages on surfaces grown from the points on them that `is_seed` picks.
fn finished(points: &[Point], found: &[(Surface, IsSeed)]) -> Vec<Primitive> {
    let cloud = Cloud::new(points.to_vec());
    let parameters = Parameters {
        // Parts of a few points leave little to estimate it from.
        tolerance: 3e-6,
        ..Parameters::default()
    };
    let mut search = Search::new(&cloud, &parameters, 1);
    for (surface, is_seed) in found {
        let seeds: Vec<u32> = (0u32..)
            .zip(points)
            .filter(|(_, p)| is_seed(p) && surface.distance(p) < 1e-9)
            .map(|(index, _)| index)
            .collect();
        assert!(seeds.len() > least_squares::degrees_of_freedom(surface.kind()));
        let candidate = search.grow(surface, &seeds).unwrap();
        search.accept(candidate);
    }
    finish(&search, &mut ()).unwrap().primitives
}

fn sizes(primitives: &[Primitive]) -> Vec<usize> {
    primitives.iter().map(|p| p.points.len()).collect()
}

#[test]
fn two_discs_in_one_plane_are_two_primitives_of_one_surface() {
    let grid = sheet(-5..=5, -5..=5, 0.0);
    let disc = |x: f64| {
        let points = grid.iter().filter(|p| p.coords.norm() <= 5.0);
        points
            .map(move |p| p + Vector::x() * x)
            .collect::<Vec<Point>>()
    };
    let points = [disc(0.0), disc(20.0)].concat();
    let found = finished(
        &points,
        &[(level(0.0), |p| p.x < 10.0), (level(0.0), |p| p.x > 10.0)],
    );
    assert_eq!(sizes(&found), [81, 81]);
    assert_eq!(found[0].surface, found[1].surface);
}

#[test]
fn an_edge_belongs_to_both_of_its_faces() {
    let wall = (1..=10).flat_map(|z| (0..=10).map(move |y| Point::new(0.0, y.into(), z.into())));
    let points: Vec<Point> = sheet(0..=15, 0..=10, 0.0).into_iter().chain(wall).collect();
    let found = finished(
        &points,
        &[(level(0.0), |p| p.x > 3.0), (upright(0.0), |p| p.z > 3.0)],
    );
    assert_eq!(sizes(&found), [16 * 11, 11 * 11]);
    let shared = found[0]
        .points
        .iter()
        .filter(|i| found[1].points.contains(i));
    assert_eq!(shared.count(), 11);
}

#[test]
fn a_fillet_shares_its_tangential_edges_with_the_planes_it_joins() {
    // A floor, a quarter of a cylinder of radius 6 in ten rows, a wall.
    let floor = sheet(0..=12, 0..=12, 0.0);
    let bend = (1..10).flat_map(|row| {
        let (sin, cos) = (f64::from(row) * std::f64::consts::FRAC_PI_2 / 10.0).sin_cos();
        (0..=12).map(move |y| Point::new(12.0 + 6.0 * sin, y.into(), 6.0 - 6.0 * cos))
    });
    let wall = (6..=18).flat_map(|z| (0..=12).map(move |y| Point::new(18.0, y.into(), z.into())));
    let points: Vec<Point> = floor.into_iter().chain(bend).chain(wall).collect();
    let axis = Point::new(12.0, 0.0, 6.0);
    let cylinder = Surface::Cylinder(Cylinder::new(axis, Vector::y(), 6.0));
    let found = finished(
        &points,
        &[
            (level(0.0), |p| p.x < 10.0),
            (upright(18.0), |p| p.z > 8.0),
            (cylinder, |_| true),
        ],
    );
    assert_eq!(sizes(&found), [13 * 13, 13 * 13, 11 * 13]);
    assert_eq!(found[2].kind, Some(SurfaceType::Cylinder));
}

#[test]
fn outliers_belong_to_nothing_even_where_they_lie_on_a_surface() {
    let mut points = sheet(0..=12, 0..=12, 0.0);
    points.push(Point::new(40.0, 3.0, 0.0));
    points.push(Point::new(5.0, 5.0, 7.0));
    let found = finished(&points, &[(level(0.0), |p| p.x < 13.0)]);
    assert_eq!(sizes(&found), [169]);
    assert!(!found[0].points.contains(&169) && !found[0].points.contains(&170));
}

#[test]
fn lands_beside_a_groove_of_one_spacing_stay_apart() {
    let lands = [sheet(0..=10, 0..=12, 0.0), sheet(11..=21, 0..=12, 0.0)].concat();
    let walls = [10.0, 11.0].into_iter().flat_map(|x| {
        (1..=6).flat_map(move |z| (0..=12).map(move |y| Point::new(x, y.into(), -f64::from(z))))
    });
    let points: Vec<Point> = lands.into_iter().chain(walls).collect();
    let found = finished(
        &points,
        &[
            (level(0.0), |p| p.x < 5.0),
            (level(0.0), |p| p.x > 15.0),
            (upright(10.0), |p| p.z < -2.0),
            (upright(11.0), |p| p.z < -2.0),
        ],
    );
    assert_eq!(sizes(&found), [143, 143, 91, 91]);
}

#[test]
fn a_sheet_with_holes_in_its_sampling_is_one_patch() {
    // Rows four spacings apart, joined nowhere among the nearest neighbours.
    let points: Vec<Point> = sheet(0..=40, 0..=20, 0.0)
        .into_iter()
        .filter(|p| p.y % 4.0 == 0.0)
        .collect();
    let found = finished(&points, &[(level(0.0), |_| true)]);
    assert_eq!(sizes(&found), [41 * 6]);
}

#[test]
fn a_plane_claims_no_row_of_points_inside_a_face_it_only_crosses() {
    // The plane of the short wall at x = 6 runs on through a row of the floor's points.
    let floor = sheet(0..=12, 0..=24, 0.0);
    let wall = (1..=8).flat_map(|z| (0..=8).map(move |y| Point::new(6.0, y.into(), z.into())));
    let points: Vec<Point> = floor.into_iter().chain(wall).collect();
    let found = finished(
        &points,
        &[(level(0.0), |p| p.x < 4.0), (upright(6.0), |p| p.z > 3.0)],
    );
    assert_eq!(found[0].points.len(), 13 * 25);
    let farthest = found[1].points.iter().map(|&i| points[i as usize].y);
    assert!(farthest.fold(0.0, f64::max) <= 12.0);
}

#[test]
fn a_surface_found_twice_is_reported_once() {
    let points = sheet(0..=12, 0..=12, 0.0);
    let found = finished(
        &points,
        &[(level(0.0), |_| true), (level(0.0), |p| p.y > 6.0)],
    );
    assert_eq!(sizes(&found), [169]);
}
