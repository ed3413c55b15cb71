//! Disjoint sets (Galler and Fischer 1964), with path halving.

/// The numbers from 0 to below a count, in sets that only ever grow together.
pub(crate) struct DisjointSets {
    parents: Vec<u32>,
}

impl DisjointSets {
    /// Every number a set of its own.
    pub(crate) fn new(count: usize) -> Self {
        Self {
            parents: (0u32..).take(count).collect(),
        }
    }

    /// The number that stands for the set of another.
    pub(crate) fn root(&mut self, mut place: usize) -> usize {
        while self.parents[place] as usize != place {
            self.parents[place] = self.parents[self.parents[place] as usize];
            place = self.parents[place] as usize;
        }
        place
    }

    /// Joins the sets of two roots; the elder stands for both.
    pub(crate) fn hang(&mut self, younger: usize, elder: usize) {
        self.parents[younger] = elder as u32;
    }

    /// Joins the sets of two numbers. The smaller root stands for both, so results do not depend on
    /// the order of joining.
    pub(crate) fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.hang(a.max(b), a.min(b));
    }

    /// The members, one for each number, set by set: in their order, and the sets in that of their
    /// first members.
    pub(crate) fn groups<T>(&mut self, members: impl IntoIterator<Item = T>) -> Vec<Vec<T>> {
        let mut place = vec![usize::MAX; self.parents.len()];
        let mut groups: Vec<Vec<T>> = Vec::new();
        for (number, member) in members.into_iter().enumerate() {
            let root = self.root(number);
            if place[root] == usize::MAX {
                place[root] = groups.len();
                groups.push(Vec::new());
            }
            groups[place[root]].push(member);
        }
        groups
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_do_not_depend_on_the_order_of_joining() {
        let joined = |pairs: &[(usize, usize)]| {
            let mut sets = DisjointSets::new(6);
            for &(a, b) in pairs {
                sets.join(a, b);
            }
            sets.groups([10, 11, 12, 13, 14, 15])
        };
        let expected = vec![vec![10, 13, 15], vec![11, 12], vec![14]];
        assert_eq!(joined(&[(0, 3), (5, 3), (2, 1)]), expected);
        assert_eq!(joined(&[(2, 1), (5, 0), (3, 5), (1, 2)]), expected);
    }
}
