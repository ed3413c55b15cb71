//! A cross-section: the curves in which a plane meets surfaces, and the points near the plane. For
//! drawing; nothing is measured on it.
//!
//! What a whole surface and a plane meet in is told in closed form ([`Meeting`]). What is drawn is
//! only the part of it that a primitive's points cover: the plane is followed from triangle to
//! triangle across the [`Patch`], and every place found is moved on until it lies on the plane and
//! on the surface.

mod meeting;

use std::collections::HashMap;

pub use meeting::Meeting;

use super::patch::Patch;
use super::{Surface, SurfaceType};
use crate::cloud::{Direction, Point, Vector};

/// A plane to cut with, and two axes in it to draw by.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CuttingPlane {
    /// A place on it, where both axes begin.
    pub origin: Point,
    /// Unit vector to the right.
    pub right: Direction,
    /// Unit vector upwards, across the one to the right.
    pub up: Direction,
}

impl CuttingPlane {
    /// The plane across an axis of the coordinates (0, 1 or 2; larger numbers are 2) at a
    /// coordinate. Seen along the axis: y and z, x and z, or x and y.
    pub fn across(axis: usize, at: f64) -> Self {
        let (right, up) = match axis {
            0 => (Vector::y_axis(), Vector::z_axis()),
            1 => (Vector::x_axis(), Vector::z_axis()),
            _ => (Vector::x_axis(), Vector::y_axis()),
        };
        let mut origin = Point::origin();
        origin[axis.min(2)] = at;
        Self { origin, right, up }
    }

    /// Unit normal.
    pub fn normal(&self) -> Vector {
        self.right.cross(&self.up)
    }

    /// Distance of a point from the plane, negative behind it.
    pub fn height(&self, point: &Point) -> f64 {
        (point - self.origin).dot(&self.normal())
    }

    /// Where a point lies along the two axes.
    pub fn flat(&self, point: &Point) -> [f64; 2] {
        let offset = point - self.origin;
        [offset.dot(&self.right), offset.dot(&self.up)]
    }

    /// Indices, ascending, of the points at most half a thickness away on either side. O(n).
    pub fn near<'a>(
        &'a self,
        points: &'a [Point],
        thickness: f64,
    ) -> impl Iterator<Item = u32> + 'a {
        let close = move |point: &Point| self.height(point).abs() <= thickness / 2.0;
        (0_u32..)
            .zip(points)
            .filter(move |(_, point)| close(point))
            .map(|(index, _)| index)
    }
}

/// A place on an edge of the patch's mesh, told by its two vertices.
type Edge = (u32, u32);

/// The curves in which the plane meets the part of a surface that some points cover, as chains of
/// places on both; a closed curve may come as a chain whose ends meet. Parts smaller than a facet of
/// the patch (5° of a curved surface) may be missed. O(n log n) for the patch.
pub fn trace(surface: &Surface, points: &[Point], plane: &CuttingPlane) -> Vec<Vec<Point>> {
    let Some(patch) = Patch::new(surface, points) else {
        return Vec::new();
    };
    let heights: Vec<f64> = patch.vertices.iter().map(|v| plane.height(v)).collect();
    let is_above = |at: u32| {
        heights
            .get(at as usize)
            .is_some_and(|height| *height >= 0.0)
    };
    let mut segments: Vec<[Edge; 2]> = Vec::new();
    for &[a, b, c] in &patch.triangles {
        let crossed: Vec<Edge> = [(a, b), (b, c), (c, a)]
            .into_iter()
            .filter(|&(from, to)| is_above(from) != is_above(to))
            .map(|(from, to)| (from.min(to), from.max(to)))
            .collect();
        if let [from, to] = crossed[..] {
            segments.push([from, to]);
        }
    }
    let place = |&(from, to): &Edge| -> Option<Point> {
        let (a, b) = (heights.get(from as usize)?, heights.get(to as usize)?);
        let (p, q) = (
            patch.vertices.get(from as usize)?,
            patch.vertices.get(to as usize)?,
        );
        Some(p + (q - p) * (a / (a - b)))
    };
    chains(&segments)
        .into_iter()
        .map(|chain| {
            let places: Vec<Point> = chain.iter().filter_map(place).collect();
            finished(surface, plane, places)
        })
        .filter(|chain| chain.len() > 1)
        .collect()
}

/// A straight chain keeps its ends; another gets the middle of every piece, and all its places are
/// brought onto the curve.
fn finished(surface: &Surface, plane: &CuttingPlane, places: Vec<Point>) -> Vec<Point> {
    if surface.kind() == SurfaceType::Plane {
        return match places[..] {
            [first, .., last] => vec![first, last],
            _ => Vec::new(),
        };
    }
    let mut finer = Vec::with_capacity(2 * places.len());
    for pair in places.windows(2) {
        if let &[from, to] = pair {
            let reach = nalgebra::distance(&from, &to);
            finer.push(onto(surface, plane, from, reach));
            finer.push(onto(surface, plane, nalgebra::center(&from, &to), reach));
        }
    }
    finer.extend(places.last().map(|last| onto(surface, plane, *last, 0.0)));
    finer
}

/// The place on plane and surface near one that is close to both (Newton's method within the
/// plane); the given one where that leads farther away than the reach, as it may where the two touch.
fn onto(surface: &Surface, plane: &CuttingPlane, given: Point, reach: f64) -> Point {
    const STEPS: usize = 6;
    let normal = plane.normal();
    let mut place = given - normal * plane.height(&given);
    for _ in 0..STEPS {
        let outward = surface.normal(&place).into_inner();
        let slope = outward - normal * outward.dot(&normal);
        let steepness = slope.norm_squared();
        if steepness < 1e-12 {
            return given;
        }
        place -= slope * (surface.signed_distance(&place) / steepness);
    }
    let moved = nalgebra::distance(&place, &given);
    if moved.is_finite() && (reach == 0.0 || moved <= reach) {
        place
    } else {
        given
    }
}

/// Joins segments that share an edge into chains, each begun at a loose end where it has one. O(n).
fn chains(segments: &[[Edge; 2]]) -> Vec<Vec<Edge>> {
    let mut ends: HashMap<Edge, Vec<usize>> = HashMap::new();
    for (at, segment) in segments.iter().enumerate() {
        for edge in segment {
            ends.entry(*edge).or_default().push(at);
        }
    }
    let is_loose = |edge: &Edge| ends.get(edge).is_some_and(|at| at.len() == 1);
    let mut used = vec![false; segments.len()];
    let loose = segments
        .iter()
        .enumerate()
        .filter(|(_, [from, to])| is_loose(from) || is_loose(to));
    // Those with a loose end first: what is left over is closed.
    let order: Vec<usize> = loose.map(|(at, _)| at).chain(0..segments.len()).collect();
    let mut chains = Vec::new();
    for start in order {
        let Some(&[from, to]) = segments.get(start) else {
            continue;
        };
        if std::mem::replace(&mut used[start], true) {
            continue;
        }
        let (first, mut last) = if is_loose(&from) {
            (from, to)
        } else {
            (to, from)
        };
        let mut chain = vec![first, last];
        while let Some(next) = ends
            .get(&last)
            .and_then(|at| at.iter().copied().find(|&at| !used[at]))
        {
            used[next] = true;
            let [from, to] = segments[next];
            last = if from == last { to } else { from };
            chain.push(last);
        }
        chains.push(chain);
    }
    chains
}

#[cfg(test)]
mod tests;
