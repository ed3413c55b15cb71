//! Which primitive of one segmentation overlaps most with each primitive of another.

use std::cmp::Reverse;
use std::collections::BTreeMap;

use crate::model::Segmentation;
use crate::sorting::sort_by;

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

    /// The class of each point; points of one class are listed by the same primitives.
    pub(super) fn classes(&self) -> impl Iterator<Item = u32> {
        self.classes.iter().copied()
    }

    /// Indices of the primitives that list the points of a class, ascending.
    pub(super) fn listing(&self, class: u32) -> &[u32] {
        self.rows.get(class as usize)
    }

    /// How many primitives the segmentation has.
    pub(super) fn count(&self) -> usize {
        self.primitive_count
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

/// Longest row that is simply counted. A point on a corner of a part is listed by three or four
/// primitives, rarely by more; rows beyond this come from lists that heap up on few points.
const SHORT: usize = 32;

/// For each primitive of `from`, the one of `to` with which it shares most points; of equals, the
/// first, as the authors' script has it; `None` if it shares none with any. Several may have one match.
/// `incidence` is that of `to`.
///
/// O(listed indices) as long as few primitives share a point. Where many do (all of them share one,
/// say), those that share other points with the list are counted first, and of the many only as many
/// are looked at as could still win: mostly the first. Lists among the same few points remain
/// quadratic in their number, which no known method avoids (maximum inner product of sets).
pub fn best_matches(from: &Segmentation, incidence: &Incidence) -> Vec<Option<Match>> {
    let mut search = Search::new(incidence);
    let lists = from.primitives.iter();
    lists
        .map(|primitive| search.best_of(&primitive.points))
        .collect()
}

/// A class of points of a list: how many of them the list has, and who else lists them.
#[derive(Clone, Copy)]
struct Share<'a> {
    class: usize,
    count: usize,
    row: &'a [u32],
}

/// Finds matches, with what can be used again from list to list.
struct Search<'a> {
    incidence: &'a Incidence,
    classes: Tally,
    shared: Tally,
    /// Answers by the classes of a list with their counts, where they took a search of long rows:
    /// lists that are alike are searched once.
    known: BTreeMap<Vec<(usize, usize)>, Option<Match>>,
    /// Entries of rows that were looked at.
    #[cfg(test)]
    looked_at: usize,
}

impl<'a> Search<'a> {
    fn new(incidence: &'a Incidence) -> Self {
        Self {
            incidence,
            classes: Tally::new(incidence.rows.len()),
            shared: Tally::new(incidence.primitive_count),
            known: BTreeMap::new(),
            #[cfg(test)]
            looked_at: 0,
        }
    }

    fn best_of(&mut self, points: &[u32]) -> Option<Match> {
        let incidence = self.incidence;
        for &point in points {
            if let Some(&class) = incidence.classes.get(point as usize) {
                self.classes.add(class, 1);
            }
        }
        let shares = self.classes.drain().map(|(class, count)| Share {
            class,
            count,
            row: incidence.rows.get(class),
        });
        let (short, mut long): (Vec<Share<'_>>, Vec<Share<'_>>) =
            shares.partition(|share| share.row.len() <= SHORT);
        if long.is_empty() {
            return best(self.count(&short));
        }
        let key = |share: &Share<'_>| (share.class, share.count);
        let mut alike: Vec<(usize, usize)> = short.iter().chain(&long).map(key).collect();
        sort_by(&mut alike, |one, other| one.cmp(other));
        if let Some(&known) = self.known.get(&alike) {
            return known;
        }
        sort_by(&mut long, |one, other| {
            (one.row.len(), one.class).cmp(&(other.row.len(), other.class))
        });
        let found = self.search(&short, &long);
        self.known.insert(alike, found);
        found
    }

    /// The best match of a list with classes of short and of long rows, the long ones ascending in
    /// length.
    fn search(&mut self, short: &[Share<'_>], long: &[Share<'_>]) -> Option<Match> {
        let near: Vec<Match> = self.count(short).collect();
        let entries: usize = long.iter().map(|share| share.row.len()).sum();
        let probes: usize = long.iter().map(|share| probes_in(share.row)).sum();
        if near.len().saturating_mul(probes) >= entries {
            let all: Vec<Share<'_>> = short.iter().chain(long).copied().collect();
            return best(self.count(&all));
        }
        #[cfg(test)]
        {
            self.looked_at += near.len() * probes;
        }
        let with = |found: Match, others: &[Share<'_>]| Match {
            shared: found.shared + listing(others, found.index),
            ..found
        };
        let mut most = best(near.iter().map(|&found| with(found, long)));
        let mut rest = long;
        while let [share, others @ ..] = rest {
            let left: usize = rest.iter().map(|share| share.count).sum();
            // Who is in none of the rows looked at so far shares no more than what is left.
            if most.is_some_and(|found| found.shared > left) {
                break;
            }
            let sharing = |&index: &u32| Match {
                index: index as usize,
                shared: share.count,
            };
            // In the last row all have the same, and the first wins. One that was met in an earlier
            // row counts for less here than it did there, which changes nothing.
            let wanted = if others.is_empty() {
                1
            } else {
                share.row.len()
            };
            #[cfg(test)]
            {
                let each: usize = others.iter().map(|other| probes_in(other.row)).sum();
                self.looked_at += wanted * (1 + each);
            }
            let new = share.row.iter().take(wanted).map(sharing);
            most = best(new.map(|found| with(found, others)).chain(most));
            rest = others;
        }
        most
    }

