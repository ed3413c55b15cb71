//! Point numbers, as files use them, and indices into a cloud.

/// Between the point numbers of a file (1-based rows of `PCi.txt`) and indices into its
/// [`Cloud`](super::Cloud), both ways.
///
/// A row that cannot be read keeps its number and has no index, so that one broken row does not
/// shift every point after it.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Numbering {
    rows: usize,
    /// Rows without a point, counted from 0, ascending.
    broken: Vec<u32>,
}

/// What a point number stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointNumber {
    /// The point at this index of the cloud.
    Index(u32),
    /// A row of the cloud file that could not be read.
    Broken,
    /// No row: 0, or beyond the last.
    Outside,
}

impl Numbering {
    /// The numbering of a cloud of `points` points without broken rows.
    pub fn of(points: usize) -> Self {
        Self {
            rows: points,
            broken: Vec::new(),
        }
    }

    /// The numbering of so many rows of which some, counted from 0 and ascending, are broken.
    pub(crate) fn with_broken(rows: usize, broken: Vec<u32>) -> Self {
        debug_assert!(broken.is_sorted() && broken.len() <= rows);
        Self { rows, broken }
    }

    /// Rows without a point, counted from 0, ascending.
    pub(crate) fn broken(&self) -> &[u32] {
        &self.broken
    }

    /// Number of rows, broken ones included: the largest point number.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Whether every row is a point, so that a point's number is its index and one.
    pub fn is_plain(&self) -> bool {
        self.broken.is_empty()
    }

    /// Of what the file's rows have, one each, what its points have. O(r log b) for r rows and b broken ones.
    pub fn of_points<T>(&self, rows: impl Iterator<Item = T>) -> impl Iterator<Item = T> {
        let is_point =
            |number: u64| self.is_plain() || matches!(self.resolve(number), PointNumber::Index(_));
        (1u64..)
            .zip(rows)
            .filter_map(move |(number, of_row)| is_point(number).then_some(of_row))
    }

    /// The number of the point at an index. O(log b) for b broken rows.
    pub fn number(&self, index: u32) -> u64 {
        // The k-th broken row, counted from 0, comes after as many points as its row less k, which
        // does not fall with k.
        let (mut before, mut end) = (0, self.broken.len());
        while before < end {
            let middle = before + (end - before) / 2;
            if self.broken[middle] as usize - middle <= index as usize {
                before = middle + 1;
            } else {
                end = middle;
            }
        }
        u64::from(index) + before as u64 + 1
    }

    /// What a number stands for. O(log b) for b broken rows.
    #[inline]
    pub fn resolve(&self, number: u64) -> PointNumber {
        let row = match usize::try_from(number) {
            Ok(number) if (1..=self.rows).contains(&number) => number - 1,
            _ => return PointNumber::Outside,
        };
        // Rows are at most `MAX_POINTS`, so they fit.
        let row = row as u32;
        if self.broken.is_empty() {
            return PointNumber::Index(row);
        }
        match self.broken.binary_search(&row) {
            Ok(_) => PointNumber::Broken,
            Err(before) => PointNumber::Index(row - before as u32),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_indices_are_each_others_inverse_whatever_rows_are_broken() {
        for broken in [
            vec![],
            vec![0],
            vec![0, 1, 2],
            vec![3, 4, 8],
            vec![9],
            vec![1, 5, 9],
        ] {
            let numbering = Numbering::with_broken(10, broken.clone());
            let points = 10 - broken.len() as u32;
            let numbers: Vec<u64> = (0..points).map(|index| numbering.number(index)).collect();
            let whole = (1..=10).filter(|number| !broken.contains(&(*number as u32 - 1)));
            assert_eq!(numbers, whole.collect::<Vec<u64>>());
            for (index, &number) in (0..).zip(&numbers) {
                assert_eq!(numbering.resolve(number), PointNumber::Index(index));
            }
        }
    }
}
