//! Cutting regions out of a cloud: missing data where one wants it.

use std::collections::BTreeSet;

use nalgebra::{Point2, Quaternion, UnitQuaternion};

use super::degrade::Worn;
use super::{SampleError, truth_on};
use crate::cloud::{Cloud, Point};
use crate::model::Model;

/// Most corners of a lasso.
pub const MAX_CORNERS: usize = 1000;

/// A part of space whose points are cut away.
#[derive(Debug, Clone, PartialEq)]
pub enum Region {
    /// A ball.
    Ball {
        /// Its centre.
        centre: Point,
        /// Its radius.
        radius: f64,
    },
    /// What a closed curve drawn on a view encloses.
    Lasso(Lasso),
}

/// A polygon in the plane through a camera's target, swept along the lines of sight. It is a region
/// of space like any other: what it cuts depends on no screen.
#[derive(Debug, Clone, PartialEq)]
pub struct Lasso {
    target: Point,
    rotation: UnitQuaternion<f64>,
    eye: f64,
    depth: f64,
    corners: Vec<Point2<f64>>,
}

impl Lasso {
    /// A lasso of a camera at `target` whose axes are turned from the world's by the quaternion
    /// `rotation` (x y z w) and which looks along its negative z axis from a distance of `eye`,
    /// infinite for an orthographic camera. `corners` are x y in the camera's axes; they are joined
    /// first to last and back. Points more than `depth` beyond the target are kept.
    ///
    /// # Errors
    /// [`SampleError::InvalidRegion`] if the numbers describe no camera, or the corners no polygon.
    pub fn new(
        target: [f64; 3],
        rotation: [f64; 4],
        eye: f64,
        depth: f64,
        corners: &[[f64; 2]],
    ) -> Result<Self, SampleError> {
        let invalid = |reason| Err(SampleError::InvalidRegion { reason });
        let finite = |numbers: &[f64]| numbers.iter().all(|x| x.is_finite());
        let [x, y, z, w] = rotation;
        let Some(rotation) = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 1e-3) else {
            return invalid("its camera needs a rotation");
        };
        if !finite(&target) || !finite(rotation.coords.as_slice()) {
            return invalid("its camera's numbers must be finite");
        }
        if eye.is_nan() || eye <= 0.0 || depth.is_nan() {
            return invalid("its camera must be before its target");
        }
        if !(3..=MAX_CORNERS).contains(&corners.len()) || !corners.iter().all(|xy| finite(xy)) {
            return invalid("a lasso has 3 to 1000 corners");
        }
        Ok(Self {
            target: target.into(),
            rotation,
            eye,
            depth,
            corners: corners.iter().copied().map(Point2::from).collect(),
        })
    }

    fn contains(&self, point: &Point) -> bool {
        let seen = self
            .rotation
            .inverse_transform_vector(&(point - self.target));
        if seen.z < -self.depth || seen.z >= self.eye {
            return false;
        }
        // Central projection onto the plane z = 0; the share is 1 for an eye at infinity.
        let scale = 1.0 / (1.0 - seen.z / self.eye);
        let (x, y) = (seen.x * scale, seen.y * scale);
        let last = self.corners.last().copied().unwrap_or_default();
        let mut from = last;
        let mut inside = false;
        for &to in &self.corners {
            if (from.y > y) != (to.y > y)
                && x < from.x + (y - from.y) / (to.y - from.y) * (to.x - from.x)
            {
                inside = !inside;
            }
            from = to;
        }
        inside
    }
}

impl Region {
    /// A ball.
    ///
    /// # Errors
    /// [`SampleError::InvalidRegion`] if a number is not finite, or the radius is negative.
    pub fn ball(centre: [f64; 3], radius: f64) -> Result<Self, SampleError> {
        let usable = radius >= 0.0 && centre.iter().chain([&radius]).all(|x| x.is_finite());
        if !usable {
            return Err(SampleError::InvalidRegion {
                reason: "a ball has a finite centre and a finite radius that is not negative",
            });
        }
        Ok(Self::Ball {
            centre: centre.into(),
            radius,
        })
    }

    fn contains(&self, point: &Point) -> bool {
        match self {
            Self::Ball { centre, radius } => {
                *radius >= 0.0 && (point - centre).norm_squared() <= radius * radius
            }
            Self::Lasso(lasso) => lasso.contains(point),
        }
    }
}

