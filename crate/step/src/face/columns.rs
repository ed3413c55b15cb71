//! Inside and outside: along each column of the chart, where the face begins and ends.

use super::boundary::Boundary;
use super::path::Segment;
use crate::geometry::chart::Chart;

/// Into how many strips a face is cut, at least and at most.
pub(crate) type Strips = [usize; 2];

/// Where the state at one end of a column is known from.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Anchor {
    /// Below the lowest crossing is outside.
    Low,
    /// Above the highest crossing is outside.
    High,
    /// The direction of the bounds tells, by a vote: inside where they run, seen from outside,
    /// against the clock.
    Vote,
}

/// A face cut into strips, each between two values of the first coordinate.
pub(crate) struct Columns {
    segments: Vec<Segment>,
    /// Borders of the strips, ascending: one more than there are strips.
    pub borders: Vec<f64>,
    /// Which segments each strip meets.
    lists: Vec<Vec<u32>>,
    anchor: Anchor,
    /// With the anchor of a vote: the state where the counting starts.
    base: bool,
    b_range: [f64; 2],
    b_period: Option<f64>,
    a_period: Option<f64>,
    /// Values of the first coordinate at which bounds cross the start of a column that closes, and
    /// whether they do so upwards.
    cuts: Vec<(f64, bool)>,
    /// Whether bounds turn over: their left is the other side.
    turned: bool,
    /// Share of the vote that the winning side had; 1 where none was held.
    pub agreement: f64,
}

/// A crossing of a column with a bound.
#[derive(Clone, Copy)]
struct Crossing {
    b: f64,
    rising: bool,
}

