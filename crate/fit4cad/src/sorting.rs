//! One sort for lists of whatever, where the time it takes does not matter.

use std::cmp::Ordering;

/// Sorts as `sort_by` of the standard library does, equal items staying in their order. That one is compiled anew for
/// every type and every order, 6 kB each, which the page has to wait for; here only places are sorted, by one code.
/// O(n log n), with two lists of places beside the items.
pub(crate) fn sort_by<T>(items: &mut [T], mut compare: impl FnMut(&T, &T) -> Ordering) {
    let mut target = vec![0; items.len()];
    let order = places(items.len(), &mut |one, other| {
        compare(&items[one], &items[other])
    });
    for (place, from) in order.into_iter().enumerate() {
        target[from] = place;
    }
    for place in 0..items.len() {
        while target[place] != place {
            let to = target[place];
            items.swap(place, to);
            target.swap(place, to);
        }
    }
}

/// The places 0, 1, … in order.
#[inline(never)]
fn places(count: usize, compare: &mut dyn FnMut(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&one, &other| compare(one, other));
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn it_sorts_as_the_standard_library_does(items in prop::collection::vec((0u8..8, any::<u16>()), 0..200)) {
            let by_first = |one: &(u8, u16), other: &(u8, u16)| one.0.cmp(&other.0);
            let (mut own, mut theirs) = (items.clone(), items);
            sort_by(&mut own, by_first);
            theirs.sort_by(by_first);
            prop_assert_eq!(own, theirs);
        }
    }
}
