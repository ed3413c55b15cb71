//! Labelling: every point gets the labels of all surfaces it lies on. Along an edge these are two,
//! at a corner three or more, and the benchmark's truth lists the point under each.

use super::super::Candidate;
use super::super::search::Search;

/// Which points lie on which surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Labels {
    /// For each surface its points, ascending.
    pub points: Vec<Vec<u32>>,
    /// Start of each point's labels in `surfaces`, and the end of the last.
    starts: Vec<u32>,
    surfaces: Vec<u32>,
}

impl Labels {
    fn new(count: usize, points: Vec<Vec<u32>>) -> Self {
        let mut starts = vec![0u32; count + 1];
        for &index in points.iter().flatten() {
            starts[index as usize + 1] += 1;
        }
        for i in 0..count {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut surfaces = vec![0; starts[count] as usize];
        for (surface, points) in (0u32..).zip(&points) {
            for &index in points {
                let slot = &mut next[index as usize];
                surfaces[*slot as usize] = surface;
                *slot += 1;
            }
        }
        Self {
            points,
            starts,
            surfaces,
        }
    }

    /// The surfaces a point lies on, ascending.
    pub fn of(&self, index: u32) -> &[u32] {
        let i = index as usize;
        &self.surfaces[self.starts[i] as usize..self.starts[i + 1] as usize]
    }
}

/// Labels the cloud. A surface goes on beyond its patch and crosses others; of the points on it,
/// it claims only groups connected to its support, or holding points of their own, which lie on
/// no other surface.
pub fn label(search: &Search<'_>, candidates: &[Candidate]) -> Labels {
    let count = search.cloud.len();
    let on: Vec<Vec<u32>> = candidates
        .iter()
        .map(|candidate| {
            let mut points = Vec::with_capacity(candidate.support.len());
            search.tree.near_zero(
                search.scale.tolerance,
                |point| candidate.surface.distance(point),
                |index| points.push(index),
            );
            points.sort_unstable();
            points
        })
        .collect();
    let mut lying = vec![0u32; count];
    for &index in on.iter().flatten() {
        lying[index as usize] += 1;
    }
    let mut open = vec![false; count];
    let points = candidates
        .iter()
        .zip(on)
        .map(|(candidate, on)| claimed(search, candidate, &on, &lying, &mut open))
        .collect();
    without_crossings(search, Labels::new(count, points))
}

/// Drops the labels of points where a surface, beyond the end of its face, cuts another: there all
/// points on the one are on the other too. Such a row of points would join what are separate faces
/// of the first.
fn without_crossings(search: &Search<'_>, labels: Labels) -> Labels {
    let has = |index: u32, surface: u32| labels.of(index).contains(&surface);
    let mut found = Vec::with_capacity(2);
    let mut crosses = |index: u32, surface: u32| {
        labels.of(index).iter().any(|&other| {
            let leaves = |i: u32| has(i, surface) && !has(i, other);
            if other == surface || search.graph.of(index).iter().any(|&i| leaves(i)) {
                return false;
            }
            let radius = BESIDE * search.scale.spacing;
            let point = search.point(index);
            search.tree.nearest(point, 1, radius, leaves, &mut found);
            found.is_empty()
        })
    };
    let kept = (0u32..)
        .zip(&labels.points)
        .map(|(surface, points)| {
            let points = points.iter().copied();
            points.filter(|&index| !crosses(index, surface)).collect()
        })
        .collect();
    Labels::new(search.cloud.len(), kept)
}

/// How near the face beside an edge has a point off the other face, in spacings.
const BESIDE: f64 = 4.0;

/// The groups of points on a surface that it may claim. `open` is false all over, before and after.
fn claimed(
    search: &Search<'_>,
    candidate: &Candidate,
    on: &[u32],
    lying: &[u32],
    open: &mut [bool],
) -> Vec<u32> {
    for &index in on {
        open[index as usize] = true;
    }
    let mut claimed = Vec::with_capacity(on.len());
    let mut group = Vec::new();
    for &start in on {
        if !open[start as usize] {
            continue;
        }
        open[start as usize] = false;
        group.clear();
        group.push(start);
        let mut next = 0;
        let (mut connected, mut own) = (false, 0);
        while next < group.len() {
            let index = group[next];
            connected = connected || candidate.support.binary_search(&index).is_ok();
            own += usize::from(lying[index as usize] == 1);
            for &neighbour in search.graph.of(index) {
                if std::mem::take(&mut open[neighbour as usize]) {
                    group.push(neighbour);
                }
            }
            next += 1;
        }
        if connected || own >= OWN {
            claimed.extend_from_slice(&group);
        }
    }
    claimed.sort_unstable();
    claimed
}

/// Points of its own that a group away from the support needs.
const OWN: usize = 3;
