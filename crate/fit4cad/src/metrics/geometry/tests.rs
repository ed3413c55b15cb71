use super::super::segmentation::Overlaps;
use super::super::segmentation::assignment::most_iou;
use super::*;
use crate::cloud::Vector;
use crate::surface::{Cylinder, Plane, Sphere};

/// A square of 21 × 21 points of side 2 on the floor, and as many on the wall x = 1 above it.
fn room() -> (Cloud, Segmentation) {
    let grid = || (0..441).map(|k| (f64::from(k % 21) * 0.1 - 1.0, f64::from(k / 21) * 0.1));
    let floor = grid().map(|(x, y)| Point::new(x, y - 1.0, 0.0));
    let wall = grid().map(|(y, z)| Point::new(1.0, y, z));
    let cloud = Cloud::new(floor.chain(wall).collect());
    let primitives = vec![
        Primitive::on(plane(Vector::z(), 0.0), 1, (0..441).collect()),
        Primitive::on(plane(Vector::x(), 1.0), 2, (441..882).collect()),
    ];
    (cloud, Segmentation { primitives })
}

fn plane(normal: Vector, offset: f64) -> Surface {
    Surface::Plane(Plane::new(Point::from(normal * offset), normal))
}

fn measured(cloud: &Cloud, truth: &Segmentation, found: &Segmentation, scale: Scale) -> Geometry {
    let overlaps = Overlaps::of(cloud.len(), truth, found).unwrap();
    let partners = most_iou(&overlaps, &|_| true).unwrap();
    measure(cloud, truth, found, &partners, scale)
}

fn close(found: Option<f64>, expected: f64) {
    let found = found.unwrap();
    assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
}

const IN_FILE_UNITS: Scale = Scale {
    normalisation: Normalisation::Nothing,
    epsilon: 0.05,
};

#[test]
fn the_truth_fits_itself() {
    let (cloud, truth) = room();
    for normalisation in Normalisation::ALL {
        let scale = Scale {
            normalisation,
            epsilon: 0.01,
        };
        let fit = measured(&cloud, &truth, &truth, scale);
        for share in [fit.p_coverage, fit.s_coverage, fit.type_accuracy] {
            close(share, 1.0);
        }
        let errors = [
            fit.residual,
            fit.residual_rms,
            fit.normal_error,
            fit.axis_error,
        ];
        for error in errors {
            close(error, 0.0);
        }
        assert_eq!((fit.radius_error, fit.angle_error), (None, None));
    }
}

#[test]
fn a_raised_floor_is_as_far_off_as_it_is_raised() {
    let (cloud, truth) = room();
    let mut found = truth.clone();
    found.primitives[0].surface = Some(plane(Vector::z(), 0.2));
    let fit = measured(&cloud, &truth, &found, IN_FILE_UNITS);
    // 0.2 of the floor, 0 of the wall.
    close(fit.residual, 0.1);
    close(fit.residual_rms, 0.1);
    close(fit.s_coverage, 0.5);
    close(fit.normal_error, 0.0);
    // The wall, the row of the floor along it, and nothing else.
    close(fit.p_coverage, (441.0 + 21.0) / 882.0);
}

#[test]
fn lengths_are_told_in_the_unit_that_is_named() {
    let (cloud, truth) = room();
    let mut found = truth.clone();
    for primitive in &mut found.primitives {
        let normal = primitive
            .surface
            .map(|surface| surface.normal(&Point::origin()));
        let (normal, raised) = (
            normal.unwrap().into_inner(),
            cloud.points()[primitive.points[0] as usize],
        );
        primitive.surface = Some(plane(normal, raised.coords.dot(&normal) + 0.2));
    }
    let residual = |normalisation| {
        let scale = Scale {
            normalisation,
            epsilon: 0.01,
        };
        measured(&cloud, &truth, &found, scale).residual
    };
    close(residual(Normalisation::Nothing), 0.2);
    close(residual(Normalisation::UnitCube), 0.1);
    close(residual(Normalisation::Cloud), 0.2 / 12f64.sqrt());
    close(residual(Normalisation::Primitive), 0.2 / 8f64.sqrt());
    // The mean is at (0.5, 0, 0.5); the farthest points are the corners (−1, ±1, 0).
    close(
        residual(Normalisation::UnitSphere),
        0.2 / (2.25f64 + 1.0 + 0.25).sqrt(),
    );
}

#[test]
fn a_turned_plane_is_off_by_the_angle_it_is_turned_by() {
    let (cloud, truth) = room();
    let mut found = truth.clone();
    let tilt = 10f64.to_radians();
    let normal = Vector::new(0.0, libm::sin(tilt), libm::cos(tilt));
    found.primitives[0].surface = Some(plane(normal, 0.0));
    let fit = measured(&cloud, &truth, &found, IN_FILE_UNITS);
    close(fit.normal_error, 5.0);
    close(fit.axis_error, 5.0);
}

