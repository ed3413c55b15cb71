//! Minimum cuts of small graphs, by the algorithm of Boykov and Kolmogorov (2004).
//!
//! Two trees of unsaturated arcs grow from the terminals; where they meet, flow is sent along the path,
//! and what that cuts off is adopted by another branch or set free. In theory slower than pushing
//! preflows, on the shallow graphs of labellings it is the fastest known. Capacities are whole numbers,
//! so that a cut is exact and the same on every machine.

/// No arc.
const NONE: u32 = u32::MAX;
/// The arc to the terminal itself.
const TERMINAL: u32 = u32::MAX - 1;
/// In place of an arc that was saturated.
const ORPHAN: u32 = u32::MAX - 2;

#[derive(Debug, Clone, Copy)]
struct Arc {
    head: u32,
    /// Next arc out of the same node.
    next: u32,
    /// What may still flow.
    room: i32,
}

#[derive(Debug, Clone, Copy)]
struct Node {
    /// First arc out of it.
    first: u32,
    /// Arc to its parent in the tree, [`NONE`] where it is in none.
    parent: u32,
    /// When its distance was last known to hold.
    stamp: u32,
    /// Arcs to the terminal.
    distance: u32,
    /// What the terminals may still send (positive) or take (negative).
    excess: i32,
    in_sink_tree: bool,
    is_active: bool,
}

/// A graph with two terminals, a source and a sink.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    nodes: Vec<Node>,
    /// In pairs: an arc and its reverse.
    arcs: Vec<Arc>,
    active: std::collections::VecDeque<u32>,
    orphans: std::collections::VecDeque<u32>,
    time: u32,
}

impl Graph {
    /// Forgets everything but the memory.
    pub fn clear(&mut self, nodes: usize) {
        self.nodes.clear();
        self.arcs.clear();
        self.active.clear();
        self.orphans.clear();
        self.time = 0;
        for _ in 0..nodes {
            self.add_node();
        }
    }

    /// One more node, by its number.
    pub fn add_node(&mut self) -> u32 {
        self.nodes.push(Node {
            first: NONE,
            parent: NONE,
            stamp: 0,
            distance: 0,
            excess: 0,
            in_sink_tree: false,
            is_active: false,
        });
        (self.nodes.len() - 1) as u32
    }

    /// What a node costs on the source's side more than on the sink's.
    pub fn add_cost(&mut self, node: u32, on_source_side: i32) {
        // What a node would take from the sink it gives to the source.
        self.nodes[node as usize].excess -= on_source_side;
    }

    /// What it costs to have one node on the source's side and the other on the sink's, and the other
    /// way round.
    pub fn add_arcs(&mut self, from: u32, to: u32, capacity: i32, reverse: i32) {
        let place = self.arcs.len() as u32;
        let (first, second) = (
            self.nodes[from as usize].first,
            self.nodes[to as usize].first,
        );
        self.arcs.push(Arc {
            head: to,
            next: first,
            room: capacity,
        });
        self.arcs.push(Arc {
            head: from,
            next: second,
            room: reverse,
        });
        self.nodes[from as usize].first = place;
        self.nodes[to as usize].first = place + 1;
    }

    /// Whether a node is on the sink's side of the minimum cut that [`Graph::cut`] found. Nodes that
    /// may be on either are on the source's.
    pub fn is_on_sink_side(&self, node: u32) -> bool {
        let node = &self.nodes[node as usize];
        node.parent != NONE && node.in_sink_tree
    }

    /// Finds a minimum cut.
    pub fn cut(&mut self) {
        for index in 0..self.nodes.len() {
            let node = &mut self.nodes[index];
            if node.excess != 0 {
                node.in_sink_tree = node.excess < 0;
                node.parent = TERMINAL;
                node.distance = 1;
                self.activate(index as u32);
            }
        }
        let mut current = None;
        loop {
            let in_tree = |&index: &u32| self.nodes[index as usize].parent != NONE;
            let Some(index) = current
                .take()
                .filter(in_tree)
                .or_else(|| self.next_active())
            else {
                break;
            };
            let meeting = self.extend(index);
            self.time += 1;
            if let Some(arc) = meeting {
                current = Some(index);
                self.augment(arc);
                while let Some(orphan) = self.orphans.pop_front() {
                    self.adopt(orphan);
                }
            }
        }
    }

