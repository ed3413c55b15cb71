//! The state of a search for surfaces: the cloud with its neighbours and scale, what has been
//! accepted and what that explains, and the three steps every method takes (grow, compare, accept).

mod marks;
mod outline;

pub use outline::{EXACT, widest_gap};

use std::f64::consts::FRAC_PI_2;

use super::least_squares::{self, Loss, degrees_of_freedom};
use super::thin::curve::is_curve;
use super::{Candidate, Parameters, Scale};
use crate::cloud::neighbours::{KdTree, Neighbour, Neighbourhoods};
use crate::cloud::{Cloud, Point};
use crate::random::Random;
use crate::surface::{Surface, SurfaceType};
use marks::Marks;

/// Points a surface is refitted to while it grows; more would not make it more exact.
const FIT_SAMPLE: usize = 800;

/// A cloud being searched for surfaces.
pub struct Search<'a> {
    /// The cloud.
    pub cloud: &'a Cloud,
    /// Tree over its points.
    pub tree: KdTree,
    /// Nearest neighbours of each point.
    pub graph: Neighbourhoods,
    /// Its scale.
    pub scale: Scale,
    /// What the user asked for.
    pub parameters: Parameters,
    /// The only source of chance: the same seed makes the same choices.
    pub random: Random,
    accepted: Vec<Candidate>,
    /// The accepted surface that held each point last.
    holder: Vec<u32>,
    marks: Marks,
}

impl<'a> Search<'a> {
    /// Prepares a cloud. O(n log n) time, about 130 bytes a point.
    pub fn new(cloud: &'a Cloud, parameters: &Parameters, seed: u64) -> Self {
        Self::over(cloud, KdTree::new(cloud.points()), parameters, seed)
    }

    /// As [`Search::new`], with the tree of the cloud's points.
    pub fn over(cloud: &'a Cloud, tree: KdTree, parameters: &Parameters, seed: u64) -> Self {
        let count = Parameters::count(parameters.neighbours);
        let graph = Neighbourhoods::new(cloud.points(), &tree, count);
        let mut scale = Scale::measure(cloud, &tree, &graph, parameters.tolerance);
        if parameters.noise > 0.0 {
            scale = scale.told(parameters.noise, parameters.tolerance);
        }
        Self {
            tree,
            graph,
            scale,
            parameters: *parameters,
            random: Random::new(seed, 0),
            accepted: Vec::new(),
            holder: vec![u32::MAX; cloud.len()],
            marks: Marks::of(cloud.len()),
            cloud,
        }
    }

    /// A point by its index.
    pub fn point(&self, index: u32) -> &Point {
        &self.cloud.points()[index as usize]
    }

    /// The points of the given indices.
    pub fn points(&self, indices: &[u32]) -> Vec<Point> {
        indices.iter().map(|&index| *self.point(index)).collect()
    }

    /// The candidates accepted so far, in order.
    pub fn accepted(&self) -> &[Candidate] {
        &self.accepted
    }

    /// Whether an accepted surface holds a point.
    pub fn is_explained(&self, index: u32) -> bool {
        self.holder[index as usize] != u32::MAX
    }

    /// Whether an accepted surface of the family already passes through all these points.
    pub fn is_known(&self, kind: SurfaceType, seeds: &[u32]) -> bool {
        let through = |candidate: &Candidate| {
            candidate.surface.kind() == kind
                && seeds
                    .iter()
                    .all(|&i| candidate.surface.distance(self.point(i)) <= self.scale.tolerance)
        };
        let mut last = u32::MAX;
        seeds.iter().any(|&i| {
            let holder = self.holder[i as usize];
            let new = holder != u32::MAX && holder != last;
            last = holder;
            new && through(&self.accepted[holder as usize])
        })
    }

    /// The accepted surface that held a point last, if any.
    pub fn holder(&self, index: u32) -> Option<&Candidate> {
        self.accepted.get(self.holder[index as usize] as usize)
    }

    /// The accepted surfaces that hold some of the points or their neighbours, each once.
    pub fn surfaces_beside(&self, points: &[u32]) -> Vec<Surface> {
        let near = points
            .iter()
            .flat_map(|&i| self.graph.of(i).iter().take(8).copied());
        let mut holders: Vec<u32> = points
            .iter()
            .copied()
            .chain(near)
            .map(|i| self.holder[i as usize])
            .filter(|&holder| holder != u32::MAX)
            .collect();
        holders.sort_unstable();
        holders.dedup();
        holders
            .iter()
            .map(|&holder| self.accepted[holder as usize].surface)
            .collect()
    }

    /// The unexplained points in random order.
    pub fn shuffled_unexplained(&mut self) -> Vec<u32> {
        let all = (0u32..).take(self.cloud.len());
        let mut order: Vec<u32> = all.filter(|&index| !self.is_explained(index)).collect();
        self.random.shuffle(&mut order);
        order
    }

