//! What arrays of points and labels are called in the files of each network; of types the engine knows it.

use fit4cad::format::foreign::Purpose;

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

/// How likely an array of a name is of points; the less the likelier.
pub(crate) fn rank_of_points(name: &str) -> Option<usize> {
    place(&POINTS, name)
}

/// How likely an array of a name is of labels, the less the likelier, and whose. `beside_points` where the file holds the
/// cloud too.
pub(crate) fn rank_of_labels(name: &str, beside_points: bool) -> Option<(Purpose, usize)> {
    if let Some(place) = place(&LABELS, name) {
        return Some((Purpose::Truth, place));
    }
    if let Some(place) = place(&PREDICTED, name) {
        return Some((Purpose::Submission, place));
    }
    let found = place(&FOUND, name)?;
    Some(if beside_points {
        (Purpose::Truth, LABELS.len() + found)
    } else {
        (Purpose::Submission, PREDICTED.len() + found)
    })
}

/// Whether the labels of such a name are of a prediction where there are others for the truth.
pub(crate) fn is_found(name: &str) -> bool {
    place(&FOUND, name).is_some()
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
