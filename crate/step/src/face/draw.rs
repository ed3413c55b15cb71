//! Areas of trimmed faces, and points drawn on them.

use fit4cad::cloud::Point;
use fit4cad::random::Random;

use super::boundary::Boundary;
use super::columns::Columns;
use crate::error::{Got, Trouble};
use crate::geometry::chart::Chart;
use crate::geometry::shape::{Ring, Shape};
use crate::read::topology::Face;

/// Nodes and weights of Gauss's rule of three on 0 to 1.
const GAUSS: [(f64, f64); 3] = [
    (0.112_701_665_379_258_3, 5.0 / 18.0),
    (0.5, 8.0 / 18.0),
    (0.887_298_334_620_741_7, 5.0 / 18.0),
];

/// In how many panels the density along the whole of a column is summed up.
const PANELS: f64 = 12.0;
/// Strips of free-form faces from which on each is narrow: one column tells what is in it, in a third of
/// the panels. Bounds of many bends need many strips, and evaluations of free-form surfaces are dear.
const NARROW: usize = 160;
/// At about how many places of a free-form face its density is looked at, over the nodes of a panel.
const MOST_LOOKS: usize = 16_384;

/// How often a draw may fail before the face is given up: each fails less often than not.
const MOST_TRIES: usize = 4000;

/// A face ready to be drawn from.
pub(crate) struct Trimmed {
    /// Its surface, laid out.
    pub chart: Chart,
    columns: Columns,
    /// Area in square millimetres.
    pub area: f64,
    /// How far an edge lies off the surface at most, in millimetres.
    pub off_surface: f64,
    /// The widest gap between edges that should meet, in millimetres.
    pub gap: f64,
    /// Places on the edges, to see how far the face reaches.
    pub corners: Vec<Point>,
    /// What the bounds agree to be inside, 0.5 to 1.
    pub agreement: f64,
    strips: Vec<Strip>,
    /// Sums of the areas of the strips up to and with each.
    sums: Vec<f64>,
    flip: bool,
}

/// What drawing from a strip needs.
#[derive(Clone, Copy, Default)]
struct Strip {
    /// No column of it has more, in units of the measure along columns.
    most: f64,
    /// Of surfaces measured by parameter: no place of it is denser.
    density: f64,
}

impl Trimmed {
    /// Trims a face, its bounds laid out to within a tolerance in millimetres.
    pub fn new(id: u64, face: &Face, tolerance: f64) -> Got<Self> {
        let trouble = |reason: &str| Trouble::new(id, reason);
        let mut shape = face.shape.clone();
        let mut chart = Chart::new(shape.clone());
        if let Some(other) = other_half(face, &shape) {
            shape = other;
            chart = Chart::new(shape);
        }
        let boundary = Boundary::of(face, &chart, tolerance);
        let sound = |it: &[f64; 2]| it.iter().all(|value| value.is_finite());
        if !boundary
            .segments
            .iter()
            .all(|it| sound(&it.from) && sound(&it.to))
        {
            return Err(trouble("has bounds that cannot be laid out on its surface"));
        }
        let strips = match &chart.shape {
            Shape::Plane(_) | Shape::Cylinder(..) => [1, 8192],
            Shape::Cone(..) | Shape::Sphere(..) | Shape::Torus(_) => [48, 4096],
            _ => {
                let [_, breaks] = chart.breaks();
                [48, (MOST_LOOKS / (breaks.len() + 4)).clamp(NARROW, 2048)]
            }
        };
        let (off_surface, gap) = (boundary.off_surface, boundary.gap);
        let columns = Columns::of(&chart, boundary, face.same_sense, strips);
        let columns = columns.ok_or_else(|| trouble("has no bounds that close on its surface"))?;
        let mut trimmed = Self {
            chart,
            area: 0.0,
            off_surface,
            gap,
            corners: face
                .bounds
                .iter()
                .flatten()
                .flat_map(|each| [0.0, 0.25, 0.5, 0.75].map(|share| each.at(share)))
                .collect(),
            agreement: columns.agreement,
            strips: Vec::with_capacity(columns.len()),
            sums: Vec::with_capacity(columns.len()),
            columns,
            flip: !face.same_sense,
        };
        trimmed.measure();
        if trimmed.area.is_finite() {
            Ok(trimmed)
        } else {
            Err(trouble("has no finite area"))
        }
    }

