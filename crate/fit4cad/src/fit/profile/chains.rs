//! Chains: the rulings in the order in which the profile runs through them.

use super::rulings::Ruling;
use crate::cloud::Point;
use crate::cloud::neighbours::{KdTree, is_gabriel_link};
use crate::disjoint::DisjointSets;
use crate::fit::thin::profile::apart;

/// Nearest rulings that one may be linked to.
const NEAREST: usize = 8;
/// Fewest rulings around a closed profile.
const AROUND: usize = 4;

/// Rulings in order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Chain {
    /// Positions of the rulings; of a closed chain the first comes last again.
    pub rulings: Vec<usize>,
    /// Whether it ends where it begins.
    pub is_closed: bool,
}

/// Chains of rulings not more than `reach` apart. A profile passes every place once, so a ruling is
/// linked to at most two others, and to fewer where `capacity` tells that the faces there are known;
/// the shortest links that `allows` admits go first. O(r log r).
pub fn chains(
    rulings: &[Ruling],
    capacity: &[u8],
    reach: f64,
    allows: impl Fn(usize, usize) -> bool,
) -> Vec<Chain> {
    let at = |ruling: &Ruling| Point::new(ruling.place[0], ruling.place[1], 0.0);
    let places: Vec<Point> = rulings.iter().map(at).collect();
    let tree = KdTree::new(&places);
    let mut links: Vec<(f64, usize, usize)> = Vec::new();
    let mut near = Vec::new();
    for (number, ruling) in rulings.iter().enumerate() {
        let is_beside =
            |other: u32| other as usize != number && rulings[other as usize].is_beside(ruling);
        tree.nearest(&places[number], NEAREST, reach, is_beside, &mut near);
        for (rank, neighbour) in near.iter().enumerate() {
            let other = neighbour.index as usize;
            let nearer = near[..rank].iter().map(|it| &places[it.index as usize]);
            let is_open = is_gabriel_link(&places[number], &places[other], nearer);
            if is_open && allows(number, other) && allows(other, number) {
                let length = apart(ruling.place, rulings[other].place);
                links.push((length, number.min(other), number.max(other)));
            }
        }
    }
    links.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    links.dedup();
    let mut next: Vec<Vec<usize>> = vec![Vec::new(); rulings.len()];
    let mut sets = DisjointSets::new(rulings.len());
    let mut size = vec![1; rulings.len()];
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
        let mut rulings = vec![start];
        seen[start] = true;
        let mut at = start;
        while let Some(&following) = next[at].iter().find(|&&it| !seen[it]) {
            seen[following] = true;
            rulings.push(following);
            at = following;
        }
        let is_closed = rulings.len() > 2 && next[at].contains(&start);
        if is_closed {
            rulings.push(start);
        }
        chains.push(Chain { rulings, is_closed });
    }
    chains
}