    /// The up to `count` unexplained points nearest to a point, itself first if unexplained.
    pub fn unexplained_near(&self, index: u32, count: usize) -> Vec<u32> {
        let mut found: Vec<Neighbour> = Vec::with_capacity(count + 1);
        let radius = self.scale.spacing * 1.6 * (count as f64).sqrt();
        let free = |i: u32| !self.is_explained(i);
        self.tree
            .nearest(self.point(index), count, radius, free, &mut found);
        found.into_iter().map(|neighbour| neighbour.index).collect()
    }

    /// Polishes a surface and grows its patch from some points on it: alternately fits the surface
    /// to the patch and adds the graph neighbours that lie on it, at most quadrupling the patch at a
    /// time, since the surface is known only as far as the points it was fitted to reach.
    ///
    /// `None` where fewer points hold on to it than degrees of freedom plus one, the surface
    /// degenerates (see [`Search::is_plausible`]), or so many exact points are on one line or circle
    /// that the patch is but a row of them. O(points of the patch).
    pub fn grow(&mut self, start: &Surface, seeds: &[u32]) -> Option<Candidate> {
        let needed = degrees_of_freedom(start.kind()) + 1;
        let mut surface = *start;
        let mut support = self.flood(&surface, seeds, 4 * seeds.len().max(needed));
        // Within noise a true band may be as narrow.
        let mut may_be_row = self.scale.is_clean();
        for _ in 0..GROWTH_ROUNDS {
            if support.len() < needed {
                return None;
            }
            let fitted = least_squares::fit(&surface, &self.sample(&support), Loss::Squares)?;
            if !self.is_plausible(&fitted.surface) {
                return None;
            }
            surface = fitted.surface;
            let limit = 4 * support.len();
            let next = self.flood(&surface, &support, limit);
            let settled = next.len() <= support.len() + support.len() / 200;
            support = next;
            // Every surface through a long row would grow along all of it, from every point of it.
            if may_be_row && support.len() >= ROW {
                if is_curve(&self.points(&support), 2.0 * self.scale.tolerance) {
                    return None;
                }
                may_be_row = false;
            }
            if settled {
                break;
            }
        }
        if support.len() < needed {
            return None;
        }
        support.sort_unstable();
        // There was room for a patch four times as large; candidates wait for each other in numbers.
        support.shrink_to_fit();
        let error = self.error(&surface, &support);
        Some(Candidate {
            surface,
            support,
            error,
        })
    }

    /// Root mean square distance of points to a surface.
    pub fn error(&self, surface: &Surface, support: &[u32]) -> f64 {
        let squares: f64 = support
            .iter()
            .map(|&i| surface.distance(self.point(i)).powi(2))
            .sum();
        (squares / support.len().max(1) as f64).sqrt()
    }

    /// An even sample of the points of a patch.
    fn sample(&self, support: &[u32]) -> Vec<Point> {
        let stride = support.len().div_ceil(FIT_SAMPLE).max(1);
        support
            .iter()
            .step_by(stride)
            .map(|&i| *self.point(i))
            .collect()
    }

    /// The points on a surface reached from the seeds along the graph, up to a limit.
    fn flood(&mut self, surface: &Surface, seeds: &[u32], limit: usize) -> Vec<u32> {
        let tolerance = self.scale.tolerance;
        let points = self.cloud.points();
        self.marks.clear();
        let mut reached: Vec<u32> = Vec::with_capacity(limit.min(points.len()));
        for &seed in seeds {
            if self.marks.insert(seed) && surface.distance(&points[seed as usize]) <= tolerance {
                reached.push(seed);
            }
        }
        let mut next = 0;
        while next < reached.len() && reached.len() < limit {
            for &neighbour in self.graph.of(reached[next]) {
                if self.marks.insert(neighbour)
                    && surface.distance(&points[neighbour as usize]) <= tolerance
                {
                    reached.push(neighbour);
                }
            }
            next += 1;
        }
        reached
    }

    /// Whether a surface is one that CAD would call by its name: not a cylinder so large that it is
    /// a plane, not, where there is no noise, a torus that cuts its own axis.
    pub fn is_plausible(&self, surface: &Surface) -> bool {
        let largest = LARGEST * self.scale.diameter;
        let smallest = 4.0 * self.scale.tolerance;
        let (slimmest, fattest) = if self.scale.is_clean() {
            (SLIMMEST, FATTEST)
        } else {
            (10.0 * SLIMMEST, NOISY_FATTEST)
        };
        match surface {
            Surface::Plane(_) => true,
            Surface::Cylinder(s) => (smallest..largest).contains(&s.radius),
            Surface::Cone(s) => (slimmest..FRAC_PI_2 - FLATTEST).contains(&s.half_angle),
            Surface::Sphere(s) => (smallest..largest).contains(&s.radius),
            Surface::Torus(s) => {
                (smallest..largest).contains(&s.minor_radius)
                    && s.major_radius < largest
                    && s.major_radius > fattest * s.minor_radius
            }
        }
    }

