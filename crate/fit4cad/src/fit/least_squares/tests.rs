//! Fits against exact surfaces and against references made by hand.

mod reference;

use super::super::local;
use super::*;
use crate::surface::{Cone, Sphere, Torus};

/// Points of a surface near a box that holds part of it.
fn on(surface: &Surface, from: [f64; 3], to: [f64; 3]) -> Vec<Point> {
    let at = |i: usize, k: usize| from[k] + (to[k] - from[k]) * i as f64 / 4.0;
    (0..125)
        .map(|i| surface.foot(&Point::new(at(i % 5, 0), at(i / 5 % 5, 1), at(i / 25, 2))))
        .collect()
}

fn axis() -> Vector {
    Vector::new(0.3, -0.2, 1.0)
}

/// Farthest that two surfaces are apart over some points.
fn apart(a: &Surface, b: &Surface, points: &[Point]) -> f64 {
    points
        .iter()
        .map(|p| (a.distance(p) - b.distance(p)).abs())
        .fold(0.0, f64::max)
}

fn exact_cases() -> Vec<(Surface, Surface, Vec<Point>)> {
    let centre = Point::new(0.1, 0.2, -0.3);
    let pairs = [
        (
            Surface::Plane(Plane::new(centre, axis())),
            Surface::Plane(Plane::new(centre, Vector::new(0.2, 0.0, 1.0))),
        ),
        (
            Surface::Sphere(Sphere::new(centre, 1.5)),
            Surface::Sphere(Sphere::new(Point::new(0.0, 0.0, 0.0), 1.3)),
        ),
        (
            Surface::Cylinder(Cylinder::new(centre, axis(), 1.5)),
            Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 1.3)),
        ),
        (
            Surface::Cone(Cone::new(centre - axis() * 4.0, axis(), 0.35)),
            Surface::Cone(Cone::new(centre - axis() * 3.5, Vector::z(), 0.3)),
        ),
        (
            Surface::Torus(Torus::new(centre, axis(), 2.0, 0.5)),
            Surface::Torus(Torus::new(
                Point::new(0.15, 0.15, -0.25),
                Vector::new(0.25, -0.2, 1.0),
                1.95,
                0.52,
            )),
        ),
    ];
    pairs
        .into_iter()
        .map(|(truth, start)| {
            let points = on(&truth, [0.8, -0.6, -1.0], [2.0, 0.6, 1.0]);
            (truth, start, points)
        })
        .collect()
}

#[test]
fn exact_points_give_the_exact_surface_of_every_family() {
    for (truth, start, points) in exact_cases() {
        let fitted = fit(&start, &points, Loss::Squares).unwrap();
        assert!(fitted.error < 1e-12, "{truth:?}: {fitted:?}");
        assert!(
            apart(&fitted.surface, &truth, &points) < 1e-9,
            "{truth:?}: {fitted:?}"
        );
    }
}

#[test]
fn far_from_the_origin_and_at_any_size_the_fit_is_as_good() {
    let motion = Isometry3::translation(1e4, -2e4, 3e4);
    for (truth, start, points) in exact_cases() {
        for size in [1e-2, 1e3] {
            let place = |s: &Surface| s.scaled(size).moved(&motion);
            let points: Vec<Point> = points.iter().map(|p| motion * (p * size)).collect();
            let fitted = fit(&place(&start), &points, Loss::Squares).unwrap();
            // Coordinates of 3e4 are themselves rounded to 4e-12.
            assert!(apart(&fitted.surface, &place(&truth), &points) < 1e-9 * (1.0 + size));
        }
    }
}

#[test]
fn outliers_have_no_say_under_the_biweight() {
    for (truth, start, mut points) in exact_cases() {
        let exact = points.len();
        points.extend(
            (0..20).map(|i| Point::new(f64::from(i) * 0.1, 8.0, 5.0 + f64::from(i) * 0.05)),
        );
        let near = fit(&start, &points[..exact], Loss::Squares)
            .unwrap()
            .surface;
        let fitted = fit(&near, &points, Loss::Biweight(0.2)).unwrap();
        assert!(
            apart(&fitted.surface, &truth, &points[..exact]) < 1e-6,
            "{truth:?} {fitted:?}"
        );
    }
}

