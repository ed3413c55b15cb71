//! Patches: a primitive of the benchmark is one connected piece of a surface, so coplanar faces that
//! do not touch are separate.
//!
//! The points of one surface are connected by the Gabriel graph (Gabriel and Sokal 1969): two of them
//! are linked where the ball over the segment between them holds no third. It connects whatever any
//! graph of the same reach does, sparse and uneven sampling included, and never steps over a row of
//! points. Rows of points are what faces end with, so an edge is a fence: its points, which have a
//! second label, link only towards the inner side of their face and along the edge. Faces of one
//! surface on both sides of a narrow groove stay apart, and so do a face and another that lies in the
//! middle of it, as where two bodies touch. Points of three or more labels only attach to what the
//! others have connected.

use super::super::Candidate;
use super::super::search::Search;
use super::label::Labels;
use super::links::{FARTHEST, FOURTH, LINKS, Longest, REACH};
use crate::cloud::Vector;
use crate::cloud::neighbours::{Neighbour, is_gabriel_link};
use crate::disjoint::DisjointSets;
use crate::surface::Surface;

/// One connected piece of a surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Patch {
    /// What it is a piece of.
    pub surface: Surface,
    /// The points on it, ascending.
    pub points: Vec<u32>,
}

/// The patches of every surface that have at least so many points. Where noise scatters a surface,
/// nearly all of its pieces are single points.
pub fn patches(
    search: &Search<'_>,
    candidates: &[Candidate],
    labels: &Labels,
    smallest: usize,
) -> Vec<Patch> {
    let longest = Longest::of(search, labels);
    let mut patches = Vec::new();
    let mut place = vec![u32::MAX; search.cloud.len()];
    for (surface, candidate) in (0u32..).zip(candidates) {
        let points = &labels.points[surface as usize];
        for (position, &index) in (0u32..).zip(points) {
            place[index as usize] = position;
        }
        let face = Face {
            search,
            longest,
            candidates,
            labels,
            surface,
            points,
            place: &place,
        };
        let pieces = face.connected().into_iter();
        for points in pieces.filter(|points| points.len() >= smallest) {
            let own = points.iter().filter(|&&i| labels.of(i).len() == 1).count();
            let supported = points
                .iter()
                .filter(|i| candidate.support.binary_search(i).is_ok())
                .count();
            if own > 0 || 2 * supported > points.len() {
                let surface = candidate.surface;
                patches.push(Patch { surface, points });
            }
        }
        for &index in points {
            place[index as usize] = u32::MAX;
        }
    }
    patches
}

/// The points of one surface.
struct Face<'a> {
    search: &'a Search<'a>,
    /// The longest of its links.
    longest: Longest,
    candidates: &'a [Candidate],
    labels: &'a Labels,
    /// Which of the candidates.
    surface: u32,
    /// Points on it, ascending.
    points: &'a [u32],
    /// Position in `points` of every point of the cloud, `u32::MAX` for those not on it.
    place: &'a [u32],
}

/// What part a point takes in connecting its face.
#[derive(Debug, Clone, Copy)]
enum Role {
    /// Links every way.
    Inner,
    /// Links inward only.
    Edge(Vector),
    /// Links nowhere.
    Corner,
}

