//! One-to-one matching of primitives: the assignment problem (Kuhn 1955, Munkres 1957).

use std::collections::BTreeMap;

use pathfinding::kuhn_munkres::{Weights, kuhn_munkres};

use super::overlaps::{Overlap, Overlaps};
use crate::disjoint::DisjointSets;

/// Cells of the largest dense table: 2,000 by 2,000 primitives, solved in some seconds.
const MOST_CELLS: usize = 4_000_000;

/// Values are compared in whole steps of 2⁻⁴⁰: sums of whole numbers do not hang on their order, so
/// that the same pairs are matched on every machine.
const STEPS: f64 = (1u64 << 40) as f64;

/// A true primitive's partner, and how well the two coincide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Partner {
    /// Place of the predicted primitive.
    pub predicted: usize,
    /// Intersection over union with it; more than 0.
    pub iou: f64,
}

/// The one-to-one matching with the largest sum of IoU, among the pairs that `keep` admits: for each
/// true primitive its partner, `None` where it has none. Only primitives that share points are
/// partners: a pair without overlap adds nothing, and what to do with the rest is for the protocol
/// to say.
///
/// `None` where a connected component of the pairs is larger than 4 million cells. Components are
/// solved one by one: O(pairs · log + Σ r² c) for their r by c primitives, r ≤ c.
pub fn most_iou(
    overlaps: &Overlaps,
    keep: &dyn Fn(Overlap) -> bool,
) -> Option<Vec<Option<Partner>>> {
    let mut partners = vec![None; overlaps.truth.len()];
    let pairs = overlaps.pairs.iter().copied().filter(|&pair| keep(pair));
    for component in components(overlaps, pairs.collect()) {
        let side = |of: fn(&Overlap) -> usize| {
            let mut places: Vec<usize> = component.iter().map(of).collect();
            places.sort_unstable();
            places.dedup();
            places
        };
        let (rows, columns) = (side(|pair| pair.truth), side(|pair| pair.predicted));
        let mut table = Table::new(rows.len(), columns.len())?;
        let cell = |pair: &Overlap| {
            let row = rows.binary_search(&pair.truth).ok()?;
            Some((row, columns.binary_search(&pair.predicted).ok()?))
        };
        for pair in &component {
            if let Some((row, column)) = cell(pair) {
                table.set(row, column, overlaps.iou(*pair));
            }
        }
        let chosen = table.largest();
        for pair in &component {
            let Some((row, column)) = cell(pair) else {
                continue;
            };
            if chosen.get(row) == Some(&Some(column))
                && let Some(partner) = partners.get_mut(pair.truth)
            {
                *partner = Some(Partner {
                    predicted: pair.predicted,
                    iou: overlaps.iou(*pair),
                });
            }
        }
    }
    Some(partners)
}

/// The pairs, those that hang together in one list each.
fn components(overlaps: &Overlaps, pairs: Vec<Overlap>) -> Vec<Vec<Overlap>> {
    let rows = overlaps.truth.len();
    let mut sets = DisjointSets::new(rows + overlaps.predicted.len());
    for pair in &pairs {
        sets.join(pair.truth, rows + pair.predicted);
    }
    let mut lists: BTreeMap<usize, Vec<Overlap>> = BTreeMap::new();
    for pair in pairs {
        lists.entry(sets.root(pair.truth)).or_default().push(pair);
    }
    lists.into_values().collect()
}

/// What each pair of a row and a column is worth.
#[derive(Debug, Clone)]
pub struct Table {
    rows: usize,
    columns: usize,
    /// Row by row of the shorter side, as the algorithm asks for.
    cells: Vec<i64>,
}

impl Table {
    /// A table of nothing but 0; `None` beyond 4 million cells.
    pub fn new(rows: usize, columns: usize) -> Option<Self> {
        let cells = rows.checked_mul(columns)?;
        (cells <= MOST_CELLS).then(|| Self {
            rows,
            columns,
            cells: vec![0; cells],
        })
    }

    /// Sets what a pair is worth, to 2⁻⁴⁰; worths beyond 2¹² are not told apart.
    pub fn set(&mut self, row: usize, column: usize, worth: f64) {
        let place = if self.is_turned() {
            column * self.rows + row
        } else {
            row * self.columns + column
        };
        if let Some(cell) = self.cells.get_mut(place) {
            *cell = (worth.clamp(-4096.0, 4096.0) * STEPS).round() as i64;
        }
    }

    /// The column of each row where the sum of what is chosen is largest: as many pairs as the
    /// shorter side has places. O(r² c) for r by c, r ≤ c.
    pub fn largest(&self) -> Vec<Option<usize>> {
        let mut chosen = vec![None; self.rows];
        if self.cells.is_empty() {
            return chosen;
        }
        let (_, places) = kuhn_munkres(self);
        for (short, long) in places.into_iter().enumerate() {
            let (row, column) = if self.is_turned() {
                (long, short)
            } else {
                (short, long)
            };
            if let Some(slot) = chosen.get_mut(row) {
                *slot = Some(column);
            }
        }
        chosen
    }

    /// Whether the columns are the shorter side.
    const fn is_turned(&self) -> bool {
        self.columns < self.rows
    }
}

impl Weights<i64> for Table {
    fn rows(&self) -> usize {
        self.rows.min(self.columns)
    }

    fn columns(&self) -> usize {
        self.rows.max(self.columns)
    }

    fn at(&self, row: usize, column: usize) -> i64 {
        let place = row * Weights::columns(self) + column;
        self.cells.get(place).copied().unwrap_or(0)
    }

    fn neg(&self) -> Self {
        Self {
            cells: self.cells.iter().map(|cell| -cell).collect(),
            ..*self
        }
    }
}
