//! Step 4: splitting a region of several surfaces by RANSAC (Schnabel, Wahl and Klein 2007).
//!
//! A draw takes a minimal set of points with normals from one neighbourhood (localised sampling:
//! points near each other are likely to be on one surface), the surfaces through it are polished
//! and grown to connected support, and the one worth most is kept. Exact normals would make the
//! minimal surface exact; estimated ones make it a start for least squares.

use super::super::detect;
use super::super::progress::{Cancelled, Observer, Stage};
use super::super::search::Search;
use super::super::{Candidate, Parameters};
use super::normal;
use crate::cloud::{Point, Vector};
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface};

/// Sizes of the neighbourhoods that minimal sets are drawn from, one drawn at random each time.
const LEVELS: [usize; 3] = [10, 16, 28];
/// Chance left that a surface of the smallest size has been missed.
const MISSED: f64 = 0.05;
/// Draws in vain after which a region is left as it is, however large.
const MOST_DRAWS: usize = 300;

/// Splits what is unexplained of a region into surfaces; the rest stays unexplained. `done` is the
/// share of the search that is done, for the observer.
///
/// # Errors
/// If the observer stops the fit.
pub fn split(
    search: &mut Search<'_>,
    region: &[u32],
    done: f64,
    observer: &mut dyn Observer,
) -> Result<(), Cancelled> {
    let smallest = Parameters::count(search.parameters.smallest);
    let mut open = region.to_vec();
    let mut vain = 0;
    let mut draws = 0usize;
    loop {
        open.retain(|&index| !search.is_explained(index));
        if open.len() < smallest || vain >= draws_needed(open.len(), smallest) {
            return Ok(());
        }
        let seed = open[search.random.below(open.len())];
        match draw(search, seed) {
            Some(candidate) => {
                detect::keep(search, candidate, observer);
                vain = 0;
            }
            None => {
                vain += 1;
                // Neighbours of a seed in vain would be in vain as well.
                let near = search.unexplained_near(seed, LEVELS[1]);
                open.retain(|index| !near.contains(index));
            }
        }
        draws += 1;
        if draws.is_multiple_of(32) {
            observer.progress(Stage::Find, done)?;
        }
    }
}

/// How many draws leave a chance of [`MISSED`] that none started on a surface of n of N points:
/// s = ln(chance) / ln(1 - n / N) (Schnabel and others, section 4.2, for localised sampling, where
/// the first point decides).
fn draws_needed(points: usize, smallest: usize) -> usize {
    let share = (smallest as f64 / points as f64).min(0.99);
    let draws = libm::log(MISSED) / libm::log(1.0 - share);
    (draws.ceil() as usize).clamp(1, MOST_DRAWS)
}

/// The best surface through minimal sets around a seed; where that leaves doubt, it competes with
/// those through the whole neighbourhood.
fn draw(search: &mut Search<'_>, seed: u32) -> Option<Candidate> {
    let level = LEVELS[search.random.below(LEVELS.len())];
    let patch = search.unexplained_near(seed, level);
    let mut candidates = Vec::new();
    if let Some(set) = minimal_set(search, &patch) {
        for surface in through(&set) {
            detect::grow_start(search, &surface, &patch, &mut candidates);
        }
    }
    let clear = candidates
        .iter()
        .any(|candidate| search.own(candidate) >= detect::CLEAR);
    if !clear {
        candidates.extend(detect::at(search, seed));
    }
    search.best(candidates)
}

/// A point with its normal.
type Oriented = (Point, Vector);

/// The seed and two other points of its neighbourhood, with normals.
fn minimal_set(search: &mut Search<'_>, patch: &[u32]) -> Option<[Oriented; 3]> {
    let (&seed, others) = patch.split_first()?;
    if others.len() < 2 {
        return None;
    }
    let first = search.random.below(others.len());
    let step = 1 + search.random.below(others.len() - 1);
    let second = (first + step) % others.len();
    let oriented = |index: u32| Some((*search.point(index), normal(search, index)?));
    Some([
        oriented(seed)?,
        oriented(others[first])?,
        oriented(others[second])?,
    ])
}

/// The surfaces through a minimal set (Schnabel and others, section 4.1): a plane by one point and
/// its normal, a sphere and a cylinder by two, a cone by three. Tori take four, and third
/// derivatives that estimated normals do not give; they are left to whole neighbourhoods.
pub fn through(set: &[Oriented; 3]) -> Vec<Surface> {
    let [(p, n), (q, m), _] = *set;
    let mut surfaces = vec![Surface::Plane(Plane::new(p, n))];
    // The common perpendicular of the two normal lines is where centre and axis are sought.
    let axis = n.cross(&m);
    let (dot, squared) = (n.dot(&m), axis.norm_squared());
    if squared > 1e-8 {
        let between = q - p;
        let along_first = (between.dot(&n) - between.dot(&m) * dot) / squared;
        let along_second = (between.dot(&n) * dot - between.dot(&m)) / squared;
        let (a, b) = (p + n * along_first, q + m * along_second);
        let centre = nalgebra::center(&a, &b);
        let radius = 0.5 * ((p - centre).norm() + (q - centre).norm());
        surfaces.push(Surface::Sphere(Sphere::new(centre, radius)));
        let radius = 0.5 * (along_first.abs() + along_second.abs());
        surfaces.push(Surface::Cylinder(Cylinder::new(a, axis, radius)));
    }
    surfaces.extend(cone(set));
    surfaces
}

/// The apex is where the three tangent planes meet; the axis is across the plane through the points
/// at unit distance from it.
fn cone(set: &[Oriented; 3]) -> Option<Surface> {
    let rows = nalgebra::Matrix3::from_rows(&set.map(|(_, n)| n.transpose()));
    let offsets = Vector::from(set.map(|(p, n)| p.coords.dot(&n)));
    let apex = Point::from(rows.lu().solve(&offsets)?);
    let [a, b, c] = set.map(|(p, _)| (p - apex).normalize());
    let axis = (b - a).cross(&(c - a)).try_normalize(1e-12)?;
    let half_angle = set
        .map(|(_, n)| libm::asin(n.dot(&axis).abs().min(1.0)))
        .iter()
        .sum::<f64>()
        / 3.0;
    apex.iter()
        .all(|x| x.is_finite())
        .then(|| Surface::Cone(Cone::new(apex, axis, half_angle)))
}

#[cfg(test)]
mod tests;
