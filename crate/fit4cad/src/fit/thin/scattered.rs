//! Thin faces of scattered points, as mesh samplers and scanners give them.
//!
//! Sampled at random, a fillet narrower than the spacing shows no rows, and hardly one of the nearest
//! neighbours of its points is on it: no patch of it is pure, and none grows along the neighbours of
//! the whole cloud. But among the points that no surface holds its own are the nearest, and the faces
//! beside it tell the direction it runs along or the axis it turns about. There three points are a
//! surface, and each further one that is exactly on it is an accident with a chance of about the share
//! of the spacing that the tolerance takes up.

use super::recurring::prevailing;
use super::rows::{Proof, proof};
use super::scatter::is_scattered;
use super::swept::swept;
use crate::cloud::neighbours::{KdTree, Neighbour};
use crate::cloud::{Direction, Point};
use crate::fit::least_squares::{self, Loss, degrees_of_freedom};
use crate::fit::progress::{Cancelled, Observer, Stage};
use crate::fit::pure::pure;
use crate::fit::quantile::quantile;
use crate::fit::stages::{FOURTH, STEPS, held};
use crate::fit::{Candidate, Parameters, Search, detect};
use crate::surface::Surface;

/// Free points of the neighbourhoods that surfaces are proposed for, the smallest first: where faces
/// are small, a wide one holds too little of each.
const SIZES: [usize; 3] = [8, 14, 24];
/// Radius within which a neighbourhood lies, in spacings: a face half a spacing wide has a point in
/// four of them.
const REACH: f64 = 24.0;
/// Most passes over the points that are left: what one finds may tell the directions for a next.
const PASSES: usize = 4;
/// Points of a neighbourhood that must be on a surface for it to be grown.
const AGREEING: usize = 6;
/// Rounds in which a surface is fitted to its points and collects them anew.
const ROUNDS: usize = 4;
/// Farthest a point may lie from a thin face, in root mean square errors of one.
const WITHIN: f64 = 4.0;
/// Root mean square error of a face, in tolerances: those of true ones are far below.
const EXACT: f64 = 0.03;
/// Share of the points around a face that no surface holds from which on it is alone. Of 0.5 to 0.9 the loosest at
/// which the training clouds show no plane in the midst of a free form; strips between strips that are not found need room.
const ALONE: f64 = 0.8;
/// Seeds in vain after which a pass ends: free-form regions have thousands of points that nothing holds.
const VAIN: usize = 3000;

/// Finds thin faces among the unexplained points of a clean cloud. O(n log n).
///
/// # Errors
/// If the observer stops the fit.
pub fn scattered(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    if !search.scale.shows_rows() {
        return Ok(());
    }
    let before = search.accepted().len();
    for _ in 0..PASSES {
        if pass(search, observer)? == 0 {
            break;
        }
    }
    drop_adrift(search, before);
    Ok(())
}

/// Takes back those of the last faces, from a position on, that lie amid points that nothing holds: where a
/// spline stands for a round, its pieces are as exact as any. Smallest first. O(faces² × points of one).
fn drop_adrift(search: &mut Search<'_>, first: usize) {
    let mut order: Vec<usize> = (first..search.accepted().len()).collect();
    order.sort_by_key(|&place| search.accepted()[place].support.len());
    let is_kept = held(search, search.accepted(), &order, ALONE);
    search.retain(|place, _| is_kept[place]);
}

