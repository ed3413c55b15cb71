//! How far two answers for one cloud agree, whatever order and types their primitives have: what
//! moving the cloud, or another seed, changes.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use crate::model::Segmentation;
use crate::sorting::sort_by;

/// How many points of a cloud are in other primitives in one answer than in the other, once
/// primitives are paired one to one, those first that share most points. Indices beyond `points`
/// are left out. O(n log n) for n points in all lists.
///
/// ```
/// use fit4cad::metrics::agreement::changed;
/// use fit4cad::model::{Primitive, Segmentation};
/// # use fit4cad::{cloud::{Point, Vector}, surface::{Plane, Surface}};
/// # let plane = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
/// let listing = |lists: &[&[u32]]| Segmentation {
///     primitives: (1..).zip(lists).map(|(n, list)| Primitive::on(plane, n, list.to_vec())).collect(),
/// };
/// let before = listing(&[&[0, 1, 2, 3], &[3, 4, 5]]);
/// let after = listing(&[&[4, 5], &[0, 1, 2, 3]]);
/// assert_eq!(changed(6, &before, &after), 1); // point 3 is on one primitive now, no more on two
/// ```
pub fn changed(points: usize, before: &Segmentation, after: &Segmentation) -> usize {
    let [old, new] = [before, after].map(|answer| lists_of(points, answer));
    let mut shared: BTreeMap<(u32, u32), usize> = BTreeMap::new();
    for (old, new) in old.iter().zip(&new) {
        for &a in old {
            for &b in new {
                *shared.entry((a, b)).or_default() += 1;
            }
        }
    }
    let mut pairs: Vec<((u32, u32), usize)> = shared.into_iter().collect();
    sort_by(&mut pairs, |one, other| {
        let key = |&(pair, count): &((u32, u32), usize)| (Reverse(count), pair);
        key(one).cmp(&key(other))
    });
    let mut taken = vec![false; before.primitives.len()];
    let mut partner: Vec<Option<u32>> = vec![None; after.primitives.len()];
    for ((a, b), _) in pairs {
        let (taken, partner) = (&mut taken[a as usize], &mut partner[b as usize]);
        if !*taken && partner.is_none() {
            *taken = true;
            *partner = Some(a);
        }
    }
    let is_changed = |(old, new): &(&Vec<u32>, &Vec<u32>)| {
        let is_known = |&b: &u32| partner[b as usize].is_some_and(|a| old.contains(&a));
        old.len() != new.len() || !new.iter().all(is_known)
    };
    old.iter().zip(&new).filter(is_changed).count()
}

/// The positions of the primitives that list each point.
fn lists_of(points: usize, answer: &Segmentation) -> Vec<Vec<u32>> {
    let mut lists = vec![Vec::new(); points];
    for (place, primitive) in (0u32..).zip(&answer.primitives) {
        for &index in &primitive.points {
            if let Some(list) = lists.get_mut(index as usize) {
                list.push(place);
            }
        }
    }
    lists
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::{Point, Vector};
    use crate::model::Primitive;
    use crate::surface::{Plane, Surface};

    fn listing(lists: &[&[u32]]) -> Segmentation {
        let plane = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
        let primitives = (1..).zip(lists);
        Segmentation {
            primitives: primitives
                .map(|(number, list)| Primitive::on(plane, number, list.to_vec()))
                .collect(),
        }
    }

    #[test]
    fn the_order_of_primitives_does_not_matter() {
        let before = listing(&[&[0, 1, 2], &[2, 3], &[5]]);
        let after = listing(&[&[5], &[0, 1, 2], &[2, 3]]);
        assert_eq!(changed(6, &before, &after), 0);
    }

    #[test]
    fn the_smaller_piece_of_a_split_primitive_has_changed() {
        let before = listing(&[&[0, 1, 2, 3, 4]]);
        let after = listing(&[&[0, 1, 2], &[3, 4]]);
        assert_eq!(changed(6, &before, &after), 2);
        assert_eq!(changed(6, &after, &before), 2);
    }

    #[test]
    fn points_found_or_lost_have_changed() {
        let (some, none) = (listing(&[&[0, 1, 2]]), listing(&[]));
        assert_eq!(changed(4, &some, &none), 3);
        assert_eq!(changed(4, &none, &some), 3);
        assert_eq!(changed(0, &some, &some), 0);
    }
}
