//! A surface laid out flat: along its first coordinate `a` it may close, along the second `b` it closes
//! only where it does along the first too.

use fit4cad::cloud::{Bounds, Point, Vector};

use super::axis::Axis;
use super::nearest::{nearest, refine};
use super::shape::Shape;
use super::swept;

/// A surface with its parameters in the order in which faces are cut into columns.
pub(crate) struct Chart {
    /// The surface.
    pub shape: Shape,
    swapped: bool,
    /// Range of the first coordinate.
    pub a: Axis,
    /// Range of the second coordinate.
    pub b: Axis,
    search: Search,
}

/// What the search for parameters of which there is no formula needs to know.
struct Search {
    /// Ranges of both parameters.
    axes: [Axis; 2],
    /// Where to begin.
    starts: Vec<([f64; 2], Point)>,
    /// A length that says how large the surface is.
    size: f64,
}

/// Steps of Gauss and Newton: places lie on the surface or nearly, where they double their digits.
const STEPS: usize = 24;
/// Most places along one parameter at which a search may begin.
const MOST_STARTS: usize = 64;

impl Chart {
    /// Lays a surface out.
    pub fn new(shape: Shape) -> Self {
        let axes = shape.axes();
        let [u, v] = axes;
        let swapped = u.period.is_none() && v.period.is_some();
        let [a, b] = if swapped { [v, u] } else { [u, v] };
        let search = Search::of(&shape, axes);
        Self {
            shape,
            swapped,
            a,
            b,
            search,
        }
    }

    /// Whether the coordinates are the parameters in the other order, which turns orientations over.
    pub fn is_swapped(&self) -> bool {
        self.swapped
    }

    /// Where either coordinate meets a new piece of the surface, between which it is smooth.
    pub fn breaks(&self) -> [Vec<f64>; 2] {
        let [u, v] = self.shape.breaks();
        if self.swapped { [v, u] } else { [u, v] }
    }

    /// The parameters of coordinates, which may have gone around.
    fn parameters(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        let (a, b) = (self.a.wrap(a), self.b.wrap(b));
        if self.swapped { [b, a] } else { [a, b] }
    }

    fn coordinates(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        if self.swapped { [v, u] } else { [u, v] }
    }

    /// The place at coordinates.
    pub fn at(&self, at: [f64; 2]) -> Point {
        self.shape.at(self.parameters(at)).0
    }

    /// Place and unit normal at coordinates.
    pub fn oriented(&self, at: [f64; 2]) -> (Point, Vector) {
        let (point, u, v) = self.shape.at(self.parameters(at));
        (point, u.cross(&v).try_normalize(0.0).unwrap_or_default())
    }

    /// Place and area per area of coordinates.
    pub fn measured(&self, at: [f64; 2]) -> (Point, f64) {
        let (point, u, v) = self.shape.at(self.parameters(at));
        (point, u.cross(&v).norm())
    }

    /// The coordinates of a place on or near the surface, those near `hint` first.
    pub fn invert(&self, place: &Point, hint: Option<Hint>) -> [f64; 2] {
        let hint = hint.map(|Hint { at, reach }| Hint {
            at: self.parameters(at),
            reach,
        });
        self.coordinates(invert(&self.shape, &self.search, place, hint))
    }
}

/// Where the coordinates of a place most likely are.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hint {
    /// Coordinates of a place beside it.
    pub at: [f64; 2],
    /// So far off the surface the place may be: what is found within is right.
    pub reach: f64,
}

