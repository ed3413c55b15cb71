//! Segments: points that belong together, by a label each.

use std::collections::BTreeMap;

use crate::surface::SurfaceType;

/// Points that belong together.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Segment {
    /// The number its file gives it.
    pub number: u32,
    /// Its type, where the file names one of the five.
    pub kind: Option<SurfaceType>,
    /// Indices into the cloud, counted from 0, ascending, each once.
    pub points: Vec<u32>,
}

/// The label of a point that belongs to no segment.
pub(super) const NO_LABEL: i32 = -1;

/// The segments that labels make, one a point, by rising label; points of labels below 0 belong to
/// none. O(n log k) for k labels.
///
/// ```
/// use fit4cad::format::by_label;
/// let segments = by_label(&[7, -1, 2, 7]);
/// assert_eq!((segments[0].number, &segments[1].points[..]), (2, &[0, 3][..]));
/// ```
pub fn by_label(labels: &[i32]) -> Vec<Segment> {
    let mut segments: BTreeMap<i32, Vec<u32>> = BTreeMap::new();
    for (index, &label) in (0..).zip(labels) {
        if label >= 0 {
            segments.entry(label).or_default().push(index);
        }
    }
    let segments = segments.into_iter();
    segments
        .map(|(label, points)| Segment {
            number: label as u32,
            kind: None,
            points,
        })
        .collect()
}

/// Labels count segments, of which there are at most as many as points.
const LARGEST_LABEL: f64 = 10_000_000.0;

/// Whether a value can be a label: a whole number, -1 or more.
pub(super) fn is_label_value(value: f64) -> bool {
    value.fract() == 0.0 && (-1.0..=LARGEST_LABEL).contains(&value)
}
