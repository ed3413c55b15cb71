//! Point numbers, as files use them, and indices into a cloud.

/// From the point numbers of a file (1-based rows of `PCi.txt`) to indices into its
/// [`Cloud`](crate::cloud::Cloud).
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
    pub(super) fn with_broken(rows: usize, broken: Vec<u32>) -> Self {
        Self { rows, broken }
    }

    /// Number of rows, broken ones included: the largest point number.
    pub fn rows(&self) -> usize {
        self.rows
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
