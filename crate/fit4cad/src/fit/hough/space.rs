//! A discretised region of parameter space: cells that know their neighbours.

/// Cells numbered from 0, with a symmetric neighbourhood.
pub trait Space {
    /// Number of cells.
    fn len(&self) -> usize;

    /// Whether there is no cell.
    fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// Calls `visit` for every neighbour of a cell, in a fixed order.
    fn neighbours(&self, cell: usize, visit: &mut dyn FnMut(usize));

    /// Coordinates of the middle of a cell; those beyond the space's dimension are 0.
    fn centre(&self, cell: usize) -> [f64; 3];
}