fn invert(shape: &Shape, search: &Search, place: &Point, hint: Option<Hint>) -> [f64; 2] {
    let along = |k: usize| hint.map(|it| (it.at[k], it.reach));
    if let Some(found) = shape.invert(place) {
        return found;
    }
    match shape {
        Shape::Extruded(curve, direction) => {
            let seen = |t: f64| swept::flattened(curve, direction, t);
            let unit = direction / direction.norm();
            let flat = place - unit * place.coords.dot(&unit);
            let u = on_curve(seen, search.axes[0], along(0), &flat, curve.breaks().len());
            let along = (place - curve.at(u).0).dot(direction);
            [u, along / direction.norm_squared()]
        }
        Shape::Revolved(curve, frame) => {
            let seen = |t: f64| swept::seen(curve, frame, t);
            let [x, y, z] = frame.enter(place);
            let flat = Point::new(libm::hypot(x, y), z, 0.0);
            let v = on_curve(seen, search.axes[1], along(1), &flat, curve.breaks().len());
            let [x0, y0, _] = frame.enter(&curve.at(v).0);
            [libm::atan2(y, x) - libm::atan2(y0, x0), v]
        }
        Shape::Offset(basis, distance) => {
            // The foot on the surface at a distance is that on the surface itself, which is as far off.
            let hint = hint.map(|Hint { at, reach }| Hint {
                at,
                reach: reach + 1.000_001 * distance.abs(),
            });
            invert(basis, search, place, hint)
        }
        _ => search.on_surface(shape, place, hint),
    }
}

/// The parameter of a plane curve nearest to a place.
fn on_curve(
    at: impl Fn(f64) -> (Point, Vector),
    axis: Axis,
    hint: Option<(f64, f64)>,
    place: &Point,
    breaks: usize,
) -> f64 {
    let [low, high] = axis.range;
    if !(low.is_finite() && high.is_finite()) {
        // A line askew to its axis, or a conic without end.
        let start = hint.map_or(0.0, |(at, _)| at);
        return refine(&at, [f64::MIN, f64::MAX], start, place);
    }
    if let Some((hint, reach)) = hint {
        let range = if axis.period.is_some() {
            [f64::MIN, f64::MAX]
        } else {
            axis.range
        };
        let found = refine(&at, range, hint, place);
        let (there, tangent) = at(found);
        // Good enough to be on the curve: no other piece of it is meant.
        if (there - place).norm() <= reach.max(1e-6 * tangent.norm() * (high - low)) {
            return axis.wrap(found);
        }
    }
    nearest(at, axis.range, (16 * breaks).clamp(64, 1024), place)
}

impl Search {
    fn of(shape: &Shape, axes: [Axis; 2]) -> Self {
        let mut basis = shape;
        while let Shape::Offset(inner, _) = basis {
            basis = inner;
        }
        let mut starts = Vec::new();
        if let Shape::Spline(spline) = basis {
            let along_u = places(&spline.u.breaks(), spline.u.degree());
            let along_v = places(&spline.v.breaks(), spline.v.degree());
            for &u in &along_u {
                starts.extend(along_v.iter().map(|&v| ([u, v], spline.at(u, v).0)));
            }
        }
        let bounds = Bounds::of(starts.iter().map(|(_, point)| point));
        let size = if bounds.is_empty() {
            1.0
        } else {
            bounds.diagonal()
        };
        Self { axes, starts, size }
    }

    /// The parameters of a surface nearest to a place.
    fn on_surface(&self, shape: &Shape, place: &Point, hint: Option<Hint>) -> [f64; 2] {
        let mut best = (f64::INFINITY, hint.map_or([0.0; 2], |it| it.at));
        let mut consider = |start: [f64; 2]| {
            let found = self.descend(shape, start, place);
            if found.0 < best.0 {
                best = found;
            }
            found.0
        };
        // On the surface, as far as files are exact: no other piece of it is meant.
        if let Some(Hint { at, reach }) = hint
            && consider(at) <= reach.max(1e-6 * self.size)
        {
            return best.1;
        }
        let starts = self.starts.iter().enumerate();
        let mut order: Vec<(f64, usize)> = starts
            .map(|(k, (_, point))| ((point - place).norm_squared(), k))
            .collect();
        let by_distance =
            |a: &(f64, usize), b: &(f64, usize)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
        const TRIED: usize = 6;
        if order.len() > TRIED {
            order.select_nth_unstable_by(TRIED, by_distance);
            order.truncate(TRIED);
        }
        order.sort_by(by_distance);
        for (_, k) in order {
            if consider(self.starts[k].0) <= 1e-7 * self.size {
                break;
            }
        }
        best.1
    }

