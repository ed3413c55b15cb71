//! Ways on a chart.

use fit4cad::cloud::Point;

use crate::geometry::chart::Chart;

/// A straight piece of a bound on the chart, in the direction of the bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Segment {
    /// Coordinates at its start.
    pub from: [f64; 2],
    /// Coordinates at its end, which no period separates from the start.
    pub to: [f64; 2],
}

/// An edge laid out: where it is at the places looked at, and whether all of the surface there is one
/// place (a pole).
pub(super) struct Trace {
    pub path: Vec<[f64; 2]>,
    /// The places of both ends in space.
    pub ends: [Point; 2],
}

/// The coordinates, by whole periods as near to others as they come.
pub(super) fn near(chart: &Chart, mut at: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    for (k, axis) in [chart.a, chart.b].into_iter().enumerate() {
        if let Some(period) = axis.period {
            at[k] -= period * ((at[k] - to[k]) / period).round();
        }
    }
    at
}
