//! Step 2: the coarse partition. Regions grow over neighbours that are not sharp.

use crate::cloud::neighbours::Neighbourhoods;

/// Neighbours a region grows to. Fewer than the variation looks at: a row of sharp points is about
/// two deep on either side of an edge, and a region must not step over it.
pub const STEPS: usize = 6;

/// Grows regions from seeds in the given order: a seed's neighbours that are not sharp join its
/// region and are seeds in their turn, until every such point has a region. Largest first, the
/// points of each ascending. O(n).
pub fn grow(
    graph: &Neighbourhoods,
    order: &[u32],
    is_sharp: impl Fn(u32) -> bool,
) -> Vec<Vec<u32>> {
    let mut free = vec![true; order.len()];
    let mut regions: Vec<Vec<u32>> = Vec::new();
    for &seed in order {
        if !free[seed as usize] || is_sharp(seed) {
            continue;
        }
        free[seed as usize] = false;
        let mut region = vec![seed];
        let mut next = 0;
        while next < region.len() {
            for &neighbour in graph.of(region[next]).iter().take(STEPS) {
                if free[neighbour as usize] && !is_sharp(neighbour) {
                    free[neighbour as usize] = false;
                    region.push(neighbour);
                }
            }
            next += 1;
        }
        region.sort_unstable();
        region.shrink_to_fit();
        regions.push(region);
    }
    regions.sort_by_key(|region| (std::cmp::Reverse(region.len()), region[0]));
    regions
}

/// The region of every point, `u32::MAX` for none.
pub fn labels(count: usize, regions: &[Vec<u32>]) -> Vec<u32> {
    let mut labels = vec![u32::MAX; count];
    for (label, region) in (0u32..).zip(regions) {
        for &index in region {
            labels[index as usize] = label;
        }
    }
    labels
}

#[cfg(test)]
mod tests;
