//! The outline of points on a surface: cells of its chart that hold points, and the border between them
//! and those that do not. Borders of cells run along one coordinate each, which on all five families are
//! straight lines and circles: a face within them is exact.

use std::collections::{BTreeMap, BTreeSet};

use fit4cad::cloud::neighbours::KdTree;
use fit4cad::cloud::{Bounds, Point};

use crate::geometry::chart::Chart;
use crate::geometry::shape::Shape;

/// A closed way along borders of cells, corner by corner in coordinates of the chart, with the face on
/// its left.
pub(super) type Loop = Vec<[f64; 2]>;

/// The side of a cell, over the distance of neighbouring points: at it, cells within even points are
/// seldom empty.
const CELL: f64 = 1.6;
/// Most cells along one coordinate: finer outlines are not worth their bytes.
const MOST: f64 = 400.0;

/// A grid of cells over part of a chart.
struct Cells {
    low: [f64; 2],
    size: [f64; 2],
    count: [i64; 2],
    closes: [bool; 2],
    full: BTreeSet<[i64; 2]>,
}

/// The outline of points, none where the surface is covered whole; `None` where there are too few.
pub(super) fn outline(chart: &Chart, points: &[Point]) -> Option<Vec<Loop>> {
    if points.len() < 3 {
        return None;
    }
    let at: Vec<[f64; 2]> = points
        .iter()
        .map(|point| chart.invert(point, None))
        .collect();
    let mut cells = Cells::over(chart, points, &at)?;
    for place in &at {
        cells.fill(*place);
    }
    cells.close_gaps();
    Some(cells.loops())
}

/// Median distance of a point to its nearest neighbour, of some of them.
fn spacing(points: &[Point]) -> Option<f64> {
    let tree = KdTree::new(points);
    let every = points.len().div_ceil(500);
    let mut found = Vec::new();
    let mut distances: Vec<f64> = Vec::new();
    for (index, point) in (0_u32..).zip(points).step_by(every) {
        tree.nearest(point, 1, f64::INFINITY, |other| other != index, &mut found);
        distances.extend(found.first().map(|it| it.distance_squared.sqrt()));
    }
    distances.sort_by(f64::total_cmp);
    let median = *distances.get(distances.len() / 2)?;
    let size = Bounds::of(points).diagonal();
    (size > 0.0).then(|| median.max(1e-4 * size))
}

impl Cells {
    fn over(chart: &Chart, points: &[Point], at: &[[f64; 2]]) -> Option<Self> {
        let side = CELL * spacing(points)?;
        // How long one unit of either coordinate is: along the first at its widest.
        let unit = match &chart.shape {
            Shape::Cylinder(_, radius) => [*radius, 1.0],
            Shape::Sphere(_, radius) => [*radius, *radius],
            Shape::Torus(ring) => [ring.major + ring.minor, ring.minor],
            Shape::Cone(_, angle) => {
                let (sin, cos) = libm::sincos(*angle);
                let most = at.iter().map(|it| it[1]).fold(0.0, f64::max);
                [most * sin / cos, 1.0 / cos]
            }
            _ => [1.0, 1.0],
        };
        let (mut low, mut size, mut count) = ([0.0; 2], [0.0; 2], [0_i64; 2]);
        let axes = [chart.a, chart.b];
        for k in 0..2 {
            let [mut from, mut to] = axes[k].range;
            if !(from.is_finite() && to.is_finite()) {
                let values = at.iter().map(|it| it[k]);
                let margin = 0.5 * side / unit[k];
                let least = values.clone().fold(f64::INFINITY, f64::min) - margin;
                let most = values.fold(f64::NEG_INFINITY, f64::max) + margin;
                from = from.max(least);
                to = to.min(most);
            }
            let cells = ((to - from) * unit[k] / side).round().clamp(1.0, MOST);
            // A way around has at least three pieces.
            let cells = if axes[k].period.is_some() {
                cells.max(3.0)
            } else {
                cells
            };
            (low[k], size[k], count[k]) = (from, (to - from) / cells, cells as i64);
        }
        let sound =
            low.iter().chain(&size).all(|it| it.is_finite()) && size.iter().all(|it| *it > 0.0);
        sound.then(|| Self {
            low,
            size,
            count,
            closes: axes.map(|axis| axis.period.is_some()),
            full: BTreeSet::new(),
        })
    }

    fn fill(&mut self, at: [f64; 2]) {
        let cell = [0, 1].map(|k| ((at[k] - self.low[k]) / self.size[k]).floor() as i64);
        if let Some(cell) = self.within(cell) {
            self.full.insert(cell);
        }
    }

