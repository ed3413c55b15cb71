//! Topological persistence of the maxima of an accumulator.
//!
//! Lower a level from the highest cell to the lowest. A component of the superlevel set
//! {cells not below the level} is born at a local maximum and dies where it meets an older one
//! (0-dimensional persistence, Edelsbrunner, Letscher and Zomorodian, 2002; the paper's section
//! "HT: Simple primitive fitting based on Hough transform"). A peak that lives long stands out from
//! its surroundings; one that dies at once is a ripple on another's flank.

use crate::disjoint::DisjointSets;

/// A local maximum and how long it lives as the level falls.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Position of its highest cell among the cells given.
    pub position: usize,
    /// Level at which it appears: its height.
    pub birth: f64,
    /// Level at which it meets an older component; 0, the height of the empty cells, if never.
    pub death: f64,
}

impl Peak {
    /// How long it lives: birth − death.
    pub fn persistence(&self) -> f64 {
        self.birth - self.death
    }
}

/// The persistence diagram of a height function on cells, and the basin of each maximum.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Diagram {
    /// All maxima, most persistent first, then by position.
    pub peaks: Vec<Peak>,
    /// For every cell, the position of the maximum whose component it joined when the level
    /// reached it.
    pub basins: Vec<usize>,
}

impl Diagram {
    /// The peaks whose persistence is at least `share` of the highest cell. The paper's default
    /// share is 0.1.
    pub fn significant(&self, share: f64) -> impl Iterator<Item = &Peak> {
        let highest = self.peaks.iter().map(|peak| peak.birth).fold(0.0, f64::max);
        self.peaks
            .iter()
            .take_while(move |peak| peak.persistence() >= share * highest)
    }
}