/// The model without the points in a region, and without its submissions. The truth's lists follow;
/// primitives of which no point is left are left out, the others keep their numbers and surfaces.
/// O(points · corners + points listed).
pub fn without(model: &Model, region: &Region) -> Model {
    let points = model.cloud.points();
    let kept: Vec<bool> = points.iter().map(|point| !region.contains(point)).collect();
    let worn = Worn::keeping(points, &kept);
    Model {
        name: model.name.clone(),
        truth: model.truth.as_ref().map(|truth| truth_on(&worn, truth)),
        cloud: Cloud::new(worn.points),
        submissions: Vec::new(),
    }
}

/// What a model has lost when it became another by cutting.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Losses {
    /// How many points.
    pub points: usize,
    /// Numbers of the true primitives that lost their last point.
    pub vanished: Vec<u32>,
}

impl Losses {
    /// Compares a model with what is left of it. O(primitives · log primitives).
    pub fn between(before: &Model, after: &Model) -> Self {
        let numbers = |model: &Model| -> Vec<u32> {
            let truth = model.truth.iter().flat_map(|truth| &truth.primitives);
            truth.map(|primitive| primitive.number).collect()
        };
        let left: BTreeSet<u32> = numbers(after).into_iter().collect();
        let mut vanished = numbers(before);
        vanished.retain(|number| !left.contains(number));
        Self {
            points: before.cloud.len().saturating_sub(after.cloud.len()),
            vanished,
        }
    }
}

/// Fewer points than these leave open what surface they lie on: a torus alone has seven parameters.
pub const FEWEST_POINTS: usize = 10;

/// Numbers of the true primitives with fewer than [`FEWEST_POINTS`] points.
pub fn thin(model: &Model) -> Vec<u32> {
    let truth = model.truth.iter().flat_map(|truth| &truth.primitives);
    let thin = truth.filter(|primitive| primitive.points.len() < FEWEST_POINTS);
    thin.map(|primitive| primitive.number).collect()
}

