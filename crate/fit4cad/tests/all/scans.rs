//! What clouds are like that people hold: rounded, scanned in lines, thin, barely bent.
#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::f64::consts::TAU;

use fit4cad::cloud::{Cloud, Point};
use fit4cad::fit::{Method, Parameters, fit};
use fit4cad::random::Random;
use fit4cad::surface::SurfaceType;

/// What is found in a cloud: each primitive's type and number of points.
fn found(points: &[Point], method: Method) -> Vec<(SurfaceType, usize)> {
    let cloud = Cloud::new(points.to_vec());
    let fit = fit(&cloud, method, &Parameters::default(), 1, &mut ()).unwrap();
    let primitives = fit.segmentation.primitives.into_iter();
    primitives
        .map(|it| (it.surface.unwrap().kind(), it.points.len()))
        .collect()
}

/// The same for both methods.
fn found_by_both(points: &[Point]) -> [Vec<(SurfaceType, usize)>; 2] {
    Method::ALL.map(|method| found(points, method))
}

/// A cylinder of radius 50 about z, points some two and a half apart.
fn pipe(turns: u32, levels: u32) -> impl Iterator<Item = Point> {
    (0..levels).flat_map(move |level| {
        (0..turns).map(move |turn| {
            let (sin, cos) = (TAU * f64::from(turn) / f64::from(turns)).sin_cos();
            Point::new(50.0 * cos, 50.0 * sin, 2.5 * f64::from(level))
        })
    })
}

/// Rounding leaves flat spots on it, exact planes each.
#[test]
fn a_cylinder_in_whole_millimetres_is_one_cylinder() {
    let rounded: Vec<Point> = pipe(130, 50).map(|it| it.map(f64::round)).collect();
    for found in found_by_both(&rounded) {
        assert_eq!(found.len(), 1, "{found:?}");
        let (kind, points) = found[0];
        assert_eq!(kind, SurfaceType::Cylinder);
        assert!(points as f64 > 0.97 * rounded.len() as f64, "{points}");
    }
}

/// Points that were placed on a lattice are exact, and none the worse for it.
#[test]
fn a_box_whose_points_are_on_a_lattice_keeps_its_faces() {
    let side = |i: i32| 2.0 * f64::from(i);
    let mut points = Vec::new();
    for (i, j, k) in
        (0..=12).flat_map(|i| (0..=9).flat_map(move |j| (0..=6).map(move |k| (i, j, k))))
    {
        if i % 12 == 0 || j % 9 == 0 || k % 6 == 0 {
            points.push(Point::new(side(i), side(j), side(k)));
        }
    }
    for found in found_by_both(&points) {
        assert_eq!(found.len(), 6, "{found:?}");
        assert!(found.iter().all(|it| it.0 == SurfaceType::Plane));
    }
}

/// Two grids nearer each other than their points: half the neighbours of each point are on the other sheet.
#[test]
fn both_sheets_of_a_wall_thinner_than_its_spacing_are_found_whole() {
    for (rows, gap) in [(21, 0.2), (40, 0.2), (30, 0.3)] {
        let sheet = |at: [f64; 3]| {
            (0..rows * rows).map(move |i| {
                let (x, y) = (f64::from(i % rows), f64::from(i / rows));
                Point::new(x + at[0], y + at[1], at[2])
            })
        };
        let points: Vec<Point> = sheet([0.0; 3]).chain(sheet([0.26, 0.34, gap])).collect();
        for found in found_by_both(&points) {
            let whole = (SurfaceType::Plane, (rows * rows) as usize);
            // Their rims are on planes too, of which nothing but these rims is seen.
            assert_eq!(found[..2], [whole; 2], "{rows}, {gap}: {found:?}");
            assert!(
                found[2..].iter().all(|it| it.1 <= 2 * rows as usize),
                "{found:?}"
            );
        }
    }
}

/// An arc of two degrees of a cylinder and as much of a sphere: of radii thirty times the size of the cloud.
#[test]
fn faces_that_bend_by_two_degrees_are_what_they_are() {
    for degrees in [2.0f64, 8.0] {
        let angle = degrees.to_radians();
        let radius = 5.0 / angle;
        let mut random = Random::new(7, 0);
        let mut turn = || angle * (random.unit() - 0.5);
        let bent: Vec<Point> = (0..500)
            .map(|_| {
                let (sin, cos) = turn().sin_cos();
                Point::new(radius * sin, radius * turn(), radius * (cos - 1.0))
            })
            .collect();
        let dome: Vec<Point> = (0..500)
            .map(|_| {
                let ((sin, cos), (up, out)) = (turn().sin_cos(), turn().sin_cos());
                Point::new(radius * sin * out, radius * up, radius * (cos * out - 1.0))
            })
            .collect();
        for (points, kind) in [(bent, SurfaceType::Cylinder), (dome, SurfaceType::Sphere)] {
            for found in found_by_both(&points) {
                assert_eq!(found, [(kind, 500)], "{degrees}");
            }
        }
    }
}

/// Points a tenth as far apart along the lines as the lines are: all neighbours of a point are on its own line.
#[test]
fn scan_lines_ten_times_as_far_apart_as_their_points_show_the_faces_they_cross() {
    let mut random = Random::new(3, 0);
    let mut points = Vec::new();
    for line in 0..40 {
        let x = f64::from(line) + 0.2 * random.unit();
        for step in 0..400 {
            let (y, off) = (0.1 * f64::from(step), 0.006 * random.normal());
            // Ground, and half a pipe across it.
            let above = 64.0 - (y - 20.0).powi(2);
            let out = (above + 2.0 * 8.0 * off).max(0.0).sqrt();
            points.push(Point::new(x, y, if above > 0.0 { out } else { off }));
        }
    }
    for found in found_by_both(&points) {
        let of = |kind| {
            let same = found.iter().filter(move |it| it.0 == kind);
            same.map(|it| it.1).sum::<usize>()
        };
        assert!(found.len() <= 5, "{found:?}");
        assert!(of(SurfaceType::Cylinder) > 6000, "{found:?}");
        assert!(of(SurfaceType::Plane) > 9000, "{found:?}");
    }
}
