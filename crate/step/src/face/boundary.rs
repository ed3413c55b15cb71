//! The bounds of a face, laid out on its chart.

use std::collections::BTreeMap;

use fit4cad::cloud::Point;

use super::link::link;
use super::path::{Segment, Trace, near};
use crate::geometry::chart::{Chart, Hint};
use crate::read::topology::{EdgeUse, Face};

/// All bounds of a face.
pub(crate) struct Boundary {
    /// The pieces: each loop closes, but for whole periods.
    pub segments: Vec<Segment>,
    /// Coordinates of places within the face, or on its rim: of seams, which are no bounds.
    pub within: Vec<[f64; 2]>,
    /// How far an edge lies off the surface at most, in millimetres.
    pub off_surface: f64,
    /// The widest gap between edges that should meet, in millimetres.
    pub gap: f64,
}

/// How often an edge is cut in halves: into pieces of a four-thousandth.
const DEEPEST: usize = 12;
/// At how many places an edge is looked at, at most: one that wavers on its surface is not worth more.
const MOST_STOPS: usize = 6000;

/// One place of an edge.
#[derive(Clone, Copy)]
struct Stop {
    share: f64,
    place: Point,
    at: [f64; 2],
    is_pole: bool,
}

struct Tracer<'a> {
    chart: &'a Chart,
    poles: [Option<Point>; 2],
    tolerance: f64,
    off: f64,
    /// How far the edge at hand lies off the surface, as far as it has been seen.
    reach: f64,
    /// At how many places it has been looked at.
    stops: usize,
}

impl Boundary {
    /// Lays out the bounds of a face to within a tolerance in millimetres. Edges that it uses in both
    /// directions are seams or slits, and no bounds.
    pub fn of(face: &Face, chart: &Chart, tolerance: f64) -> Self {
        let kept = without_seams(&face.bounds);
        let seams = face.bounds.iter().flatten().zip(kept.iter().flatten());
        let seams = seams.filter(|(_, kept)| kept.is_none());
        let within = seams.flat_map(|(seam, _)| {
            [0.31, 0.5, 0.69].map(|share| chart.invert(&seam.at(share), None))
        });
        let within = within.collect();
        let poles = [0, 1].map(|end| {
            let at = [chart.a.range[0].max(-1.0), chart.b.range[end]];
            chart.b.poles[end].then(|| chart.at(at))
        });
        let mut tracer = Tracer {
            chart,
            poles,
            tolerance,
            off: 0.0,
            reach: 0.0,
            stops: 0,
        };
        let mut loops: Vec<Vec<Option<Trace>>> = Vec::new();
        for bound in kept {
            let traces = bound.into_iter();
            loops.push(
                traces
                    .map(|it| it.map(|each| tracer.trace(&each)))
                    .collect(),
            );
        }
        let (segments, gap) = link(chart, &loops);
        Self {
            segments,
            within,
            off_surface: tracer.off,
            gap,
        }
    }
}

/// The bounds with nothing in the place of seams.
fn without_seams(bounds: &[Vec<EdgeUse>]) -> Vec<Vec<Option<EdgeUse>>> {
    let mut uses: BTreeMap<u64, [usize; 2]> = BTreeMap::new();
    for each in bounds.iter().flatten() {
        uses.entry(each.key).or_default()[usize::from(each.forward)] += 1;
    }
    // As many of one direction as of the other go; what is used once too often stays.
    let mut left: BTreeMap<u64, [usize; 2]> = BTreeMap::new();
    for (key, [backward, forward]) in uses {
        let pairs = backward.min(forward);
        left.insert(key, [backward - pairs, forward - pairs]);
    }
    let mut keep = |each: &EdgeUse| {
        let count = left
            .get_mut(&each.key)
            .map(|it| &mut it[usize::from(each.forward)]);
        count.is_some_and(|count| {
            let keep = *count > 0;
            *count = count.saturating_sub(1);
            keep
        })
    };
    bounds
        .iter()
        .map(|bound| {
            bound
                .iter()
                .map(|each| keep(each).then(|| each.clone()))
                .collect()
        })
        .collect()
}

