//! Which primitive of one segmentation overlaps most with each primitive of another.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use crate::model::Segmentation;

/// The primitive that shares most points with a given one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Match {
    /// Its place in the other segmentation.
    pub index: usize,
    /// How many points the two share; at least one.
    pub shared: usize,
}

/// For every point of a cloud, the primitives that list it. Points that the same primitives list
/// are one class: most primitives are made of a few classes, however many points they have and
/// however many lists are alike.
#[derive(Debug, Clone)]
pub struct Incidence {
    /// Class of each point: 0 for those in no list, 1 + k for those in list k alone.
    classes: Vec<u32>,
    /// The primitives that list the points of each class, ascending.
    rows: Rows,
    primitive_count: usize,
}

impl Incidence {
    /// Turns the lists of a segmentation round. Indices beyond the cloud are left out.
    /// O(points + listed indices · log classes).
    pub fn new(segmentation: &Segmentation, points: usize) -> Self {
        let listed = Rows::turned_round(segmentation, points);
        let primitive_count = segmentation.primitives.len();
        let mut rows = Rows::default();
        rows.push(&[]);
        for primitive in (0u32..).take(primitive_count) {
            rows.push(&[primitive]);
        }
        let mut several: BTreeMap<&[u32], u32> = BTreeMap::new();
        let classes = (0..points).map(|point| match listed.get(point) {
            [] => 0,
            &[primitive] => 1 + primitive,
            row => *several.entry(row).or_insert_with(|| rows.push(row)),
        });
        Self {
            classes: classes.collect(),
            rows,
            primitive_count,
        }
    }

    /// Indices of the primitives that list a point, ascending; none for a point beyond the cloud.
    pub fn primitives_of(&self, point: u32) -> &[u32] {
        let class = self.classes.get(point as usize);
        class.map_or(&[], |&class| self.rows.get(class as usize))
    }

    /// Whether any primitive lists the point.
    pub fn is_labelled(&self, point: u32) -> bool {
        self.classes
            .get(point as usize)
            .is_some_and(|&class| class > 0)
    }

    /// How many points of the cloud some primitive lists. O(points).
    pub fn labelled_count(&self) -> usize {
        self.classes.iter().filter(|&&class| class > 0).count()
    }
}

/// Lists of primitives, one after another.
#[derive(Debug, Clone)]
struct Rows {
    /// Where each row begins in `primitives`; one entry more than there are rows.
    offsets: Vec<usize>,
    primitives: Vec<u32>,
}

impl Default for Rows {
    fn default() -> Self {
        Self {
            offsets: vec![0],
            primitives: Vec::new(),
        }
    }
}

impl Rows {
    /// For each point a row of the primitives that list it: compressed, so that a pass over the
    /// points walks memory forwards.
    fn turned_round(segmentation: &Segmentation, points: usize) -> Self {
        let listed = || {
            let numbered = (0u32..).zip(&segmentation.primitives);
            let pairs = numbered.flat_map(|(primitive, entry)| {
                let points = entry.points.iter().map(|&point| point as usize);
                points.map(move |point| (primitive, point))
            });
            pairs.filter(|(_, point)| *point < points)
        };
        let mut offsets = vec![0; points + 1];
        for (_, point) in listed() {
            if let Some(count) = offsets.get_mut(point + 1) {
                *count += 1;
            }
        }
        let mut total = 0;
        for offset in &mut offsets {
            total += *offset;
            *offset = total;
        }
        let mut primitives = vec![0; total];
        let mut next = offsets.clone();
        for (primitive, point) in listed() {
            if let Some(slot) = next.get_mut(point) {
                if let Some(entry) = primitives.get_mut(*slot) {
                    *entry = primitive;
                }
                *slot += 1;
            }
        }
        Self {
            offsets,
            primitives,
        }
    }

    fn len(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Adds a row and gives its place.
    fn push(&mut self, row: &[u32]) -> u32 {
        let place = self.len() as u32;
        self.primitives.extend_from_slice(row);
        self.offsets.push(self.primitives.len());
        place
    }

    /// A row; empty beyond the last.
    fn get(&self, place: usize) -> &[u32] {
        let (Some(&from), Some(&to)) = (self.offsets.get(place), self.offsets.get(place + 1))
        else {
            return &[];
        };
        self.primitives.get(from..to).unwrap_or(&[])
    }
}

/// Counts by place, cleared in time proportional to how many places were counted.
struct Tally {
    counts: Vec<usize>,
    touched: Vec<usize>,
}

impl Tally {
    fn new(places: usize) -> Self {
        Self {
            counts: vec![0; places],
            touched: Vec::new(),
        }
    }

    fn add(&mut self, place: u32, count: usize) {
        if let Some(sum) = self.counts.get_mut(place as usize) {
            if *sum == 0 {
                self.touched.push(place as usize);
            }
            *sum += count;
        }
    }

