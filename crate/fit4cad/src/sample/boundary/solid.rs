//! A solid in its place: what it contains, and the maps between space and its outline.

use nalgebra::{Point2, Vector2};

use super::super::blocks::{Operation, Placement, Segment, Solid, Sweep};
use crate::cloud::{Bounds, Point, Vector};

const TAU: f64 = std::f64::consts::TAU;

/// A solid ready to be asked about points. A point of space is a point of the outline's plane and
/// the way it has been swept: a height, or an angle.
#[derive(Debug, Clone)]
pub struct Placed {
    pub operation: Operation,
    pub segments: Vec<Segment>,
    pub sweep: Sweep,
    pub placement: Placement,
    /// Box in space, not necessarily the smallest.
    pub bounds: Bounds,
    low: Point2<f64>,
    high: Point2<f64>,
}

impl Placed {
    /// # Errors
    /// Says why the description makes no solid.
    pub fn new(operation: Operation, solid: &Solid) -> Result<Self, &'static str> {
        let placement = solid.frame.placement();
        let placement =
            placement.ok_or("its frame needs two finite directions that span a plane")?;
        let mut numbers = solid.outline.loops.iter().flat_map(|turn| turn.numbers());
        if !numbers.all(|number| number.abs() < 1e9) {
            return Err("its outline holds a number that is not finite or beyond 1e9");
        }
        let loops = solid.outline.loops.iter();
        let segments: Vec<Segment> = loops.flat_map(|turn| turn.segments()).collect();
        if segments.is_empty() || !segments.iter().all(|s| s.length() > 0.0) {
            return Err("its outline encloses nothing");
        }
        let mut low = Point2::new(f64::INFINITY, f64::INFINITY);
        let mut high = -low;
        for segment in &segments {
            for step in 0..=16 {
                let point = segment.at(segment.length() * f64::from(step) / 16.0);
                (low, high) = (low.inf(&point), high.sup(&point));
            }
        }
        let (sound, span) = match solid.sweep {
            Sweep::Extrude { height } => (height.is_finite() && height > 0.0, height),
            Sweep::Revolve { angle } => (angle > 0.0 && angle <= TAU, angle),
        };
        if !sound {
            return Err("its height must be positive, its angle within 0 to 2π");
        }
        if matches!(solid.sweep, Sweep::Revolve { .. }) && low.x < -1e-9 * high.x {
            return Err("its outline crosses the axis of revolution");
        }
        // Arcs bulge over the sixteenths they were measured by.
        let margin = (high - low) * 0.01;
        (low, high) = (low - margin, high + margin);
        let mut placed = Self {
            operation,
            segments,
            sweep: solid.sweep,
            placement,
            bounds: Bounds::EMPTY,
            low,
            high,
        };
        for corner in placed.corners(span) {
            placed.bounds.add(&placement.to_world(&corner));
        }
        Ok(placed)
    }

    fn corners(&self, span: f64) -> [Point; 8] {
        let (low, high) = match self.sweep {
            Sweep::Extrude { .. } => (
                Point::new(self.low.x, self.low.y, 0.0),
                Point::new(self.high.x, self.high.y, span),
            ),
            Sweep::Revolve { .. } => (
                Point::new(-self.high.x, -self.high.x, self.low.y),
                Point::new(self.high.x, self.high.x, self.high.y),
            ),
        };
        std::array::from_fn(|k| {
            let pick = |bit: usize, axis: usize| {
                if k >> bit & 1 == 0 {
                    low[axis]
                } else {
                    high[axis]
                }
            };
            Point::new(pick(0, 0), pick(1, 1), pick(2, 2))
        })
    }

    /// How far the outline is swept.
    pub fn span(&self) -> f64 {
        match self.sweep {
            Sweep::Extrude { height } => height,
            Sweep::Revolve { angle } => angle,
        }
    }

    /// Whether the sweep returns to its start, so that there are no caps.
    pub fn is_closed(&self) -> bool {
        matches!(self.sweep, Sweep::Revolve { angle } if angle >= TAU)
    }

    /// Length of the sweep per unit of it.
    pub fn pace(&self, outline: &Point2<f64>) -> f64 {
        match self.sweep {
            Sweep::Extrude { .. } => 1.0,
            Sweep::Revolve { .. } => outline.x.abs(),
        }
    }

    /// The point of the outline's plane and the sweep that brings it to a point of space.
    pub fn locate(&self, point: &Point) -> (Point2<f64>, f64) {
        let local = self.placement.to_local(point);
        match self.sweep {
            Sweep::Extrude { .. } => (local.xy(), local.z),
            Sweep::Revolve { angle } => {
                let mut turn = libm::atan2(local.y, local.x);
                if turn < 0.0 {
                    turn += TAU;
                }
                if turn > (TAU + angle) / 2.0 {
                    turn -= TAU;
                }
                (Point2::new(radius(&local), local.z), turn)
            }
        }
    }

    /// The point of space that a point of the outline's plane is swept to.
    pub fn place(&self, outline: &Point2<f64>, sweep: f64) -> Point {
        self.placement.to_world(&match self.sweep {
            Sweep::Extrude { .. } => Point::new(outline.x, outline.y, sweep),
            Sweep::Revolve { .. } => {
                let (sin, cos) = libm::sincos(sweep);
                Point::new(outline.x * cos, outline.x * sin, outline.y)
            }
        })
    }

    /// The direction in space that a direction of the outline's plane is swept to.
    pub fn lift(&self, direction: &Vector2<f64>, sweep: f64) -> Vector {
        self.placement.vector_to_world(&match self.sweep {
            Sweep::Extrude { .. } => Vector::new(direction.x, direction.y, 0.0),
            Sweep::Revolve { .. } => {
                let (sin, cos) = libm::sincos(sweep);
                Vector::new(direction.x * cos, direction.x * sin, direction.y)
            }
        })
    }

    /// Unit direction of the sweep at a sweep.
    pub fn heading(&self, sweep: f64) -> Vector {
        self.placement.vector_to_world(&match self.sweep {
            Sweep::Extrude { .. } => Vector::z(),
            Sweep::Revolve { .. } => {
                let (sin, cos) = libm::sincos(sweep);
                Vector::new(-sin, cos, 0.0)
            }
        })
    }

    /// Whether the outline encloses a point of its plane.
    pub fn encloses(&self, point: &Point2<f64>) -> bool {
        let outside = point.x < self.low.x
            || point.y < self.low.y
            || point.x > self.high.x
            || point.y > self.high.y;
        let crossings = || {
            self.segments
                .iter()
                .map(|s| s.crossings(point))
                .sum::<usize>()
        };
        !outside && crossings() % 2 == 1
    }

    /// Whether a point of space is in the solid.
    pub fn contains(&self, point: &Point) -> bool {
        // Most points are outside the box, which costs a tenth of what the outline does.
        if !self.bounds.contains(point) {
            return false;
        }
        if self.is_closed() {
            let local = self.placement.to_local(point);
            return self.encloses(&Point2::new(radius(&local), local.z));
        }
        let (outline, sweep) = self.locate(point);
        sweep > 0.0 && sweep < self.span() && self.encloses(&outline)
    }

    /// The box of the outline.
    pub fn frame(&self) -> (Point2<f64>, Point2<f64>) {
        (self.low, self.high)
    }
}

/// Distance from the z axis.
fn radius(local: &Point) -> f64 {
    (local.x * local.x + local.y * local.y).sqrt()
}
