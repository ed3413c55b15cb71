//! Orthogonal least squares of perturbed points against minima found in extended precision.
//!
//! The points lie up to a few hundredths off a surface of their family and are rounded to two
//! decimals. The minimum of Σ d² was found apart from this crate, in decimal arithmetic of 160 digits
//! and in global coordinates (the axis as (a, b, 1), a point of it, the lengths): Levenberg-Marquardt
//! near it, then Newton's method with the full Hessian, until the gradient was below 1e-60. The
//! Hessian is positive definite there. Canonical parameters are given to the precision of `f64`.

use super::*;

/// Farthest a parameter may be from that of the reference.
const AGREEMENT: f64 = 1e-7;

/// Position, axis, then lengths or angle: the canonical parameters in a row.
fn parameters(surface: &Surface) -> Vec<f64> {
    let row = |point: &Point, axis: &Vector, rest: &[f64]| {
        let all = point.iter().chain(axis.iter()).chain(rest);
        all.copied().collect()
    };
    match surface {
        Surface::Plane(plane) => vec![plane.normal.x, plane.normal.y, plane.normal.z, plane.offset],
        Surface::Sphere(s) => vec![s.centre.x, s.centre.y, s.centre.z, s.radius],
        Surface::Cylinder(s) => row(&s.centre, &s.axis, &[s.radius]),
        Surface::Cone(s) => row(&s.apex, &s.axis, &[s.half_angle]),
        Surface::Torus(s) => row(&s.centre, &s.axis, &[s.major_radius, s.minor_radius]),
    }
}

/// The fit from `start` has the parameters and the root mean square distance of the reference.
fn assert_minimum(start: &Surface, points: &[[f64; 3]], expected: &[f64], error: f64) {
    let points: Vec<Point> = points.iter().map(|&point| Point::from(point)).collect();
    let fitted = fit(start, &points, Loss::Squares).unwrap();
    let found = parameters(&fitted.surface);
    assert_eq!(found.len(), expected.len());
    let off = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
    let off = off.fold(0.0, f64::max);
    assert!(off < AGREEMENT, "off by {off:e}: {found:?}");
    assert!((fitted.error - error).abs() < AGREEMENT, "{fitted:?}");
}

#[test]
fn the_plane_is_the_minimum_of_extended_precision() {
    let start = Surface::Plane(Plane::new(
        Point::new(0.0, 0.0, 1.4),
        Vector::new(0.3, -0.2, 1.0),
    ));
    let points = [
        [-0.42, -1.92, 0.95],
        [0.12, -0.68, 1.07],
        [0.71, 0.85, 1.4],
        [1.3, 0.64, 0.94],
        [0.44, -2.19, 0.4],
        [1.73, -0.48, 0.39],
        [1.18, -1.27, 0.34],
        [-0.43, -2.28, 0.73],
        [-0.56, 1.32, 2.14],
        [-0.72, 0.31, 1.84],
        [0.31, -1.09, 0.87],
        [1.72, 0.21, 0.6],
        [0.39, -1.59, 0.63],
        [0.51, -0.6, 0.95],
    ];
    let expected = [
        0.4200647790876442,
        -0.3073013610575741,
        0.8538802344955709,
        1.1890680611579747,
    ];
    assert_minimum(&start, &points, &expected, 0.025172999022151185);
}

#[test]
fn the_sphere_is_the_minimum_of_extended_precision() {
    let start = Surface::Sphere(Sphere::new(Point::new(1.1, -0.5, 1.9), 1.8));
    let points = [
        [0.6, -1.24, 3.52],
        [0.2, -0.15, 3.17],
        [2.39, 0.09, 2.96],
        [0.74, -1.14, 3.5],
        [2.89, -0.55, 2.14],
        [0.82, 0.09, 3.33],
        [2.61, 0.16, 2.59],
        [-0.1, -1.33, 2.41],
        [0.12, -0.66, 3.25],
        [-0.24, -0.51, 2.34],
        [0.08, -1.42, 2.79],
        [0.42, -1.12, 3.42],
        [0.82, 0.41, 3.17],
        [-0.12, -1.4, 2.32],
        [0.53, -0.44, 3.5],
        [1.7, 0.59, 3.0],
    ];
    let expected = [
        1.3156951271902244,
        -0.7095314306551405,
        2.1415805585657446,
        1.5902949124744878,
    ];
    assert_minimum(&start, &points, &expected, 0.03267561407912832);
}