impl Columns {
    /// Cuts the region within `segments` into strips; `None` where it has no end.
    pub fn of(chart: &Chart, boundary: Boundary, same_sense: bool, strips: Strips) -> Option<Self> {
        let Boundary {
            segments, within, ..
        } = boundary;
        let [low, high] = chart.b.range;
        let poles = chart.b.poles;
        let anchor = if chart.b.period.is_some() || (poles[0] && poles[1]) {
            Anchor::Vote
        } else if poles[0] {
            Anchor::High
        } else {
            Anchor::Low
        };
        let whole = segments.is_empty();
        let ends_of = |k: usize| {
            let values = segments.iter().flat_map(move |it| [it.from[k], it.to[k]]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], it| {
                [a.min(it), b.max(it)]
            })
        };
        let (mut a_range, mut b_range) = (chart.a.range, [low, high]);
        if !whole {
            if chart.a.period.is_none() {
                let [from, to] = ends_of(0);
                a_range = [from.max(a_range[0]), to.min(a_range[1])];
            }
            let [from, to] = ends_of(1);
            if !low.is_finite() {
                b_range[0] = from;
            }
            if !high.is_finite() {
                b_range[1] = to;
            }
        }
        if let (Some(period), false) = (chart.b.period, whole) {
            let start = clear_of(&segments, b_range[0], period);
            b_range = [start, start + period];
        }
        let finite = a_range.iter().chain(&b_range).all(|it| it.is_finite());
        if !finite || a_range[0] >= a_range[1] {
            return None;
        }
        let segments = unrolled(segments, a_range, chart.a.period);
        let [breaks, _] = chart.breaks();
        let borders = borders(&segments, &breaks, a_range, strips);
        let lists = lists(&segments, &borders);
        let mut columns = Self {
            segments,
            borders,
            lists,
            anchor,
            base: false,
            b_range,
            b_period: chart.b.period,
            a_period: chart.a.period,
            cuts: Vec::new(),
            turned: same_sense == chart.is_swapped(),
            agreement: 1.0,
        };
        columns.cuts = columns.cuts();
        if whole {
            columns.anchor = Anchor::Vote;
            columns.base = true;
        } else if anchor == Anchor::Vote {
            columns.vote(&within);
        }
        Some(columns)
    }

    /// How many strips there are.
    pub fn len(&self) -> usize {
        self.lists.len()
    }

    /// Whether the face holds coordinates, which may have gone around.
    pub fn holds(&self, [a, b]: [f64; 2]) -> bool {
        let mut found = Vec::new();
        let wrap = |value: f64, low: f64, period: Option<f64>| {
            period.map_or(value, |period| {
                value - period * ((value - low) / period).floor()
            })
        };
        let a = wrap(a, self.borders[0], self.a_period);
        let b = wrap(b, self.b_range[0], self.b_period);
        if a < self.borders[0] || a > self.borders[self.len()] {
            return false;
        }
        let after = self.borders.partition_point(|border| *border <= a);
        self.intervals(after.clamp(1, self.len()) - 1, a, &mut found);
        found.iter().any(|[low, high]| (*low..=*high).contains(&b))
    }

    /// The ranges of both coordinates that the face may reach.
    pub fn range(&self) -> [[f64; 2]; 2] {
        [[self.borders[0], self.borders[self.len()]], self.b_range]
    }

    /// How long a column may be.
    pub fn height(&self) -> f64 {
        self.b_range[1] - self.b_range[0]
    }

    /// Where the face lies along a column of a strip: pairs of second coordinates, ascending.
    pub fn intervals(&self, strip: usize, a: f64, found: &mut Vec<[f64; 2]>) {
        found.clear();
        let mut crossings = self.crossings(strip, a);
        crossings.sort_unstable_by(|x, y| x.b.total_cmp(&y.b));
        let mut inside = self.start(a, crossings.len());
        let mut from = self.b_range[0];
        for crossing in &crossings {
            if inside && crossing.b > from {
                found.push([from, crossing.b]);
            }
            inside = !inside;
            from = crossing.b;
        }
        if inside && self.b_range[1] > from {
            found.push([from, self.b_range[1]]);
        }
    }

    /// The state at the start of a column with so many crossings.
    fn start(&self, a: f64, crossings: usize) -> bool {
        match self.anchor {
            Anchor::Low => false,
            Anchor::High => crossings % 2 == 1,
            Anchor::Vote => self.base ^ (self.cuts.partition_point(|(cut, _)| *cut < a) % 2 == 1),
        }
    }

    fn crossings(&self, strip: usize, a: f64) -> Vec<Crossing> {
        let mut found = Vec::new();
        for &index in &self.lists[strip] {
            let Segment { from, to } = &self.segments[index as usize];
            // Half open, so that where two pieces meet one of them is crossed.
            if (from[0] <= a) == (to[0] <= a) {
                continue;
            }
            let share = (a - from[0]) / (to[0] - from[0]);
            let mut b = from[1] + (to[1] - from[1]) * share;
            if let Some(period) = self.b_period {
                b -= period * ((b - self.b_range[0]) / period).floor();
            } else {
                b = b.clamp(self.b_range[0], self.b_range[1]);
            }
            let rising = to[0] > from[0];
            found.push(Crossing { b, rising });
        }
        found
    }

    /// Where the bounds cross the start of the columns, of a chart that closes both ways.
    fn cuts(&self) -> Vec<(f64, bool)> {
        let Some(period) = self.b_period else {
            return Vec::new();
        };
        let mut cuts = Vec::new();
        for Segment { from, to } in &self.segments {
            let turn = |b: f64| ((b - self.b_range[0]) / period).floor();
            let (first, last) = (turn(from[1]), turn(to[1]));
            let mut at = first.min(last) + 1.0;
            while at <= first.max(last) {
                let b = self.b_range[0] + at * period;
                let share = (b - from[1]) / (to[1] - from[1]);
                cuts.push((from[0] + (to[0] - from[0]) * share, last > first));
                at += 1.0;
            }
        }
        let [start, end] = [self.borders[0], self.borders[self.borders.len() - 1]];
        cuts.retain(|(cut, _)| (start..end).contains(cut));
        cuts.sort_unstable_by(|x, y| x.0.total_cmp(&y.0));
        cuts
    }

    /// Decides what is inside: by places that are, as seams have, else by the direction of the bounds,
    /// of which each says it of what lies on its left. Exporters are known to get directions wrong, of
    /// fillets that close above all.
    fn vote(&mut self, within: &[[f64; 2]]) {
        let (mut for_outside, mut for_inside) = (0.0, 0.0);
        // Just beside a seam, on both sides: at it, bounds begin and end.
        let aside = 1e-5 * (self.borders[self.len()] - self.borders[0]);
        for ([a, b], aside) in within.iter().flat_map(|at| [(at, -aside), (at, aside)]) {
            if self.holds([a + aside, *b]) {
                for_outside += 1.0;
            } else {
                for_inside += 1.0;
            }
        }
        if for_inside != for_outside {
            self.base = for_inside > for_outside;
            return;
        }
        for strip in 0..self.len() {
            let width = self.borders[strip + 1] - self.borders[strip];
            let a = self.borders[strip] + 0.5 * width;
            let mut crossings = self.crossings(strip, a);
            crossings.sort_unstable_by(|x, y| x.b.total_cmp(&y.b));
            let mut inside = self.start(a, crossings.len());
            for crossing in crossings {
                inside = !inside;
                // Going towards greater a, the left is above.
                let above = crossing.rising != self.turned;
                if above == inside {
                    for_outside += width;
                } else {
                    for_inside += width;
                }
            }
        }
        if for_inside == for_outside {
            // Bounds that only run along the columns, as of a torus cut across its tube: going up, the left
            // is towards smaller a.
            for (before, (_, rising)) in self.cuts.iter().enumerate() {
                let inside = before % 2 == 1;
                if (*rising != self.turned) == inside {
                    for_outside += 1.0;
                } else {
                    for_inside += 1.0;
                }
            }
        }
        self.base = for_inside > for_outside;
        let total = for_inside + for_outside;
        if total > 0.0 {
            self.agreement = f64::max(for_inside, for_outside) / total;
        }
    }
}