    /// How many points each primitive shares in some classes. O(entries of their rows).
    fn count(&mut self, shares: &[Share<'_>]) -> impl Iterator<Item = Match> {
        for share in shares {
            #[cfg(test)]
            {
                self.looked_at += share.row.len();
            }
            for &primitive in share.row {
                self.shared.add(primitive, share.count);
            }
        }
        let counted = self.shared.drain();
        counted.map(|(index, shared)| Match { index, shared })
    }
}

/// That with most shared points; of equals, the first primitive.
fn best(matches: impl Iterator<Item = Match>) -> Option<Match> {
    matches.max_by_key(|found| (found.shared, Reverse(found.index)))
}

/// How many of the points a primitive lists: those of the classes whose rows hold it.
fn listing(shares: &[Share<'_>], index: usize) -> usize {
    let holds = |share: &&Share<'_>| {
        let place = |&primitive: &u32| (primitive as usize).cmp(&index);
        share.row.binary_search_by(place).is_ok()
    };
    shares.iter().filter(holds).map(|share| share.count).sum()
}

/// How many entries a search in a row looks at.
fn probes_in(row: &[u32]) -> usize {
    row.len().ilog2() as usize + 1
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

    /// Lists on few of a hundred points, so that rows are long: more primitives than are counted.
    fn heaped() -> impl Strategy<Value = Vec<Vec<u32>>> {
        let list = prop::collection::btree_set(prop_oneof![0u32..4, 0u32..100], 0..5);
        let list = list.prop_map(|list| list.into_iter().collect());
        prop::collection::vec(list, 0..4 * SHORT)
    }

    /// The matches of counting every pair.
    fn counted(from: &[Vec<u32>], to: &[Vec<u32>], points: u32) -> Vec<Option<(usize, usize)>> {
        let best = |one: &Vec<u32>| {
            let shared = |other: &Vec<u32>| {
                let both = |point: &&u32| **point < points && other.contains(point);
                one.iter().filter(both).count()
            };
            let counts: Vec<usize> = to.iter().map(shared).collect();
            let most = counts.iter().copied().max().filter(|&most| most > 0)?;
            Some((counts.iter().position(|&count| count == most)?, most))
        };
        from.iter().map(best).collect()
    }

    fn slices(lists: &[Vec<u32>]) -> Vec<&[u32]> {
        lists.iter().map(Vec::as_slice).collect()
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
            prop_assert_eq!(matches(&slices(&from), &slices(&to)), counted(&from, &to, 10));
        }

        #[test]
        fn heaps_of_lists_on_few_points_have_the_same_matches(from in heaped(), to in heaped()) {
            let incidence = Incidence::new(&segmentation(&slices(&to)), 90);
            let found = best_matches(&segmentation(&slices(&from)), &incidence);
            let found: Vec<_> = found.iter().map(|m| m.map(|m| (m.index, m.shared))).collect();
            prop_assert_eq!(found, counted(&from, &to, 90));
        }
    }

    /// Primitives that all share points, and what else they list. Where every primitive of a shared
    /// point is looked at for every list, as many entries are looked at as the square of their number.
    #[test]
    fn few_entries_are_looked_at_however_many_primitives_share_a_point() {
        const MANY: u32 = 20_000;
        let shapes: [fn(u32) -> Vec<u32>; 5] = [
            |_| vec![0],
            |own| vec![0, own],
            |own| vec![own % 2, 2, own],
            |own| vec![own % 3, (own + 1) % 3],
            |own| vec![0, own, own + 1],
        ];
        for (place, shape) in shapes.into_iter().enumerate() {
            let lists: Vec<Vec<u32>> = (0..MANY).map(|own| shape(own + 3)).collect();
            let all = segmentation(&slices(&lists));
            let incidence = Incidence::new(&all, MANY as usize + 4);
            let mut search = Search::new(&incidence);
            let found = lists.iter().map(|list| search.best_of(list));
            assert!(found.collect::<Vec<_>>().iter().all(Option::is_some));
            // Short rows, and a search in each of the long ones: not thousands.
            let listed: usize = lists.iter().map(Vec::len).sum();
            let each = search.looked_at / listed;
            assert!(
                each < 64,
                "shape {place}: {each} entries for each listed point"
            );
        }
    }
}
