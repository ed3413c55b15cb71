//! Joining the edges of a bound to loops, across what was dropped between them.

use super::path::{Segment, Trace, near};
use crate::geometry::chart::Chart;

/// The pieces of all loops, with those that join one edge to the next, and the widest gap in space.
pub(super) fn link(chart: &Chart, loops: &[Vec<Option<Trace>>]) -> (Vec<Segment>, f64) {
    let mut segments = Vec::new();
    let mut gap = 0.0_f64;
    let mut loose_ends: Vec<&Trace> = Vec::new();
    let mut loose_starts: Vec<&Trace> = Vec::new();
    for bound in loops {
        for trace in bound.iter().flatten() {
            let pairs = trace.path.windows(2);
            segments.extend(pairs.map(|pair| Segment {
                from: pair[0],
                to: pair[1],
            }));
        }
        for (k, trace) in bound.iter().enumerate() {
            let next = &bound[(k + 1) % bound.len()];
            match (trace, next) {
                (Some(trace), Some(next)) => gap = gap.max(join(chart, trace, next, &mut segments)),
                // A seam was here: what goes on is wherever it ends.
                (Some(trace), None) => loose_ends.push(trace),
                (None, Some(next)) => loose_starts.push(next),
                (None, None) => {}
            }
        }
    }
    for trace in loose_ends {
        let distance = |start: &Trace| (start.ends[0] - trace.ends[1]).norm();
        let apart = |start: &Trace| {
            let to = near(chart, start.path[0], last(trace));
            (to[0] - last(trace)[0]).abs() + (to[1] - last(trace)[1]).abs()
        };
        let order = |a: &(usize, &&Trace), b: &(usize, &&Trace)| {
            let by_place = distance(a.1).total_cmp(&distance(b.1));
            // At one vertex more than one bound may go on: the nearest on the chart does.
            if (distance(a.1) - distance(b.1)).abs() <= 1e-9 {
                apart(a.1).total_cmp(&apart(b.1))
            } else {
                by_place
            }
        };
        if let Some((k, _)) = loose_starts.iter().enumerate().min_by(order) {
            let start = loose_starts.swap_remove(k);
            gap = gap.max(join(chart, trace, start, &mut segments));
        }
    }
    (segments, gap)
}

fn last(trace: &Trace) -> [f64; 2] {
    trace.path[trace.path.len() - 1]
}

/// Adds the piece from the end of one edge to the start of the next; gives the gap in space.
fn join(chart: &Chart, trace: &Trace, next: &Trace, segments: &mut Vec<Segment>) -> f64 {
    let from = last(trace);
    let to = near(chart, next.path[0], from);
    if from != to {
        segments.push(Segment { from, to });
    }
    (next.ends[0] - trace.ends[1]).norm()
}
