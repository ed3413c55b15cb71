//! The edges of a part and the points that sample them.

use std::collections::BTreeMap;

use super::curves::{Curve, curves};
use super::{Boundary, tolerance};
use crate::cloud::{Point, Vector};
use crate::sorting::sort_by;

/// A point on an edge or at a corner.
#[derive(Debug, Clone, PartialEq)]
pub struct EdgePoint {
    pub point: Point,
    /// The carriers that meet there, ascending.
    pub carriers: Vec<usize>,
}

/// Points on all edges of the part, each once: corners, and between them points at even distances
/// as near the spacing as the length allows.
pub fn edge_points(boundary: &Boundary, spacing: f64) -> Vec<EdgePoint> {
    let mut edges = Edges {
        boundary,
        spacing,
        points: Vec::new(),
        corners: Vec::new(),
        tracks: BTreeMap::new(),
    };
    for curve in curves(boundary, spacing / 2.0) {
        edges.add(&curve);
    }
    // A corner gathers carriers from a little way around, and near-tangent faces may miss it.
    for EdgePoint { point, carriers } in &mut edges.points {
        carriers.retain(|&carrier| boundary.is_on(carrier, point));
    }
    edges.points.retain(|edge| !edge.carriers.is_empty());
    edges.points
}

struct Edges<'a> {
    boundary: &'a Boundary,
    spacing: f64,
    points: Vec<EdgePoint>,
    /// Indices of the points that end a piece.
    corners: Vec<usize>,
    /// The pieces accepted so far as chains of points, by the carriers that meet in them.
    tracks: BTreeMap<Vec<usize>, Vec<Vec<Point>>>,
}