impl Tracer<'_> {
    fn trace(&mut self, edge: &EdgeUse) -> Trace {
        let mut shares = edge.edge.shares();
        if !edge.forward {
            shares.reverse();
            for share in &mut shares {
                *share = 1.0 - *share;
            }
        }
        (self.reach, self.stops) = (0.0, 0);
        let mut stops: Vec<Stop> = Vec::new();
        for share in shares {
            let hint = stops.last().map(|stop| stop.at);
            stops.push(self.stop(edge, share, hint));
        }
        // The first of all has had no neighbour to be near to: of two halves of a surface that closes
        // it may lie on either.
        settle_poles(&mut stops);
        let mut path = vec![stops[0].at];
        let mut last = stops[0];
        for next in &stops[1..] {
            self.refine(edge, &last, next, 0, &mut path);
            last = Stop {
                at: path[path.len() - 1],
                ..*next
            };
        }
        let ends = [stops[0].place, stops[stops.len() - 1].place];
        Trace { path, ends }
    }

    fn stop(&mut self, edge: &EdgeUse, share: f64, hint: Option<[f64; 2]>) -> Stop {
        let place = edge.at(share);
        let reach = self.reach;
        let hint = hint.map(|at| Hint { at, reach });
        let mut at = self.chart.invert(&place, hint);
        self.stops += 1;
        let foot = self.chart.at(at);
        let off = (foot - place).norm();
        if off.is_finite() {
            self.off = self.off.max(off);
            self.reach = self.reach.max(1.5 * off);
        }
        let mut is_pole = false;
        for (end, pole) in self.poles.iter().enumerate() {
            if pole.is_some_and(|pole| (foot - pole).norm() <= 0.1 * self.tolerance) {
                is_pole = true;
                at[1] = self.chart.b.range[end];
            }
        }
        Stop {
            share,
            place,
            at,
            is_pole,
        }
    }

    /// The coordinates, by whole periods as near to others as they come.
    fn near(&self, at: [f64; 2], to: [f64; 2]) -> [f64; 2] {
        near(self.chart, at, to)
    }

    /// Adds the path from one stop, to which it has come, to the next, straight where that is near
    /// enough. By which way around it goes is only seen from near by.
    fn refine(
        &mut self,
        edge: &EdgeUse,
        from: &Stop,
        to: &Stop,
        depth: usize,
        path: &mut Vec<[f64; 2]>,
    ) {
        let end = self.near(to.at, from.at);
        let short = (from.place - to.place).norm() <= 0.1 * self.tolerance;
        if depth >= DEEPEST || self.stops >= MOST_STOPS || (depth > 0 && short) {
            path.push(end);
            return;
        }
        let middle = [0.5 * (from.at[0] + end[0]), 0.5 * (from.at[1] + end[1])];
        let mut stop = self.stop(edge, 0.5 * (from.share + to.share), Some(middle));
        if stop.is_pole {
            stop.at[0] = middle[0];
        }
        let at = self.near(stop.at, middle);
        if !self.is_wide(from.at, end) && self.error(from.at, end, at) <= self.tolerance {
            path.push(end);
            return;
        }
        self.refine(edge, from, &stop, depth + 1, path);
        let half = Stop {
            at: path[path.len() - 1],
            ..stop
        };
        self.refine(edge, &half, to, depth + 1, path);
    }

    /// Whether coordinates lie so far apart that the other way around may be meant.
    fn is_wide(&self, from: [f64; 2], to: [f64; 2]) -> bool {
        let axes = [self.chart.a, self.chart.b];
        (0..2).any(|k| {
            axes[k]
                .period
                .is_some_and(|period| (to[k] - from[k]).abs() > 0.3 * period)
        })
    }

    /// How far, in space, coordinates lie from the straight way on the chart.
    fn error(&self, from: [f64; 2], to: [f64; 2], at: [f64; 2]) -> f64 {
        let here = self.chart.at(at);
        let way = [to[0] - from[0], to[1] - from[1]];
        // By how much either coordinate moves things, to drop a perpendicular.
        let scale = |k: usize| {
            let mut beside = at;
            let step = 1e-4 * way[k].abs().max(1e-9);
            beside[k] += step;
            (self.chart.at(beside) - here).norm() / step
        };
        let (sa, sb) = (scale(0), scale(1));
        let (wa, wb) = (way[0] * sa, way[1] * sb);
        let (oa, ob) = ((at[0] - from[0]) * sa, (at[1] - from[1]) * sb);
        let square = wa * wa + wb * wb;
        let share = if square > 0.0 {
            ((oa * wa + ob * wb) / square).clamp(0.0, 1.0)
        } else {
            0.5
        };
        let straight = [from[0] + way[0] * share, from[1] + way[1] * share];
        (self.chart.at(straight) - here).norm()
    }
}

/// Gives stops at poles, where the first coordinate says nothing, that of a neighbour.
fn settle_poles(stops: &mut [Stop]) {
    for k in 1..stops.len() {
        if stops[k].is_pole && !stops[k - 1].is_pole {
            stops[k].at[0] = stops[k - 1].at[0];
        }
    }
    for k in (0..stops.len().saturating_sub(1)).rev() {
        if stops[k].is_pole && (k == 0 || stops[k - 1].is_pole) {
            stops[k].at[0] = stops[k + 1].at[0];
        }
    }
}
