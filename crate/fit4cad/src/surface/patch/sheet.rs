//! A mesh over a rectangle of two parameters.

use std::f64::consts::TAU;

use super::extent::Range;
use super::{Mark, Patch};
use crate::cloud::{Direction, Point, Vector};

/// Angle that one facet of a curved surface spans at most.
const FACET: f64 = TAU / 72.0;

/// A rectangle of parameters: rows along one, columns (an angle) along the other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sheet {
    /// Range of the first parameter.
    pub rows: Range,
    /// Range of the second parameter, an angle.
    pub columns: Range,
    /// Whether the surface is straight along the first parameter, and one strip is enough.
    pub straight: bool,
}

impl Sheet {
    /// Meshes a surface given by its point and outer normal (of any length but zero) at each pair
    /// of parameters. The rim leaves out the borders where a closed range meets itself.
    pub fn mesh(
        &self,
        at: impl Fn(f64, f64) -> Point,
        normal: impl Fn(f64, f64) -> Vector,
    ) -> Patch {
        let rows = if self.straight { 1 } else { facets(&self.rows) };
        let columns = facets(&self.columns);
        let value = |range: &Range, step: u32, steps: u32| {
            range.low + range.length() * f64::from(step) / f64::from(steps)
        };
        let mut patch = Patch::default();
        for row in 0..=rows {
            for column in 0..=columns {
                let (a, b) = (
                    value(&self.rows, row, rows),
                    value(&self.columns, column, columns),
                );
                patch.vertices.push(at(a, b));
                let normal = Direction::try_new(normal(a, b), f64::MIN_POSITIVE);
                patch.normals.push(normal.unwrap_or_else(Vector::z_axis));
            }
        }
        let index = |row: u32, column: u32| row * (columns + 1) + column;
        for row in 0..rows {
            for column in 0..columns {
                let (a, b) = (index(row, column), index(row, column + 1));
                let (c, d) = (index(row + 1, column), index(row + 1, column + 1));
                patch.triangles.extend([[a, b, d], [a, d, c]]);
            }
        }
        let mut rim = |from: u32, to: u32| {
            let end = |index: u32| patch.vertices.get(index as usize).copied();
            if let (Some(from), Some(to)) = (end(from), end(to)) {
                patch.lines.push((Mark::Rim, [from, to]));
            }
        };
        if !self.rows.closed {
            for column in 0..columns {
                rim(index(0, column), index(0, column + 1));
                rim(index(rows, column), index(rows, column + 1));
            }
        }
        if !self.columns.closed {
            for row in 0..rows {
                rim(index(row, 0), index(row + 1, 0));
                rim(index(row, columns), index(row + 1, columns));
            }
        }
        patch
    }
}

/// How many facets an angle's range takes.
fn facets(range: &Range) -> u32 {
    // At most a full turn: the cast cannot overflow.
    ((range.length() / FACET).ceil() as u32).clamp(1, 72)
}
