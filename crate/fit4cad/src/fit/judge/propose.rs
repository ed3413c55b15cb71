//! Surfaces that may be in a noisy cloud: fitted to neighbourhoods wide enough for their shape to stand out
//! of the noise, and grown.

use super::family::{Measures, Sample};
use super::height::residual;
use crate::cloud::Point;
use crate::cloud::neighbours::{KdTree, Neighbourhoods};
use crate::fit::progress::Cancelled;
use crate::random::Random;
use crate::surface::Surface;

/// Points of the neighbourhoods that are tried, from the smallest on which a height function can be
/// wrong to what is wide even at 1 % of noise.
const SIZES: [usize; 8] = [11, 16, 24, 36, 54, 80, 115, 160];
/// By how many standard deviations of itself the residual of a neighbourhood may be larger than the noise.
const CHANCE: f64 = 2.2;
/// Standard deviations within which a growing surface takes points.
const BAND: f64 = 2.5;
/// Neighbours along which it grows.
const STEPS: usize = 10;
/// By what factor a patch grows before its surface is fitted again.
const GROWTH: f64 = 1.6;
/// And before families are compared again.
const COMPARED: f64 = 2.5;
/// Most fits of one growth.
const ROUNDS: usize = 24;
/// Points that are fitted to while growing, and that families are compared on.
const FITTED: [usize; 2] = [100, 160];
/// Least points of a proposal.
const FEWEST: usize = 8;
/// Neighbours of a point well inside a patch that are in it too.
const INSIDE: usize = 8;

/// Covered ones among these, from which on a point is amidst them.
const AMIDST: usize = 7;

/// A surface and the connected points near it.
#[derive(Debug, Clone)]
pub struct Proposal {
    /// The surface.
    pub surface: Surface,
    /// Points near it, in the order in which they were reached.
    pub support: Vec<u32>,
}

/// What proposals are made from.
pub struct Proposer<'a> {
    points: &'a [Point],
    tree: &'a KdTree,
    graph: &'a Neighbourhoods,
    /// Noise and extent of the cloud.
    pub measures: Measures,
    /// In what flood each point was last seen.
    seen: Vec<u32>,
    flood: u32,
}

impl<'a> Proposer<'a> {
    /// Over a cloud with its tree and neighbours.
    pub fn new(
        points: &'a [Point],
        tree: &'a KdTree,
        graph: &'a Neighbourhoods,
        measures: Measures,
    ) -> Self {
        Self {
            points,
            tree,
            graph,
            measures,
            seen: vec![0; points.len()],
            flood: 0,
        }
    }

    /// Proposals from up to `most` seeds among the points that may be used, until they cover these.
    /// `tell` hears what share of the seeds is done.
    ///
    /// # Errors
    /// If `tell` says to stop.
    pub fn propose(
        &mut self,
        usable: &[bool],
        most: usize,
        random: &mut Random,
        tell: &mut dyn FnMut(f64) -> Result<(), Cancelled>,
    ) -> Result<Vec<Proposal>, Cancelled> {
        let all = (0u32..).take(self.points.len());
        let mut order: Vec<u32> = all.filter(|&i| usable[i as usize]).collect();
        random.shuffle(&mut order);
        let mut covered = vec![false; self.points.len()];
        let mut proposals = Vec::new();
        let mut tried = 0;
        for seed in order {
            if covered[seed as usize] || self.is_amidst(seed, &covered) {
                continue;
            }
            if tried == most {
                break;
            }
            tell(tried as f64 / most as f64)?;
            tried += 1;
            let patch = self.neighbourhood(seed, usable);
            if let Some(proposal) = self.grow(&patch) {
                for &index in &proposal.support {
                    covered[index as usize] = true;
                }
                proposals.push(proposal);
            }
        }
        Ok(proposals)
    }

    /// Whether nearly all around a point is covered: then it is far off a surface that is proposed already. One in eighty
    /// is, and each would have that surface grow again.
    fn is_amidst(&self, seed: u32, covered: &[bool]) -> bool {
        let near = self.graph.of(seed).iter().take(INSIDE);
        near.filter(|&&other| covered[other as usize]).count() >= AMIDST
    }