/// Looks at every unexplained point once. Returns how many faces were accepted.
fn pass(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<usize, Cancelled> {
    let order = search.shuffled_unexplained();
    if order.len() < AGREEING {
        return Ok(0);
    }
    let free = Free::of(search, &order);
    let recurring = prevailing(search);
    let (mut accepted, mut vain) = (0, 0);
    for (place, &seed) in order.iter().enumerate() {
        if place % 64 == 0 {
            observer.progress(Stage::Find, 1.0)?;
        }
        if search.is_explained(seed) {
            continue;
        }
        if let Some(face) = free.face_at(search, &recurring, seed) {
            detect::keep(search, face, observer);
            accepted += 1;
        } else {
            vain += 1;
            if vain == VAIN {
                break;
            }
        }
    }
    Ok(accepted)
}

/// The points that no surface held when a pass began.
struct Free {
    tree: KdTree,
    /// Index in the cloud of each, ascending.
    indices: Vec<u32>,
    /// Largest root mean square error of a face.
    exact: f64,
}

impl Free {
    fn of(search: &Search<'_>, unexplained: &[u32]) -> Self {
        let mut indices = unexplained.to_vec();
        indices.sort_unstable();
        Self {
            tree: KdTree::new(&search.points(&indices)),
            indices,
            exact: search.scale.largest_error(EXACT),
        }
    }

    /// The nearest points to one that are still free, itself first.
    fn near(&self, search: &Search<'_>, seed: u32, count: usize) -> Vec<u32> {
        let mut near: Vec<Neighbour> = Vec::with_capacity(count + 1);
        let radius = REACH * search.scale.spacing;
        let is_free = |place: u32| !search.is_explained(self.indices[place as usize]);
        self.tree
            .nearest(search.point(seed), count, radius, is_free, &mut near);
        near.iter()
            .map(|neighbour| self.indices[neighbour.index as usize])
            .collect()
    }

    /// The face that a point is on, if its neighbours show one.
    fn face_at(
        &self,
        search: &Search<'_>,
        recurring: &[Direction],
        seed: u32,
    ) -> Option<Candidate> {
        for size in SIZES {
            let patch = self.near(search, seed, size);
            if patch.len() < size.min(AGREEING + 1) {
                return None;
            }
            let mut surfaces = swept(search, recurring, &patch);
            surfaces.extend(pure(search, &patch));
            let mut faces: Vec<Candidate> = Vec::new();
            for surface in surfaces {
                let tolerance = search.scale.tolerance;
                let is_on = |&&index: &&u32| surface.distance(search.point(index)) <= tolerance;
                let on: Vec<u32> = patch.iter().filter(is_on).copied().collect();
                let is_new = !faces.iter().any(|face| {
                    face.surface.kind() == surface.kind()
                        && on.iter().all(|i| face.support.binary_search(i).is_ok())
                });
                if on.len() >= AGREEING && is_new {
                    faces.extend(self.grow(search, &surface, on));
                }
            }
            // Of those with about as many points the simplest: the more freedom, the more accidents.
            let worth = |face: &Candidate| {
                face.support.len() as isize - degrees_of_freedom(face.surface.kind()) as isize
            };
            if let Some(best) = faces.into_iter().max_by_key(worth) {
                return Some(best);
            }
        }
        None
    }

    /// Fits a surface to its points and collects those connected to them, as far apart as they are on
    /// this face, until nothing changes. `None` where they are no proof of it.
    fn grow(&self, search: &Search<'_>, start: &Surface, seeds: Vec<u32>) -> Option<Candidate> {
        let mut surface = *start;
        let mut support = seeds;
        let mut tolerance = search.scale.tolerance;
        let reach = reach(search, &search.points(&support));
        for _ in 0..ROUNDS {
            let next = self.connected(search, &surface, &support, tolerance, reach);
            let freedom = degrees_of_freedom(surface.kind());
            if next.len() <= freedom {
                return None;
            }
            let fitted = least_squares::fit(&surface, &search.points(&next), Loss::Squares)?;
            if !search.is_plausible(&fitted.surface) {
                return None;
            }
            let is_settled = next == support;
            surface = fitted.surface;
            support = next;
            tolerance = (WITHIN * self.exact).min(search.scale.tolerance);
            if is_settled {
                break;
            }
        }
        let error = search.error(&surface, &support);
        let face = Candidate {
            surface,
            support,
            error,
        };
        self.is_evident(search, &face).then_some(face)
    }

    /// The free points on a surface that are connected to some of them by steps no longer than `reach`,
    /// ascending.
    fn connected(
        &self,
        search: &Search<'_>,
        surface: &Surface,
        from: &[u32],
        tolerance: f64,
        reach: f64,
    ) -> Vec<u32> {
        let mut on: Vec<u32> = Vec::new();
        self.tree.near_zero(
            tolerance,
            |point| surface.distance(point),
            |place| on.push(self.indices[place as usize]),
        );
        on.retain(|&index| !search.is_explained(index));
        on.sort_unstable();
        let points = search.points(&on);
        let tree = KdTree::new(&points);
        let mut is_reached: Vec<bool> = on
            .iter()
            .map(|index| from.binary_search(index).is_ok())
            .collect();
        let mut queue: Vec<u32> = (0u32..)
            .zip(&is_reached)
            .filter(|(_, is)| **is)
            .map(|(i, _)| i)
            .collect();
        let mut near = Vec::new();
        while let Some(place) = queue.pop() {
            let is_open = |other: u32| !is_reached[other as usize];
            tree.nearest(
                &points[place as usize],
                usize::MAX,
                reach,
                is_open,
                &mut near,
            );
            for neighbour in &near {
                is_reached[neighbour.index as usize] = true;
                queue.push(neighbour.index);
            }
        }
        let reached = on.iter().zip(is_reached);
        reached
            .filter(|(_, is)| *is)
            .map(|(&index, _)| index)
            .collect()
    }

    /// Whether so many points are so exactly on a surface that it is no accident.
    fn is_evident(&self, search: &Search<'_>, face: &Candidate) -> bool {
        let smallest = Parameters::count(search.parameters.smallest);
        let freedom = degrees_of_freedom(face.surface.kind());
        let needed = smallest.max(freedom + search.scale.redundancy());
        face.support.len() >= needed
            && face.error <= self.exact
            && proof(search, face) == Proof::Certain
            && is_scattered(search, face)
    }
}

/// How far apart neighbours on a face may be, from some of its points.
fn reach(search: &Search<'_>, points: &[Point]) -> f64 {
    let fourth = |point: &Point| {
        let mut apart: Vec<f64> = points.iter().map(|other| (other - point).norm()).collect();
        apart.sort_by(f64::total_cmp);
        apart.get(FOURTH).or(apart.last()).copied().unwrap_or(0.0)
    };
    let mut apart: Vec<f64> = points.iter().map(fourth).collect();
    let usual = STEPS * quantile(&mut apart, 0.5);
    usual.min(REACH * search.scale.spacing)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Cloud;
    use crate::fit::{Method, fit};
    use crate::random::Random;
    use crate::surface::SurfaceType;

    /// A square step of side 1 with a round of the given radius along its edge, `density` points on the unit of
    /// area, at random.
    fn step(radius: f64, density: f64) -> Vec<Point> {
        let mut random = Random::new(5, 0);
        let arc = std::f64::consts::FRAC_PI_2;
        let flat = (density * (1.0 - radius)) as usize;
        let round = (density * radius * arc) as usize;
        let mut points = Vec::new();
        for _ in 0..flat {
            let (along, off) = (random.unit(), radius + (1.0 - radius) * random.unit());
            points.push(Point::new(off, along, 0.0));
            let (along, off) = (random.unit(), radius + (1.0 - radius) * random.unit());
            points.push(Point::new(0.0, along, off));
        }
        for _ in 0..round {
            let (sin, cos) = (arc * random.unit()).sin_cos();
            points.push(Point::new(
                radius - radius * cos,
                random.unit(),
                radius - radius * sin,
            ));
        }
        points
    }

    #[test]
    fn a_round_narrower_than_the_spacing_is_found_among_points_at_random() {
        // Spacings of about 0.47 / 55 = 0.0085; 26 points on the round.
        let cloud = Cloud::new(step(0.0055, 3000.0));
        for method in Method::ALL {
            let found = fit(&cloud, method, &Parameters::default(), 1, &mut ()).unwrap();
            let primitives = &found.segmentation.primitives;
            let kinds: Vec<_> = primitives.iter().filter_map(|it| it.kind).collect();
            use SurfaceType::{Cylinder, Plane};
            assert_eq!(kinds, [Plane, Plane, Cylinder], "{method:?}");
            assert!(primitives[2].points.len() >= 22, "{method:?}");
        }
    }

    #[test]
    fn a_smooth_surface_that_is_none_has_no_thin_faces() {
        let mut random = Random::new(3, 0);
        let wave = |x: f64, y: f64| 0.1 * (3.0 * x).sin() * (2.0 * y + x * x).cos();
        let points = (0..3000).map(|_| {
            let (x, y) = (random.unit(), random.unit());
            Point::new(x, y, wave(x, y))
        });
        let cloud = Cloud::new(points.collect());
        let mut search = Search::new(&cloud, &Parameters::default(), 1);
        scattered(&mut search, &mut ()).unwrap();
        assert_eq!(search.accepted(), []);
    }
}