impl Face<'_> {
    /// Connected components of the points.
    fn connected(&self) -> Vec<Vec<u32>> {
        let roles: Vec<Role> = self.points.iter().map(|&index| self.role(index)).collect();
        let mut sets = DisjointSets::new(self.points.len());
        let mut near = Vec::with_capacity(LINKS + 1);
        let farthest = FARTHEST * self.search.scale.spacing;
        let mut own = vec![0.0; self.points.len()];
        let mut long: Vec<(u32, u32, f64)> = Vec::new();
        let mut longest: Vec<f64> = Vec::with_capacity(self.points.len());
        for (position, &index) in (0u32..).zip(self.points) {
            if matches!(roles[position as usize], Role::Corner) {
                continue;
            }
            let point = self.search.point(index);
            self.near(index, farthest, &mut near);
            let fourth = near.get(FOURTH - 1).or(near.last());
            own[position as usize] = fourth.map_or(0.0, |n| n.distance_squared.sqrt());
            let mut last = None;
            for (rank, neighbour) in near.iter().enumerate() {
                let other = self.place[neighbour.index as usize];
                let end = self.search.point(neighbour.index);
                let nearer = near[..rank].iter().map(|n| self.search.point(n.index));
                if self.links(&roles, position, other) && is_gabriel_link(point, end, nearer) {
                    let length = neighbour.distance_squared.sqrt();
                    last = Some(length);
                    if self.longest.is_usual(length) {
                        sets.join(position as usize, other as usize);
                    } else {
                        long.push((position, other, length));
                    }
                }
            }
            // The nearest come first.
            longest.extend(last);
        }
        let allowed = self.longest.on_face(&mut longest);
        for (from, to, length) in long {
            // Both ends must be as sparse: a pad of few points beside a large face is another.
            let sparser = own[from as usize].min(own[to as usize]);
            if length <= allowed.max(self.longest.steps * sparser) {
                sets.join(from as usize, to as usize);
            }
        }
        self.attach(&roles, &mut sets, &mut near);
        sets.groups(self.points.iter().copied())
    }

    /// The nearest points of the face, nearest first, within a radius.
    fn near(&self, index: u32, radius: f64, near: &mut Vec<Neighbour>) {
        let is_on = |i: u32| self.place[i as usize] != u32::MAX;
        let point = self.search.point(index);
        let around = self.search.graph.of(index);
        // Well inside the face, where most points are, the nearest of all points are the nearest.
        if around.len() >= LINKS && around[..LINKS].iter().all(|&i| is_on(i)) {
            near.clear();
            near.extend(around[..LINKS].iter().map(|&index| Neighbour {
                index,
                distance_squared: (self.search.point(index) - point).norm_squared(),
            }));
            return;
        }
        let is_other = |i: u32| i != index && is_on(i);
        self.search
            .tree
            .nearest(point, LINKS, radius, is_other, near);
    }

    /// Whether both ends of a link allow it.
    fn links(&self, roles: &[Role], from: u32, to: u32) -> bool {
        let [first, second] = [from, to].map(|position| roles[position as usize]);
        let [start, end] = [from, to].map(|p| self.points[p as usize]);
        let step = self.search.point(end) - self.search.point(start);
        let allows = |role: Role, step: &Vector| match role {
            Role::Inner => true,
            Role::Edge(inward) => step.dot(&inward) >= -SIDEWAYS * step.norm(),
            Role::Corner => false,
        };
        // Along one edge the face may lie on this side here and on that side there.
        let same_side = match (first, second) {
            (Role::Edge(a), Role::Edge(b)) => {
                self.labels.of(start) != self.labels.of(end) || a.dot(&b) > 0.0
            }
            _ => true,
        };
        same_side && allows(first, &step) && allows(second, &-step)
    }

    /// Corners go to the patch of the nearest point that is none.
    fn attach(&self, roles: &[Role], sets: &mut DisjointSets, near: &mut Vec<Neighbour>) {
        for (position, &index) in (0u32..).zip(self.points) {
            if matches!(roles[position as usize], Role::Corner) {
                self.near(index, REACH * self.search.scale.spacing, near);
                let mut places = near.iter().map(|n| self.place[n.index as usize]);
                let nearest = places.find(|&p| !matches!(roles[p as usize], Role::Corner));
                if let Some(nearest) = nearest {
                    sets.join(position as usize, nearest as usize);
                }
            }
        }
    }

    /// The role of a point by its labels: within the face, on an edge or at a corner.
    fn role(&self, index: u32) -> Role {
        let other = match *self.labels.of(index) {
            [a, b] => a + b - self.surface,
            [_] => return Role::Inner,
            _ => return Role::Corner,
        };
        self.at_edge(index, other)
    }

    /// The role of a point on the edge to another surface. Into its face leads the direction in the
    /// surface across the edge, which runs along the cross product of the two normals or, where the
    /// surfaces touch tangentially, along the points of the edge; neighbours that are not on the other
    /// surface tell which side. Where they tell of both sides or none, the edge is only a fence.
    fn at_edge(&self, index: u32, other: u32) -> Role {
        let point = self.search.point(index);
        let normal_of = |surface: u32| self.candidates[surface as usize].surface.normal(point);
        let normal = normal_of(self.surface);
        let crossing = normal.cross(&normal_of(other));
        let edge = if crossing.norm() > CROSSING {
            Some(crossing)
        } else {
            self.run_of_edge(index)
        };
        let across = edge.and_then(|edge| normal.cross(&edge).try_normalize(f64::MIN_POSITIVE));
        let Some(across) = across else {
            return Role::Inner;
        };
        // The other bank of a narrow groove is off the other surface too, but an edge itself.
        let (mut inside, mut off) = (0.0, 0.0);
        for &neighbour in self.search.graph.of(index) {
            let labels = self.labels.of(neighbour);
            if self.place[neighbour as usize] != u32::MAX && !labels.contains(&other) {
                let step = self.search.point(neighbour) - point;
                let side = step.dot(&across).signum();
                off += side;
                inside += if labels.len() == 1 { side } else { 0.0 };
            }
        }
        let sides = if inside == 0.0 { off } else { inside };
        if sides == 0.0 {
            Role::Corner
        } else {
            Role::Edge(across * f64::signum(sides))
        }
    }

    /// The direction in which a tangential edge runs, where the surfaces themselves do not tell:
    /// along the nearest points with the same two labels.
    fn run_of_edge(&self, index: u32) -> Option<Vector> {
        let point = self.search.point(index);
        let labels = self.labels.of(index);
        let near = self.search.graph.of(index).iter();
        let along = near
            .filter(|&&neighbour| self.labels.of(neighbour) == labels)
            .take(4)
            .map(|&neighbour| self.search.point(neighbour) - point);
        along.reduce(|sum, step| {
            if sum.dot(&step) < 0.0 {
                sum - step
            } else {
                sum + step
            }
        })
    }
}

/// How far outward, as a cosine, a link may still lead: along the edge, with room for its bend.
const SIDEWAYS: f64 = 0.25;

/// Sine of the angle between two surfaces below which they touch tangentially.
const CROSSING: f64 = 0.05;
