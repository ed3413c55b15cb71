//! Step 1: surface variation, and how much of it makes a point sharp.

use crate::cloud::Point;
use crate::cloud::neighbours::Neighbourhoods;
use crate::cloud::normals::Spread;
use crate::fit::quantile::quantile;

/// Surface variation σ_n = λ₁ / (λ₁ + λ₂ + λ₃) of every point, over itself and its n nearest
/// neighbours (as many of them as the graph holds). O(n).
pub fn surface_variation(points: &[Point], graph: &Neighbourhoods, neighbours: usize) -> Vec<f64> {
    (0u32..)
        .take(points.len())
        .map(|index| {
            let near = graph.of(index).iter().take(neighbours).copied();
            let patch = std::iter::once(index)
                .chain(near)
                .map(|i| &points[i as usize]);
            Spread::of(patch).map_or(0.0, |spread| spread.surface_variation())
        })
        .collect()
}

/// Above which surface variation a point is sharp.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Threshold {
    /// The paper's η: the share of points at or below it.
    pub quantile: f64,
    /// The surface variation at that quantile.
    pub value: f64,
}

/// The smallest and largest η (paper, section "PG").
const RANGE: [f64; 2] = [0.65, 0.95];
/// Bins of the histogram, evenly spaced in the logarithm of the variation.
const BINS: usize = 64;
/// Variation below which a neighbourhood is as good as flat: one that bends by 5° has more.
const FLAT: f64 = 1e-4;
/// Largest variation there is.
const LARGEST: f64 = 1.0 / 3.0;

/// The threshold at a quantile η, or, for η = 0, where the histogram of the cloud asks for it.
///
/// Neighbourhoods inside a face are flat or gently bent, those across an edge are not: on a
/// logarithmic scale the histogram has two hills, and the threshold that separates two classes best
/// is the one of greatest variance between them (Otsu 1979). It is kept to the paper's range of η.
pub fn threshold(values: &[f64], quantile_asked: f64) -> Threshold {
    let mut sorted = values.to_vec();
    if quantile_asked > 0.0 {
        return Threshold {
            quantile: quantile_asked,
            value: quantile(&mut sorted, quantile_asked),
        };
    }
    let split = otsu(values);
    let at_most = values.iter().filter(|&&value| value <= split).count();
    let share = at_most as f64 / values.len().max(1) as f64;
    let quantile_found = share.clamp(RANGE[0], RANGE[1]);
    let value = if share == quantile_found {
        split
    } else {
        quantile(&mut sorted, quantile_found)
    };
    Threshold {
        quantile: quantile_found,
        // Nothing flat is sharp, however few the edges.
        value: value.max(FLAT),
    }
}

/// The value that separates the logarithms of the values best.
fn otsu(values: &[f64]) -> f64 {
    let (low, high) = (libm::log(FLAT), libm::log(LARGEST));
    let width = (high - low) / BINS as f64;
    let mut histogram = [0.0; BINS];
    for value in values {
        let bin = (libm::log(value.max(FLAT)) - low) / width;
        histogram[(bin as usize).min(BINS - 1)] += 1.0;
    }
    let total: f64 = histogram.iter().sum();
    let moment: f64 = histogram
        .iter()
        .enumerate()
        .map(|(i, n)| i as f64 * n)
        .sum();
    let (mut below, mut moment_below) = (0.0, 0.0);
    let mut best = (0.0, BINS / 2);
    for (bin, count) in histogram.iter().enumerate() {
        below += count;
        moment_below += bin as f64 * count;
        let above = total - below;
        if below > 0.0 && above > 0.0 {
            let apart = moment_below / below - (moment - moment_below) / above;
            let between = below * above * apart * apart;
            if between > best.0 {
                best = (between, bin + 1);
            }
        }
    }
    libm::exp(low + best.1 as f64 * width)
}

#[cfg(test)]
mod tests;