/// Two circles of radii 1 ± e about one axis: the least-squares cylinder has radius 1 and every
/// point is off by e, by symmetry.
#[test]
fn the_cylinder_between_two_circles_has_the_mean_radius() {
    let off = 0.01;
    let points: Vec<Point> = (0..48)
        .flat_map(|i| {
            let turn = f64::from(i) * std::f64::consts::TAU / 48.0;
            // Either circle at both ends, so that no cone fits better.
            let side = if i % 2 == 0 { off } else { -off };
            [1.0 + side, 1.0 - side]
                .into_iter()
                .zip([-1.0, 1.0])
                .map(move |(r, z)| Point::new(r * turn.cos(), r * turn.sin(), z))
        })
        .collect();
    let start = Surface::Cylinder(Cylinder::new(Point::new(0.1, 0.0, 0.0), axis(), 0.8));
    let fitted = fit(&start, &points, Loss::Squares).unwrap();
    let Surface::Cylinder(found) = fitted.surface else {
        panic!("not a cylinder");
    };
    assert!((found.radius - 1.0).abs() < 1e-7 && found.centre.coords.norm() < 1e-7);
    assert!((fitted.error - off).abs() < 1e-7);
}

/// The corners of a cube with edge 2, pushed out by e along their diagonals on one pair of
/// opposite corners: r = √3 + e/4, every term of the gradient in closed form.
#[test]
fn the_sphere_through_a_stretched_cube_has_the_mean_distance_as_radius() {
    let off = 0.05;
    let points: Vec<Point> = (0..8)
        .map(|i| {
            let sign = |bit: i32| if i & bit == 0 { -1.0 } else { 1.0 };
            let corner = Vector::new(sign(1), sign(2), sign(4));
            let length = 3f64.sqrt() + if i == 0 || i == 7 { off } else { 0.0 };
            Point::from(corner.normalize() * length)
        })
        .collect();
    let start = Surface::Sphere(Sphere::new(Point::new(0.1, -0.2, 0.1), 1.5));
    let Surface::Sphere(found) = fit(&start, &points, Loss::Squares).unwrap().surface else {
        panic!("not a sphere");
    };
    // By symmetry the centre stays, so the radius is the mean distance from it.
    assert!(found.centre.coords.norm() < 1e-7);
    assert!((found.radius - (3f64.sqrt() + off / 4.0)).abs() < 1e-7);
}

#[test]
fn a_cone_is_found_from_the_cylinder_that_nearly_fits_it() {
    let truth = Cone::new(Point::new(0.0, 0.0, -8.0), Vector::z(), 0.15);
    let points = on(&Surface::Cone(truth), [0.5, -1.0, -1.0], [1.5, 1.0, 1.0]);
    let cylinder = Cylinder::new(Point::origin(), Vector::z(), 1.2);
    let near = fit_cone_near(&cylinder, &points, Loss::Squares).unwrap();
    let fitted = fit(&near.surface, &points, Loss::Squares).unwrap();
    assert!(apart(&fitted.surface, &Surface::Cone(truth), &points) < 1e-9);
}

#[test]
fn too_few_or_coinciding_points_determine_nothing() {
    for (_, start, points) in exact_cases() {
        let few = degrees_of_freedom(start.kind()) - 1;
        assert_eq!(fit(&start, &points[..few], Loss::Squares), None);
        assert_eq!(fit(&start, &[Point::origin(); 20], Loss::Squares), None);
    }
}

/// Some thirty points of a torus, within a tenth of the tube of one of its points, tell which torus it
/// is as long as they are exact. The starts bend as the patch does at one point and are no nearer.
#[test]
fn a_small_patch_of_a_torus_leads_to_the_whole() {
    let truth = Torus::new(Point::origin(), Vector::z(), 20.0, 5.0);
    let at = |u: f64, v: f64| {
        let reach = 20.0 + 5.0 * v.cos();
        Point::new(reach * u.cos(), reach * u.sin(), 5.0 * v.sin())
    };
    for latitude in [-2.4, -0.9, 0.0, 0.7, 1.5, 2.2] {
        let patch: Vec<Point> = (0..30)
            .map(|i| {
                let (x, y) = (f64::from(i % 6) - 2.5, f64::from(i / 6) - 2.0);
                // Rows out of line, or cones and tori of other axes pass through them too.
                at(
                    0.005 * (x + 0.3 * y * y),
                    latitude + 0.04 * (y + 0.2 * x * x),
                )
            })
            .collect();
        let found = local::starts(SurfaceType::Torus, &patch)
            .iter()
            .filter_map(|start| fit(start, &patch, Loss::Squares))
            .min_by(|a, b| a.error.total_cmp(&b.error));
        let Some(Surface::Torus(found)) = found.map(|fitted| fitted.surface) else {
            panic!("no torus at {latitude}");
        };
        let off = (found.major_radius - truth.major_radius).abs()
            + (found.minor_radius - truth.minor_radius).abs()
            + (found.centre - truth.centre).norm();
        assert!(off < 1e-5, "{off} at {latitude}: {found:?}");
    }
}
