//! Standard errors against how far fits to many samples are apart.

use super::*;
use crate::fit::least_squares::{Loss, fit};
use crate::random::Random;
use crate::surface::{Cone, Cylinder, Sphere, Torus};

const SAMPLES: usize = 200;
const NOISE: f64 = 0.01;

/// A surface of each family, and the box whose points' feet are on the part of it that is seen.
fn parts() -> Vec<(Surface, [f64; 3], [f64; 3])> {
    let centre = Point::new(40.0, -20.0, 30.0);
    let axis = Vector::new(0.3, -0.2, 1.0);
    let at = |x: f64, y: f64, z: f64| [centre.x + x, centre.y + y, centre.z + z];
    vec![
        (
            Surface::Plane(Plane::new(centre, axis)),
            at(-1.0, -2.0, -0.1),
            at(1.0, 2.0, 0.1),
        ),
        (
            Surface::Cylinder(Cylinder::new(centre, axis, 1.5)),
            at(0.8, -1.0, -1.5),
            at(2.0, 1.0, 1.5),
        ),
        (
            Surface::Cone(Cone::new(centre - axis * 4.0, axis, 0.35)),
            at(0.8, -1.0, -1.0),
            at(2.0, 1.0, 1.0),
        ),
        (
            Surface::Sphere(Sphere::new(centre, 1.5)),
            at(0.2, -1.0, -1.0),
            at(2.0, 1.0, 1.0),
        ),
        (
            Surface::Torus(Torus::new(centre, axis, 2.0, 0.5)),
            at(0.8, -1.2, -0.7),
            at(2.7, 1.2, 0.7),
        ),
    ]
}

/// Points of a part with normal noise.
fn sample(part: &(Surface, [f64; 3], [f64; 3]), count: usize, seed: u64) -> Vec<Point> {
    let (surface, from, to) = part;
    let mut random = Random::new(seed, 0);
    let mut within = |axis: usize| from[axis] + (to[axis] - from[axis]) * random.unit();
    let boxed: Vec<Point> = (0..count)
        .map(|_| Point::new(within(0), within(1), within(2)))
        .collect();
    let feet = boxed.iter().map(|point| surface.foot(point));
    feet.map(|foot| {
        let mut noise = || NOISE * random.normal();
        foot + Vector::new(noise(), noise(), noise())
    })
    .collect()
}

/// What is estimated: as the errors list it, with the position where an axis or a plane passes a point.
fn estimates(surface: &Surface, middle: &Point) -> [Option<Vector>; 6] {
    let number = |value: f64| Some(Vector::new(value, 0.0, 0.0));
    match *surface {
        Surface::Plane(it) => {
            let normal = it.normal.into_inner();
            let off = middle.coords.dot(&normal) - it.offset;
            let foot = middle.coords - normal * off;
            [
                Some(normal),
                Some(foot),
                number(it.offset),
                None,
                None,
                None,
            ]
        }
        Surface::Cylinder(it) => {
            let axis = it.axis.into_inner();
            let foot = it.centre + axis * (middle - it.centre).dot(&axis);
            [
                Some(axis),
                Some(foot.coords),
                None,
                number(it.radius),
                None,
                None,
            ]
        }
        Surface::Cone(it) => {
            let axis = it.axis.into_inner();
            [
                Some(axis),
                Some(it.apex.coords),
                None,
                None,
                None,
                number(it.half_angle),
            ]
        }
        Surface::Sphere(it) => [
            None,
            Some(it.centre.coords),
            None,
            number(it.radius),
            None,
            None,
        ],
        Surface::Torus(it) => {
            let (major, minor) = (number(it.major_radius), number(it.minor_radius));
            [
                Some(it.axis.into_inner()),
                Some(it.centre.coords),
                None,
                major,
                minor,
                None,
            ]
        }
    }
}

/// Root mean square distance of some estimates from their mean.
fn spread(estimates: &[Vector]) -> f64 {
    let count = estimates.len() as f64;
    let mean = estimates.iter().sum::<Vector>() / count;
    let squares = estimates.iter().map(|it| (it - mean).norm_squared());
    (squares.sum::<f64>() / (count - 1.0)).sqrt()
}

