//! SHREC 2022's tables: is each segment recognised as what it is, and how well is it fitted (Romanengo,
//! Raffo, Biasotti, Falcidieno and others 2022).
//!
//! There a cloud is one primitive. Here every true primitive is a segment, and its answer is the
//! predicted primitive matched to it one to one by IoU: on clouds of one segment and one answer the two
//! readings are the same.

use super::geometry::{Lengths, Normalisation};
use super::segmentation::assignment::most_iou;
use super::segmentation::overlaps::Overlaps;
use crate::cloud::{Cloud, Direction};
use crate::model::{Primitive, Segmentation};
use crate::surface::{Surface, SurfaceType};

/// What is to be known about the tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RecognitionInfo {
    /// Name by which they are asked for.
    pub key: &'static str,
    /// What they are called.
    pub title: &'static str,
    /// What is computed.
    pub definition: &'static str,
    /// In one sentence, what kind of answer they reward.
    pub rewards: &'static str,
    /// What one has to know before comparing.
    pub trap: &'static str,
    /// Where the rules are read off.
    pub source: &'static str,
}

/// The tables in words.
pub const INFO: RecognitionInfo = RecognitionInfo {
    key: "shrec2022",
    title: "SHREC 2022",
    definition: "Every true primitive is a segment, its answer the primitive matched one to one by IoU. Of \
                 the answered types PPV, NPV, TPR, TNR and ACC, each type against the rest and the mean over \
                 types; of the answered surface the mean (MFE) and the largest distance (directed Hausdorff) \
                 of the segment's points, and the L2 distance of the parameters.",
    rewards: "Telling every type equally well, the rare as much as the common, and surfaces near their \
              points.",
    trap: "TNR and ACC are high for any method: of five types four are rightly denied. L2 counts only where \
           the type is right, adds lengths, angles and directions, leaves out where planes and cylinders \
           stand, and turns an axis by the sign of one coordinate: its means explode, its medians do not. \
           A rate without a case, PPV of a type that was never answered, is left out of the mean, where the \
           original gives no number.",
    source: "rea1991/SHREC2022_evaluation, results/classification_measures.py and fitting_measures_L2.py, \
             _MFE.py, _Haus_analysis.py",
};

/// A true primitive as a segment of its own, and what was answered.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// Its number in the file.
    pub number: u32,
    /// Its type, where it is one of the five.
    pub kind: Option<SurfaceType>,
    /// The type that was answered; `None` for another or no answer.
    pub answer: Option<SurfaceType>,
    /// Mean distance of its points to the answered surface, over the unit of length.
    pub mfe: Option<f64>,
    /// Largest distance of its points to the answered surface, over the unit of length.
    pub hausdorff: Option<f64>,
    /// Euclidean distance of the answered from the true parameters, in mixed units; `None` of different
    /// types.
    pub parameters: Option<f64>,
}

/// Sets every true primitive beside its answer, in the order of the file. `None` where the lists are so
/// entangled that they cannot be matched (see [`most_iou`]). O(listed points) beside the matching.
pub fn recognise(
    cloud: &Cloud,
    truth: &Segmentation,
    predicted: &Segmentation,
    normalisation: Normalisation,
) -> Option<Vec<Segment>> {
    let overlaps = Overlaps::of(cloud.len(), truth, predicted)?;
    let partners = most_iou(&overlaps, &|_| true)?;
    let lengths = Lengths::of(cloud, normalisation);
    let rows = truth.primitives.iter().zip(partners);
    let segments = rows.map(|(primitive, partner)| {
        let answer = partner.and_then(|partner| predicted.primitives.get(partner.predicted));
        let surface = answer.and_then(|answer| answer.surface);
        let fit = surface.and_then(|surface| {
            let distances = distances(cloud, primitive, &surface)?;
            let unit = lengths.of_primitive(cloud, primitive)?;
            Some(distances.map(|distance| distance / unit))
        });
        let both = primitive.surface.zip(surface);
        Segment {
            number: primitive.number,
            kind: primitive.kind,
            answer: answer.and_then(|answer| answer.kind),
            mfe: fit.map(|[mean, _]| mean),
            hausdorff: fit.map(|[_, largest]| largest),
            parameters: both.and_then(|(own, other)| parameter_distance(&own, &other)),
        }
    });
    Some(segments.collect())
}

/// Mean and largest distance of a primitive's points to a surface; `None` without points or where the
/// numbers overflow.
fn distances(cloud: &Cloud, primitive: &Primitive, surface: &Surface) -> Option<[f64; 2]> {
    let points = primitive.points.iter();
    let known = points.filter_map(|&index| cloud.points().get(index as usize));
    let (mut sum, mut largest, mut count) = (0.0, 0.0f64, 0u32);
    for point in known {
        let distance = surface.distance(point);
        sum += distance;
        largest = largest.max(distance);
        count += 1;
    }
    let is_known = count > 0 && f64::is_finite(sum);
    is_known.then(|| [sum / f64::from(count), largest])
}

