//! Open borders: where an accepted surface ends and nothing yet begins.
//!
//! A ring, chamfer or countersink one point wide has no interior points, so none of its points ever
//! looks unexplained: all lie on the edges of its neighbours. But there the neighbours end without
//! a second surface to end at. Such a point sees its own surface only on one side, and one surface
//! alone holds it.

use crate::cloud::{Direction, Vector};
use crate::fit::Search;
use crate::surface::across;

/// Angle without neighbours, in radians, above which a point is on the border of its surface. On a
/// straight border it is π; inside a face of evenly spread points it stays below 1.5.
const GAP: f64 = 1.9;

/// What is known of every point's place among the accepted surfaces.
#[derive(Debug, Clone)]
pub struct Borders {
    state: Vec<State>,
}

/// A point's place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// On no accepted surface.
    Unexplained,
    /// On the border of this accepted surface alone.
    Open(u32),
    /// Inside a surface, or where two meet.
    Settled,
}

impl Borders {
    /// Looks at every point. O(n).
    pub fn of(search: &Search<'_>) -> Self {
        let mut state = vec![State::Unexplained; search.cloud.len()];
        let mut owners = vec![Owner::Nobody; search.cloud.len()];
        for (number, candidate) in (0_u32..).zip(search.accepted()) {
            for &index in &candidate.support {
                let owner = &mut owners[index as usize];
                *owner = match owner {
                    Owner::Nobody => Owner::One(number),
                    _ => Owner::Many,
                };
            }
        }
        let mut angles = Vec::new();
        for (index, owner) in (0_u32..).zip(&owners) {
            let Owner::One(owner) = *owner else {
                if *owner == Owner::Many {
                    state[index as usize] = State::Settled;
                }
                continue;
            };
            let surface = &search.accepted()[owner as usize];
            let normal = surface.surface.normal(search.point(index));
            let same = search.graph.of(index).iter().copied().filter(|&neighbour| {
                match owners[neighbour as usize] {
                    Owner::One(other) => other == owner,
                    Owner::Many => surface.support.binary_search(&neighbour).is_ok(),
                    Owner::Nobody => false,
                }
            });
            let steps = same.map(|neighbour| search.point(neighbour) - search.point(index));
            state[index as usize] = if widest_gap(&normal, steps, &mut angles) > GAP {
                State::Open(owner)
            } else {
                State::Settled
            };
        }
        Self { state }
    }

    /// Notes that a new surface explains these points.
    pub fn settle(&mut self, support: &[u32]) {
        for &index in support {
            self.state[index as usize] = State::Settled;
        }
    }

    /// Whether a point is unexplained or on an open border.
    pub fn is_free(&self, index: u32) -> bool {
        self.state[index as usize] != State::Settled
    }

    /// The position, among the accepted, of the surface whose open border a point is on.
    pub fn owner(&self, index: u32) -> Option<u32> {
        match self.state[index as usize] {
            State::Open(owner) => Some(owner),
            _ => None,
        }
    }

    /// How many free points a new surface would settle, and whether they show that it is there: on
    /// the border of one surface alone a second one always finds a row of points to pass through, so
    /// the free points must come from two sides, or from one side and from none.
    pub fn evidence(&self, support: &[u32]) -> Option<usize> {
        let mut sides: Vec<(Option<u32>, usize)> = Vec::new();
        for &index in support.iter().filter(|&&index| self.is_free(index)) {
            let owner = self.owner(index);
            match sides.iter_mut().find(|(side, _)| *side == owner) {
                Some((_, count)) => *count += 1,
                None => sides.push((owner, 1)),
            }
        }
        let total: usize = sides.iter().map(|(_, count)| count).sum();
        let largest = sides.iter().map(|(_, count)| *count).max().unwrap_or(0);
        let others = total - largest;
        let two_sided = others >= 2 && 6 * others >= total;
        let mostly_free = 5 * total >= 3 * support.len();
        (two_sided && mostly_free).then_some(total)
    }
}

/// Who holds a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Owner {
    Nobody,
    One(u32),
    Many,
}

/// The widest angle around a point without a step, seen along the normal; a full turn for fewer
/// than two steps.
fn widest_gap(
    normal: &Direction,
    steps: impl Iterator<Item = Vector>,
    angles: &mut Vec<f64>,
) -> f64 {
    let first = across(normal);
    let second = normal.cross(&first);
    angles.clear();
    angles.extend(steps.map(|step| step.dot(&second).atan2(step.dot(&first))));
    angles.sort_unstable_by(f64::total_cmp);
    let (Some(&low), Some(&high)) = (angles.first(), angles.last()) else {
        return std::f64::consts::TAU;
    };
    let around = low + std::f64::consts::TAU - high;
    angles
        .windows(2)
        .map(|pair| pair[1] - pair[0])
        .fold(around, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_on_a_straight_border_sees_a_gap_of_half_a_turn() {
        let steps = (0..=8).map(|i| {
            let (sin, cos) = (f64::from(i) * std::f64::consts::PI / 8.0).sin_cos();
            Vector::new(cos, sin, 0.0)
        });
        let gap = widest_gap(&Vector::z_axis(), steps, &mut Vec::new());
        assert!((gap - std::f64::consts::PI).abs() < 1e-12);
    }

    #[test]
    fn evidence_needs_free_points_from_two_sides() {
        let open = |owner| vec![State::Open(owner); 5];
        let borders = Borders {
            state: [open(0), open(1), vec![State::Settled; 5]].concat(),
        };
        let support = |range: std::ops::Range<u32>| range.collect::<Vec<u32>>();
        assert_eq!(borders.evidence(&support(0..5)), None);
        assert_eq!(borders.evidence(&support(0..10)), Some(10));
        assert_eq!(borders.evidence(&support(4..15)), None);
    }
}