    /// The cell itself, by whole turns in the grid; `None` beyond an end.
    fn within(&self, mut cell: [i64; 2]) -> Option<[i64; 2]> {
        for (k, value) in cell.iter_mut().enumerate() {
            if self.closes[k] {
                *value = value.rem_euclid(self.count[k]);
            } else if *value == self.count[k] {
                // A point on the end itself.
                *value -= 1;
            }
            if !(0..self.count[k]).contains(value) {
                return None;
            }
        }
        Some(cell)
    }

    fn is_full(&self, cell: [i64; 2]) -> bool {
        self.full.contains(&self.corner(cell))
    }

    /// Fills cells that are empty by chance: those between full ones, in both directions.
    fn close_gaps(&mut self) {
        let mut filled = Vec::new();
        for i in 0..self.count[0] {
            for j in 0..self.count[1] {
                let full = |di: i64, dj: i64| self.is_full([i + di, j + dj]);
                let across = full(-1, 0) && full(1, 0);
                let along = full(0, -1) && full(0, 1);
                if !self.is_full([i, j]) && (across || along) {
                    filled.push([i, j]);
                }
            }
        }
        self.full.extend(filled);
    }

    /// Borders between full and empty cells, joined to loops.
    fn loops(&self) -> Vec<Loop> {
        // From corner to corner of the grid, the full cell on the left.
        let mut next: BTreeMap<[i64; 2], Vec<[i64; 2]>> = BTreeMap::new();
        for &[i, j] in &self.full {
            let sides = [
                ([i, j - 1], [i, j], [i + 1, j]),
                ([i + 1, j], [i + 1, j], [i + 1, j + 1]),
                ([i, j + 1], [i + 1, j + 1], [i, j + 1]),
                ([i - 1, j], [i, j + 1], [i, j]),
            ];
            for (beside, from, to) in sides {
                if !self.is_full(beside) {
                    next.entry(self.corner(from))
                        .or_default()
                        .push(self.corner(to));
                }
            }
        }
        let mut loops = Vec::new();
        while let Some(start) = next.keys().next().copied() {
            let mut corners = vec![start];
            let mut at = start;
            let mut before: Option<[i64; 2]> = None;
            while let Some(ways) = next.get_mut(&at) {
                // Where two full cells meet in a corner alone, turn left: they stay apart.
                let way = ways
                    .iter()
                    .position(|to| before.is_some_and(|from| self.turns_left(from, at, *to)));
                let to = ways.swap_remove(way.unwrap_or(0));
                if ways.is_empty() {
                    next.remove(&at);
                }
                before = Some(at);
                at = to;
                if at == start {
                    break;
                }
                corners.push(at);
            }
            loops.push(self.straightened(&corners));
        }
        loops
    }

    /// A corner or cell, by whole turns in the grid where the chart closes.
    fn corner(&self, corner: [i64; 2]) -> [i64; 2] {
        [0, 1].map(|k| {
            if self.closes[k] {
                corner[k].rem_euclid(self.count[k])
            } else {
                corner[k]
            }
        })
    }

    /// The step from one corner to the next, across the border of a chart that closes too.
    fn step(&self, from: [i64; 2], to: [i64; 2]) -> [i64; 2] {
        [0, 1].map(|k| {
            let step = to[k] - from[k];
            if step.abs() > 1 { -step.signum() } else { step }
        })
    }

    fn turns_left(&self, from: [i64; 2], at: [i64; 2], to: [i64; 2]) -> bool {
        let (a, b) = (self.step(from, at), self.step(at, to));
        a[0] * b[1] - a[1] * b[0] > 0
    }

    /// Corners where the way turns, and, of long ways around, some between; coordinates go on across the
    /// border of a chart that closes.
    fn straightened(&self, corners: &[[i64; 2]]) -> Loop {
        let count = corners.len();
        let mut place = corners[0];
        let mut kept = Vec::new();
        let mut straight = 0_i64;
        for k in 0..count {
            let before = self.step(corners[(k + count - 1) % count], corners[k]);
            let after = self.step(corners[k], corners[(k + 1) % count]);
            let axis = usize::from(after[1] != 0);
            // A third of a turn at most, so that each arc is one of two.
            let most = if self.closes[axis] {
                self.count[axis] / 3
            } else {
                i64::MAX
            };
            straight += 1;
            if before != after || straight >= most || (k == 0 && self.closes[axis]) {
                kept.push([0, 1].map(|k| self.low[k] + self.size[k] * place[k] as f64));
                straight = 0;
            }
            place = [place[0] + after[0], place[1] + after[1]];
        }
        kept
    }
}