    fn activate(&mut self, index: u32) {
        let node = &mut self.nodes[index as usize];
        if !node.is_active {
            node.is_active = true;
            self.active.push_back(index);
        }
    }

    fn next_active(&mut self) -> Option<u32> {
        while let Some(index) = self.active.pop_front() {
            let node = &mut self.nodes[index as usize];
            node.is_active = false;
            if node.parent != NONE {
                return Some(index);
            }
        }
        None
    }

    /// The arc whose room lets flow go towards the sink between a node and what its arc leads to: the
    /// arc itself in the sink's tree seen from the leaf, its reverse in the source's.
    fn room(&self, arc: u32, reversed: bool) -> i32 {
        self.arcs[(arc ^ u32::from(reversed)) as usize].room
    }

    /// Lets the tree grow from a node; the arc to the other tree if it was reached.
    fn extend(&mut self, index: u32) -> Option<u32> {
        let Node {
            in_sink_tree,
            stamp,
            distance,
            first,
            ..
        } = self.nodes[index as usize];
        let mut arc = first;
        while arc != NONE {
            let Arc { head, next, .. } = self.arcs[arc as usize];
            if self.room(arc, in_sink_tree) > 0 {
                let other = &mut self.nodes[head as usize];
                if other.parent == NONE {
                    other.in_sink_tree = in_sink_tree;
                    other.parent = arc ^ 1;
                    other.stamp = stamp;
                    other.distance = distance + 1;
                    self.activate(head);
                } else if other.in_sink_tree != in_sink_tree {
                    return Some(arc ^ u32::from(in_sink_tree));
                } else if other.stamp <= stamp && other.distance > distance {
                    other.parent = arc ^ 1;
                    other.stamp = stamp;
                    other.distance = distance + 1;
                }
            }
            arc = next;
        }
        None
    }

    /// Sends what it can along the path through an arc from the source's tree to the sink's.
    fn augment(&mut self, middle: u32) {
        let ends = [
            self.arcs[(middle ^ 1) as usize].head,
            self.arcs[middle as usize].head,
        ];
        let mut amount = self.arcs[middle as usize].room;
        for (end, in_sink_tree) in ends.into_iter().zip([false, true]) {
            let mut index = end;
            loop {
                let Node { parent, excess, .. } = self.nodes[index as usize];
                if parent == TERMINAL {
                    amount = amount.min(excess.abs());
                    break;
                }
                amount = amount.min(self.room(parent, !in_sink_tree));
                index = self.arcs[parent as usize].head;
            }
        }
        self.arcs[middle as usize].room -= amount;
        self.arcs[(middle ^ 1) as usize].room += amount;
        for (end, in_sink_tree) in ends.into_iter().zip([false, true]) {
            let mut index = end;
            loop {
                let parent = self.nodes[index as usize].parent;
                if parent == TERMINAL {
                    let node = &mut self.nodes[index as usize];
                    node.excess -= if in_sink_tree { -amount } else { amount };
                    if node.excess == 0 {
                        self.orphan_in_front(index);
                    }
                    break;
                }
                let along = parent ^ u32::from(!in_sink_tree);
                self.arcs[along as usize].room -= amount;
                self.arcs[(along ^ 1) as usize].room += amount;
                if self.arcs[along as usize].room == 0 {
                    self.orphan_in_front(index);
                }
                index = self.arcs[parent as usize].head;
            }
        }
    }

    fn orphan_in_front(&mut self, index: u32) {
        self.nodes[index as usize].parent = ORPHAN;
        self.orphans.push_front(index);
    }