/// Euclidean distance of the parameters that SHREC 2022 compares, its directions of one sign: of planes the
/// normal; of cylinders radius and axis; of cones half-angle in radians, axis and apex; of spheres radius
/// and centre; of tori the radii, axis and centre. `None` of different types.
pub fn parameter_distance(truth: &Surface, answer: &Surface) -> Option<f64> {
    let lengths = |one: f64, other: f64| (one - other).powi(2);
    let squares = match (truth, answer) {
        (Surface::Plane(one), Surface::Plane(other)) => directions(&one.normal, &other.normal),
        (Surface::Cylinder(one), Surface::Cylinder(other)) => {
            lengths(one.radius, other.radius) + directions(&one.axis, &other.axis)
        }
        (Surface::Cone(one), Surface::Cone(other)) => {
            lengths(one.half_angle, other.half_angle)
                + directions(&one.axis, &other.axis)
                + (one.apex - other.apex).norm_squared()
        }
        (Surface::Sphere(one), Surface::Sphere(other)) => {
            lengths(one.radius, other.radius) + (one.centre - other.centre).norm_squared()
        }
        (Surface::Torus(one), Surface::Torus(other)) => {
            let ordered = |a: f64, b: f64| (a.min(b), a.max(b));
            let (small, large) = ordered(one.minor_radius, one.major_radius);
            let (slight, wide) = ordered(other.minor_radius, other.major_radius);
            lengths(small, slight)
                + lengths(large, wide)
                + directions(&one.axis, &other.axis)
                + (one.centre - other.centre).norm_squared()
        }
        _ => return None,
    };
    squares.is_finite().then(|| squares.sqrt())
}

/// Squared distance of two unit vectors of which one may point either way: turned so that the first
/// coordinates that are not 0 agree in sign, as the original does.
fn directions(one: &Direction, other: &Direction) -> f64 {
    let mut products = one.iter().zip(other.iter()).map(|(a, b)| a * b);
    let is_opposed = products
        .find(|product| *product != 0.0)
        .is_some_and(|product| product < 0.0);
    let other = other.into_inner();
    let turned = if is_opposed { -other } else { other };
    (one.into_inner() - turned).norm_squared()
}

/// How well types are told, each the mean over the types that occur among segments or answers: a type
/// against all others.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Rates {
    /// Number of segments.
    pub segments: usize,
    /// Positive predictive value: right among what was answered as the type.
    pub ppv: Option<f64>,
    /// Negative predictive value: right among what was answered as another.
    pub npv: Option<f64>,
    /// True positive rate: told among what is of the type.
    pub tpr: Option<f64>,
    /// True negative rate: told among what is of another.
    pub tnr: Option<f64>,
    /// Accuracy: right among all.
    pub acc: Option<f64>,
}