    /// Distance and parameters of the foot of a place, found from `start`.
    fn descend(&self, shape: &Shape, start: [f64; 2], place: &Point) -> (f64, [f64; 2]) {
        let mut at = start;
        let (mut point, mut along_u, mut along_v) = shape.at(at);
        let mut distance = (place - point).norm();
        for _ in 0..STEPS {
            if distance <= 1e-14 * self.size {
                break;
            }
            let offset = place - point;
            let full = step(&offset, &along_u, &along_v);
            let mut share = 1.0;
            let mut moved = false;
            for _ in 0..6 {
                let next =
                    self.within(at, full.map(|it| it * share), &offset, [&along_u, &along_v]);
                let there = shape.at(next);
                let reached = (place - there.0).norm();
                if reached < distance {
                    let gain = distance - reached;
                    (at, distance) = (next, reached);
                    (point, along_u, along_v) = there;
                    moved = gain > 1e-15 * self.size;
                    break;
                }
                share *= 0.5;
            }
            if !moved {
                break;
            }
        }
        (distance, at)
    }

    /// The parameters after a step, which stops at the ends of the surface; along an end it goes on.
    fn within(
        &self,
        at: [f64; 2],
        step: [f64; 2],
        offset: &Vector,
        along: [&Vector; 2],
    ) -> [f64; 2] {
        let mut next = [at[0] + step[0], at[1] + step[1]];
        for k in 0..2 {
            let Axis { range, period, .. } = self.axes[k];
            if period.is_some() {
                continue;
            }
            let clamped = next[k].clamp(range[0], range[1]);
            if clamped != next[k] {
                let (this, other) = (along[k], along[1 - k]);
                let square = other.norm_squared();
                let taken = clamped - at[k];
                if square > 0.0 {
                    next[1 - k] = at[1 - k] + other.dot(&(offset - this * taken)) / square;
                }
                next[k] = clamped;
            }
        }
        for (value, axis) in next.iter_mut().zip(self.axes) {
            *value = axis.wrap(*value).clamp(axis.range[0], axis.range[1]);
        }
        next
    }
}

/// The step of Gauss and Newton towards the foot, damped a little where the parameters are degenerate.
fn step(offset: &Vector, along_u: &Vector, along_v: &Vector) -> [f64; 2] {
    let (uu, uv, vv) = (
        along_u.norm_squared(),
        along_u.dot(along_v),
        along_v.norm_squared(),
    );
    let damping = 1e-12;
    let (uu, vv) = (uu * (1.0 + damping) + 1e-300, vv * (1.0 + damping) + 1e-300);
    let (u, v) = (along_u.dot(offset), along_v.dot(offset));
    let determinant = uu * vv - uv * uv;
    if determinant > 1e-14 * uu * vv {
        [
            (vv * u - uv * v) / determinant,
            (uu * v - uv * u) / determinant,
        ]
    } else {
        // Both directions are one, or one of them vanishes: along the longer alone.
        if uu >= vv {
            [u / uu, 0.0]
        } else {
            [0.0, v / vv]
        }
    }
}

/// Places in every span between knots, as many as its degree asks for; not more than are worth it.
fn places(breaks: &[f64], degree: usize) -> Vec<f64> {
    let spans = breaks.len().saturating_sub(1).max(1);
    let each = (degree + 1).clamp(2, 8).min((MOST_STARTS / spans).max(1));
    let inner = breaks.windows(2).flat_map(|pair| {
        let (from, to) = (pair[0], pair[1]);
        (0..each).map(move |k| from + (to - from) * k as f64 / each as f64)
    });
    let mut places: Vec<f64> = inner.collect();
    places.extend(breaks.last());
    let every = places.len().div_ceil(MOST_STARTS);
    let last = places.len() - 1;
    let kept = places.iter().enumerate();
    kept.filter(|(k, _)| k % every == 0 || *k == last)
        .map(|(_, place)| *place)
        .collect()
}