    /// The widest neighbourhood of a point, among those that may be used, that a smooth sheet explains;
    /// empty where none does.
    fn neighbourhood(&self, seed: u32, usable: &[bool]) -> Vec<u32> {
        let mut found = Vec::new();
        let most = SIZES[SIZES.len() - 1];
        let middle = &self.points[seed as usize];
        let keep = |i: u32| usable[i as usize];
        self.tree
            .nearest(middle, most, f64::INFINITY, keep, &mut found);
        let near = found.iter().map(|it| self.points[it.index as usize]);
        let points: Vec<Point> = near.collect();
        let mut widest = 0;
        for size in SIZES {
            let Some(patch) = points.get(..size) else {
                break;
            };
            // The residual of ν degrees of freedom is known to one part in the root of 2ν.
            let spread = 1.0 / (2.0 * (size - 6) as f64).sqrt();
            let limit = self.measures.deviation.noise * (1.0 + CHANCE * spread);
            if residual(patch).is_some_and(|it| it <= limit) {
                widest = size;
            } else if widest > 0 {
                break;
            }
        }
        found.truncate(widest);
        found.into_iter().map(|it| it.index).collect()
    }

    /// Fits the family that describes a patch best, and grows it as far as it goes.
    fn grow(&mut self, patch: &[u32]) -> Option<Proposal> {
        let [fitted, compared_on] = FITTED;
        let first = Sample::of(self.points, patch, compared_on);
        let mut surface = self.measures.best(None, &first)?;
        let mut support = patch.to_vec();
        let mut compared = patch.len();
        for _ in 0..ROUNDS {
            let limit = (GROWTH * support.len() as f64) as usize;
            let next = self.reached(&surface, &support, limit);
            if next.len() < FEWEST {
                return None;
            }
            let settled = next.len() <= support.len() + support.len() / 50;
            support = next;
            if settled || support.len() as f64 > COMPARED * compared as f64 {
                compared = support.len();
                let inner = self.inner(&support);
                let is_enough = is_enough(inner.len(), support.len());
                let told_by = if is_enough { &inner } else { &support };
                let sample = Sample::of(self.points, told_by, compared_on);
                let better = self.measures.best(Some(surface), &sample)?;
                let same = better.kind() == surface.kind();
                surface = better;
                if settled && same {
                    break;
                }
            } else {
                let sample = Sample::of(self.points, &support, fitted);
                surface = self.measures.refit(&surface, &sample.points)?;
            }
        }
        let support = self.reached(&surface, &support, usize::MAX);
        (support.len() >= FEWEST).then_some(Proposal { surface, support })
    }

    /// The points of the last flood that are well inside, where no points of the next face pass for its
    /// own.
    fn inner(&self, support: &[u32]) -> Vec<u32> {
        let is_inside = |&&index: &&u32| {
            let mut near = self.graph.of(index).iter().take(INSIDE);
            near.all(|&other| self.seen[other as usize] == self.flood + NEAR)
        };
        support.iter().filter(is_inside).copied().collect()
    }

    /// The points near a surface reached from some points along the graph, up to a limit.
    fn reached(&mut self, surface: &Surface, seeds: &[u32], limit: usize) -> Vec<u32> {
        let band = BAND * self.measures.deviation.noise;
        self.flood += NEAR + 1;
        let mut reached = Vec::new();
        for &seed in seeds {
            self.visit(seed, surface, band, &mut reached);
        }
        let mut next = 0;
        while next < reached.len() && reached.len() < limit {
            for &other in self.graph.of(reached[next]).iter().take(STEPS) {
                self.visit(other, surface, band, &mut reached);
            }
            next += 1;
        }
        reached
    }

    /// Adds a point that was not seen yet where it is near.
    fn visit(&mut self, index: u32, surface: &Surface, band: f64, reached: &mut Vec<u32>) {
        let seen = &mut self.seen[index as usize];
        if *seen < self.flood {
            *seen = self.flood;
            if surface.distance(&self.points[index as usize]) <= band {
                *seen += NEAR;
                reached.push(index);
            }
        }
    }
}

/// What marks a point seen in a flood as near, besides the number of the flood.
const NEAR: u32 = 1;

/// Whether the inner points of a group are so many that the group can be told from them.
pub fn is_enough(inner: usize, all: usize) -> bool {
    inner >= 20.max(all / 4)
}
