//! Points of which each is taken once, however often it comes.

use std::collections::BTreeSet;

use super::gather::Gather;
use crate::cloud::Point;
use crate::diagnostics::Diagnostic;
use crate::format::cloud::CloudFile;

/// Gathers rows, and of equal ones the first. Beside the points themselves it holds 8 to 16 bytes for each.
pub(super) struct Distinct<'a> {
    gather: Gather<'a>,
    /// Places of points, by what their coordinates come to, or [`FREE`]; the one beside is tried next. A power of two,
    /// at most half of them taken.
    slots: Vec<u32>,
    /// Rows that are no points, by the bits of their numbers.
    broken: BTreeSet<[u64; 3]>,
}

const FREE: u32 = u32::MAX;
const FEWEST: usize = 1 << 10;

impl<'a> Distinct<'a> {
    pub(super) fn new(gather: Gather<'a>) -> Self {
        Self {
            gather,
            slots: vec![FREE; FEWEST],
            broken: BTreeSet::new(),
        }
    }

    /// Takes a row, if it is the first of its kind; false where there is no room for more. O(1) on average.
    pub(super) fn push(&mut self, row: [f64; 3]) -> bool {
        let taken = self.gather.points().len();
        if 2 * (taken + 1) > self.slots.len() {
            self.grow();
        }
        let slot = slot_of(&self.slots, self.gather.points(), row);
        let is_known = self.slots.get(slot).is_none_or(|&place| place != FREE);
        if is_known || self.broken.contains(&row.map(f64::to_bits)) {
            return true;
        }
        if !self.gather.has_room() {
            return false;
        }
        self.gather.push(row, None);
        if self.gather.points().len() > taken {
            if let Some(free) = self.slots.get_mut(slot) {
                *free = taken as u32;
            }
        } else {
            self.broken.insert(row.map(f64::to_bits));
        }
        true
    }

    fn grow(&mut self) {
        let count = 2 * self.slots.len();
        self.slots.clear();
        self.slots.resize(count, FREE);
        for (place, point) in (0u32..).zip(self.gather.points()) {
            let slot = slot_of(&self.slots, self.gather.points(), (*point).into());
            if let Some(free) = self.slots.get_mut(slot) {
                *free = place;
            }
        }
    }

    pub(super) fn finish(self) -> (CloudFile, Vec<Diagnostic>) {
        let Self { gather, .. } = self;
        gather.finish()
    }
}

/// Where the place of a point stands, or is to stand.
fn slot_of(slots: &[u32], points: &[Point], row: [f64; 3]) -> usize {
    let mask = slots.len() - 1;
    let mut slot = mixed(row) & mask;
    loop {
        let place = slots.get(slot).copied().unwrap_or(FREE);
        let is_same = |point: &Point| point.x == row[0] && point.y == row[1] && point.z == row[2];
        if place == FREE || points.get(place as usize).is_some_and(is_same) {
            return slot;
        }
        slot = (slot + 1) & mask;
    }
}

/// A number that depends on every bit of the coordinates, the same for zeros of either sign.
fn mixed(row: [f64; 3]) -> usize {
    // The odd number is 2^64 over the golden ratio (Knuth, The Art of Computer Programming 3, 6.4).
    let mix = |sum: u64, value: f64| {
        let product = (sum ^ (value + 0.0).to_bits()).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        product ^ (product >> 32)
    };
    row.into_iter().fold(0, mix) as usize
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::format::findings::Findings;

    #[test]
    fn the_first_of_equal_rows_is_taken_and_what_is_broken_once() {
        let mut distinct = Distinct::new(Gather::new(Findings::new("a", &[]), 0, false));
        let far = 10_000;
        for turn in 0..2 {
            for x in 0..far {
                assert!(distinct.push([f64::from(x), 0.0, -0.0]), "{turn}");
            }
            distinct.push([-0.0, 0.0, 0.0]);
            distinct.push([f64::NAN, 1.0, 2.0]);
        }
        let (file, findings) = distinct.finish();
        assert_eq!(file.cloud.len(), far as usize);
        assert_eq!(file.cloud.points()[1].x, 1.0);
        assert_eq!(file.cloud.numbering().rows(), far as usize + 1);
        assert_eq!(findings.len(), 1);
    }
}
