//! Votes and how a family's ladder turns them into candidate surfaces.
//!
//! A vote is the local solution of one small neighbourhood: a surface in canonical parameters, the
//! point where Γ of all its points meet (a randomised Hough transform, Xu, Oja and Kultanen, 1990).
//! It lights one cell where a single point would light a hypersurface of them, so accumulators stay
//! sparse and a peak of a few votes already stands out.

use std::rc::Rc;

use super::accumulator::{Accumulator, Ballot};
use super::directions::DirectionSpace;
use super::family::{Region, Rung, Settled, ladder, surface};
use super::grid::Grid;
use super::recorder::{Recorder, View};
use super::space::Space;
use crate::cloud::{Point, Vector};
use crate::surface::{Surface, SurfaceType};

/// One local solution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vote {
    /// The surface voted for.
    pub surface: Surface,
    /// Index of the point in the middle of the neighbourhood.
    pub point: u32,
}

/// A peak at the top of a ladder.
#[derive(Debug, Clone, PartialEq)]
pub struct Summit {
    /// Consensus of its voters.
    pub surface: Surface,
    /// Positions of its voters among the votes, ascending.
    pub voters: Vec<u32>,
}

/// The spaces of all families over one cloud.
#[derive(Debug, Clone)]
pub struct Spaces {
    region: Region,
    directions: Rc<DirectionSpace>,
}

impl Spaces {
    /// The spaces over a region. Allocates the direction space, O(1/angle_step).
    pub fn new(region: Region) -> Self {
        let directions = Rc::new(DirectionSpace::new(region.angle_step));
        Self { region, directions }
    }

    /// The same with other cells of lengths; the directions are shared.
    pub fn with_length_step(&self, length_step: f64) -> Self {
        Self {
            region: Region {
                length_step,
                ..self.region
            },
            directions: Rc::clone(&self.directions),
        }
    }

    /// Those of surfaces that these have no cells for.
    pub fn far(&self) -> Self {
        Self {
            region: Region {
                is_far: true,
                ..self.region
            },
            directions: Rc::clone(&self.directions),
        }
    }

    /// The region they discretise.
    pub fn region(&self) -> &Region {
        &self.region
    }

    /// The direction space.
    pub fn directions(&self) -> &DirectionSpace {
        &self.directions
    }

    /// All summits of a family: peaks whose persistence is at least `share` of the highest on
    /// every rung, with at least `least` voters. Most voters first. `points` are those of the cloud,
    /// which the votes point into. O(v log v) per rung.
    pub fn climb(
        &self,
        kind: SurfaceType,
        votes: &[Vote],
        points: &[Point],
        share: f64,
        least: usize,
        recorder: &mut Recorder<'_>,
    ) -> Vec<Summit> {
        let mut climb = Climb {
            spaces: self,
            kind,
            votes,
            points,
            share,
            least: least.max(1),
            recorder,
            summits: Vec::new(),
        };
        let all = (0_u32..)
            .zip(votes)
            .filter(|(_, vote)| vote.surface.kind() == kind && self.region.concerns(&vote.surface))
            .map(|(voter, _)| voter)
            .collect();
        climb.rung(ladder(kind), all, &Settled::default());
        let mut summits = climb.summits;
        summits.sort_by(|a, b| {
            b.voters
                .len()
                .cmp(&a.voters.len())
                .then(a.voters.cmp(&b.voters))
        });
        summits
    }
}

/// A voter and its coordinates on a rung.
type Placed = (u32, [f64; 3]);

struct Climb<'a, 'o> {
    spaces: &'a Spaces,
    kind: SurfaceType,
    votes: &'a [Vote],
    points: &'a [Point],
    share: f64,
    least: usize,
    recorder: &'a mut Recorder<'o>,
    summits: Vec<Summit>,
}

