//! One piece of an outline, measured by arc length.

use nalgebra::{Point2, Vector2};

/// A line, a circular arc or a cubic Bézier curve from one corner of an outline to the next.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sample) enum Segment {
    Line {
        from: Point2<f64>,
        direction: Vector2<f64>,
        length: f64,
    },
    Arc(Arc),
    Curve(Curve),
}

/// An arc turning by `sweep` about its centre, anticlockwise where positive.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sample) struct Arc {
    pub centre: Point2<f64>,
    pub radius: f64,
    start: f64,
    sweep: f64,
    ends: [Point2<f64>; 2],
    /// Pieces that rise or fall throughout: the two ordinates, and whether right of the centre.
    pieces: Vec<(f64, f64, bool)>,
}

/// A cubic Bézier curve with its arc length tabulated.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::sample) struct Curve {
    controls: [Point2<f64>; 4],
    points: Vec<Point2<f64>>,
    lengths: Vec<f64>,
}

/// Where a point stands to a segment.
#[derive(Debug, Clone, Copy)]
pub(in crate::sample) struct Foot {
    /// Arc length of the nearest point of the segment's carrier (line, whole circle, curve).
    pub along: f64,
    /// Signed distance from the carrier, positive to the right of its direction.
    pub offset: f64,
    /// Unit gradient of the signed distance.
    pub normal: Vector2<f64>,
}

const TAU: f64 = std::f64::consts::TAU;
const HALF_PI: f64 = std::f64::consts::FRAC_PI_2;

impl Segment {
    pub fn line(from: Point2<f64>, to: Point2<f64>) -> Self {
        let length = (to - from).norm();
        Self::Line {
            from,
            direction: (to - from) / length,
            length,
        }
    }

    /// The arc between two points whose bulge is the tangent of a quarter of its turn.
    pub fn arc(from: Point2<f64>, to: Point2<f64>, bulge: f64) -> Self {
        let chord = to - from;
        let left = Vector2::new(-chord.y, chord.x);
        let centre = from + chord / 2.0 + left * ((1.0 - bulge * bulge) / (4.0 * bulge));
        let radius = chord.norm() * (1.0 + bulge * bulge) / (4.0 * bulge.abs());
        let start = libm::atan2(from.y - centre.y, from.x - centre.x);
        let sweep = 4.0 * libm::atan(bulge);
        Self::Arc(Arc::new(centre, radius, start, sweep, [from, to]))
    }

    pub fn circle(centre: Point2<f64>, radius: f64) -> Self {
        let end = centre + Vector2::new(radius, 0.0);
        Self::Arc(Arc::new(centre, radius, 0.0, TAU, [end, end]))
    }

    pub fn curve(controls: [Point2<f64>; 4]) -> Self {
        Self::Curve(Curve::new(controls))
    }

    pub fn length(&self) -> f64 {
        match self {
            Self::Line { length, .. } => *length,
            Self::Arc(arc) => arc.radius * arc.sweep.abs(),
            Self::Curve(curve) => curve.length(),
        }
    }

    /// Whether the segment is a whole circle.
    pub fn is_closed(&self) -> bool {
        matches!(self, Self::Arc(arc) if arc.sweep.abs() >= TAU)
    }

    /// The point at an arc length from the start.
    pub fn at(&self, along: f64) -> Point2<f64> {
        match self {
            Self::Line {
                from, direction, ..
            } => from + direction * along,
            Self::Arc(arc) => arc.at(along),
            Self::Curve(curve) => curve.point(curve.parameter(along)),
        }
    }

    pub fn ends(&self) -> [Point2<f64>; 2] {
        match self {
            Self::Line {
                from,
                direction,
                length,
            } => [*from, from + direction * *length],
            Self::Arc(arc) => arc.ends,
            Self::Curve(curve) => [curve.controls[0], curve.controls[3]],
        }
    }

    pub fn foot(&self, point: &Point2<f64>) -> Foot {
        match self {
            Self::Line {
                from, direction, ..
            } => {
                let normal = Vector2::new(direction.y, -direction.x);
                Foot {
                    along: (point - from).dot(direction),
                    offset: (point - from).dot(&normal),
                    normal,
                }
            }
            Self::Arc(arc) => arc.foot(point),
            Self::Curve(curve) => curve.foot(point),
        }
    }

    /// How often the ray from the point towards positive x crosses the segment. A piece counts
    /// where its ends lie on different sides of the ray, so corners are counted once.
    pub fn crossings(&self, point: &Point2<f64>) -> usize {
        let straddles = |low: f64, high: f64| (low > point.y) != (high > point.y);
        match self {
            Self::Line { .. } => {
                let [a, b] = self.ends();
                let crossed = straddles(a.y, b.y)
                    && a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x) > point.x;
                usize::from(crossed)
            }
            Self::Arc(arc) => {
                let rise = point.y - arc.centre.y;
                let half = (arc.radius * arc.radius - rise * rise).max(0.0).sqrt();
                let crossed = |&&(low, high, right): &&(f64, f64, bool)| {
                    let x = arc.centre.x + if right { half } else { -half };
                    straddles(low, high) && x > point.x
                };
                arc.pieces.iter().filter(crossed).count()
            }
            Self::Curve(curve) => curve.crossings(point),
        }
    }
}