#[test]
fn parameters_are_compared_where_the_type_is_right() {
    let (cloud, mut truth) = room();
    let cylinder = |radius| Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), radius));
    truth.primitives[0].surface = Some(cylinder(1.0));
    truth.primitives[0].kind = Some(cylinder(1.0).kind());
    let mut found = truth.clone();
    found.primitives[0].surface = Some(cylinder(1.25));
    let sphere = Surface::Sphere(Sphere::new(Point::origin(), 1.0));
    found.primitives[1].surface = Some(sphere);
    found.primitives[1].kind = Some(sphere.kind());
    let fit = measured(&cloud, &truth, &found, IN_FILE_UNITS);
    close(fit.radius_error, 0.25);
    close(fit.axis_error, 0.0);
    close(fit.type_accuracy, 0.5);
    let plane = Some(crate::surface::SurfaceType::Plane);
    let as_sphere = MatchedType::Type(crate::surface::SurfaceType::Sphere);
    assert_eq!(fit.types.count(plane, as_sphere), 1);
}

#[test]
fn what_is_missed_is_not_covered_and_has_no_residual() {
    let (cloud, truth) = room();
    let mut found = truth.clone();
    found.primitives.truncate(1);
    let fit = measured(&cloud, &truth, &found, IN_FILE_UNITS);
    close(fit.s_coverage, 0.5);
    close(fit.residual, 0.0);
    let nothing = measured(&cloud, &truth, &Segmentation::default(), IN_FILE_UNITS);
    assert_eq!(
        (nothing.s_coverage, nothing.p_coverage),
        (Some(0.0), Some(0.0))
    );
    assert_eq!(nothing.residual, None);
}

#[test]
fn without_surfaces_nothing_is_measured_but_what_types_say() {
    let (cloud, truth) = room();
    let mut found = truth.clone();
    for primitive in &mut found.primitives {
        primitive.surface = None;
    }
    let fit = measured(&cloud, &truth, &found, IN_FILE_UNITS);
    assert_eq!(
        (fit.p_coverage, fit.s_coverage, fit.residual),
        (None, None, None)
    );
    assert_eq!(fit.type_accuracy, Some(1.0));
}

#[test]
fn a_cloud_without_extent_has_no_unit_but_the_files() {
    let cloud = Cloud::new(vec![Point::origin(); 3]);
    let truth = Segmentation {
        primitives: vec![Primitive::on(plane(Vector::z(), 0.0), 1, vec![0, 1, 2])],
    };
    assert_eq!(
        measured(&cloud, &truth, &truth, Scale::default()).residual,
        None
    );
    assert_eq!(
        measured(&cloud, &truth, &truth, IN_FILE_UNITS).residual,
        Some(0.0)
    );
}

#[test]
fn a_normalisation_is_known_by_its_name() {
    for normalisation in Normalisation::ALL {
        assert_eq!(normalisation.name().parse(), Ok(normalisation));
    }
    let unknown: Result<Normalisation, _> = "sphere".parse();
    assert!(unknown.unwrap_err().to_string().contains("unit-sphere"));
}

/// What the field does: so many of a primitive's samples, drawn with a seed.
fn drawn(truth: &Segmentation, count: usize, seed: u64) -> Segmentation {
    let mut random = crate::random::Random::new(seed, 0);
    let mut truth = truth.clone();
    for primitive in &mut truth.primitives {
        random.shuffle(&mut primitive.points);
        primitive.points.truncate(count);
        primitive.points.sort_unstable();
    }
    truth
}

#[test]
fn drawn_samples_scatter_about_the_figures_of_all_which_hang_on_no_seed() {
    let (cloud, truth) = room();
    let mut found = truth.clone();
    let tilt = 3f64.to_radians();
    let normal = Vector::new(0.0, libm::sin(tilt), libm::cos(tilt));
    found.primitives[0].surface = Some(plane(normal, 0.01));
    let overlaps = Overlaps::of(cloud.len(), &truth, &found).unwrap();
    let partners = most_iou(&overlaps, &|_| true).unwrap();
    let figures = |truth: &Segmentation| {
        let fit = measure(&cloud, truth, &found, &partners, IN_FILE_UNITS);
        [fit.residual, fit.residual_rms, fit.s_coverage].map(Option::unwrap)
    };
    let all = figures(&truth);
    // All samples in whatever order: none is drawn, so that every seed gives the same figure, far below
    // the last digit shown (10⁻⁵ of residuals, 10⁻⁴ of coverages).
    for seed in 0..20 {
        let again = figures(&drawn(&truth, usize::MAX, seed));
        for (one, other) in again.iter().zip(all) {
            assert!((one - other).abs() < 1e-12);
        }
    }
    // Half of them are right on average, and each draw shows in the digits.
    let draws: Vec<[f64; 3]> = (0..200)
        .map(|seed| figures(&drawn(&truth, 220, seed)))
        .collect();
    for (place, last_digit) in [1e-5, 1e-5, 1e-4].into_iter().enumerate() {
        let values = || draws.iter().map(|draw| draw[place]);
        let mean = values().sum::<f64>() / 200.0;
        let deviation = (values().map(|it| (it - mean).powi(2)).sum::<f64>() / 199.0).sqrt();
        // Five standard errors of the mean; that of a square root is a little biased.
        let off = (mean - all[place]).abs();
        assert!(off < 5.0 * deviation / 200f64.sqrt() + 1e-4, "{off}");
        assert!(deviation > 10.0 * last_digit, "{deviation}");
    }
}
