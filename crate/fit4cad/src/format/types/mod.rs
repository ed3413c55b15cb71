//! Types of points, as networks tell them: each segment is of the type that most of its points have.

mod coding;

pub use coding::{Coding, Named, named};

use std::collections::BTreeMap;

use crate::surface::SurfaceType;

/// The type of a point or a segment, of which all five are known and others are one.
pub type Told = Option<SurfaceType>;

/// What most of the values are, of as many the least; `None` where there are none. O(n log k) for k different ones.
///
/// ```
/// use fit4cad::format::types::most;
/// assert_eq!(most([3, 1, 3, 2]), Some(3));
/// assert_eq!(most([2, 1]), Some(1));
/// ```
pub fn most<T: Ord>(values: impl IntoIterator<Item = T>) -> Option<T> {
    let mut counts: BTreeMap<T, usize> = BTreeMap::new();
    for value in values {
        *counts.entry(value).or_default() += 1;
    }
    let counts = counts.into_iter().rev();
    let most = counts.max_by_key(|&(_, count)| count);
    most.map(|(value, _)| value)
}

/// The type that most of some points have.
pub(super) fn of_points(points: &[u32], types: &[Told]) -> Told {
    let of_each = points.iter().filter_map(|&index| types.get(index as usize));
    most(of_each.copied()).flatten()
}

/// The type of each label that is not below 0, by rising label: that of the number that most of its points have, of as
/// many the least. O(n log n) for n points.
///
/// ```
/// use fit4cad::format::types::{Coding, of_labels};
/// use fit4cad::surface::SurfaceType::Cylinder;
/// let types = of_labels(&[0, 0, 0, -1], &[4.0, 4.0, 1.0, 1.0], Coding::ParseNet);
/// assert_eq!(types, [(0, Some(Cylinder))]);
/// ```
pub fn of_labels(labels: &[i32], numbers: &[f64], coding: Coding) -> Vec<(i32, Told)> {
    let mut of_each: BTreeMap<i32, Vec<u64>> = BTreeMap::new();
    for (&label, &number) in labels.iter().zip(numbers) {
        if label >= 0 {
            // What is no whole number is none of the types.
            let is_place = number.fract() == 0.0 && number >= 0.0;
            let number = if is_place { number as u64 } else { u64::MAX };
            of_each.entry(label).or_default().push(number);
        }
    }
    let of_each = of_each.into_iter();
    of_each
        .map(|(label, numbers)| {
            let kind = most(numbers).and_then(|number| coding.kind(number as f64));
            (label, kind)
        })
        .collect()
}
