//! A model of the benchmark: a cloud, its true segmentation and the segmentations submitted for it.
//!
//! Files, fitters and the sample generator all make these types, and everything downstream reads
//! them, so a submission looks the same wherever it came from.

use crate::cloud::Cloud;
use crate::surface::{Form, Surface, SurfaceType};

/// One point cloud with everything known about it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Model {
    /// Name as in its files, e.g. `PC14`.
    pub name: String,
    /// The points.
    pub cloud: Cloud,
    /// The ground truth, if it is there.
    pub truth: Option<Segmentation>,
    /// Results to be scored, ordered by method; see [`Model::submit`].
    pub submissions: Vec<Submission>,
}

impl Model {
    /// Adds the result of a method, in the place of an earlier one of the same name.
    ///
    /// ```
    /// use fit4cad::model::{Model, Segmentation};
    /// let mut model = Model::default();
    /// model.submit("HT", Segmentation::default());
    /// assert_eq!(model.submissions[0].method, "HT");
    /// ```
    pub fn submit(&mut self, method: &str, segmentation: Segmentation) {
        let submission = Submission {
            method: method.to_owned(),
            segmentation,
        };
        let name = |each: &Submission| each.method.as_str().cmp(method);
        match self.submissions.binary_search_by(name) {
            Ok(place) => self.submissions[place] = submission,
            Err(place) => self.submissions.insert(place, submission),
        }
    }
}

/// The result of one method on one model.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Submission {
    /// Name of the method, e.g. `HT`.
    pub method: String,
    /// What it found.
    pub segmentation: Segmentation,
}

/// A cloud's points grouped into primitives. Groups may share points (usually along a common
/// edge), and points in no group are unsegmented.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Segmentation {
    /// The primitives, in the order of the file.
    pub primitives: Vec<Primitive>,
}

/// One primitive: a group of points and the surface they lie on.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Primitive {
    /// The number the file gives it (`Primitive7`); not always its position.
    pub number: u32,
    /// Indices into the cloud, counted from 0, ascending, each once.
    pub points: Vec<u32>,
    /// The type named by the file, where it is one of the five; `None` for others (`BSpline`) and
    /// where no surface file names it.
    pub kind: Option<SurfaceType>,
    /// The surface for distances (MFE, directed Hausdorff): from the parametric file, or from the
    /// implicit file where there is no parametric file at all.
    pub surface: Option<Surface>,
    /// The parametric vector (paper, appendix "Parametric representations").
    pub parametric: Coefficients,
    /// The implicit vector (paper, appendix "Implicit representations"); exactly converted from
    /// the parametric one where there is no implicit file at all.
    pub implicit: Coefficients,
}

impl Primitive {
    /// Points on a surface that is known exactly: both vectors are converted from it.
    ///
    /// ```
    /// use fit4cad::cloud::{Point, Vector};
    /// use fit4cad::model::Primitive;
    /// use fit4cad::surface::{Plane, Surface};
    /// let floor = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
    /// let primitive = Primitive::on(floor, 1, vec![0, 1, 2]);
    /// assert_eq!(primitive.parametric.values().map(<[f64]>::len), Some(9));
    /// ```
    pub fn on(surface: Surface, number: u32, points: Vec<u32>) -> Self {
        Self {
            number,
            points,
            kind: Some(surface.kind()),
            surface: Some(surface),
            parametric: Coefficients::Given(surface.to_parametric()),
            implicit: Coefficients::Given(surface.to_implicit()),
        }
    }

    /// Its vector in one form.
    pub fn coefficients(&self, form: Form) -> &Coefficients {
        match form {
            Form::Parametric => &self.parametric,
            Form::Implicit => &self.implicit,
        }
    }
}

/// The numbers of one entry of a surface file.
#[derive(Debug, Clone, PartialEq, Default)]
pub enum Coefficients {
    /// The file holds no entry for this primitive.
    #[default]
    Missing,
    /// There is an entry, but it cannot be used (wrong length, not a number).
    Malformed,
    /// As many numbers as the type asks for.
    Given(Vec<f64>),
}

impl Coefficients {
    /// The numbers, if there are any.
    pub fn values(&self) -> Option<&[f64]> {
        match self {
            Self::Given(values) => Some(values),
            Self::Missing | Self::Malformed => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn submissions_stay_ordered_and_a_second_one_of_a_method_replaces_the_first() {
        let with = |count| Segmentation {
            primitives: vec![Primitive::default(); count],
        };
        let mut model = Model::default();
        for (method, count) in [("PG", 1), ("HT", 2), ("Ours", 3), ("HT", 4)] {
            model.submit(method, with(count));
        }
        let found = model.submissions.iter();
        let found: Vec<(&str, usize)> = found
            .map(|each| (&each.method[..], each.segmentation.primitives.len()))
            .collect();
        assert_eq!(found, [("HT", 4), ("Ours", 3), ("PG", 1)]);
    }
}
