//! Which primitive of one segmentation overlaps most with each primitive of another.

use crate::model::Segmentation;

/// The primitive that shares most points with a given one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Match {
    /// Its place in the other segmentation.
    pub index: usize,
    /// How many points the two share; at least one.
    pub shared: usize,
}

/// For every point of a cloud, the primitives that list it: compressed rows, so that a pass over
/// a primitive's points walks memory forwards and hashes nothing.
#[derive(Debug, Clone)]
pub struct Incidence {
    /// Where each point's row begins in `primitives`; one entry more than there are points.
    offsets: Vec<usize>,
    primitives: Vec<u32>,
    primitive_count: usize,
}

impl Incidence {
    /// Turns the lists of a segmentation round. Indices beyond the cloud are left out.
    /// O(points + listed indices).
    pub fn new(segmentation: &Segmentation, points: usize) -> Self {
        let listed = || {
            let numbered = (0u32..).zip(&segmentation.primitives);
            numbered.flat_map(|(primitive, entry)| {
                let points = entry.points.iter().map(|&point| point as usize);
                points.map(move |point| (primitive, point))
            })
        };
        let mut offsets = vec![0; points + 1];
        for (_, point) in listed() {
            if let (true, Some(count)) = (point < points, offsets.get_mut(point + 1)) {
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
        for (primitive, point) in listed().filter(|(_, point)| *point < points) {
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
            primitive_count: segmentation.primitives.len(),
        }
    }

    /// Indices of the primitives that list a point, ascending; none for a point beyond the cloud.
    pub fn primitives_of(&self, point: u32) -> &[u32] {
        let point = point as usize;
        let (Some(&from), Some(&to)) = (self.offsets.get(point), self.offsets.get(point + 1))
        else {
            return &[];
        };
        self.primitives.get(from..to).unwrap_or(&[])
    }

    /// Whether any primitive lists the point.
    pub fn is_labelled(&self, point: u32) -> bool {
        !self.primitives_of(point).is_empty()
    }

    /// How many points of the cloud some primitive lists. O(points).
    pub fn labelled_count(&self) -> usize {
        let rows = self.offsets.iter().zip(self.offsets.iter().skip(1));
        rows.filter(|(from, to)| from < to).count()
    }
}

/// For each primitive of `from`, the one of `to` with which it shares most points; of equals, the
/// first; `None` if it shares none with any (PROTOCOL, "Matching"). Several may have one match.
/// `incidence` is that of `to`. O(primitives + overlaps).
pub fn best_matches(from: &Segmentation, incidence: &Incidence) -> Vec<Option<Match>> {
    let mut shared = vec![0usize; incidence.primitive_count];
    let mut touched: Vec<usize> = Vec::new();
    let best_of = |points: &[u32]| {
        for &point in points {
            for &primitive in incidence.primitives_of(point) {
                let primitive = primitive as usize;
                if let Some(count) = shared.get_mut(primitive) {
                    if *count == 0 {
                        touched.push(primitive);
                    }
                    *count += 1;
                }
            }
        }
        let mut best: Option<Match> = None;
        for index in touched.drain(..) {
            let Some(count) = shared.get_mut(index) else {
                continue;
            };
            let shared = std::mem::take(count);
            let better = best.is_none_or(|best| {
                shared > best.shared || (shared == best.shared && index < best.index)
            });
            if better {
                best = Some(Match { index, shared });
            }
        }
        best
    };
    let lists = from
        .primitives
        .iter()
        .map(|primitive| primitive.points.as_slice());
    lists.map(best_of).collect()
}

#[cfg(test)]
mod tests {
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
}
