//! A labelling of a cloud by surfaces, and the moves that lower its energy: a surface takes over whatever
//! points it had better have (an expansion move; Boykov, Veksler and Zabih 2001, with the prices of labels
//! of Delong and others 2012).

use std::collections::BTreeMap;

use super::energy::{self, Deviation, Links, NO_SURFACE, Priced, counted};
use super::maxflow::Graph;
use crate::cloud::Point;
use crate::cloud::neighbours::KdTree;

/// Standard deviations within which a surface may take a point.
const REACH: f64 = 5.0;
/// What a point must gain to count for a new surface, in nats.
const SLACK: f64 = 1.0;

/// What is labelled.
#[derive(Debug, Clone, Copy)]
pub struct Scene<'a> {
    /// The points.
    pub points: &'a [Point],
    /// Tree over them.
    pub tree: &'a KdTree,
    /// Pairs of neighbours among them.
    pub links: &'a Links,
}

/// Every point's surface, and what that costs.
#[derive(Debug, Clone)]
pub struct Labelling {
    /// The surfaces; those without points are no part of the energy.
    pub surfaces: Vec<Priced>,
    /// Position among them of each point's surface, or [`NO_SURFACE`].
    pub labels: Vec<u32>,
    /// How many points each surface has.
    pub sizes: Vec<u32>,
    /// How the points lie off their surfaces.
    pub deviation: Deviation,
    /// What each point costs where it is, borders left out.
    costs: Vec<i32>,
    border: i32,
    /// Number of each point in the graph of a move, [`NO_NODE`] for those that are not in it.
    node: Vec<u32>,
    graph: Graph,
}

const NO_NODE: u32 = u32::MAX;

impl Labelling {
    /// All points on no surface.
    pub fn empty(points: usize, deviation: Deviation) -> Self {
        Self {
            surfaces: Vec::new(),
            labels: vec![NO_SURFACE; points],
            sizes: Vec::new(),
            deviation,
            costs: vec![counted(energy::OUTLIER); points],
            border: counted(energy::BORDER),
            node: vec![NO_NODE; points],
            graph: Graph::default(),
        }
    }

    /// The energy, in whole numbers. O(n).
    #[cfg(test)]
    pub fn energy(&self, links: &Links) -> i64 {
        let points: i64 = self.costs.iter().map(|&cost| i64::from(cost)).sum();
        let used = self.surfaces.iter().zip(&self.sizes);
        let surfaces: i64 = used
            .filter(|(_, size)| **size > 0)
            .map(|(it, _)| i64::from(it.price))
            .sum();
        let cut = (0u32..).zip(&self.labels).map(|(index, &label)| {
            let near = links.at(index).iter();
            near.filter(|&&other| other > index && self.labels[other as usize] != label)
                .count()
        });
        points + surfaces + cut.sum::<usize>() as i64 * i64::from(self.border)
    }

    /// Renews what points cost, after surfaces or the noise changed. O(n).
    pub fn revalue(&mut self, points: &[Point]) {
        for ((point, &label), cost) in points.iter().zip(&self.labels).zip(&mut self.costs) {
            *cost = match self.surfaces.get(label as usize) {
                Some(surface) => surface.cost(point, self.deviation),
                None => counted(energy::OUTLIER),
            };
        }
    }

    /// What a point costs where it is.
    pub fn cost(&self, index: u32) -> i32 {
        self.costs[index as usize]
    }

    /// Adds a surface, without any point yet.
    pub fn add(&mut self, surface: Priced) -> u32 {
        self.surfaces.push(surface);
        self.sizes.push(0);
        (self.surfaces.len() - 1) as u32
    }

    /// The points of each surface, ascending.
    pub fn members(&self) -> Vec<Vec<u32>> {
        let mut members: Vec<Vec<u32>> = self
            .sizes
            .iter()
            .map(|&size| Vec::with_capacity(size as usize))
            .collect();
        for (index, &label) in (0u32..).zip(&self.labels) {
            if let Some(members) = members.get_mut(label as usize) {
                members.push(index);
            }
        }
        members
    }

    /// Gives a point another surface.
    pub fn set(&mut self, index: u32, label: u32, cost: i32) {
        let old = std::mem::replace(&mut self.labels[index as usize], label);
        for (label, step) in [(old, -1), (label, 1)] {
            if let Some(size) = self.sizes.get_mut(label as usize) {
                *size = size.wrapping_add_signed(step);
            }
        }
        self.costs[index as usize] = cost;
    }

    /// Lets a surface take over the points that it had better have; by how much that lowers the energy.
    /// Where it would not, nothing changes.
    pub fn expand(&mut self, scene: &Scene<'_>, label: u32) -> i64 {
        let surface = self.surfaces[label as usize];
        let mut open: Vec<(u32, i32)> = Vec::new();
        scene.tree.near_zero(
            REACH * self.deviation.noise,
            |point| surface.surface.distance(point),
            |index| {
                if self.labels[index as usize] != label {
                    open.push((
                        index,
                        surface.cost(&scene.points[index as usize], self.deviation),
                    ));
                }
            },
        );
        open.sort_unstable_by_key(|it| it.0);
        self.take(scene, label, &open)
    }

