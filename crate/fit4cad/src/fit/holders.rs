//! Which surfaces hold each point of a cloud.

/// The numbers of the surfaces through each point, as linked lists in one arena: 4 bytes a point and 8
/// for every point of a surface. A vector for each point would take three times as much before it
/// holds anything.
#[derive(Debug, Clone)]
pub struct Holders {
    /// Position in `entries` of the last surface to hold each point.
    first: Vec<u32>,
    /// A surface, and the position of the one before it; beyond the last where there is none.
    entries: Vec<(u32, u32)>,
}

impl Holders {
    /// No surface yet through any of so many points, with room for surfaces of `held` points together.
    pub fn with_room(points: usize, held: usize) -> Self {
        Self {
            first: vec![u32::MAX; points],
            entries: Vec::with_capacity(held),
        }
    }

    /// Notes that a surface holds some points, each once. O(points), amortised.
    pub fn add(&mut self, surface: u32, support: &[u32]) {
        if self.entries.capacity() - self.entries.len() < support.len() {
            // Doubled, the arena would outweigh all else that is kept of the surfaces.
            let more = support.len().max(self.entries.len() / 8);
            self.entries.reserve_exact(more);
        }
        for &index in support {
            let first = &mut self.first[index as usize];
            let before = std::mem::replace(first, self.entries.len() as u32);
            self.entries.push((surface, before));
        }
    }

    /// The surfaces that hold a point, the last to be added first.
    pub fn of(&self, index: u32) -> impl Iterator<Item = u32> + '_ {
        let mut next = self.first[index as usize];
        std::iter::from_fn(move || {
            let &(surface, before) = self.entries.get(next as usize)?;
            next = before;
            Some(surface)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_knows_the_surfaces_that_hold_it() {
        let mut holders = Holders::with_room(4, 3);
        holders.add(0, &[0, 1, 2]);
        holders.add(1, &[1, 3]);
        holders.add(2, &[1]);
        let of = |index| holders.of(index).collect::<Vec<u32>>();
        assert_eq!(of(0), [0]);
        assert_eq!(of(1), [2, 1, 0]);
        assert_eq!(of(3), [1]);
        assert!(Holders::with_room(1, 0).of(0).next().is_none());
    }
}
