//! What arrays are called, and how types are numbered, in the files of each network.

use fit4cad::surface::SurfaceType;

/// Points, the likelier name first. SPFN has them with noise too.
const POINTS: [&str; 13] = [
    "points",
    "gt_points",
    "point_cloud",
    "pointcloud",
    "pc",
    "p",
    "xyz",
    "pos",
    "coords",
    "vertices",
    "v",
    "data",
    "noisy_points",
];

/// Labels of the truth.
const LABELS: [&str; 13] = [
    "labels",
    "gt_labels",
    "i_gt",
    "label",
    "instances",
    "instance",
    "inst",
    "segments",
    "segment",
    "seg",
    "pid",
    "ids",
    "l_gt",
];

/// Labels of a prediction; of the truth where a cloud comes with no others.
const FOUND: [&str; 3] = ["instance_per_point", "seg_id", "cluster_ids"];

/// Labels of a prediction in any case.
const PREDICTED: [&str; 8] = [
    "pred_labels",
    "pred_label",
    "pred_instances",
    "pred_instance",
    "pred_inst",
    "pred_segments",
    "pred_seg",
    "pred_seg_id",
];

/// Types of the truth, of a prediction, and how they are numbered.
const TYPES: [(&str, Whose, Coding); 10] = [
    ("prim", Whose::Truth, Coding::ParseNet),
    ("gt_prim", Whose::Truth, Coding::ParseNet),
    ("primitives", Whose::Truth, Coding::ParseNet),
    ("t_gt", Whose::Truth, Coding::Spfn),
    ("gt_type", Whose::Truth, Coding::Spfn),
    ("pred_primitives", Whose::Prediction, Coding::ParseNet),
    ("pred_prim", Whose::Prediction, Coding::ParseNet),
    ("pred_type", Whose::Prediction, Coding::Spfn),
    ("pred_type_per_point", Whose::Prediction, Coding::Spfn),
    ("type_per_point", Whose::Prediction, Coding::Spfn),
];

/// Whose labels or types are meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Whose {
    Truth,
    Prediction,
}

/// How types are numbered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Coding {
    /// ParseNet's and HPNet's: 1 plane, 3 cone, 4 cylinder, 5 sphere; the others are splines and the like.
    ParseNet,
    /// SPFN's and CPFN's: 0 sphere, 1 plane, 2 cylinder, 3 cone.
    Spfn,
}

impl Coding {
    /// The type of a number; `None` where it is none of the five.
    pub(crate) fn kind(self, number: f64) -> Option<SurfaceType> {
        use SurfaceType::{Cone, Cylinder, Plane, Sphere};
        let kinds: &[Option<SurfaceType>] = match self {
            Self::ParseNet => &[
                None,
                Some(Plane),
                None,
                Some(Cone),
                Some(Cylinder),
                Some(Sphere),
            ],
            Self::Spfn => &[Some(Sphere), Some(Plane), Some(Cylinder), Some(Cone)],
        };
        let is_place = number.fract() == 0.0 && number >= 0.0;
        kinds
            .get(number as usize)
            .copied()
            .flatten()
            .filter(|_| is_place)
    }
}

/// How likely an array of a name is of points; the less the likelier.
pub(crate) fn rank_of_points(name: &str) -> Option<usize> {
    place(&POINTS, name)
}

/// How likely an array of a name is of labels, the less the likelier, and whose. `beside_points` where the file holds the
/// cloud too.
pub(crate) fn rank_of_labels(name: &str, beside_points: bool) -> Option<(Whose, usize)> {
    if let Some(place) = place(&LABELS, name) {
        return Some((Whose::Truth, place));
    }
    if let Some(place) = place(&PREDICTED, name) {
        return Some((Whose::Prediction, place));
    }
    let found = place(&FOUND, name)?;
    Some(if beside_points {
        (Whose::Truth, LABELS.len() + found)
    } else {
        (Whose::Prediction, PREDICTED.len() + found)
    })
}

/// Whether the labels of such a name are of a prediction where there are others for the truth.
pub(crate) fn is_found(name: &str) -> bool {
    place(&FOUND, name).is_some()
}

/// How likely an array of a name is of types, whose, and how they are numbered.
pub(crate) fn types_named(name: &str) -> Option<(Whose, usize, Coding)> {
    let place = TYPES
        .iter()
        .position(|(known, ..)| name.eq_ignore_ascii_case(known))?;
    let &(_, whose, coding) = TYPES.get(place)?;
    Some((whose, place, coding))
}

/// Whether a group is one of SPFN's surfaces, whose parameters are a pickled attribute.
pub(crate) fn is_soup(name: &str) -> bool {
    name.rsplit_once("_soup_").is_some_and(|(_, number)| {
        !number.is_empty() && number.bytes().all(|it| it.is_ascii_digit())
    })
}

fn place(names: &[&str], name: &str) -> Option<usize> {
    names
        .iter()
        .position(|known| name.eq_ignore_ascii_case(known))
}
