//! How many points each true primitive shares with each predicted one.

use std::collections::BTreeMap;

use super::super::matching::Incidence;
use crate::model::Segmentation;

/// Pairs of primitives looked at for one table. Parts of the benchmark have some ten thousand; beyond
/// this, lists heap up on the same points, and the table would no longer be sparse.
const MOST_PAIRS: usize = 20_000_000;

/// A true and a predicted primitive that share points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Overlap {
    /// Place of the true primitive.
    pub truth: usize,
    /// Place of the predicted one.
    pub predicted: usize,
    /// How many points they share; at least one.
    pub shared: usize,
}

/// The sizes of all primitives and the sparse table of their overlaps: all that measures of
/// segmentation are made of. Primitives are sets: a point of several primitives is a member of each.
/// Indices beyond the cloud do not exist.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Overlaps {
    /// Number of points of the cloud.
    pub points: usize,
    /// Number of points of each true primitive.
    pub truth: Vec<usize>,
    /// Number of points of each predicted primitive.
    pub predicted: Vec<usize>,
    /// The pairs that share points, ascending by true, then by predicted primitive.
    pub pairs: Vec<Overlap>,
}

impl Overlaps {
    /// Counts the overlaps of two segmentations of a cloud; `None` where so many primitives list the
    /// same points that the table would not be sparse (20 million pairs, point class by point class).
    /// O(listed indices · log + pairs · log).
    pub fn of(points: usize, truth: &Segmentation, predicted: &Segmentation) -> Option<Self> {
        let (of_truth, of_predicted) = (
            Incidence::new(truth, points),
            Incidence::new(predicted, points),
        );
        Self::between(points, &of_truth, &of_predicted)
    }

    /// The same of segmentations that are turned round already.
    pub(in crate::metrics) fn between(
        points: usize,
        truth: &Incidence,
        predicted: &Incidence,
    ) -> Option<Self> {
        // Points that the same primitives list on both sides are counted together.
        let mut classes: Vec<(u32, u32)> = truth.classes().zip(predicted.classes()).collect();
        classes.sort_unstable();
        let (mut of_truth, mut of_predicted) = (vec![0; truth.count()], vec![0; predicted.count()]);
        let mut work = 0usize;
        let mut shared: BTreeMap<(u32, u32), usize> = BTreeMap::new();
        for alike in classes.chunk_by(|one, other| one == other) {
            let Some(&(class, other)) = alike.first() else {
                continue;
            };
            let (rows, columns) = (truth.listing(class), predicted.listing(other));
            work = work.saturating_add(rows.len().saturating_mul(columns.len()));
            if work > MOST_PAIRS {
                return None;
            }
            for (sizes, places) in [(&mut of_truth, rows), (&mut of_predicted, columns)] {
                for &place in places {
                    if let Some(size) = sizes.get_mut(place as usize) {
                        *size += alike.len();
                    }
                }
            }
            for &row in rows {
                for &column in columns {
                    *shared.entry((row, column)).or_default() += alike.len();
                }
            }
        }
        let pairs = shared.into_iter();
        Some(Self {
            points,
            truth: of_truth,
            predicted: of_predicted,
            pairs: pairs
                .map(|((truth, predicted), shared)| Overlap {
                    truth: truth as usize,
                    predicted: predicted as usize,
                    shared,
                })
                .collect(),
        })
    }

    /// Intersection over union of a pair, |G ∩ P| / |G ∪ P|, 0 to 1.
    pub fn iou(&self, pair: Overlap) -> f64 {
        let union = self.both(pair).saturating_sub(pair.shared);
        pair.shared as f64 / union.max(1) as f64
    }

    /// Sørensen–Dice index of a pair, 2 |G ∩ P| / (|G| + |P|), 0 to 1.
    pub fn dice(&self, pair: Overlap) -> f64 {
        (2 * pair.shared) as f64 / self.both(pair).max(1) as f64
    }

    /// |G| + |P|.
    fn both(&self, pair: Overlap) -> usize {
        let size = |sizes: &[usize], place: usize| sizes.get(place).copied().unwrap_or(0);
        size(&self.truth, pair.truth) + size(&self.predicted, pair.predicted)
    }
}
