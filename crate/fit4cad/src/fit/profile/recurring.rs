//! What recurs in a profile: circles and radii that several faces have in common.

use crate::fit::thin::profile::{Curve, Place, apart};

/// Distance between centres that are one, in tolerances.
const ONE_CENTRE: f64 = 10.0;
/// How far off a recurring circle places may be, in tolerances: it was told by places elsewhere.
const OFF: f64 = 10.0;
/// How far apart radii may be that are one, in tolerances: that of a short arc is not known well.
const RADII: f64 = 30.0;
/// Rulings that make a radius about a known centre recur, and pieces that make a shape.
pub const VOTES: usize = 6;

/// Circles that recur.
#[derive(Debug, Clone, Default)]
pub struct Recurring {
    circles: Vec<(Place, f64)>,
    tolerance: f64,
}

impl Recurring {
    /// The circles among surely known curves, and those about their centres that many of the places
    /// are on: votes for a radius about each known axis. O(centres × places log places).
    pub fn of(sure: &[Curve], places: &[Place], tolerance: f64) -> Self {
        let mut circles: Vec<(Place, f64)> = Vec::new();
        let mut centres: Vec<Place> = Vec::new();
        for curve in sure {
            let Curve::Circle(centre, radius) = *curve else {
                continue;
            };
            circles.push((centre, radius));
            let near = ONE_CENTRE * tolerance;
            if centres.iter().all(|&other| apart(centre, other) > near) {
                centres.push(centre);
            }
        }
        for centre in centres {
            let mut radii: Vec<f64> = places.iter().map(|&it| apart(it, centre)).collect();
            radii.sort_by(f64::total_cmp);
            let peaks = radii
                .chunk_by(|a, b| b - a <= tolerance)
                .filter(|votes| votes.len() >= VOTES);
            circles.extend(peaks.map(|votes| (centre, votes[votes.len() / 2])));
        }
        Self { circles, tolerance }
    }

    /// The recurring circle that all places are on, if any.
    pub fn through(&self, places: &[Place]) -> Option<Curve> {
        let off = OFF * self.tolerance;
        let circles = self.circles.iter();
        let mut curves = circles.map(|&(centre, radius)| Curve::Circle(centre, radius));
        curves.find(|curve| places.iter().all(|&place| curve.distance(place) <= off))
    }

    /// Whether a circle is one of those that recur.
    pub fn has(&self, centre: Place, radius: f64) -> bool {
        self.circles.contains(&(centre, radius))
    }

    /// Whether a radius recurs.
    pub fn has_radius(&self, radius: f64) -> bool {
        let limit = RADII * self.tolerance;
        let mut circles = self.circles.iter();
        circles.any(|(_, other)| (radius - other).abs() <= limit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_at_one_distance_from_a_known_centre_make_a_circle_and_others_do_not() {
        let shaft = Curve::Circle([1.0, 2.0], 3.0);
        let mut places: Vec<Place> = (0..7)
            .map(|i| {
                let angle = 0.8 * f64::from(i);
                [1.0 + 5.0 * angle.cos(), 2.0 + 5.0 * angle.sin()]
            })
            .collect();
        places.push([1.0, 6.0]);
        let recurring = Recurring::of(&[shaft], &places, 1e-9);
        assert!(recurring.through(&places[..7]).is_some());
        assert!(recurring.through(&places).is_none());
        assert!(recurring.has_radius(3.0) && recurring.has_radius(5.0));
        assert!(!recurring.has_radius(4.0));
        assert!(recurring.has([1.0, 2.0], 3.0) && !recurring.has([1.0, 2.1], 3.0));
    }
}