    fn measure(&mut self) {
        let mut found = Vec::new();
        let mut rest = 0.0;
        let dear = self.chart.shape.cumulative(0.0).is_none();
        let [_, breaks] = self.chart.breaks();
        let (nodes, panels) = if dear && self.columns.len() > NARROW {
            (&[(0.5, 1.0)][..], PANELS / 3.0)
        } else {
            (&GAUSS[..], PANELS)
        };
        for index in 0..self.columns.len() {
            let (from, to) = (self.columns.borders[index], self.columns.borders[index + 1]);
            let mut strip = Strip::default();
            let mut area = 0.0;
            for (share, weight) in nodes {
                let a = from + (to - from) * share;
                self.columns.intervals(index, a, &mut found);
                let (along, most, density) = self.along(a, &found, panels, &breaks);
                area += weight * (to - from) * along;
                strip.most = strip.most.max(most);
                strip.density = strip.density.max(density);
            }
            // Just within the borders: at them, bounds of the strips beside are met.
            for share in [1e-6, 1.0 - 1e-6] {
                let a = from + (to - from) * share;
                self.columns.intervals(index, a, &mut found);
                let most: f64 = found.iter().map(|it| self.between(it)).sum();
                strip.most = strip.most.max(most);
            }
            // Between the columns looked at a curved one may have a little more.
            strip.most *= 1.02;
            strip.density *= 1.1;
            rest += area.max(0.0);
            self.strips.push(strip);
            self.sums.push(rest);
        }
        self.area = rest;
    }

    /// Of a column: area per width, its measure, and the greatest density.
    fn along(&self, a: f64, intervals: &[[f64; 2]], most: f64, breaks: &[f64]) -> (f64, f64, f64) {
        let measure: f64 = intervals.iter().map(|it| self.between(it)).sum();
        if self.chart.shape.cumulative(0.0).is_some() {
            return (measure, measure, 1.0);
        }
        let (mut area, mut greatest) = (0.0, 0.0_f64);
        let mut add = |low: f64, high: f64| {
            let share = (high - low) / self.columns.height();
            let panels = (most * share).ceil().clamp(1.0, most) as usize;
            let width = (high - low) / panels as f64;
            for panel in 0..panels {
                let start = low + width * panel as f64;
                for (share, weight) in GAUSS {
                    let (_, density) = self.chart.measured([a, start + width * share]);
                    greatest = greatest.max(density);
                    area += weight * width * density;
                }
            }
        };
        for [low, high] in intervals {
            // A kink within a panel would spoil it. Columns of charts that close may have gone around.
            let turn = self.chart.b.wrap(*low) - low;
            let first = breaks.partition_point(|it| it - turn <= *low);
            let mut from = *low;
            for at in breaks[first..].iter().map(|it| it - turn) {
                if at >= *high {
                    break;
                }
                add(from, at);
                from = at;
            }
            let middle = 0.5 * (from + high);
            if from == *low {
                add(from, middle);
                add(middle, *high);
            } else {
                add(from, *high);
            }
        }
        (area, measure, greatest)
    }

    /// The measure of a piece of a column: area per width where there is a formula, else the length.
    fn between(&self, [low, high]: &[f64; 2]) -> f64 {
        match (
            self.chart.shape.cumulative(*low),
            self.chart.shape.cumulative(*high),
        ) {
            (Some(low), Some(high)) => (high - low).abs(),
            _ => high - low,
        }
    }

    /// A place on the face, all of its area as likely, with its coordinates; `None` where it has
    /// next to no area.
    pub fn draw(&self, random: &mut Random) -> Option<([f64; 2], Point)> {
        let mut found = Vec::new();
        for _ in 0..MOST_TRIES {
            let target = random.unit() * self.area;
            let strip = self.sums.partition_point(|sum| *sum <= target);
            let Strip { most, density } = *self.strips.get(strip)?;
            if let Some(at) = self.try_strip(strip, most, density, random, &mut found) {
                return Some(at);
            }
        }
        None
    }

