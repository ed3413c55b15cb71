//! Chains: places of a plane in the order in which a curve runs through them.

use super::profile::{Place, apart};
use crate::cloud::Point;
use crate::cloud::neighbours::{KdTree, is_gabriel_link};
use crate::disjoint::DisjointSets;

/// Nearest places that one may be linked to.
const NEAREST: usize = 8;
/// Fewest places around a closed curve.
const AROUND: usize = 4;

/// Places in order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chain {
    /// Numbers of the places; of a closed chain the first comes last again.
    pub places: Vec<usize>,
    /// Whether it ends where it begins.
    pub is_closed: bool,
}

/// Chains of places not more than `reach` apart. A curve passes every place once, so a place is linked
/// to at most two others that are `beside` it, and to fewer where `capacity` tells so; the shortest
/// links that `allows` admits go first. O(p log p).
pub fn chains(
    places: &[Place],
    capacity: &[u8],
    reach: f64,
    beside: impl Fn(usize, usize) -> bool,
    allows: impl Fn(usize, usize) -> bool,
) -> Vec<Chain> {
    let points: Vec<Point> = places
        .iter()
        .map(|it| Point::new(it[0], it[1], 0.0))
        .collect();
    let tree = KdTree::new(&points);
    let mut links: Vec<(f64, usize, usize)> = Vec::new();
    let mut near = Vec::new();
    for (number, point) in points.iter().enumerate() {
        let is_beside = |other: u32| other as usize != number && beside(other as usize, number);
        tree.nearest(point, NEAREST, reach, is_beside, &mut near);
        for (rank, neighbour) in near.iter().enumerate() {
            let other = neighbour.index as usize;
            let nearer = near[..rank].iter().map(|it| &points[it.index as usize]);
            let is_open = is_gabriel_link(point, &points[other], nearer);
            if is_open && allows(number, other) && allows(other, number) {
                let length = apart(places[number], places[other]);
                links.push((length, number.min(other), number.max(other)));
            }
        }
    }
    links.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    links.dedup();
    let mut next: Vec<Vec<usize>> = vec![Vec::new(); places.len()];
    let mut sets = DisjointSets::new(places.len());
    let mut size = vec![1; places.len()];
    for (_, a, b) in links {
        let has_room = |it: usize| next[it].len() < usize::from(capacity[it].min(2));
        let (one, other) = (sets.root(a), sets.root(b));
        if !has_room(a) || !has_room(b) || one == other && size[one] < AROUND {
            continue;
        }
        next[a].push(b);
        next[b].push(a);
        if one != other {
            let both = size[one] + size[other];
            sets.join(a, b);
            size[sets.root(a)] = both;
        }
    }
    walk(&next)
}

/// The chains of a graph in which no node has more than two neighbours.
fn walk(next: &[Vec<usize>]) -> Vec<Chain> {
    let mut seen = vec![false; next.len()];
    let mut chains = Vec::new();
    // Open chains from their ends first; what is left is closed.
    let ends = (0..next.len()).filter(|&it| next[it].len() == 1);
    for start in ends.chain(0..next.len()) {
        if seen[start] || next[start].is_empty() {
            continue;
        }
        let mut places = vec![start];
        seen[start] = true;
        let mut at = start;
        while let Some(&following) = next[at].iter().find(|&&it| !seen[it]) {
            seen[following] = true;
            places.push(following);
            at = following;
        }
        let is_closed = places.len() > 2 && next[at].contains(&start);
        if is_closed {
            places.push(start);
        }
        chains.push(Chain { places, is_closed });
    }
    chains
}