    /// How many points of a candidate no accepted surface holds.
    pub fn own(&self, candidate: &Candidate) -> usize {
        candidate
            .support
            .iter()
            .filter(|&&i| !self.is_explained(i))
            .count()
    }

    /// What a candidate is worth: its points, those that nothing else explains counting three times.
    pub fn worth(&self, candidate: &Candidate) -> f64 {
        (candidate.support.len() + 2 * self.own(candidate)) as f64
    }

    /// The best of several candidates for the same place: the one worth most; of those that are
    /// worth nearly as much, the simplest, unless its root mean square error is clearly larger.
    ///
    /// The paper compares mean fitting errors alone. Here every candidate has grown as far as its
    /// surface reaches within the tolerance, so a wrong family shows in fewer points first.
    pub fn best(&self, mut candidates: Vec<Candidate>) -> Option<Candidate> {
        let rated = candidates.iter().map(|c| (self.worth(c), c));
        let place = self.best_of(&rated.collect::<Vec<_>>())?;
        Some(candidates.swap_remove(place))
    }

    /// As [`Search::best`], of candidates whose worth is given: the position of the best.
    pub fn best_of(&self, rated: &[(f64, &Candidate)]) -> Option<usize> {
        let most = rated.iter().map(|(worth, _)| *worth).fold(0.0, f64::max);
        let least_error = rated
            .iter()
            .filter(|(worth, _)| *worth >= NEARLY * most)
            .map(|(_, c)| c.error)
            .fold(f64::INFINITY, f64::min);
        let is_good = |c: &Candidate| {
            if self.scale.is_clean() {
                c.error <= 2.0 * least_error + 0.3 * self.scale.tolerance
            } else {
                // The error of n points is known to about one part in the root of 2n.
                c.error <= least_error * (1.0 + NOISE_SPREAD / (c.support.len() as f64).sqrt())
            }
        };
        rated
            .iter()
            .enumerate()
            .filter(|(_, (worth, c))| *worth >= NEARLY * most && is_good(c))
            .min_by(|(_, (worth, a)), (_, (other, b))| {
                self.rank(a.surface.kind())
                    .cmp(&self.rank(b.surface.kind()))
                    .then(other.total_cmp(worth))
            })
            .map(|(place, _)| place)
    }

    /// Order of simplicity: fewer degrees of freedom first. Within noise the order is that of how
    /// common the families are: any short band of a cylinder passes for one of a sphere.
    fn rank(&self, kind: SurfaceType) -> usize {
        if self.scale.is_clean() {
            degrees_of_freedom(kind)
        } else {
            kind as usize
        }
    }

    /// Keeps a candidate; its points are explained from now on.
    pub fn accept(&mut self, candidate: Candidate) {
        // Candidates are fewer than points, which u32 counts.
        let place = self.accepted.len() as u32;
        for &index in &candidate.support {
            self.holder[index as usize] = place;
        }
        self.accepted.push(candidate);
    }

    /// Takes back the accepted candidates that are not to be kept, by their positions. O(n).
    pub fn retain(&mut self, keep: impl Fn(usize, &Candidate) -> bool) {
        let accepted = std::mem::take(&mut self.accepted);
        self.holder.fill(u32::MAX);
        for (place, candidate) in accepted.into_iter().enumerate() {
            if keep(place, &candidate) {
                self.accept(candidate);
            }
        }
    }

    /// Ends the search with what was accepted.
    pub fn into_accepted(self) -> Vec<Candidate> {
        self.accepted
    }
}

const GROWTH_ROUNDS: usize = 24;
/// Largest radius, in diameters of the cloud: that of an arc of two degrees.
const LARGEST: f64 = 30.0;
/// Points of a patch at which it is to be more than one row of them.
const ROW: usize = 200;
/// Smallest half-angle of a cone without noise, in radians: drafts of moulded parts are a few
/// thousandths. A slimmer cone is a cylinder.
const SLIMMEST: f64 = 5e-4;
/// How far, in radians, the half-angle of a cone stays from a right one: a flatter cone is a plane. It
/// may have most of the points of a narrow strip of a plane and a row of the face beside it.
const FLATTEST: f64 = 8e-3;
/// Smallest major radius of a torus without noise, in minor ones, with room for errors. One that cuts its
/// own axis is a degenerate torus in CAD (ISO 10303-42): the ground truth calls such faces free-form, and
/// smooth free-form regions pass for them.
const FATTEST: f64 = 0.95;
/// And with noise, where a small piece of a proper torus may look like one that cuts its axis.
const NOISY_FATTEST: f64 = 0.1;
/// By how many parts in the root of the number of points a fitting error may be larger by chance.
const NOISE_SPREAD: f64 = 3.0;
/// Share of the most worth that counts as nearly as much.
const NEARLY: f64 = 0.97;

#[cfg(test)]
mod tests;