    /// The places counted with their counts, in the order of their first; none is left.
    fn drain(&mut self) -> impl Iterator<Item = (usize, usize)> {
        let counts = &mut self.counts;
        let take = |place: usize| Some((place, std::mem::take(counts.get_mut(place)?)));
        self.touched.drain(..).filter_map(take)
    }
}

/// For each primitive of `from`, the one of `to` with which it shares most points; of equals, the
/// first, as the authors' script has it; `None` if it shares none with any. Several may have one match.
/// `incidence` is that of `to`. O(listed indices + primitives of each class that a list meets).
pub fn best_matches(from: &Segmentation, incidence: &Incidence) -> Vec<Option<Match>> {
    let mut classes = Tally::new(incidence.rows.len());
    let mut shared = Tally::new(incidence.primitive_count);
    let best_of = |points: &[u32]| {
        for &point in points {
            if let Some(&class) = incidence.classes.get(point as usize) {
                classes.add(class, 1);
            }
        }
        for (class, count) in classes.drain() {
            for &primitive in incidence.rows.get(class) {
                shared.add(primitive, count);
            }
        }
        let matches = shared.drain();
        matches
            .map(|(index, shared)| Match { index, shared })
            .max_by_key(|found| (found.shared, Reverse(found.index)))
    };
    let lists = from
        .primitives
        .iter()
        .map(|primitive| primitive.points.as_slice());
    lists.map(best_of).collect()
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::model::Primitive;

    fn segmentation(lists: &[&[u32]]) -> Segmentation {
        let primitive = |points: &&[u32]| Primitive {
            points: points.to_vec(),
            ..Primitive::default()
        };
        Segmentation {
            primitives: lists.iter().map(primitive).collect(),
        }
    }

    fn matches(from: &[&[u32]], to: &[&[u32]]) -> Vec<Option<(usize, usize)>> {
        let incidence = Incidence::new(&segmentation(to), 10);
        let found = best_matches(&segmentation(from), &incidence);
        found
            .iter()
            .map(|m| m.map(|m| (m.index, m.shared)))
            .collect()
    }

    #[test]
    fn the_primitive_with_most_shared_points_wins() {
        let found = matches(&[&[0, 1, 2, 3]], &[&[0], &[1, 2, 9], &[3]]);
        assert_eq!(found, [Some((1, 2))]);
    }

    #[test]
    fn of_equals_the_first_wins_whichever_point_comes_first() {
        let found = matches(&[&[0, 1, 2, 3]], &[&[8], &[2, 3], &[0, 1]]);
        assert_eq!(found, [Some((1, 2))]);
    }

    #[test]
    fn one_prediction_may_serve_several_primitives_and_none_may_serve_one() {
        let found = matches(&[&[0, 1], &[2, 3], &[4]], &[&[0, 1, 2, 3]]);
        assert_eq!(found, [Some((0, 2)), Some((0, 2)), None]);
    }

    #[test]
    fn points_listed_by_two_primitives_count_for_both() {
        let incidence = Incidence::new(&segmentation(&[&[0, 1], &[1, 2]]), 5);
        assert_eq!(incidence.primitives_of(1), [0, 1]);
        assert_eq!(incidence.labelled_count(), 3);
        assert!(!incidence.is_labelled(4));
    }

    #[test]
    fn indices_beyond_the_cloud_are_left_out() {
        let incidence = Incidence::new(&segmentation(&[&[0, 5, u32::MAX]]), 5);
        assert_eq!(incidence.labelled_count(), 1);
        assert!(!incidence.is_labelled(5));
        assert!(!incidence.is_labelled(u32::MAX));
    }

    /// Lists that often are alike, overlap, or reach beyond the ten points.
    fn lists() -> impl Strategy<Value = Vec<Vec<u32>>> {
        let list = prop::collection::btree_set(0u32..12, 0..6);
        let list = list.prop_map(|list| list.into_iter().collect());
        let alike = prop::sample::select(vec![vec![0, 1, 2], vec![1, 2], vec![]]);
        prop::collection::vec(prop_oneof![list, alike], 0..8)
    }

    proptest! {
        #[test]
        fn matches_are_those_of_counting_every_pair(from in lists(), to in lists()) {
            fn slices(lists: &[Vec<u32>]) -> Vec<&[u32]> {
                lists.iter().map(Vec::as_slice).collect()
            }
            let counted = from.iter().map(|one| {
                let shared = |other: &Vec<u32>| {
                    let both = |point: &&u32| **point < 10 && other.contains(point);
                    one.iter().filter(both).count()
                };
                let counts: Vec<usize> = to.iter().map(shared).collect();
                let most = counts.iter().copied().max().filter(|&most| most > 0)?;
                Some((counts.iter().position(|&count| count == most)?, most))
            });
            let counted: Vec<Option<(usize, usize)>> = counted.collect();
            prop_assert_eq!(matches(&slices(&from), &slices(&to)), counted);
        }
    }
}