    /// Draws from one strip until it succeeds: strips are chosen by their areas.
    fn try_strip(
        &self,
        strip: usize,
        most: f64,
        density: f64,
        random: &mut Random,
        found: &mut Vec<[f64; 2]>,
    ) -> Option<([f64; 2], Point)> {
        let (from, to) = (self.columns.borders[strip], self.columns.borders[strip + 1]);
        for _ in 0..64 {
            let a = from + (to - from) * random.unit();
            self.columns.intervals(strip, a, found);
            let mut left = random.unit() * most;
            for interval in found.iter() {
                let piece = self.between(interval);
                if left >= piece {
                    left -= piece;
                    continue;
                }
                let at = [a, self.within(interval, left)];
                let (point, here) = self.chart.measured(at);
                let formula = self.chart.shape.cumulative(0.0).is_some();
                if formula || random.unit() * density < here {
                    return Some((at, point));
                }
                break;
            }
        }
        None
    }

    /// The second coordinate up to which a piece of a column has a measure.
    fn within(&self, [low, high]: &[f64; 2], measure: f64) -> f64 {
        let shape = &self.chart.shape;
        let Some(start) = shape.cumulative(*low) else {
            return low + measure;
        };
        let found = match shape {
            Shape::Plane(_) => low + measure,
            Shape::Cylinder(_, radius) => low + measure / radius,
            Shape::Cone(_, angle) => {
                let (sin, cos) = libm::sincos(*angle);
                (2.0 * (start + measure) * cos * cos / sin).max(0.0).sqrt()
            }
            Shape::Sphere(_, radius) => {
                libm::asin(((start + measure) / (radius * radius)).clamp(-1.0, 1.0))
            }
            // Kepler's equation: no formula turns it about.
            _ => {
                let falls = shape.cumulative(*high) < Some(start);
                let target = if falls {
                    start - measure
                } else {
                    start + measure
                };
                let (mut below, mut above) = (*low, *high);
                for _ in 0..50 {
                    let middle = 0.5 * (below + above);
                    let value = shape.cumulative(middle).unwrap_or(target);
                    if (value < target) != falls {
                        below = middle;
                    } else {
                        above = middle;
                    }
                }
                0.5 * (below + above)
            }
        };
        found.clamp(*low, *high)
    }

    /// Whether coordinates of its chart lie within its bounds. O(bounds that their column meets).
    pub fn holds(&self, at: [f64; 2]) -> bool {
        self.columns.holds(at)
    }

    /// The ranges of both coordinates that it may reach.
    pub fn range(&self) -> [[f64; 2]; 2] {
        self.columns.range()
    }

    /// Place and unit normal of the face, as its bounds run against the clock about it.
    pub fn oriented(&self, at: [f64; 2]) -> (Point, fit4cad::cloud::Vector) {
        let (point, normal) = self.chart.oriented(at);
        (point, if self.flip { -normal } else { normal })
    }
}

/// Of surfaces that meet themselves and fall in two, the other half where most edges lie there: the
/// nappe of a cone behind its apex, the apple or the lemon of a torus.
fn other_half(face: &Face, shape: &Shape) -> Option<Shape> {
    let edges = face.bounds.iter().flatten();
    let places = edges.flat_map(|each| [0.0, 0.23, 0.5, 0.77].map(|share| each.at(share)));
    match shape {
        Shape::Cone(frame, angle) => {
            let height: f64 = places.map(|place| frame.enter(&place)[2]).sum();
            (height < 0.0).then(|| Shape::Cone(frame.flipped(), *angle))
        }
        Shape::Torus(ring) if ring.minor > ring.major => {
            let off = |place: &Point, major: f64| {
                let [x, y, z] = ring.frame.enter(place);
                (libm::hypot(libm::hypot(x, y) - major, z) - ring.minor).abs()
            };
            let votes = places.map(|place| (off(&place, ring.major), off(&place, -ring.major)));
            let (outer, inner) = votes.fold((0.0, 0.0), |sum, it| (sum.0 + it.0, sum.1 + it.1));
            let is_inner = inner < outer;
            let other = Ring {
                inner: is_inner,
                ..*ring
            };
            (outer != inner && is_inner != ring.inner).then_some(Shape::Torus(other))
        }
        _ => None,
    }
}
