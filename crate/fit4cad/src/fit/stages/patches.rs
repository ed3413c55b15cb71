//! Patches: a primitive of the benchmark is one connected piece of a surface, so coplanar faces that
//! do not touch are separate.
//!
//! Points of one surface are connected along the graph of nearest neighbours. Faces of one surface
//! that come close (two lands beside a narrow groove) would be joined by their edge points, which
//! have a second label, so a two-label point links only towards the inner side of its face, and
//! points of three or more labels only attach to what the others have connected.

use super::super::Candidate;
use super::super::search::Search;
use super::label::Labels;
use crate::cloud::Vector;

/// Neighbours along which points connect.
const LINKS: usize = 12;

/// The patches of every surface, each with its points, ascending.
pub fn patches<'c>(
    search: &Search<'_>,
    candidates: &'c [Candidate],
    labels: &Labels,
) -> Vec<(&'c Candidate, Vec<u32>)> {
    let mut patches = Vec::new();
    let mut place = vec![u32::MAX; search.cloud.len()];
    for (surface, candidate) in (0u32..).zip(candidates) {
        let points = &labels.points[surface as usize];
        for (position, &index) in (0u32..).zip(points) {
            place[index as usize] = position;
        }
        for patch in connected(search, candidates, labels, surface, points, &place) {
            let own = patch.iter().filter(|&&i| labels.of(i).len() == 1).count();
            let supported = patch
                .iter()
                .filter(|i| candidate.support.binary_search(i).is_ok())
                .count();
            if own > 0 || 2 * supported > patch.len() {
                patches.push((candidate, patch));
            }
        }
        for &index in points {
            place[index as usize] = u32::MAX;
        }
    }
    patches
}

/// Connected components of the points of one surface.
fn connected(
    search: &Search<'_>,
    candidates: &[Candidate],
    labels: &Labels,
    surface: u32,
    points: &[u32],
    place: &[u32],
) -> Vec<Vec<u32>> {
    let inward: Vec<Option<Vector>> = points
        .iter()
        .map(|&index| inward(search, candidates, labels, surface, index, place))
        .collect();
    let permits = |from: u32, to: u32, step: &Vector| -> bool {
        let inward = inward[place[from as usize] as usize];
        debug_assert_ne!(place[to as usize], u32::MAX);
        inward.is_none_or(|inward| step.dot(&inward) >= -SIDEWAYS * step.norm())
    };
    let mut sets = DisjointSets::new(points.len());
    for &index in points {
        if labels.of(index).len() > 2 {
            continue;
        }
        for &neighbour in search.graph.of(index).iter().take(LINKS) {
            if place[neighbour as usize] == u32::MAX || labels.of(neighbour).len() > 2 {
                continue;
            }
            let step = search.point(neighbour) - search.point(index);
            if permits(index, neighbour, &step) && permits(neighbour, index, &-step) {
                sets.join(place[index as usize], place[neighbour as usize]);
            }
        }
    }
    // Corners go to the patch of the nearest point that is none.
    for &index in points {
        if labels.of(index).len() > 2 {
            let nearest = search.graph.of(index).iter().find(|&&neighbour| {
                place[neighbour as usize] != u32::MAX && labels.of(neighbour).len() <= 2
            });
            if let Some(&nearest) = nearest {
                sets.join(place[index as usize], place[nearest as usize]);
            }
        }
    }
    let mut components: Vec<Vec<u32>> = Vec::new();
    let mut component = vec![usize::MAX; points.len()];
    for (position, &index) in (0u32..).zip(points) {
        let root = sets.root(position) as usize;
        if component[root] == usize::MAX {
            component[root] = components.len();
            components.push(Vec::new());
        }
        components[component[root]].push(index);
    }
    components
}

/// How far outward, as a cosine, a link may still lead: along the edge, with room for its bend.
const SIDEWAYS: f64 = 0.25;

/// The direction from a two-label point into its face: in the surface, across the edge, which runs
/// along the cross product of the two normals or, where the surfaces touch tangentially, along the
/// points of the edge; interior neighbours tell which side. `None` where every direction is as good.
fn inward(
    search: &Search<'_>,
    candidates: &[Candidate],
    labels: &Labels,
    surface: u32,
    index: u32,
    place: &[u32],
) -> Option<Vector> {
    let own = labels.of(index);
    if own.len() != 2 {
        return None;
    }
    let other = if own[0] == surface { own[1] } else { own[0] };
    let point = search.point(index);
    let normal = candidates[surface as usize].surface.normal(point);
    let crossing = normal.cross(&candidates[other as usize].surface.normal(point));
    let edge = if crossing.norm() > CROSSING {
        crossing
    } else {
        run_of_edge(search, labels, index)?
    };
    let across = normal.cross(&edge).try_normalize(f64::MIN_POSITIVE)?;
    let mut sides = 0.0;
    for &neighbour in search.graph.of(index) {
        if place[neighbour as usize] != u32::MAX && labels.of(neighbour).len() == 1 {
            let step = search.point(neighbour) - point;
            sides += step.dot(&across).signum();
        }
    }
    (sides != 0.0).then(|| across * f64::signum(sides))
}

/// Sine of the angle between two surfaces below which they touch tangentially.
const CROSSING: f64 = 0.05;

/// The direction in which a tangential edge runs, where the surfaces themselves do not tell: along
/// the nearest points with the same two labels.
fn run_of_edge(search: &Search<'_>, labels: &Labels, index: u32) -> Option<Vector> {
    let point = search.point(index);
    let along = search
        .graph
        .of(index)
        .iter()
        .filter(|&&neighbour| labels.of(neighbour) == labels.of(index))
        .take(4)
        .map(|&neighbour| search.point(neighbour) - point);
    along.reduce(|sum, step| {
        if sum.dot(&step) < 0.0 {
            sum - step
        } else {
            sum + step
        }
    })
}

/// Union-find with path halving; the smaller index is the root, so results do not depend on the
/// order of joining.
struct DisjointSets {
    parent: Vec<u32>,
}

impl DisjointSets {
    fn new(count: usize) -> Self {
        Self {
            parent: (0u32..).take(count).collect(),
        }
    }

    fn root(&mut self, mut place: u32) -> u32 {
        while self.parent[place as usize] != place {
            let above = self.parent[self.parent[place as usize] as usize];
            self.parent[place as usize] = above;
            place = above;
        }
        place
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        let (low, high) = (a.min(b), a.max(b));
        self.parent[high as usize] = low;
    }
}
