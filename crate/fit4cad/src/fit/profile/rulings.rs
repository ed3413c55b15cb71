//! Rulings: the rows of points in which a mesher lays out faces that were extruded.

use crate::fit::Search;
use crate::fit::quantile::quantile;
use crate::fit::thin::plan::Plan;
use crate::fit::thin::profile::{Place, apart};
use crate::surface::Surface;

/// Points that make a row no accident.
const FEWEST: usize = 4;
/// Side of the cells in which places are collected, in tolerances.
const CELL: f64 = 16.0;
/// Distance between points of one ruling, seen along it, in tolerances.
const SAME: f64 = 4.0;
/// Largest median gap of a ruling, in spacings: points of faces side by side are in rows as well.
const SPARSE: f64 = 6.0;
/// Radius, in half distances of two rulings, around their middle in which no other point may be.
const NARROWED: f64 = 0.9;
/// One in so many places along two rulings may have another point beside it.
const FILLED: usize = 5;
/// Gap beyond which a few points at an end are no part of a ruling, in upper quartiles of its gaps.
const STRAY: f64 = 3.0;
/// Longest gap within a ruling, in spacings.
const GAP: f64 = 12.0;
/// As [`GAP`], in upper quartiles of the gaps of the ruling, where that is more.
const UNEVEN: f64 = 8.0;

/// A row of points along a direction, without long gaps.
#[derive(Debug, Clone, PartialEq)]
pub struct Ruling {
    /// Where it is seen.
    pub place: Place,
    /// Heights at which it begins and ends.
    pub ends: [f64; 2],
    /// Its points, from below.
    pub points: Vec<u32>,
}

impl Ruling {
    /// Whether it runs beside another for most of its length, or the other's, which is not much longer.
    pub fn is_beside(&self, other: &Self) -> bool {
        let common = self.ends[1].min(other.ends[1]) - self.ends[0].max(other.ends[0]);
        let [one, two] = [self, other].map(|it| it.ends[1] - it.ends[0]);
        4.0 * common >= 3.0 * one.min(two) && 3.0 * common >= one.max(two)
    }
}

/// The rulings of a clean cloud along a direction. O(n log n).
pub fn rulings(search: &Search<'_>, plan: &Plan) -> Vec<Ruling> {
    let cell = CELL * search.scale.tolerance;
    let mut cells: Vec<(i64, i64, u32)> = (0u32..)
        .zip(search.cloud.points())
        .map(|(index, point)| {
            let [x, y] = plan.place(point).map(|at| (at / cell).floor() as i64);
            (x, y, index)
        })
        .collect();
    cells.sort_unstable();
    let mut groups: Vec<&[(i64, i64, u32)]> = cells
        .chunk_by(|a, b| (a.0, a.1) == (b.0, b.1))
        .filter(|group| 2 * group.len() >= FEWEST)
        .collect();
    groups.sort_by_key(|group| std::cmp::Reverse(group.len()));
    let mut taken = vec![false; search.cloud.len()];
    let mut rulings = Vec::new();
    for group in groups {
        let places = group.iter().map(|it| plan.place(search.point(it.2)));
        let place = mean(places);
        // The border of a cell may run through a ruling.
        let (x, y) = (group[0].0, group[0].1);
        let mut row: Vec<u32> = Vec::new();
        for x in x - 1..=x + 1 {
            let from = cells.partition_point(|it| (it.0, it.1) < (x, y - 1));
            let near = cells[from..]
                .iter()
                .take_while(|it| it.0 == x && it.1 <= y + 1);
            row.extend(near.map(|it| it.2).filter(|&index| {
                let limit = SAME * search.scale.tolerance;
                !taken[index as usize] && apart(plan.place(search.point(index)), place) <= limit
            }));
        }
        if row.len() < FEWEST {
            continue;
        }
        for &index in &row {
            taken[index as usize] = true;
        }
        split(search, plan, row, &mut rulings);
    }
    rulings
}