impl Rates {
    /// Counts pairs of a true and an answered type; an answer of `None` is wrong. A rate without a case
    /// is left out of the mean over types. O(pairs).
    pub fn of(pairs: &[(SurfaceType, Option<SurfaceType>)]) -> Self {
        let all = pairs.len();
        let of_type = |kind: SurfaceType| {
            let is = |wanted: fn(bool, bool) -> bool| {
                let counted = pairs.iter();
                counted
                    .filter(|(truth, answer)| wanted(*truth == kind, *answer == Some(kind)))
                    .count()
            };
            let (hits, invented) = (is(|it, told| it && told), is(|it, told| !it && told));
            let (missed, denied) = (is(|it, told| it && !told), is(|it, told| !it && !told));
            let share = |part: usize, whole: usize| (whole > 0).then(|| part as f64 / whole as f64);
            (hits + invented + missed > 0).then(|| {
                [
                    share(hits, hits + invented),
                    share(denied, denied + missed),
                    share(hits, hits + missed),
                    share(denied, denied + invented),
                    share(hits + denied, all),
                ]
            })
        };
        let of_types: Vec<[Option<f64>; 5]> =
            SurfaceType::ALL.into_iter().filter_map(of_type).collect();
        let mean = |of: fn(&[Option<f64>; 5]) -> Option<f64>| super::mean(of_types.iter().map(of));
        Self {
            segments: all,
            ppv: mean(|[ppv, ..]| *ppv),
            npv: mean(|[_, npv, ..]| *npv),
            tpr: mean(|[_, _, tpr, ..]| *tpr),
            tnr: mean(|[.., tnr, _]| *tnr),
            acc: mean(|[.., acc]| *acc),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::{Point, Vector};
    use crate::surface::{Cone, Cylinder, Plane, Sphere, Torus};

    use SurfaceType::{Cone as CONE, Cylinder as CYLINDER, Plane as PLANE};

    fn close(found: Option<f64>, expected: f64) {
        let found = found.unwrap();
        assert!((found - expected).abs() < 1e-12, "{found}, not {expected}");
    }

    #[test]
    fn rates_are_those_of_the_table_of_confusions() {
        // True planes: 3 told, 1 taken for a cylinder. True cylinders: 1 told, 1 for a plane. One cone,
        // without an answer.
        let pairs = [
            (PLANE, Some(PLANE)),
            (PLANE, Some(PLANE)),
            (PLANE, Some(PLANE)),
            (PLANE, Some(CYLINDER)),
            (CYLINDER, Some(CYLINDER)),
            (CYLINDER, Some(PLANE)),
            (CONE, None),
        ];
        let rates = Rates::of(&pairs);
        assert_eq!(rates.segments, 7);
        // Nothing was answered as a cone.
        close(rates.ppv, (3.0 / 4.0 + 1.0 / 2.0) / 2.0);
        close(rates.npv, (2.0 / 3.0 + 4.0 / 5.0 + 6.0 / 7.0) / 3.0);
        close(rates.tpr, (3.0 / 4.0 + 1.0 / 2.0 + 0.0) / 3.0);
        close(rates.tnr, (2.0 / 3.0 + 4.0 / 5.0 + 1.0) / 3.0);
        close(rates.acc, (5.0 / 7.0 + 5.0 / 7.0 + 6.0 / 7.0) / 3.0);
        assert_eq!(Rates::of(&[]), Rates::default());
        let right = Rates::of(&[(PLANE, Some(PLANE)), (CONE, Some(CONE))]);
        let one = Some(1.0);
        assert_eq!(
            [right.ppv, right.npv, right.tpr, right.tnr, right.acc],
            [one; 5]
        );
    }

    #[test]
    fn parameters_are_compared_as_the_track_does() {
        let (origin, up, tilted) = (Point::origin(), Vector::z(), Vector::new(0.0, 0.6, 0.8));
        let between = (0.6f64.powi(2) + 0.2f64.powi(2)).sqrt();
        let shifted = Point::new(0.0, 0.0, 2.0);
        let cases: [(Surface, Surface, f64); 6] = [
            // Where a plane stands and which way it looks do not count.
            (
                Surface::Plane(Plane::new(origin, up)),
                Surface::Plane(Plane::new(shifted, -tilted)),
                between,
            ),
            (
                Surface::Cylinder(Cylinder::new(origin, up, 1.0)),
                Surface::Cylinder(Cylinder::new(Point::new(9.0, 0.0, 0.0), up, 1.5)),
                0.5,
            ),
            (
                Surface::Cone(Cone::new(origin, up, 0.5)),
                Surface::Cone(Cone::new(shifted, up, 0.5)),
                2.0,
            ),
            (
                Surface::Sphere(Sphere::new(origin, 1.0)),
                Surface::Sphere(Sphere::new(shifted, 2.5)),
                2.5,
            ),
            (
                Surface::Torus(Torus::new(origin, up, 3.0, 1.0)),
                Surface::Torus(Torus::new(origin, -up, 3.0, 1.0)),
                0.0,
            ),
            (
                Surface::Torus(Torus::new(origin, up, 3.0, 1.0)),
                Surface::Torus(Torus::new(origin, up, 6.0, 5.0)),
                5.0,
            ),
        ];
        for (truth, answer, expected) in cases {
            close(parameter_distance(&truth, &answer), expected);
        }
        let (plane, sphere) = (cases[0].0, cases[3].0);
        assert_eq!(parameter_distance(&plane, &sphere), None);
    }

    #[test]
    fn a_segment_is_told_and_measured_by_the_answer_that_shares_its_points() {
        let floor = (0..100).map(|k| Point::new(f64::from(k % 10), f64::from(k / 10), 0.0));
        let lid = (0..100).map(|k| Point::new(f64::from(k % 10), f64::from(k / 10), 5.0));
        let cloud = Cloud::new(floor.chain(lid).collect());
        let plane =
            |height: f64| Surface::Plane(Plane::new(Point::new(0.0, 0.0, height), Vector::z()));
        let truth = Segmentation {
            primitives: vec![
                Primitive::on(plane(0.0), 1, (0..100).collect()),
                Primitive::on(plane(5.0), 2, (100..200).collect()),
            ],
        };
        let sphere = Surface::Sphere(Sphere::new(Point::new(4.5, 4.5, 1000.0), 995.0));
        let answers = Segmentation {
            primitives: vec![
                Primitive::on(sphere, 1, (100..200).collect()),
                Primitive::on(plane(0.5), 2, (0..100).collect()),
            ],
        };
        let found = recognise(&cloud, &truth, &answers, Normalisation::Nothing).unwrap();
        let [floor, lid] = &found[..] else {
            panic!("two segments, not {found:?}");
        };
        assert_eq!((floor.number, floor.answer), (1, Some(PLANE)));
        close(floor.mfe, 0.5);
        close(floor.hausdorff, 0.5);
        close(floor.parameters, 0.0);
        assert_eq!(lid.answer, Some(SurfaceType::Sphere));
        assert_eq!(lid.parameters, None);
        // The corners: √(995² + 2 · 4.5²) − 995.
        close(lid.hausdorff, (995f64.powi(2) + 40.5).sqrt() - 995.0);
        let own = recognise(&cloud, &truth, &answers, Normalisation::Primitive).unwrap();
        close(own[0].mfe, 0.5 / 162f64.sqrt());
        let nothing = recognise(
            &cloud,
            &truth,
            &Segmentation::default(),
            Normalisation::Cloud,
        );
        for segment in nothing.unwrap() {
            assert_eq!((segment.answer, segment.mfe), (None, None));
        }
    }
}
