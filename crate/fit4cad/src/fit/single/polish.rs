//! The surface on which points gather.

use crate::cloud::Point;
use crate::fit::least_squares::{self, BIWEIGHT, Loss};
use crate::surface::Surface;

/// Standard deviation of normal noise over the median of its absolute value.
const MEDIAN: f64 = 1.4826;
/// Share of the points of a band that normal noise leaves in its inner quarter, at most: what it is for a
/// band of one standard deviation. A wider one is never looked at.
const IN_QUARTER: f64 = 0.29;
/// Standard deviations above chance that tell a core.
const SIGNIFICANT: f64 = 4.0;
/// Bands of which each is a quarter of the one before: from any noise to rounding.
const BANDS: usize = 16;

/// The least-squares surface near a start: of all points under a loss that passes over outliers; then,
/// as long as significantly more points than chance gives lie in the inner quarter of the band
/// around it, of that band alone, down to the points that are exact.
pub(super) fn polish(start: &Surface, points: &[Point]) -> Surface {
    let mut surface = *start;
    let refit = |surface: &Surface, loss| {
        least_squares::fit(surface, points, loss)
            .map(|fitted| fitted.surface)
            .filter(|surface| super::is_sound(surface, points))
    };
    if let Some(fitted) = refit(&surface, Loss::Squares) {
        // A start nearer to most points than least squares are is on the track of a core.
        if super::median_distance(&fitted, points) <= super::median_distance(&surface, points) {
            surface = fitted;
        }
    }
    let mut band = f64::INFINITY;
    for _ in 0..2 {
        band = MEDIAN * super::median_distance(&surface, points);
        if band <= super::EXACT {
            break;
        }
        match refit(&surface, Loss::Biweight(BIWEIGHT * band)) {
            Some(fitted) => surface = fitted,
            None => break,
        }
    }
    for _ in 0..BANDS {
        if band <= 1e-3 * super::EXACT || !has_core(&surface, points, band) {
            break;
        }
        let Some(fitted) = refit(&surface, Loss::Biweight(band)) else {
            break;
        };
        surface = fitted;
        band *= 0.25;
    }
    surface
}

/// Whether significantly more of the points of a band lie in its inner quarter than chance gives.
fn has_core(surface: &Surface, points: &[Point], band: f64) -> bool {
    let (mut inner, mut all) = (0.0, 0.0);
    for point in points {
        let distance = surface.distance(point);
        all += f64::from(distance <= band);
        inner += f64::from(distance <= 0.25 * band);
    }
    let spread: f64 = (all * IN_QUARTER * (1.0 - IN_QUARTER)).sqrt();
    inner - all * IN_QUARTER > SIGNIFICANT * spread
}