/// Adds the parts of a row between its long gaps.
fn split(search: &Search<'_>, plan: &Plan, mut row: Vec<u32>, rulings: &mut Vec<Ruling>) {
    let height = |index: u32| plan.height(search.point(index));
    row.sort_by(|&a, &b| height(a).total_cmp(&height(b)));
    let mut gaps: Vec<f64> = row
        .windows(2)
        .map(|pair| height(pair[1]) - height(pair[0]))
        .collect();
    let median = quantile(&mut gaps, 0.5);
    if median > SPARSE * search.scale.spacing {
        return;
    }
    let wide = quantile(&mut gaps, 0.75);
    let gap = (GAP * search.scale.spacing).max(UNEVEN * wide);
    for part in row.chunk_by(|&a, &b| height(b) - height(a) <= gap) {
        let part = without_strays(part, |a, b| height(b) - height(a) > STRAY * wide);
        let [first, .., last] = *part else {
            continue;
        };
        let ends = [height(first), height(last)];
        if part.len() >= FEWEST && ends[1] - ends[0] > search.scale.spacing {
            rulings.push(Ruling {
                place: mean(part.iter().map(|&index| plan.place(search.point(index)))),
                ends,
                points: part.to_vec(),
            });
        }
    }
}

/// A row without the few points at either end that are far from the others: another face may have
/// points right above.
fn without_strays(row: &[u32], is_far: impl Fn(u32, u32) -> bool) -> &[u32] {
    let is_gap = |&after: &usize| after < row.len() && is_far(row[after - 1], row[after]);
    let start = (1..FEWEST).rev().find(is_gap).unwrap_or(0);
    let last = row.len().saturating_sub(FEWEST - 1).max(start + 1);
    let end = (last..row.len()).find(is_gap).unwrap_or(row.len());
    row.get(start..end).unwrap_or_default()
}

fn mean(places: impl Iterator<Item = Place>) -> Place {
    let mut sum = [0.0; 2];
    let mut count = 0.0;
    for place in places {
        sum = [sum[0] + place[0], sum[1] + place[1]];
        count += 1.0;
    }
    sum.map(|it| it / f64::max(count, 1.0))
}

/// Whether there is nothing off a face between two of its neighbouring rulings, as there would be if
/// it bulged more, or were several that are too short to have rulings.
pub fn is_empty_between(
    search: &Search<'_>,
    plan: &Plan,
    surface: &Surface,
    first: &Ruling,
    second: &Ruling,
) -> bool {
    let middle = plan.point([0, 1].map(|i| 0.5 * (first.place[i] + second.place[i])));
    let radius = NARROWED * 0.5 * apart(first.place, second.place);
    let (low, high) = (
        first.ends[0].max(second.ends[0]),
        first.ends[1].min(second.ends[1]),
    );
    let within = |height: f64| height - low > radius && high - height > radius;
    let mut found = Vec::with_capacity(1);
    let (mut looked, mut filled) = (0, 0);
    for &index in first.points.iter().chain(&second.points) {
        let height = plan.height(search.point(index));
        if within(height) {
            let between = middle + plan.direction.into_inner() * height;
            let is_off =
                |index: u32| surface.distance(search.point(index)) > search.scale.tolerance;
            search.tree.nearest(&between, 1, radius, is_off, &mut found);
            looked += 1;
            filled += usize::from(!found.is_empty());
        }
    }
    FILLED * filled < looked.max(1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_few_points_beyond_a_gap_are_no_part_of_a_row() {
        let heights = [0.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0, 20.0, 21.0];
        let is_far = |a: u32, b: u32| heights[b as usize] - heights[a as usize] > 3.0;
        let row: Vec<u32> = (0..9).collect();
        assert_eq!(without_strays(&row, is_far), [1, 2, 3, 4, 5, 6]);
        assert_eq!(without_strays(&row[1..7], is_far), &row[1..7]);
        assert_eq!(without_strays(&[], is_far), [0u32; 0]);
    }

    #[test]
    fn a_ruling_that_lost_a_part_is_still_beside_the_next() {
        let ruling = |low: f64, high: f64| Ruling {
            place: [0.0, 0.0],
            ends: [low, high],
            points: Vec::new(),
        };
        let whole = ruling(0.0, 30.0);
        assert!(whole.is_beside(&ruling(2.0, 29.0)));
        assert!(whole.is_beside(&ruling(4.0, 17.0)) && ruling(4.0, 17.0).is_beside(&whole));
        assert!(!whole.is_beside(&ruling(20.0, 50.0)));
        assert!(!whole.is_beside(&ruling(4.0, 9.0)));
    }
}