impl Arc {
    fn new(
        centre: Point2<f64>,
        radius: f64,
        start: f64,
        sweep: f64,
        ends: [Point2<f64>; 2],
    ) -> Self {
        let (low, high) = (start.min(start + sweep), start.max(start + sweep));
        // Odd multiples of π/2 strictly within the arc are its highest and lowest points.
        let mut turns: Vec<f64> = (-5..=5)
            .map(|k| HALF_PI * f64::from(2 * k + 1))
            .filter(|&angle| angle > low + 1e-12 && angle < high - 1e-12)
            .collect();
        if sweep < 0.0 {
            turns.reverse();
        }
        let ordinate =
            |angle: f64| centre.y + radius * if libm::sin(angle) > 0.0 { 1.0 } else { -1.0 };
        let mut pieces = Vec::new();
        let (mut angle, mut y) = (start, ends[0].y);
        for turn in turns {
            pieces.push((y, ordinate(turn), libm::cos((angle + turn) / 2.0) > 0.0));
            (angle, y) = (turn, ordinate(turn));
        }
        let middle = (angle + start + sweep) / 2.0;
        pieces.push((y, ends[1].y, libm::cos(middle) > 0.0));
        Self {
            centre,
            radius,
            start,
            sweep,
            ends,
            pieces,
        }
    }

    fn at(&self, along: f64) -> Point2<f64> {
        let angle = self.start + self.sweep.signum() * along / self.radius;
        let (sin, cos) = libm::sincos(angle);
        self.centre + Vector2::new(cos, sin) * self.radius
    }

    fn foot(&self, point: &Point2<f64>) -> Foot {
        let spoke = point - self.centre;
        let distance = spoke.norm();
        let outward = if distance > 0.0 {
            spoke / distance
        } else {
            Vector2::x()
        };
        let turn = self.sweep.signum();
        let mut angle = turn * (libm::atan2(spoke.y, spoke.x) - self.start);
        angle -= TAU * (angle / TAU).floor();
        // Of a point beyond the ends, the nearer end decides whether it comes before or after.
        if angle > (TAU + self.sweep.abs()) / 2.0 {
            angle -= TAU;
        }
        Foot {
            along: angle * self.radius,
            offset: turn * (distance - self.radius),
            normal: outward * turn,
        }
    }
}

impl Curve {
    const STEPS: usize = 256;

    fn new(controls: [Point2<f64>; 4]) -> Self {
        let mut curve = Self {
            controls,
            points: vec![controls[0]],
            lengths: vec![0.0],
        };
        let (mut last, mut total) = (controls[0], 0.0);
        for step in 1..=Self::STEPS {
            let point = curve.point(step as f64 / Self::STEPS as f64);
            total += (point - last).norm();
            curve.points.push(point);
            curve.lengths.push(total);
            last = point;
        }
        curve
    }

    fn length(&self) -> f64 {
        self.lengths.last().copied().unwrap_or_default()
    }

    /// By de Casteljau's subdivision.
    fn point(&self, t: f64) -> Point2<f64> {
        let mut row = self.controls;
        for level in (1..4).rev() {
            for k in 0..level {
                row[k] += (row[k + 1] - row[k]) * t;
            }
        }
        row[0]
    }

    fn derivative(&self, t: f64) -> Vector2<f64> {
        let [a, b, c, d] = self.controls;
        let s = 1.0 - t;
        ((b - a) * (s * s) + (c - b) * (2.0 * s * t) + (d - c) * (t * t)) * 3.0
    }

    /// The parameter at an arc length, linear between the table's entries.
    fn parameter(&self, along: f64) -> f64 {
        let steps = Self::STEPS as f64;
        let next = self.lengths.partition_point(|&length| length < along);
        let next = next.clamp(1, Self::STEPS);
        let (low, high) = (self.lengths[next - 1], self.lengths[next]);
        (next as f64 - 1.0 + (along - low) / (high - low)) / steps
    }

    fn along(&self, t: f64) -> f64 {
        let position = t * Self::STEPS as f64;
        let step = (position.max(0.0) as usize).min(Self::STEPS - 1);
        let (low, high) = (self.lengths[step], self.lengths[step + 1]);
        low + (high - low) * (position - step as f64)
    }

    /// Newton's method on (C(t) - p)·C'(t) = 0 from the nearest point of a coarse scan.
    fn foot(&self, point: &Point2<f64>) -> Foot {
        let square = |t: f64| (self.point(t) - point).norm_squared();
        let mut t = (0..=32)
            .map(|k| f64::from(k) / 32.0)
            .min_by(|&a, &b| square(a).total_cmp(&square(b)))
            .unwrap_or_default();
        for _ in 0..12 {
            let tangent = self.derivative(t);
            let [a, b, c, d] = self.controls;
            let bend = ((c.coords - b.coords * 2.0 + a.coords) * (1.0 - t)
                + (d.coords - c.coords * 2.0 + b.coords) * t)
                * 6.0;
            let gap = self.point(t) - point;
            let slope = tangent.norm_squared() + gap.dot(&bend);
            if slope <= 0.0 {
                break;
            }
            t = (t - gap.dot(&tangent) / slope).clamp(-0.05, 1.05);
        }
        let tangent = self.derivative(t);
        let normal = Vector2::new(tangent.y, -tangent.x) / tangent.norm();
        Foot {
            along: self.along(t),
            offset: (point - self.point(t)).dot(&normal),
            normal,
        }
    }

    fn crossings(&self, point: &Point2<f64>) -> usize {
        // The table's steps are short enough to rise or fall throughout, but for one that holds a
        // summit; a ray that grazes it meets no outline a part is made of.
        let mut count = 0;
        for (k, ends) in self.points.windows(2).enumerate() {
            let above = ends[0].y > point.y;
            if above == (ends[1].y > point.y) {
                continue;
            }
            let (mut low, mut high) = (k as f64, k as f64 + 1.0);
            for _ in 0..50 {
                let middle = (low + high) / 2.0;
                if (self.point(middle / Self::STEPS as f64).y > point.y) == above {
                    low = middle;
                } else {
                    high = middle;
                }
            }
            count += usize::from(self.point(low / Self::STEPS as f64).x > point.x);
        }
        count
    }
}
