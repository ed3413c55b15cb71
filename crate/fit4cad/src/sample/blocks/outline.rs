//! Outlines: plane regions bounded by lines, arcs and free-form curves.

use nalgebra::{Point2, Vector2};

use super::segment::Segment;

/// A plane region: the points that a ray leaves through its loops an odd number of times, so a
/// loop within another is a hole.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Outline {
    /// Closed curves that neither cross themselves nor each other, in any order and direction.
    pub loops: Vec<Loop>,
}

/// A closed curve in the plane.
#[derive(Debug, Clone, PartialEq)]
pub enum Loop {
    /// A circle.
    Circle {
        /// Its centre.
        centre: [f64; 2],
        /// Its radius, positive.
        radius: f64,
    },
    /// Corners joined one after the other; the last step leads back to the start, by a straight
    /// line if need be.
    Path {
        /// The first corner.
        start: [f64; 2],
        /// The way round.
        steps: Vec<Step>,
    },
}

/// The way from one corner of a path to the next.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Step {
    /// A straight line.
    Line {
        /// The next corner.
        to: [f64; 2],
    },
    /// A circular arc.
    Arc {
        /// The next corner.
        to: [f64; 2],
        /// Tangent of a quarter of the angle turned through: 1 is a half circle, √2 - 1 a
        /// quarter, positive anticlockwise.
        bulge: f64,
    },
    /// A cubic Bézier curve: swept, it makes a free-form face that stays unsegmented.
    Curve {
        /// The two inner control points.
        controls: [[f64; 2]; 2],
        /// The next corner.
        to: [f64; 2],
    },
}

/// Bulge of a quarter circle, tan(π/8).
pub const QUARTER: f64 = std::f64::consts::SQRT_2 - 1.0;

impl Outline {
    /// The region within one loop.
    pub fn new(outer: Loop) -> Self {
        Self { loops: vec![outer] }
    }

    /// The region less the inside of a loop that lies within it.
    #[must_use]
    pub fn hole(mut self, hole: Loop) -> Self {
        self.loops.push(hole);
        self
    }

    /// Axis-parallel rectangle between two opposite corners.
    pub fn rectangle(from: [f64; 2], to: [f64; 2]) -> Self {
        Self::new(Loop::polygon(&[
            from,
            [to[0], from[1]],
            to,
            [from[0], to[1]],
        ]))
    }

    /// Disc about a centre.
    pub fn disc(centre: [f64; 2], radius: f64) -> Self {
        Self::new(Loop::Circle { centre, radius })
    }
}

impl Loop {
    /// A circle.
    pub const fn circle(centre: [f64; 2], radius: f64) -> Self {
        Self::Circle { centre, radius }
    }

    /// The start of a path, to be lengthened by [`Loop::line`], [`Loop::arc`] and [`Loop::curve`].
    pub const fn path(start: [f64; 2]) -> Self {
        let steps = Vec::new();
        Self::Path { start, steps }
    }

    /// Corners joined by straight lines.
    pub fn polygon(corners: &[[f64; 2]]) -> Self {
        let start = corners.first().copied().unwrap_or_default();
        let steps = corners.iter().skip(1).map(|&to| Step::Line { to });
        Self::Path {
            start,
            steps: steps.collect(),
        }
    }

    /// A polygon given as (x, y, radius), each corner of positive radius rounded by the arc of
    /// that radius which touches both its sides.
    pub fn rounded(corners: &[[f64; 3]]) -> Self {
        let count = corners.len();
        let corner = |k: usize| {
            let [x, y, radius] = corners[k % count];
            (Point2::new(x, y), radius)
        };
        let mut steps = Vec::new();
        for k in 0..count {
            let (at, radius) = corner(k);
            let (before, after) = (corner(k + count - 1).0 - at, corner(k + 1).0 - at);
            let (before, after) = (before.normalize(), after.normalize());
            // With φ the angle turned through, tan(φ/2) = √((1 - cos φ)/(1 + cos φ)).
            let cos = -before.dot(&after);
            let half = ((1.0 - cos) / (1.0 + cos)).max(0.0).sqrt();
            let [from, to] = [before, after].map(|way| at + way * (radius * half));
            steps.push(Step::Line { to: from.into() });
            if radius > 0.0 && half > 0.0 {
                let quarter = half / (1.0 + (1.0 + half * half).sqrt());
                let bulge = quarter * after.perp(&before).signum();
                let to = to.into();
                steps.push(Step::Arc { to, bulge });
            }
        }
        let start = match steps.first() {
            Some(&Step::Line { to }) => to,
            _ => [0.0; 2],
        };
        let first = steps.len().min(1);
        steps.rotate_left(first);
        Self::Path { start, steps }
    }