/// Indices, ascending, of the points that [`without`] would cut away. O(points · corners).
pub fn points_in(model: &Model, region: &Region) -> Vec<u32> {
    let points = (0u32..).zip(model.cloud.points());
    let inside = points.filter(|(_, point)| region.contains(point));
    inside.map(|(index, _)| index).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;
    use crate::model::{Primitive, Segmentation};
    use crate::sample::{Options, farthest_off, generate};

    fn model() -> Model {
        let coarse = Options {
            spacing: 0.03,
            ..Options::default()
        };
        generate("housing", &coarse).unwrap()
    }

    const UPRIGHT: [f64; 4] = [0.0, 0.0, 0.0, 1.0];
    const SQUARE: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

    #[test]
    fn a_ball_takes_its_points_and_the_lists_follow() {
        let model = model();
        let centre = model.cloud.points()[0];
        let radius = 0.2 * model.cloud.bounds().diagonal();
        let ball = Region::Ball { centre, radius };
        let rest = without(&model, &ball);
        let losses = Losses::between(&model, &rest);
        assert_eq!(losses.points, points_in(&model, &ball).len());
        assert_eq!(losses.points, model.cloud.len() - rest.cloud.len());
        assert!(rest.cloud.len() < model.cloud.len());
        assert!(
            rest.cloud
                .points()
                .iter()
                .all(|point| (point - centre).norm() > radius)
        );
        let numbers = |model: &Model| -> Vec<u32> {
            let truth = model.truth.as_ref().unwrap();
            truth.primitives.iter().map(|each| each.number).collect()
        };
        assert!(numbers(&rest).len() <= numbers(&model).len());
        assert!(
            numbers(&rest)
                .iter()
                .all(|number| numbers(&model).contains(number))
        );
        assert!(farthest_off(&rest).unwrap() < 1e-9);
    }

    #[test]
    fn a_primitive_that_loses_every_point_is_gone() {
        let model = model();
        let gone = &model.truth.as_ref().unwrap().primitives[3];
        let points = gone
            .points
            .iter()
            .map(|&index| model.cloud.points()[index as usize]);
        let rest = points.fold(model.clone(), |rest, centre| {
            without(
                &rest,
                &Region::Ball {
                    centre,
                    radius: 1e-6,
                },
            )
        });
        assert_eq!(rest.cloud.len(), model.cloud.len() - gone.points.len());
        assert_eq!(Losses::between(&model, &rest).vanished, [gone.number]);
        let left = rest.truth.unwrap().primitives;
        assert!(left.iter().all(|primitive| primitive.number != gone.number));
    }

    #[test]
    fn nothing_is_lost_between_a_model_and_itself() {
        let model = model();
        let losses = Losses::between(&model, &model);
        assert_eq!((losses.points, losses.vanished.len()), (0, 0));
    }

    #[test]
    fn a_primitive_of_nine_points_is_thin_and_one_of_ten_is_not() {
        let listing = |number, points| Primitive {
            number,
            points: (0..points).collect(),
            ..Primitive::default()
        };
        let model = Model {
            truth: Some(Segmentation {
                primitives: vec![listing(3, 10), listing(5, 9), listing(7, 0)],
            }),
            ..Model::default()
        };
        assert_eq!(thin(&model), [5, 7]);
        assert_eq!(thin(&Model::default()), [0; 0]);
    }

    #[test]
    fn a_lasso_widens_with_distance_from_a_near_eye_but_not_from_a_far_one() {
        let near = Lasso::new([0.0; 3], UPRIGHT, 10.0, f64::INFINITY, &SQUARE).unwrap();
        let far = Lasso::new([0.0; 3], UPRIGHT, f64::INFINITY, f64::INFINITY, &SQUARE).unwrap();
        let behind = Point::new(1.5, 0.0, -10.0);
        assert!(near.contains(&behind) && !far.contains(&behind));
        let before = Point::new(0.9, 0.0, 5.0);
        assert!(!near.contains(&before) && far.contains(&before));
        let behind_the_eye = Point::new(0.0, 0.0, 11.0);
        assert!(!near.contains(&behind_the_eye) && far.contains(&behind_the_eye));
    }

    #[test]
    fn a_lasso_looks_where_its_camera_looks_and_no_deeper_than_asked() {
        // A quarter turn about x: the camera's z axis is the world's negative y.
        let half = std::f64::consts::FRAC_1_SQRT_2;
        let turned = [half, 0.0, 0.0, half];
        let target = [10.0, 0.0, 0.0];
        let lasso = Lasso::new(target, turned, f64::INFINITY, 2.0, &SQUARE).unwrap();
        assert!(lasso.contains(&Point::new(10.5, 1.9, 0.9)));
        assert!(!lasso.contains(&Point::new(10.5, 2.1, 0.9)));
        assert!(lasso.contains(&Point::new(10.5, -100.0, 0.9)));
        assert!(!lasso.contains(&Point::new(10.5, 0.0, 1.1)));
    }

    #[test]
    fn numbers_that_are_no_lasso_are_refused() {
        let lasso = |rotation, eye, depth, corners: &[[f64; 2]]| {
            Lasso::new([0.0; 3], rotation, eye, depth, corners)
                .unwrap_err()
                .to_string()
        };
        assert!(lasso([0.0; 4], 1.0, 1.0, &SQUARE).contains("rotation"));
        assert!(lasso([f64::NAN; 4], 1.0, 1.0, &SQUARE).contains("rotation"));
        assert!(lasso(UPRIGHT, -1.0, 1.0, &SQUARE).contains("before its target"));
        assert!(lasso(UPRIGHT, 1.0, f64::NAN, &SQUARE).contains("before its target"));
        assert!(lasso(UPRIGHT, 1.0, 1.0, &SQUARE[..2]).contains("corners"));
        assert!(lasso(UPRIGHT, 1.0, 1.0, &[[f64::NAN; 2]; 3]).contains("corners"));
        for (centre, radius) in [
            ([f64::NAN, 0.0, 0.0], 1.0),
            ([0.0, f64::INFINITY, 0.0], 1.0),
            ([0.0; 3], f64::INFINITY),
            ([0.0; 3], -1.0),
        ] {
            let refused = Region::ball(centre, radius).unwrap_err().to_string();
            assert!(refused.contains("a ball has"), "{refused}");
        }
        let nowhere = Region::Ball {
            centre: Point::new(f64::NAN, 0.0, 0.0),
            radius: f64::INFINITY,
        };
        assert!(!nowhere.contains(&(Point::origin() + Vector::x())));
        let inside_out = Region::Ball {
            centre: Point::origin(),
            radius: -1.0,
        };
        assert!(!inside_out.contains(&Point::origin()));
    }
}