/// Where to begin columns that close: as far as can be from the ends of all segments, so that bounds
/// which run along it do not waver across.
fn clear_of(segments: &[Segment], low: f64, period: f64) -> f64 {
    let wrap = |b: f64| b - period * ((b - low) / period).floor();
    let mut ends: Vec<f64> = segments.iter().map(|it| wrap(it.from[1])).collect();
    ends.sort_unstable_by(f64::total_cmp);
    let (first, last) = (ends[0], ends[ends.len() - 1]);
    let mut widest = (first + period - last, last);
    for pair in ends.windows(2) {
        let gap = (pair[1] - pair[0], pair[0]);
        if gap.0 > widest.0 {
            widest = gap;
        }
    }
    widest.1 + 0.5 * widest.0
}

/// The segments where the chart is looked at: each of a chart that closes once, or twice where it meets
/// the border.
fn unrolled(segments: Vec<Segment>, [low, high]: [f64; 2], period: Option<f64>) -> Vec<Segment> {
    let Some(period) = period else {
        return segments;
    };
    let mut all = Vec::with_capacity(segments.len());
    for Segment { from, to } in segments {
        let (least, most) = (from[0].min(to[0]), from[0].max(to[0]));
        // A hair more: where one ends at the border but for rounding, it must not fall through.
        let first = ((low - most) / period - 1e-9).ceil();
        let last = ((high - least) / period + 1e-9).floor();
        let mut turn = first;
        while turn <= last {
            let shift = turn * period;
            all.push(Segment {
                from: [from[0] + shift, from[1]],
                to: [to[0] + shift, to[1]],
            });
            turn += 1.0;
        }
    }
    all
}

/// Where strips begin and end: at the ends of all segments, where the surface has a break, and often
/// enough between.
fn borders(
    segments: &[Segment],
    breaks: &[f64],
    [low, high]: [f64; 2],
    [least, most]: Strips,
) -> Vec<f64> {
    let mut borders: Vec<f64> = segments
        .iter()
        .flat_map(|it| [it.from[0], it.to[0]])
        .chain(breaks.iter().copied())
        .collect();
    borders.retain(|it| *it > low && *it < high);
    borders.extend((0..=least).map(|k| low + (high - low) * k as f64 / least as f64));
    borders.sort_unstable_by(f64::total_cmp);
    let apart = 1e-9 * (high - low);
    borders.dedup_by(|a, b| *a - *b < apart);
    if let Some(last) = borders.last_mut() {
        *last = high;
    }
    if borders.len() > most + 1 {
        let every = borders.len().div_ceil(most);
        let last = borders.len() - 1;
        let mut place = 0;
        borders.retain(|_| {
            place += 1;
            (place - 1) % every == 0 || place - 1 == last
        });
    }
    borders
}

/// Which segments meet each strip.
fn lists(segments: &[Segment], borders: &[f64]) -> Vec<Vec<u32>> {
    let mut lists = vec![Vec::new(); borders.len() - 1];
    for (index, Segment { from, to }) in segments.iter().enumerate() {
        let (low, high) = (from[0].min(to[0]), from[0].max(to[0]));
        if low == high {
            continue;
        }
        let first = borders.partition_point(|it| *it <= low).saturating_sub(1);
        let after = borders.partition_point(|it| *it < high).min(lists.len());
        for list in lists.iter_mut().take(after).skip(first) {
            list.push(index as u32);
        }
    }
    lists
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Once around a surface that closes, and a rounding error farther: the last piece ends just before
    /// the border at which it belongs, and all of it counts.
    #[test]
    fn a_bound_that_ends_a_hair_beyond_the_border_is_kept() {
        let (low, period) = (-0.045_146_378_366_35, 28.057_281_028_391_35);
        let end = low - 7e-16;
        assert!(end < low);
        let piece = Segment {
            from: [3.294, 0.0],
            to: [end, 0.0],
        };
        let all = unrolled(vec![piece], [low, low + period], Some(period));
        let met = |a: f64| {
            all.iter()
                .filter(move |it| (it.to[0]..it.from[0]).contains(&a))
        };
        assert_eq!(met(1.0).count(), 1);
        assert_eq!(met(20.0).count(), 0);
    }
}