impl Edges<'_> {
    /// Cuts a curve where other carriers begin to meet in it, and samples the pieces in which at
    /// least two do.
    fn add(&mut self, curve: &Curve) {
        let at = |t: f64| curve.at(self.boundary, t);
        let count = ((2.0 * curve.length / self.spacing).ceil() as usize).max(16);
        // Samples sit in the middle of their stretch, away from the corners at a curve's own
        // ends. A meeting goes beyond its ends, which must not be missed.
        let mut places: Vec<f64> = (0..count)
            .map(|k| (k as f64 + 0.5) / count as f64)
            .collect();
        if curve.closed {
            places.push(places[0] + 1.0);
        } else if !curve.ends_exactly() {
            places.insert(0, 0.0);
            places.push(1.0);
        }
        let carriers: Vec<Vec<usize>> = places.iter().map(|&t| self.carriers_at(&at(t))).collect();
        let mut cuts = Vec::new();
        for k in 1..places.len() {
            if carriers[k - 1] != carriers[k] {
                // Close to where faces touch, more than one change may lie in between: look for
                // the one at which an edge begins or ends.
                let begins = carriers[k].len() >= 2;
                let wanted = if begins {
                    &carriers[k]
                } else {
                    &carriers[k - 1]
                };
                let (mut low, mut high) = (places[k - 1], places[k]);
                for _ in 0..40 {
                    let t = (low + high) / 2.0;
                    if (self.carriers_at(&at(t)) == *wanted) == begins {
                        high = t;
                    } else {
                        low = t;
                    }
                }
                cuts.push((low, k));
            }
        }
        let mut pieces = Vec::new();
        if cuts.is_empty() {
            pieces.push((0.0, 1.0, 0));
        } else if curve.closed {
            for (index, &(from, first)) in cuts.iter().enumerate() {
                let (to, _) = cuts[(index + 1) % cuts.len()];
                pieces.push((from, if to > from { to } else { to + 1.0 }, first));
            }
        } else {
            pieces.push((0.0, cuts[0].0, 0));
            for (index, &(from, first)) in cuts.iter().enumerate() {
                let to = cuts.get(index + 1).map_or(1.0, |cut| cut.0);
                pieces.push((from, to, first));
            }
        }
        let whole = curve.closed && cuts.is_empty();
        for (from, to, first) in pieces {
            if carriers[first].len() >= 2 {
                self.sample(curve, [from, to], &carriers[first], whole);
            }
        }
    }

    fn sample(&mut self, curve: &Curve, range: [f64; 2], carriers: &[usize], whole: bool) {
        let [from, to] = range;
        let length = (to - from) * curve.length;
        let least = if whole { 3 } else { 1 };
        let count = ((length / self.spacing).round() as usize).max(least);
        let at = |share: f64| {
            let t = from + (to - from) * share;
            curve.at(self.boundary, t)
        };
        let known = self.tracks.get(carriers).map_or(&[][..], Vec::as_slice);
        // Where an edge of a solid is also a meeting of two faces, it comes twice.
        let tracked: Vec<bool> = (0..=count)
            .map(|k| {
                let point = at(k as f64 / count as f64);
                let near = |track: &Vec<Point>| distance(track, &point) < 0.05 * self.spacing;
                known.iter().any(near)
            })
            .collect();
        let mut new = Vec::new();
        for k in (0..=count).filter(|&k| !tracked[k]) {
            let share = k as f64 / count as f64;
            let point = at(share);
            let end = k == 0 || k == count;
            if whole && k == count {
                continue;
            }
            if whole || !end {
                new.push(EdgePoint {
                    point,
                    carriers: carriers.to_vec(),
                });
            } else {
                let t = if k == 0 { from } else { to };
                let exact = curve.ends_exactly() && (t == 0.0 || t == 1.0);
                self.add_corner(point, exact, carriers);
            }
        }
        self.points.extend(new);
        let fine = 2 * count.max(8);
        let track = (0..=fine).map(|k| at(k as f64 / fine as f64)).collect();
        self.tracks
            .entry(carriers.to_vec())
            .or_default()
            .push(track);
    }

    /// Adds the end of a piece, unless another piece has brought it.
    fn add_corner(&mut self, point: Point, exact: bool, carriers: &[usize]) {
        let reach = 20.0 * tolerance::ASIDE * self.boundary.diagonal;
        let point = if exact {
            point
        } else {
            self.settle_corner(point, reach)
        };
        let same = |&&index: &&usize| (self.points[index].point - point).norm() < reach;
        let mut all = self.carriers_at(&point);
        all.extend_from_slice(carriers);
        let index = self.corners.iter().find(same).copied();
        let index = index.unwrap_or_else(|| {
            self.corners.push(self.points.len());
            self.points.push(EdgePoint {
                point,
                carriers: Vec::new(),
            });
            self.points.len() - 1
        });
        let known = &mut self.points[index].carriers;
        known.append(&mut all);
        sort_by(known, |one, other| one.cmp(other));
        known.dedup();
    }

    /// A corner found by bisection is moved onto those three faces around it that fix it best.
    fn settle_corner(&self, point: Point, reach: f64) -> Point {
        let boundary = self.boundary;
        let mut around: Vec<(usize, Vector)> = Vec::new();
        for (index, face) in boundary.faces.iter().enumerate() {
            let foot = boundary.foot(index, &point);
            let solid = &boundary.solids[face.solid];
            if foot.offset.abs() < reach && face.holds(solid, foot.chart, reach) {
                around.push((index, foot.gradient));
            }
        }
        let (mut three, mut two) = ((1e-2, Vec::new()), (0.0, Vec::new()));
        for (i, a) in around.iter().enumerate() {
            for (j, b) in around.iter().enumerate().skip(i + 1) {
                let across = a.1.cross(&b.1);
                if across.norm() > two.0 {
                    two = (across.norm(), vec![a.0, b.0]);
                }
                for c in &around[j + 1..] {
                    let volume = across.dot(&c.1).abs();
                    if volume > three.0 {
                        three = (volume, vec![a.0, b.0, c.0]);
                    }
                }
            }
        }
        // Where a third face only touches the second, two decide.
        let faces = if three.1.is_empty() { two.1 } else { three.1 };
        let corner = boundary.settle(point, &faces);
        if (corner - point).norm() < 5.0 * reach {
            corner
        } else {
            point
        }
    }

    fn carriers_at(&self, point: &Point) -> Vec<usize> {
        let faces = self.boundary.faces_at(point);
        let carriers = faces.iter().map(|&face| self.boundary.faces[face].carrier);
        let mut carriers: Vec<usize> = carriers.collect();
        sort_by(&mut carriers, |one, other| one.cmp(other));
        carriers.dedup();
        carriers
    }
}

/// Distance of a point from a chain of points joined by straight lines.
fn distance(chain: &[Point], point: &Point) -> f64 {
    let square = chain.windows(2).map(|ends| {
        let way = ends[1] - ends[0];
        let share = (point - ends[0]).dot(&way) / way.norm_squared();
        (point - (ends[0] + way * share.clamp(0.0, 1.0))).norm_squared()
    });
    square.fold(f64::INFINITY, f64::min).sqrt()
}