/// The persistence of every maximum of `heights`. `neighbours(c, visit)` calls `visit` for the cells
/// next to c and must be symmetric. Of equal heights the earlier cell is the older.
/// Union-find with path halving: O(n log n) and n visits of neighbours.
pub fn diagram(heights: &[f64], neighbours: impl Fn(usize, &mut dyn FnMut(usize))) -> Diagram {
    let mut order: Vec<usize> = (0..heights.len()).collect();
    order.sort_by(|&a, &b| heights[b].total_cmp(&heights[a]).then(a.cmp(&b)));
    let mut rank = vec![0; heights.len()];
    for (age, &cell) in order.iter().enumerate() {
        rank[cell] = age;
    }
    // A component's root is its oldest cell, so the elder rule is a comparison of ranks.
    let mut components = DisjointSets::new(heights.len());
    let mut death = vec![0.0; heights.len()];
    let mut basins: Vec<usize> = (0..heights.len()).collect();
    // The elder that a component joined; a cell of its own counts as never joined.
    let mut joined: Vec<usize> = (0..heights.len()).collect();
    let mut reached = Vec::new();
    for &cell in &order {
        reached.clear();
        neighbours(cell, &mut |other| {
            if rank[other] < rank[cell] {
                reached.push(other);
            }
        });
        for &other in &reached {
            let (mine, theirs) = (components.root(cell), components.root(other));
            if mine == theirs {
                continue;
            }
            let (elder, younger) = if rank[mine] < rank[theirs] {
                (mine, theirs)
            } else {
                (theirs, mine)
            };
            components.hang(younger, elder);
            death[younger] = heights[cell];
            joined[younger] = elder;
        }
        basins[cell] = components.root(cell);
    }
    // A component that dies at the level of its birth was only a part of a plateau or a slope.
    let is_maximum = |cell: usize| joined[cell] == cell || death[cell] < heights[cell];
    for basin in &mut basins {
        while !is_maximum(*basin) {
            *basin = joined[*basin];
        }
    }
    let mut peaks: Vec<Peak> = (0..heights.len())
        .filter(|&cell| is_maximum(cell))
        .map(|cell| Peak {
            position: cell,
            birth: heights[cell],
            death: death[cell],
        })
        .collect();
    peaks.sort_by(|a, b| {
        b.persistence()
            .total_cmp(&a.persistence())
            .then(a.position.cmp(&b.position))
    });
    Diagram { peaks, basins }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn line(heights: &[f64]) -> Diagram {
        let last = heights.len();
        diagram(heights, |cell, visit| {
            if cell > 0 {
                visit(cell - 1);
            }
            if cell + 1 < last {
                visit(cell + 1);
            }
        })
    }

    fn ring(heights: &[f64]) -> Diagram {
        let count = heights.len();
        diagram(heights, |cell, visit| {
            visit((cell + count - 1) % count);
            visit((cell + 1) % count);
        })
    }

    #[test]
    fn a_smaller_peak_dies_at_the_saddle_to_a_higher_one() {
        let found = line(&[0.0, 5.0, 1.0, 3.0, 0.0]);
        let expected = [
            Peak {
                position: 1,
                birth: 5.0,
                death: 0.0,
            },
            Peak {
                position: 3,
                birth: 3.0,
                death: 1.0,
            },
        ];
        assert_eq!(found.peaks, expected);
        assert_eq!(found.basins, [1, 1, 1, 3, 1]);
    }

    #[test]
    fn on_an_angular_axis_the_ends_are_one_peak() {
        assert_eq!(line(&[4.0, 1.0, 1.0, 3.0]).peaks.len(), 2);
        let wrapped = ring(&[4.0, 1.0, 1.0, 3.0]);
        assert_eq!(
            wrapped.peaks,
            [Peak {
                position: 0,
                birth: 4.0,
                death: 0.0
            }]
        );
    }

    #[test]
    fn a_plateau_is_one_peak_and_no_cells_have_none() {
        assert_eq!(line(&[2.0, 2.0, 2.0]).peaks.len(), 1);
        assert!(line(&[]).peaks.is_empty());
    }

    #[test]
    fn the_threshold_is_a_share_of_the_highest_cell() {
        let found = line(&[10.0, 0.0, 1.0, 0.0, 0.9, 0.0]);
        assert_eq!(found.significant(0.1).count(), 2);
        assert_eq!(found.significant(0.05).count(), 3);
    }

    /// By definition: the maximum c dies at the highest level at which the superlevel set joins
    /// it to an older cell, found by flooding the set for every level anew.
    fn by_definition(heights: &[f64], width: usize) -> Vec<Peak> {
        let older =
            |a: usize, b: usize| heights[a] > heights[b] || (heights[a] == heights[b] && a < b);
        let mut levels = heights.to_vec();
        levels.sort_by(|a, b| b.total_cmp(a));
        let mut peaks = Vec::new();
        for cell in 0..heights.len() {
            let mut fate = Some(0.0);
            for &level in levels.iter().filter(|&&level| level <= heights[cell]) {
                let component = flood(heights, width, cell, level);
                if component.iter().any(|&other| older(other, cell)) {
                    // Joined at its own level: it never was a component's oldest cell.
                    fate = (level < heights[cell]).then_some(level);
                    break;
                }
            }
            if let Some(death) = fate {
                peaks.push(Peak {
                    position: cell,
                    birth: heights[cell],
                    death,
                });
            }
        }
        peaks.sort_by(|a, b| {
            b.persistence()
                .total_cmp(&a.persistence())
                .then(a.position.cmp(&b.position))
        });
        peaks
    }

    fn flood(heights: &[f64], width: usize, from: usize, level: f64) -> Vec<usize> {
        let mut seen = vec![from];
        let mut next = 0;
        while next < seen.len() {
            for other in grid_neighbours(seen[next], width, heights.len()) {
                if heights[other] >= level && !seen.contains(&other) {
                    seen.push(other);
                }
            }
            next += 1;
        }
        seen
    }

    /// Four neighbours; columns wrap, rows do not.
    fn grid_neighbours(cell: usize, width: usize, count: usize) -> Vec<usize> {
        let (row, column) = (cell / width, cell % width);
        let mut cells = vec![
            row * width + (column + 1) % width,
            row * width + (column + width - 1) % width,
        ];
        if row > 0 {
            cells.push(cell - width);
        }
        if cell + width < count {
            cells.push(cell + width);
        }
        cells
    }

    proptest! {
        #[test]
        fn union_find_agrees_with_the_definition(
            width in 3_usize..7,
            values in prop::collection::vec(1_u8..9, 42),
        ) {
            let count = values.len() / width * width;
            let heights: Vec<f64> = values[..count].iter().map(|&v| f64::from(v)).collect();
            let found = diagram(&heights, |cell, visit| {
                for other in grid_neighbours(cell, width, count) {
                    visit(other);
                }
            });
            prop_assert_eq!(found.peaks, by_definition(&heights, width));
        }
    }
}