/// Compares the standard errors of many samples with how their fits scatter.
fn assert_agreement(outliers: bool) {
    for part in parts() {
        let (truth, ..) = part;
        let middle = sample(&part, 4000, 999)
            .iter()
            .map(|it| it.coords)
            .sum::<Vector>()
            / 4000.0;
        let (mut found, mut said) = (Vec::new(), Vec::new());
        for seed in 0..SAMPLES as u64 {
            let mut points = sample(&part, 400, seed);
            let mut loss = Loss::Squares;
            if outliers {
                // Beside the surface, on one side.
                let off = points.iter().step_by(8).map(|point| {
                    let normal = truth.normal(point).into_inner();
                    truth.foot(point) + normal * (20.0 * NOISE)
                });
                let off: Vec<Point> = off.collect();
                points.extend(off);
                loss = Loss::Biweight(BIWEIGHT * NOISE);
            }
            let fitted = fit(&truth, &points, loss).unwrap().surface;
            found.push(estimates(&fitted, &Point::from(middle)));
            said.push(StandardErrors::of(&fitted, &points).values());
        }
        for parameter in 0..6 {
            let own: Vec<Vector> = found.iter().filter_map(|it| it[parameter]).collect();
            let errors: Vec<f64> = said.iter().filter_map(|it| it[parameter]).collect();
            assert_eq!(own.len(), errors.len(), "{truth:?} {parameter}");
            if own.is_empty() {
                continue;
            }
            let squares = errors.iter().map(|error| error * error).sum::<f64>();
            let expected = (squares / errors.len() as f64).sqrt();
            let ratio = spread(&own) / expected;
            assert!((ratio - 1.0).abs() < 0.2, "{truth:?} {parameter}: {ratio}");
        }
    }
}

#[test]
fn fits_to_many_samples_scatter_as_their_standard_errors_say() {
    assert_agreement(false);
}

#[test]
fn outliers_change_nothing_about_that() {
    assert_agreement(true);
}

#[test]
fn of_exact_points_they_are_at_the_level_of_rounding() {
    for part in parts() {
        let points = sample(&part, 400, 1);
        let feet: Vec<Point> = points.iter().map(|point| part.0.foot(point)).collect();
        let errors = StandardErrors::of(&part.0, &feet);
        assert!(errors.position.is_some_and(|it| it < 1e-12), "{errors:?}");
    }
}

#[test]
fn what_the_points_do_not_determine_has_none() {
    // One circle: of the cylinders through it the radius is sure and the axis is not.
    let cylinder = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 2.0));
    let circle = (0..60).map(|i| {
        let turn = f64::from(i) * std::f64::consts::TAU / 60.0;
        let off = if i % 3 == 0 { 2.01 } else { 1.995 };
        Point::new(off * turn.cos(), off * turn.sin(), 0.0)
    });
    let errors = StandardErrors::of(&cylinder, &circle.collect::<Vec<_>>());
    assert_eq!(errors.axis, None);
    assert!(errors.radius.is_some_and(|it| it.is_finite()));
    // Points on a line are on any plane along it.
    let plane = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
    let line = (0..20).map(|i| Point::new(f64::from(i), 0.0, 0.01 * f64::from(i % 2)));
    let errors = StandardErrors::of(&plane, &line.collect::<Vec<_>>());
    assert_eq!(errors.axis, None);
    for few in [0, 1, 3] {
        let points = vec![Point::new(1.0, 2.0, 3.0); few];
        assert_eq!(
            StandardErrors::of(&plane, &points),
            StandardErrors::default()
        );
        assert_eq!(
            StandardErrors::of(&cylinder, &points),
            StandardErrors::default()
        );
    }
    let broken = vec![Point::new(f64::NAN, f64::INFINITY, 1e300); 40];
    assert_eq!(
        StandardErrors::of(&plane, &broken),
        StandardErrors::default()
    );
}
