//! Edges: pieces of curves between vertices.

use fit4cad::cloud::Point;

use super::curve::Curve;

/// A piece of a curve, run through from 0 to 1.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Edge {
    curve: Curve,
    from: f64,
    to: f64,
}

impl Edge {
    /// The piece of a curve from one vertex to another, along the curve (`forward`) or against it.
    /// Where both are one vertex and the curve closes, all of it, in that direction.
    pub fn new(curve: Curve, [start, end]: [Point; 2], one: bool, forward: bool) -> Self {
        if let Curve::Line(..) = curve {
            return Self::straight(start, end);
        }
        let sign = if forward { 1.0 } else { -1.0 };
        let (mut from, mut to) = (curve.parameter(&start), curve.parameter(&end));
        if let Some(period) = curve.period() {
            if let (Some([low, high]), false) = (curve.range(), matches!(curve, Curve::Ellipse(..)))
            {
                let near = 1e-9 * period;
                if forward && high - from < near {
                    from = low;
                } else if !forward && from - low < near {
                    from = high;
                }
            }
            if one {
                to = from + sign * period;
            } else {
                to -= period * ((to - from) / period).floor();
                if !forward {
                    to -= period;
                }
                // Two vertices nearer than the parameter tells apart are next to each other, not a
                // whole turn apart; `to` is less than a period off in the right direction.
                let turn = (to - from).abs() / period;
                let middle = curve.at(from + 0.5 * (to - from)).0;
                if turn > 1.0 - 1e-7 && (end - start).norm() < 1e-6 * (middle - start).norm() {
                    to = from;
                }
            }
        } else if one && let Some([low, high]) = curve.range() {
            (from, to) = if forward { (low, high) } else { (high, low) };
        }
        Self { curve, from, to }
    }

    /// Straight from one place to another.
    pub fn straight(start: Point, end: Point) -> Self {
        Self {
            curve: Curve::Line(start, end - start),
            from: 0.0,
            to: 1.0,
        }
    }

    /// The place at a share of the way, 0 to 1.
    pub fn at(&self, share: f64) -> Point {
        self.curve.at(self.from + (self.to - self.from) * share).0
    }

    /// Shares at which to begin: both ends, where the curve may have a kink, and so many between as
    /// catch each bend of it.
    pub fn shares(&self) -> Vec<f64> {
        let span = self.to - self.from;
        if let Curve::Line(..) = self.curve {
            return vec![0.0, 0.5, 1.0];
        }
        let mut shares = vec![0.0, 1.0];
        if span != 0.0 {
            let period = self.curve.period();
            for knot in self.curve.breaks() {
                for turn in -1..=1 {
                    let knot = knot + f64::from(turn) * period.unwrap_or(0.0);
                    let share = (knot - self.from) / span;
                    if share > 1e-9 && share < 1.0 - 1e-9 {
                        shares.push(share);
                    }
                }
            }
        }
        shares.sort_by(f64::total_cmp);
        shares.dedup_by(|a, b| *a - *b < 1e-9);
        let least = 8;
        let each = least_pieces(shares.len() - 1, least);
        let inner = shares.windows(2).flat_map(|pair| {
            let (from, to) = (pair[0], pair[1]);
            (0..each).map(move |k| from + (to - from) * k as f64 / each as f64)
        });
        let mut all: Vec<f64> = inner.collect();
        all.push(1.0);
        all
    }
}

/// In how many parts to cut each of `pieces` to have `least` and, of each, two.
fn least_pieces(pieces: usize, least: usize) -> usize {
    least.div_ceil(pieces.max(1)).max(2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::placement::Frame;
    use fit4cad::cloud::Vector;

    fn circle() -> Curve {
        let frame = Frame::new(Point::origin(), Vector::z(), Some(Vector::x())).unwrap();
        Curve::Ellipse(frame, 2.0, 2.0)
    }

    fn on(degrees: f64) -> Point {
        let angle = degrees.to_radians();
        Point::new(2.0 * angle.cos(), 2.0 * angle.sin(), 0.0)
    }

    #[test]
    fn an_arc_goes_the_way_of_its_sense() {
        let ends = [on(10.0), on(100.0)];
        let short = Edge::new(circle(), ends, false, true);
        assert!((short.at(0.5) - on(55.0)).norm() < 1e-12);
        let long = Edge::new(circle(), ends, false, false);
        assert!((long.at(0.5) - on(235.0)).norm() < 1e-12);
    }

    /// A full circle against its curve runs backwards: read without its sense, fillets of full circles
    /// come out empty.
    #[test]
    fn a_closed_edge_keeps_its_sense() {
        for (forward, quarter) in [(true, 120.0), (false, -60.0)] {
            let edge = Edge::new(circle(), [on(30.0), on(30.0)], true, forward);
            assert!((edge.at(0.25) - on(quarter)).norm() < 1e-12, "{forward}");
            assert!((edge.at(1.0) - on(30.0)).norm() < 1e-12);
        }
    }

    #[test]
    fn two_vertices_at_one_place_are_no_whole_turn_apart() {
        let edge = Edge::new(circle(), [on(30.0), on(30.0 - 1e-10)], false, true);
        assert!((edge.at(0.5) - on(30.0)).norm() < 1e-6);
    }
}