impl Climb<'_, '_> {
    fn rung(&mut self, rungs: &[Rung], voters: Vec<u32>, settled: &Settled) {
        if voters.len() < self.least {
            return;
        }
        let Some((&rung, rest)) = rungs.split_first() else {
            if let Some(surface) = surface(self.kind, settled) {
                self.summits.push(Summit { surface, voters });
            }
            return;
        };
        let region = self.spaces.region;
        for share in self.shares(rung, voters, settled) {
            let (voters, at): (Vec<u32>, Vec<[f64; 3]>) = share.into_iter().unzip();
            let settled = region.settle(rung, consensus(rung, at), settled);
            self.rung(rest, voters, &settled);
        }
    }

    /// The voters of each significant peak of a rung with their coordinates on it. Those without any,
    /// or outside the region, drop out.
    fn shares(&mut self, rung: Rung, voters: Vec<u32>, settled: &Settled) -> Vec<Vec<Placed>> {
        let region = self.spaces.region;
        let placed: Vec<Placed> = voters
            .iter()
            .filter_map(|&voter| {
                let vote = &self.votes[voter as usize];
                let foot = self.points.get(vote.point as usize)?;
                let at = region.coordinates(rung, &vote.surface, foot, settled)?;
                Some((voter, at))
            })
            .collect();
        drop(voters);
        if rung == Rung::Direction {
            let cell = |at: &[f64; 3]| self.spaces.directions.cell(&Vector::from(*at));
            self.split(&*self.spaces.directions, rung, settled, &placed, cell)
        } else {
            let grid: Grid = region.grid(rung);
            let cell = |at: &[f64; 3]| grid.cell(at);
            self.split(&grid, rung, settled, &placed, cell)
        }
    }

    /// Counts the votes on a rung and gives each significant peak its voters.
    fn split<S: Space>(
        &mut self,
        space: &S,
        rung: Rung,
        settled: &Settled,
        placed: &[Placed],
        cell: impl Fn(&[f64; 3]) -> Option<usize>,
    ) -> Vec<Vec<Placed>> {
        let ballots = (0_u32..)
            .zip(placed)
            .filter_map(|(position, (_, at))| {
                Some(Ballot {
                    cell: cell(at)?,
                    voter: position,
                    weight: 1.0,
                })
            })
            .collect();
        let accumulator = Accumulator::count(ballots);
        let diagram = accumulator.maxima(space);
        let view = View {
            kind: self.kind,
            rung,
            settled,
            accumulator: &accumulator,
            diagram: &diagram,
        };
        self.recorder.accumulator(&view, self.share, space);
        diagram
            .significant(self.share)
            .map(|peak| {
                accumulator
                    .voters_of(space, &diagram, peak)
                    .into_iter()
                    .map(|position| placed[position as usize])
                    .collect()
            })
            .collect()
    }
}