#[test]
fn the_cylinder_is_the_minimum_of_extended_precision() {
    let start = Surface::Cylinder(Cylinder::new(
        Point::new(1.9, -1.1, 0.0),
        Vector::new(0.3, 0.3, 1.0),
        1.1,
    ));
    let points = [
        [0.69, -1.35, 0.51],
        [1.67, -0.07, -0.76],
        [1.39, -0.48, 2.53],
        [0.82, -1.77, 0.33],
        [2.02, 0.41, 0.98],
        [1.42, -2.42, -0.08],
        [2.27, -1.93, 1.7],
        [2.27, -1.8, 2.33],
        [1.35, -0.38, 2.39],
        [0.89, -0.46, 0.72],
        [2.31, -1.94, 1.62],
        [1.57, -2.3, 0.26],
        [1.54, 0.22, 1.33],
        [1.46, -2.44, 0.02],
        [1.41, 0.13, 0.46],
        [0.59, -1.76, -0.01],
        [2.67, -1.78, 2.06],
        [0.59, -1.73, 0.08],
    ];
    let expected = [
        1.7007097094571628,
        -1.208985877049978,
        -0.2635487229784306,
        0.3236735904922963,
        0.2568050843317957,
        0.9106517201867926,
        1.234732528849044,
    ];
    assert_minimum(&start, &points, &expected, 0.023771100780124035);
}

#[test]
fn the_cone_is_the_minimum_of_extended_precision() {
    let start = Surface::Cone(Cone::new(
        Point::new(-0.6, 0.9, 1.4),
        Vector::new(1.0, 0.45, -0.4),
        0.42,
    ));
    let points = [
        [1.01, 2.05, -0.37],
        [2.6, 1.92, 1.76],
        [2.67, 1.35, 1.52],
        [1.74, 1.68, 1.72],
        [2.4, 1.09, 1.34],
        [0.76, 1.35, 1.53],
        [1.36, 3.13, -0.49],
        [2.2, 0.98, 1.19],
        [2.56, 0.7, 0.52],
        [0.63, 0.78, 1.08],
        [1.29, 0.79, 0.84],
        [0.78, 1.75, -0.24],
        [1.01, 2.66, -0.32],
        [1.72, 1.69, 1.73],
        [0.39, 1.65, 0.32],
        [0.97, 0.98, 0.19],
        [1.08, 2.81, -0.35],
        [0.8, 1.25, 0.1],
        [1.72, 0.73, 0.67],
        [0.38, 1.35, 0.32],
    ];
    let expected = [
        -0.5065354165496228,
        0.8578186818381239,
        1.3842139956377657,
        0.8548915592460193,
        0.4048192504401667,
        -0.3244715648604225,
        0.46950503610043315,
    ];
    assert_minimum(&start, &points, &expected, 0.029386726469920358);
}

#[test]
fn the_torus_is_the_minimum_of_extended_precision() {
    let start = Surface::Torus(Torus::new(
        Point::new(0.5, 1.5, -1.0),
        Vector::new(0.3, 1.0, -0.2),
        2.1,
        0.75,
    ));
    let points = [
        [-0.48, 2.06, -2.83],
        [0.22, 1.78, -2.97],
        [-0.46, 1.47, -3.73],
        [-0.43, 2.89, 0.87],
        [-0.11, 0.53, -3.46],
        [-1.93, 2.39, -1.96],
        [-1.06, 1.62, -1.08],
        [-0.01, 2.78, 1.17],
        [-0.87, 2.2, -1.69],
        [-0.64, 2.01, -0.21],
        [-0.86, 0.82, -3.25],
        [0.35, 1.54, -2.59],
        [-1.79, 1.29, -1.53],
        [1.24, 2.06, 0.44],
        [0.04, 2.51, 1.69],
        [-1.43, 2.71, -1.17],
        [-0.58, 1.86, -3.47],
        [-1.55, 2.75, -1.12],
        [1.33, 1.68, 0.25],
        [-1.01, 2.46, -1.35],
    ];
    let expected = [
        0.5405619350379575,
        1.4907484034434,
        -1.0079826767932587,
        0.2569245069943978,
        0.9433633417584348,
        -0.20989379012263362,
        2.2180649604504112,
        0.7056962560970549,
    ];
    assert_minimum(&start, &points, &expected, 0.023422132126161132);
}
