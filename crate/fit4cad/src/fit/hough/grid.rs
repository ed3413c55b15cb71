//! A box of parameter space cut into equal cells: offsets, centres, radii and angles.

use super::space::Space;

/// One coordinate of a parameter space, cut into equal steps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axis {
    start: f64,
    step: f64,
    count: usize,
    wraps: bool,
}

impl Axis {
    /// Most steps along one axis; a finer wish is coarsened to it.
    pub const MOST: usize = 1 << 20;

    /// Steps of about `step` from `start` to `end`; an empty or unbounded range is one cell.
    pub fn new(start: f64, end: f64, step: f64) -> Self {
        Self::of(start, end, step, false)
    }

    /// The same for an angle: the last step is next to the first, and values beyond the range are
    /// brought back into it by whole turns of its length.
    pub fn wrapping(start: f64, end: f64, step: f64) -> Self {
        Self::of(start, end, step, true)
    }

    fn of(start: f64, end: f64, step: f64, wraps: bool) -> Self {
        let length = end - start;
        if !(length.is_finite() && start.is_finite() && length > 0.0 && step > 0.0) {
            let start = if start.is_finite() { start } else { 0.0 };
            return Self {
                start,
                step: f64::INFINITY,
                count: 1,
                wraps: false,
            };
        }
        let count = ((length / step).ceil() as usize).clamp(1, Self::MOST);
        Self {
            start,
            step: length / count as f64,
            count,
            wraps,
        }
    }

    /// The same range in at most so many steps.
    fn coarsened(self, most: usize) -> Self {
        if self.count <= most {
            return self;
        }
        Self {
            step: self.step * self.count as f64 / most as f64,
            count: most,
            ..self
        }
    }

    /// Number of steps.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Length of a step; infinite where the axis is one cell without bounds.
    pub fn step(&self) -> f64 {
        self.step
    }

    /// Smallest value of the range.
    pub fn start(&self) -> f64 {
        self.start
    }

    /// The step that holds a value; `None` outside the range and for NaN. The range is closed: its
    /// end belongs to the last step.
    pub fn index(&self, value: f64) -> Option<usize> {
        if !value.is_finite() {
            return None;
        }
        if self.step == f64::INFINITY {
            return Some(0);
        }
        let place = (value - self.start) / self.step;
        let count = self.count as f64;
        if self.wraps {
            let place = place.rem_euclid(count);
            return Some((place as usize).min(self.count - 1));
        }
        (0.0..=count)
            .contains(&place)
            .then(|| (place as usize).min(self.count - 1))
    }

    /// The value in the middle of a step.
    pub fn centre(&self, index: usize) -> f64 {
        if self.step == f64::INFINITY {
            self.start
        } else {
            self.start + (index as f64 + 0.5) * self.step
        }
    }

    /// The step `by` further along, if there is one.
    fn offset(&self, index: usize, by: isize) -> Option<usize> {
        if self.wraps {
            let count = self.count as isize;
            return Some((index as isize + by).rem_euclid(count) as usize);
        }
        index.checked_add_signed(by).filter(|&i| i < self.count)
    }
}

/// The cells of a box with one to three axes, the last axis running fastest.
///
/// Never more than 32 bits count, on any machine: a browser's engine must find what a native one does.
#[derive(Debug, Clone, PartialEq)]
pub struct Grid {
    axes: Vec<Axis>,
}

impl Grid {
    /// Most steps along each of one, two or three axes.
    const MOST: [usize; 3] = [Axis::MOST, 65_535, 1200];

    /// The box of these axes; more steps than can be counted together are coarsened.
    pub fn new(axes: Vec<Axis>) -> Self {
        let dimension = axes.len().clamp(1, Self::MOST.len());
        let most = Self::MOST[dimension - 1];
        let axes = axes.into_iter().map(|axis| axis.coarsened(most)).collect();
        Self { axes }
    }

    /// The axes, slowest first.
    pub fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// The cell of a parameter tuple; `None` outside the box or with fewer values than axes.
    pub fn cell(&self, values: &[f64]) -> Option<usize> {
        if values.len() < self.axes.len() {
            return None;
        }
        let mut cell = 0_usize;
        for (axis, &value) in self.axes.iter().zip(values) {
            cell = cell
                .checked_mul(axis.count)?
                .checked_add(axis.index(value)?)?;
        }
        Some(cell)
    }

    /// The steps of a cell along each axis.
    pub fn place(&self, cell: usize) -> Vec<usize> {
        let mut rest = cell;
        let mut place = vec![0; self.axes.len()];
        for (axis, index) in self.axes.iter().zip(&mut place).rev() {
            *index = rest % axis.count;
            rest /= axis.count;
        }
        place
    }