    /// The path lengthened by a straight line.
    #[must_use]
    pub fn line(self, to: [f64; 2]) -> Self {
        self.step(Step::Line { to })
    }

    /// The path lengthened by a circular arc; see [`Step::Arc`].
    #[must_use]
    pub fn arc(self, to: [f64; 2], bulge: f64) -> Self {
        self.step(Step::Arc { to, bulge })
    }

    /// The path lengthened by a circular arc, anticlockwise about a centre as far from its end as
    /// from the path's last corner.
    #[must_use]
    pub fn arc_about(self, centre: [f64; 2], to: [f64; 2]) -> Self {
        let last = Vector2::from(self.last_corner()) - Vector2::from(centre);
        let next = Vector2::from(to) - Vector2::from(centre);
        let angle = libm::atan2(last.perp(&next), last.dot(&next));
        let angle = if angle > 0.0 {
            angle
        } else {
            angle + std::f64::consts::TAU
        };
        self.arc(to, libm::tan(angle / 4.0))
    }

    fn last_corner(&self) -> [f64; 2] {
        match self {
            Self::Circle { centre, .. } => *centre,
            Self::Path { start, steps } => steps.last().map_or(*start, |step| match *step {
                Step::Line { to } | Step::Arc { to, .. } | Step::Curve { to, .. } => to,
            }),
        }
    }

    /// The path lengthened by a cubic Bézier curve.
    #[must_use]
    pub fn curve(self, controls: [[f64; 2]; 2], to: [f64; 2]) -> Self {
        self.step(Step::Curve { controls, to })
    }

    fn step(mut self, step: Step) -> Self {
        if let Self::Path { steps, .. } = &mut self {
            steps.push(step);
        }
        self
    }

    /// The segments of positive length, in order.
    pub(in crate::sample) fn segments(&self) -> Vec<Segment> {
        let (start, steps) = match self {
            Self::Circle { centre, radius } => {
                return vec![Segment::circle((*centre).into(), *radius)];
            }
            Self::Path { start, steps } => (Point2::from(*start), steps),
        };
        let close = Step::Line { to: start.into() };
        let mut from = start;
        let mut segments = Vec::new();
        for &step in steps.iter().chain([&close]) {
            let (Step::Line { to } | Step::Arc { to, .. } | Step::Curve { to, .. }) = step;
            let to = Point2::from(to);
            let apart: Vector2<f64> = to - from;
            if apart.norm() <= NEGLIGIBLE * (1.0 + from.coords.amax()) {
                continue;
            }
            segments.push(match step {
                Step::Arc { bulge, .. } if bulge != 0.0 => Segment::arc(from, to, bulge),
                Step::Curve { controls, .. } => {
                    let [first, second] = controls.map(Point2::from);
                    Segment::curve([from, first, second, to])
                }
                Step::Line { .. } | Step::Arc { .. } => Segment::line(from, to),
            });
            from = to;
        }
        segments
    }

    /// Every number of the description.
    pub(in crate::sample) fn numbers(&self) -> Vec<f64> {
        match self {
            Self::Circle { centre, radius } => vec![centre[0], centre[1], *radius],
            Self::Path { start, steps } => {
                let of_step = |step: &Step| match *step {
                    Step::Line { to } => vec![to],
                    Step::Arc { to, bulge } => vec![to, [bulge, 0.0]],
                    Step::Curve { controls, to } => vec![controls[0], controls[1], to],
                };
                let pairs = steps.iter().flat_map(of_step).chain([*start]);
                pairs.flatten().collect()
            }
        }
    }
}

/// Steps shorter than this, relative to the coordinates, are left out.
const NEGLIGIBLE: f64 = 1e-12;