    /// Lets points be on no surface where they had better be; by how much that lowers the energy.
    pub fn release(&mut self, scene: &Scene<'_>) -> i64 {
        let cost = counted(energy::OUTLIER);
        let open: Vec<(u32, i32)> = (0u32..)
            .zip(self.labels.iter().zip(&self.costs))
            .filter(|(_, (label, old))| **label != NO_SURFACE && 2 * **old > cost)
            .map(|(index, _)| (index, cost))
            .collect();
        self.take(scene, NO_SURFACE, &open)
    }

    /// The best move of some points, with what they would cost there, to a surface.
    pub fn take(&mut self, scene: &Scene<'_>, label: u32, open: &[(u32, i32)]) -> i64 {
        if open.is_empty() {
            return 0;
        }
        let is_new = self
            .sizes
            .get(label as usize)
            .is_some_and(|&size| size == 0);
        let price = if is_new {
            i64::from(self.surfaces[label as usize].price)
        } else {
            0
        };
        let slack = counted(SLACK);
        // A surface that gains little at each of its points gains it from those that happen to be nearer
        // to it than to the surface they have; the borders around them would cost more.
        let costs = open
            .iter()
            .map(|&(index, cost)| i64::from(self.costs[index as usize] - cost - slack).max(0));

        if is_new && costs.sum::<i64>() <= price {
            return 0;
        }
        for (node, &(index, _)) in (0u32..).zip(open) {
            self.node[index as usize] = node;
        }
        self.build(scene, label, open);
        self.graph.cut();
        let moved: Vec<(u32, i32)> = (0u32..)
            .zip(open)
            .filter(|(node, _)| self.graph.is_on_sink_side(*node))
            .map(|(_, &it)| it)
            .collect();
        for &(index, _) in open {
            self.node[index as usize] = NO_NODE;
        }
        let gain = self.gain(scene, label, &moved) - price;
        if gain <= 0 {
            return 0;
        }
        for (index, cost) in moved {
            self.set(index, label, cost);
        }
        gain
    }

    /// The graph of a move: a node on the sink's side moves.
    fn build(&mut self, scene: &Scene<'_>, label: u32, open: &[(u32, i32)]) {
        let border = self.border;
        self.graph.clear(open.len());
        let mut inside: BTreeMap<u32, u32> = BTreeMap::new();
        for (node, &(index, cost)) in (0u32..).zip(open) {
            let old = self.labels[index as usize];
            let mut stays = self.costs[index as usize] - cost;
            for &other in scene.links.at(index) {
                let theirs = self.labels[other as usize];
                let place = self.node[other as usize];
                if place == NO_NODE {
                    stays += border * (i32::from(old != theirs) - i32::from(label != theirs));
                } else if theirs == old {
                    if node < place {
                        self.graph.add_arcs(node, place, border, border);
                    }
                } else if node < place {
                    // Both on their own cost a border; one alone costs one too, both together none.
                    self.graph.add_arcs(node, place, border, 0);
                } else {
                    stays += border;
                }
            }
            self.graph.add_cost(node, stays);
            if old != NO_SURFACE {
                *inside.entry(old).or_insert(0) += 1;
            }
        }
        // A surface all of whose points may move is paid for by the last of them.
        for (old, count) in inside {
            if count == self.sizes[old as usize] {
                let price = self.surfaces[old as usize].price;
                let owner = self.graph.add_node();
                self.graph.add_cost(owner, price);
                for (node, &(index, _)) in (0u32..).zip(open) {
                    if self.labels[index as usize] == old {
                        self.graph.add_arcs(node, owner, price, 0);
                    }
                }
            }
        }
    }

    /// What the energy falls by if points move, the price of the label they move to left out.
    fn gain(&mut self, scene: &Scene<'_>, label: u32, moved: &[(u32, i32)]) -> i64 {
        const MOVES: u32 = 0;
        for &(index, _) in moved {
            self.node[index as usize] = MOVES;
        }
        let mut gain = 0i64;
        let mut left: BTreeMap<u32, u32> = BTreeMap::new();
        for &(index, cost) in moved {
            let old = self.labels[index as usize];
            gain += i64::from(self.costs[index as usize] - cost);
            for &other in scene.links.at(index) {
                let theirs = self.labels[other as usize];
                if self.node[other as usize] == MOVES {
                    // Of a pair that moves together one counts.
                    gain += i64::from(self.border * i32::from(index < other && old != theirs));
                } else {
                    let steps = i32::from(old != theirs) - i32::from(label != theirs);
                    gain += i64::from(self.border * steps);
                }
            }
            if old != NO_SURFACE {
                *left.entry(old).or_insert(0) += 1;
            }
        }
        for (old, count) in left {
            if count == self.sizes[old as usize] {
                gain += i64::from(self.surfaces[old as usize].price);
            }
        }
        for &(index, _) in moved {
            self.node[index as usize] = NO_NODE;
        }
        gain
    }
}