/// The median of each coordinate: half the voters may be wrong without moving it far. Directions
/// are first turned to one side.
fn consensus(rung: Rung, mut at: Vec<[f64; 3]>) -> [f64; 3] {
    if rung == Rung::Direction
        && let Some(&first) = at.first()
    {
        for direction in &mut at {
            if Vector::from(*direction).dot(&Vector::from(first)) < 0.0 {
                *direction = direction.map(|component| -component);
            }
        }
    }
    let mut values = Vec::with_capacity(at.len());
    std::array::from_fn(|axis| {
        values.clear();
        values.extend(at.iter().map(|coordinates| coordinates[axis]));
        let middle = values.len() / 2;
        if values.is_empty() {
            0.0
        } else {
            *values.select_nth_unstable_by(middle, f64::total_cmp).1
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Bounds;
    use crate::surface::{Cone, Cylinder, Plane, Sphere, Torus};

    fn spaces() -> Spaces {
        Spaces::new(Region {
            bounds: Bounds {
                min: Point::new(-2.0, -2.0, -2.0),
                max: Point::new(2.0, 2.0, 2.0),
            },
            length_step: 0.05,
            angle_step: 0.03,
            is_far: false,
        })
    }

    /// A number in −1..1 that looks random.
    fn noise(i: u32) -> f64 {
        let hash = u64::from(i + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        (hash >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn vote(surface: Surface, point: u32) -> Vote {
        Vote { surface, point }
    }

    /// Climbs with points on the surfaces they vote for.
    fn climb(kind: SurfaceType, votes: &[Vote]) -> Vec<Summit> {
        let foot = |vote: &Vote| {
            let [x, y, z] = [0, 1, 2].map(|axis| noise(7 * vote.point + axis));
            vote.surface.foot(&Point::new(x, y, z))
        };
        let points: Vec<Point> = votes.iter().map(foot).collect();
        spaces().climb(kind, votes, &points, 0.1, 3, &mut Recorder::new(&mut ()))
    }

    #[test]
    fn equal_votes_of_every_family_give_their_parameters_exactly() {
        let p = Point::new(0.3, -0.4, 0.5);
        let d = Vector::new(0.2, -1.0, 0.6);
        for surface in [
            Surface::Plane(Plane::new(p, d)),
            Surface::Cylinder(Cylinder::new(p, d, 0.7)),
            Surface::Cone(Cone::new(p, d, 0.4)),
            Surface::Sphere(Sphere::new(p, 0.7)),
            Surface::Torus(Torus::new(p, d, 0.9, 0.2)),
        ] {
            let votes: Vec<Vote> = (0..20).map(|i| vote(surface, i)).collect();
            let summits = climb(surface.kind(), &votes);
            assert_eq!(summits.len(), 1);
            assert_eq!(summits[0].voters.len(), 20);
            for i in 0..20 {
                let probe = Point::new(noise(i), noise(i + 50), noise(i + 90));
                let difference = summits[0].surface.distance(&probe) - surface.distance(&probe);
                assert!(difference.abs() < 1e-9);
            }
        }
    }

    #[test]
    fn parallel_planes_are_told_apart_by_their_offsets() {
        let votes: Vec<Vote> = (0..60)
            .map(|i| {
                let height = f64::from(i % 3) * 0.5;
                let plane = Plane::new(Point::new(0.0, 0.0, height), Vector::new(0.0, 0.1, 1.0));
                vote(Surface::Plane(plane), i)
            })
            .collect();
        let summits = climb(SurfaceType::Plane, &votes);
        assert_eq!(summits.len(), 3);
        assert!(summits.iter().all(|summit| summit.voters.len() == 20));
    }

    #[test]
    fn a_recurring_cylinder_stands_out_among_scattered_votes() {
        let truth = Cylinder::new(Point::new(0.5, 0.5, 0.0), Vector::z(), 0.3);
        let votes: Vec<Vote> = (0..300)
            .map(|i| {
                let wrong = Cylinder::new(
                    Point::new(noise(3 * i), noise(3 * i + 1), 0.0),
                    Vector::new(noise(5 * i), noise(5 * i + 1), noise(5 * i + 2)),
                    0.5 + 0.4 * noise(11 * i),
                );
                let surface = if i % 10 == 0 { truth } else { wrong };
                vote(Surface::Cylinder(surface), i)
            })
            .collect();
        let summits = climb(SurfaceType::Cylinder, &votes);
        let Surface::Cylinder(found) = summits[0].surface else {
            unreachable!()
        };
        assert!((found.radius - truth.radius).abs() < 1e-6);
        assert!((found.centre - truth.centre).norm() < 1e-6);
    }

    #[test]
    fn votes_of_other_families_do_not_count() {
        let sphere = Surface::Sphere(Sphere::new(Point::origin(), 1.0));
        let votes: Vec<Vote> = (0..20).map(|i| vote(sphere, i)).collect();
        assert!(climb(SurfaceType::Plane, &votes).is_empty());
    }
}
