//! Whether a face stands in the way of a ray.

use fit4cad::cloud::{Bounds, Point};

use super::ray::Ray;
use crate::face::Trimmed;

/// Into how many pieces a free-form face is cut along each coordinate: flat ones stand for it.
const PIECES: usize = 32;
/// Pieces of a block along each coordinate: blocks are looked into where a ray meets their boxes.
const BLOCK: usize = 4;
/// Places along each coordinate at which a face of the five families is looked at to see how far it reaches.
const LOOKS: usize = 24;
/// By how much its box is more than what was seen of it, over its longest side. Between two looks at a whole
/// circle it bulges by 1 - cos(π/24), 0.9 % of its radius.
const MORE: f64 = 0.01;
/// How near a crossing must be to where its coordinates say, over the size of the face: that of the other half
/// of a cone, or of a torus that meets itself, is none.
const SAME: f64 = 1e-6;

/// A face as what hides others, in coordinates of its body.
pub(super) struct Screen<'a> {
    face: &'a Trimmed,
    /// All of it.
    pub bounds: Bounds,
    facets: Option<Facets>,
}

/// A free-form face as flat pieces, not trimmed: what is hit is asked where it lies.
struct Facets {
    /// Places and coordinates, `PIECES + 1` in a row.
    grid: Vec<(Point, [f64; 2])>,
    /// The box of each block, with its first pieces.
    blocks: Vec<(Bounds, [usize; 2])>,
    /// The longest side of a piece: what of the face is nearer to a place of it may be its own piece.
    side: f64,
    /// How far a piece may lie off the surface.
    sag: f64,
}

impl<'a> Screen<'a> {
    pub fn new(face: &'a Trimmed) -> Self {
        let free = face.chart.shape.cumulative(0.0).is_none();
        let pieces = if free { PIECES } else { LOOKS };
        let grid = grid(face, pieces);
        let seen = Bounds::of(grid.iter().map(|(point, _)| point));
        let facets = free.then(|| Facets::new(face, grid));
        let sag = facets.as_ref().map_or(0.0, |it| it.sag);
        let bounds = wider(&seen, MORE * seen.longest_side() + sag);
        Self {
            face,
            bounds,
            facets,
        }
    }

    /// Whether a ray from a place meets it farther than `clear` from that place, over the length of the ray.
    /// `own` where the place is one of its own. O(1) of the five families but for what its bounds ask; of
    /// free-form faces O(blocks).
    pub fn hides(&self, ray: &Ray, clear: f64, own: bool) -> bool {
        let Some(piece) = ray.within(&self.bounds) else {
            return false;
        };
        if let Some(facets) = &self.facets {
            let length = ray.way.norm();
            let blind = if own { facets.side } else { 2.0 * facets.sag };
            return facets.hides(ray, clear.max(blind / length), self.face);
        }
        let chart = &self.face.chart;
        let near = SAME * self.bounds.diagonal();
        let crossings = ray.crossings(&chart.shape, piece).unwrap_or_default();
        crossings.into_iter().filter(|t| *t > clear).any(|t| {
            let hit = ray.at(t);
            let at = chart.invert(&hit, None);
            (chart.at(at) - hit).norm() <= near && self.face.holds(at)
        })
    }
}

impl Facets {
    fn new(face: &Trimmed, grid: Vec<(Point, [f64; 2])>) -> Self {
        let mut facets = Self {
            grid,
            blocks: Vec::new(),
            side: 0.0,
            sag: 0.0,
        };
        for a in 0..PIECES {
            for b in 0..PIECES {
                let [from, across, up, to] = facets.corners(a, b);
                let middle = [0, 1].map(|k| 0.5 * (from.1[k] + to.1[k]));
                let flat = nalgebra::center(&across.0, &up.0);
                let flat = (nalgebra::center(&from.0, &to.0) - flat).norm();
                let bulge = (face.chart.at(middle) - nalgebra::center(&from.0, &to.0)).norm();
                let side = (to.0 - from.0).norm().max((up.0 - across.0).norm());
                facets.sag = facets.sag.max(bulge + flat);
                facets.side = facets.side.max(side);
            }
        }
        for a in (0..PIECES).step_by(BLOCK) {
            for b in (0..PIECES).step_by(BLOCK) {
                let rows = a..=a + BLOCK;
                let places = rows.flat_map(|a| {
                    let row = a * (PIECES + 1) + b;
                    facets.grid[row..=row + BLOCK].iter()
                });
                let bounds = Bounds::of(places.map(|(point, _)| point));
                facets.blocks.push((bounds, [a, b]));
            }
        }
        facets
    }

    fn corners(&self, a: usize, b: usize) -> [(Point, [f64; 2]); 4] {
        let first = a * (PIECES + 1) + b;
        let next = first + PIECES + 1;
        [first, next, first + 1, next + 1].map(|place| self.grid[place])
    }

    fn hides(&self, ray: &Ray, clear: f64, face: &Trimmed) -> bool {
        let met = self
            .blocks
            .iter()
            .filter(|(bounds, _)| ray.within(bounds).is_some());
        met.flat_map(|(_, [a, b])| {
            (*a..a + BLOCK).flat_map(move |a| (*b..b + BLOCK).map(move |b| (a, b)))
        })
        .any(|(a, b)| {
            let [from, across, up, to] = self.corners(a, b);
            [[from, across, up], [to, up, across]]
                .iter()
                .any(|corners| {
                    let [p, q, r] = corners;
                    let Some((t, [u, v])) = ray.triangle([&p.0, &q.0, &r.0]) else {
                        return false;
                    };
                    let at = [0, 1].map(|k| p.1[k] + u * (q.1[k] - p.1[k]) + v * (r.1[k] - p.1[k]));
                    t > clear && face.holds(at)
                })
        })
    }
}

/// Places over the whole of the chart that a face may reach.
fn grid(face: &Trimmed, pieces: usize) -> Vec<(Point, [f64; 2])> {
    let [a, b] = face.range();
    let along = |[low, high]: [f64; 2], k: usize| low + (high - low) * k as f64 / pieces as f64;
    let places = (0..=pieces).flat_map(|i| (0..=pieces).map(move |j| (i, j)));
    places
        .map(|(i, j)| {
            let at = [along(a, i), along(b, j)];
            (face.chart.at(at), at)
        })
        .collect()
}

fn wider(bounds: &Bounds, by: f64) -> Bounds {
    let more = Bounds {
        min: bounds.min.map(|x| x - by),
        max: bounds.max.map(|x| x + by),
    };
    if bounds.is_empty() { *bounds } else { more }
}
