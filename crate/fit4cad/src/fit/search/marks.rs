//! Sets of points that are emptied again and again.

/// A set of points that is emptied in O(1).
#[derive(Debug, Default)]
pub(super) struct Marks {
    stamps: Vec<u32>,
    current: u32,
}

impl Marks {
    /// No point yet, of so many.
    pub(super) fn of(count: usize) -> Self {
        Self {
            stamps: vec![0; count],
            current: 1,
        }
    }

    /// Takes all points out.
    pub(super) fn clear(&mut self) {
        if self.current == u32::MAX {
            self.stamps.fill(0);
            self.current = 0;
        }
        self.current += 1;
    }

    /// Puts a point in. Whether it was not yet there.
    pub(super) fn insert(&mut self, index: u32) -> bool {
        let stamp = &mut self.stamps[index as usize];
        let new = *stamp != self.current;
        *stamp = self.current;
        new
    }

    /// Whether a point is in the set.
    pub(super) fn contains(&self, index: u32) -> bool {
        self.stamps[index as usize] == self.current
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_is_empty_again_however_often_it_was_emptied() {
        let mut marks = Marks::of(2);
        marks.current = u32::MAX - 1;
        for _ in 0..3 {
            marks.clear();
            assert!(!marks.contains(0) && !marks.contains(1));
            assert!(marks.insert(1) && !marks.insert(1));
            assert!(marks.contains(1) && !marks.contains(0));
        }
    }
}