    /// The parameter tuple in the middle of a cell.
    pub fn parameters(&self, cell: usize) -> Vec<f64> {
        let place = self.place(cell);
        self.axes
            .iter()
            .zip(place)
            .map(|(axis, index)| axis.centre(index))
            .collect()
    }
}

impl Space for Grid {
    fn len(&self) -> usize {
        self.axes
            .iter()
            .fold(1_usize, |cells, axis| cells.saturating_mul(axis.count))
    }

    fn centre(&self, cell: usize) -> [f64; 3] {
        let parameters = self.parameters(cell);
        std::array::from_fn(|axis| parameters.get(axis).copied().unwrap_or(0.0))
    }

    /// The 3ᵈ − 1 cells around a cell, fewer at the border of the box.
    fn neighbours(&self, cell: usize, visit: &mut dyn FnMut(usize)) {
        let place = self.place(cell);
        let around = 3_usize.pow(self.axes.len() as u32);
        let mut seen = Vec::with_capacity(around);
        'around: for code in 0..around {
            let mut digits = code;
            let mut other = 0_usize;
            for (axis, &index) in self.axes.iter().zip(&place) {
                let by = (digits % 3) as isize - 1;
                digits /= 3;
                let Some(index) = axis.offset(index, by) else {
                    continue 'around;
                };
                other = other * axis.count + index;
            }
            // A wrapping axis of one or two steps meets the same cell from both sides.
            if other != cell && !seen.contains(&other) {
                seen.push(other);
                visit(other);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn around(grid: &Grid, cell: usize) -> Vec<usize> {
        let mut cells = Vec::new();
        grid.neighbours(cell, &mut |other| cells.push(other));
        cells.sort_unstable();
        cells
    }

    #[test]
    fn a_value_falls_into_the_step_that_holds_it() {
        let axis = Axis::new(-1.0, 1.0, 0.5);
        assert_eq!(axis.count(), 4);
        assert_eq!(axis.index(-1.0), Some(0));
        assert_eq!(axis.index(0.1), Some(2));
        assert_eq!(axis.index(1.0), Some(3));
        assert_eq!(axis.index(1.1), None);
        assert_eq!(axis.index(f64::NAN), None);
    }

    #[test]
    fn an_angle_comes_back_by_whole_turns() {
        let axis = Axis::wrapping(0.0, std::f64::consts::TAU, 0.1);
        assert_eq!(axis.index(-0.01), Some(axis.count() - 1));
        assert_eq!(axis.index(std::f64::consts::TAU + 0.01), Some(0));
    }

    #[test]
    fn a_range_of_no_length_is_one_cell() {
        let axis = Axis::new(2.0, 2.0, 0.1);
        assert_eq!(
            (axis.count(), axis.index(5.0), axis.centre(0)),
            (1, Some(0), 2.0)
        );
    }

    #[test]
    fn cells_know_their_place_and_centre() {
        let grid = Grid::new(vec![Axis::new(0.0, 3.0, 1.0), Axis::new(0.0, 2.0, 0.5)]);
        assert_eq!(grid.len(), 12);
        let cell = grid.cell(&[2.2, 0.6]).unwrap();
        assert_eq!(cell, 2 * 4 + 1);
        assert_eq!(grid.parameters(cell), vec![2.5, 0.75]);
        assert_eq!(grid.cell(&[1.0]), None);
    }

    #[test]
    fn the_cells_of_any_grid_can_be_counted_in_32_bits() {
        for dimension in 1..=3 {
            let grid = Grid::new(vec![Axis::new(-4.0, 4.0, 1e-9); dimension]);
            assert!(u32::try_from(grid.len()).is_ok());
            let last = grid.cell(&[4.0; 3]).unwrap();
            assert_eq!(last, grid.len() - 1);
            assert_eq!(grid.cell(&[-4.0; 3]), Some(0));
        }
    }

    #[test]
    fn neighbours_stop_at_the_border_and_go_round_an_angle() {
        let flat = Grid::new(vec![Axis::new(0.0, 3.0, 1.0), Axis::new(0.0, 3.0, 1.0)]);
        assert_eq!(around(&flat, 4), vec![0, 1, 2, 3, 5, 6, 7, 8]);
        assert_eq!(around(&flat, 0), vec![1, 3, 4]);
        let round = Grid::new(vec![Axis::wrapping(0.0, 5.0, 1.0)]);
        assert_eq!(around(&round, 0), vec![1, 4]);
        let pair = Grid::new(vec![Axis::wrapping(0.0, 2.0, 1.0)]);
        assert_eq!(around(&pair, 0), vec![1]);
    }
}
