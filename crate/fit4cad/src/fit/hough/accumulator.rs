//! The accumulator function 𝓗: how many votes each cell of a parameter space holds.
//!
//! Kept sparse: local solutions light one cell each, so nearly all cells of a space are empty. The
//! votes are sorted by cell once, O(v log v), and are then read both ways: the height of a cell,
//! and who voted for it.

use super::persistence::{self, Peak};
use super::space::Space;

/// One vote for one cell.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ballot {
    /// The cell of the space.
    pub cell: usize,
    /// Whatever voted: an index the caller can look up.
    pub voter: u32,
    /// How much the vote counts, not negative.
    pub weight: f32,
}

/// The non-empty cells of 𝓗, ascending, with their voters.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Accumulator {
    cells: Vec<usize>,
    heights: Vec<f64>,
    starts: Vec<u32>,
    voters: Vec<u32>,
}

impl Accumulator {
    /// Counts the votes. The order in which they come does not matter. O(v log v).
    pub fn count(mut ballots: Vec<Ballot>) -> Self {
        ballots.sort_unstable_by_key(|ballot| (ballot.cell, ballot.voter));
        let mut counted = Self::default();
        for ballot in &ballots {
            if counted.cells.last() != Some(&ballot.cell) {
                counted.starts.push(counted.voters.len() as u32);
                counted.cells.push(ballot.cell);
                counted.heights.push(0.0);
            }
            if let Some(height) = counted.heights.last_mut() {
                *height += f64::from(ballot.weight);
            }
            counted.voters.push(ballot.voter);
        }
        counted.starts.push(counted.voters.len() as u32);
        counted
    }

    /// The cells that hold a vote, ascending.
    pub fn cells(&self) -> &[usize] {
        &self.cells
    }

    /// The heights of those cells, in the same order.
    pub fn heights(&self) -> &[f64] {
        &self.heights
    }

    /// The voters of the cell at a position in [`cells`](Self::cells), ascending.
    pub fn voters_at(&self, position: usize) -> &[u32] {
        match (self.starts.get(position), self.starts.get(position + 1)) {
            (Some(&from), Some(&to)) => &self.voters[from as usize..to as usize],
            _ => &[],
        }
    }

    /// Where a cell stands in [`cells`](Self::cells), if it holds a vote. O(log cells).
    pub fn position(&self, cell: usize) -> Option<usize> {
        self.cells.binary_search(&cell).ok()
    }

    /// The height of any cell of the space.
    pub fn height(&self, cell: usize) -> f64 {
        self.position(cell).map_or(0.0, |at| self.heights[at])
    }

    /// All local maxima with their persistence, most persistent first.
    pub fn maxima(&self, space: &impl Space) -> persistence::Diagram {
        persistence::diagram(&self.heights, |position, visit| {
            space.neighbours(self.cells[position], &mut |cell| {
                if let Some(other) = self.position(cell) {
                    visit(other);
                }
            });
        })
    }

    /// The voters of a peak: of its own cell and of every neighbour that belongs to its basin, so
    /// that votes spread over a cell border stay together. Ascending, each once.
    pub fn voters_of(
        &self,
        space: &impl Space,
        diagram: &persistence::Diagram,
        peak: &Peak,
    ) -> Vec<u32> {
        let basin = diagram.basins[peak.position];
        let mut voters = self.voters_at(peak.position).to_vec();
        space.neighbours(self.cells[peak.position], &mut |cell| {
            if let Some(other) = self.position(cell)
                && diagram.basins[other] == basin
            {
                voters.extend_from_slice(self.voters_at(other));
            }
        });
        voters.sort_unstable();
        voters.dedup();
        voters
    }
}

#[cfg(test)]
mod tests {
    use super::super::grid::{Axis, Grid};
    use super::*;

    fn ballots(cells: &[usize]) -> Vec<Ballot> {
        cells
            .iter()
            .enumerate()
            .map(|(voter, &cell)| Ballot {
                cell,
                voter: voter as u32,
                weight: 1.0,
            })
            .collect()
    }

    #[test]
    fn votes_are_counted_by_cell_and_remember_their_voters() {
        let counted = Accumulator::count(ballots(&[7, 2, 7, 7, 9]));
        assert_eq!(counted.cells(), [2, 7, 9]);
        assert_eq!(counted.heights(), [1.0, 3.0, 1.0]);
        assert_eq!(counted.voters_at(1), [0, 2, 3]);
        assert_eq!(counted.height(7), 3.0);
        assert_eq!(counted.height(8), 0.0);
    }

    #[test]
    fn an_accumulator_without_votes_has_no_maxima() {
        let grid = Grid::new(vec![Axis::new(0.0, 1.0, 0.1)]);
        let counted = Accumulator::count(Vec::new());
        assert!(counted.maxima(&grid).peaks.is_empty());
    }

    #[test]
    fn a_peak_gathers_the_votes_on_both_sides_of_a_cell_border() {
        let grid = Grid::new(vec![Axis::new(0.0, 10.0, 1.0)]);
        let counted = Accumulator::count(ballots(&[3, 3, 3, 4, 4, 8]));
        let diagram = counted.maxima(&grid);
        assert_eq!(diagram.peaks.len(), 2);
        let voters = counted.voters_of(&grid, &diagram, &diagram.peaks[0]);
        assert_eq!(voters, [0, 1, 2, 3, 4]);
    }
}