    /// Finds an orphan a new parent in its tree, or sets it and its children free.
    fn adopt(&mut self, orphan: u32) {
        let Node {
            first,
            in_sink_tree,
            ..
        } = self.nodes[orphan as usize];
        let mut best: Option<(u32, u32)> = None;
        let mut arc = first;
        while arc != NONE {
            let Arc { head, next, .. } = self.arcs[arc as usize];
            let node = &self.nodes[head as usize];
            if self.room(arc, !in_sink_tree) > 0
                && node.in_sink_tree == in_sink_tree
                && node.parent != NONE
                && let Some(distance) = self.distance_to_terminal(head)
            {
                if best.is_none_or(|(_, least)| distance < least) {
                    best = Some((arc, distance));
                }
                self.mark_path(head, distance);
            }
            arc = next;
        }
        if let Some((arc, distance)) = best {
            let node = &mut self.nodes[orphan as usize];
            node.parent = arc;
            node.stamp = self.time;
            node.distance = distance + 1;
            return;
        }
        self.nodes[orphan as usize].parent = NONE;
        let mut arc = first;
        while arc != NONE {
            let Arc { head, next, .. } = self.arcs[arc as usize];
            let Node {
                in_sink_tree: side,
                parent,
                ..
            } = self.nodes[head as usize];
            if side == in_sink_tree && parent != NONE {
                if self.room(arc, !in_sink_tree) > 0 {
                    self.activate(head);
                }
                let is_child = parent != TERMINAL
                    && parent != ORPHAN
                    && self.arcs[parent as usize].head == orphan;
                if is_child {
                    self.nodes[head as usize].parent = ORPHAN;
                    self.orphans.push_back(head);
                }
            }
            arc = next;
        }
    }

    /// Arcs from a node to the terminal of its tree; `None` where its root is an orphan.
    fn distance_to_terminal(&mut self, start: u32) -> Option<u32> {
        let (mut index, mut steps) = (start, 0);
        loop {
            let node = &mut self.nodes[index as usize];
            if node.stamp == self.time {
                return Some(steps + node.distance);
            }
            match node.parent {
                TERMINAL => {
                    node.stamp = self.time;
                    node.distance = 1;
                    return Some(steps + 1);
                }
                ORPHAN | NONE => return None,
                arc => index = self.arcs[arc as usize].head,
            }
            steps += 1;
        }
    }

    /// Notes the distances on the way to the terminal.
    fn mark_path(&mut self, start: u32, distance: u32) {
        let (mut index, mut distance) = (start, distance);
        loop {
            let node = &mut self.nodes[index as usize];
            if node.stamp == self.time {
                return;
            }
            node.stamp = self.time;
            node.distance = distance;
            distance -= 1;
            index = self.arcs[node.parent as usize].head;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;

    /// Costs of small graphs at random, cut in all ways there are.
    #[test]
    fn cuts_are_as_cheap_as_the_cheapest_of_all() {
        let mut random = Random::new(5, 0);
        let mut graph = Graph::default();
        for _ in 0..3000 {
            let count = 2 + random.below(7);
            let costs: Vec<i32> = (0..count).map(|_| random.below(21) as i32 - 10).collect();
            let arcs: Vec<(usize, usize, i32, i32)> = (0..random.below(2 * count + 1))
                .map(|_| {
                    let from = random.below(count);
                    let to = (from + 1 + random.below(count - 1)) % count;
                    (from, to, random.below(8) as i32, random.below(8) as i32)
                })
                .collect();
            graph.clear(count);
            for (node, &cost) in (0u32..).zip(&costs) {
                graph.add_cost(node, cost);
            }
            for &(from, to, capacity, reverse) in &arcs {
                graph.add_arcs(from as u32, to as u32, capacity, reverse);
            }
            graph.cut();
            let cost = |on_sink_side: &dyn Fn(usize) -> bool| -> i32 {
                let nodes = costs.iter().enumerate();
                let nodes: i32 = nodes
                    .filter(|(i, _)| !on_sink_side(*i))
                    .map(|(_, c)| c)
                    .sum();
                let cut = arcs.iter().map(|&(from, to, capacity, reverse)| {
                    match (on_sink_side(from), on_sink_side(to)) {
                        (false, true) => capacity,
                        (true, false) => reverse,
                        _ => 0,
                    }
                });
                nodes + cut.sum::<i32>()
            };
            let found = cost(&|i| graph.is_on_sink_side(i as u32));
            let least = (0..1usize << count).map(|sides| cost(&|i| sides >> i & 1 == 1));
            assert_eq!(Some(found), least.min());
        }
    }
}
