//! Specks: plane faces of a handful of points, such as the tip of a pin.
//!
//! They have fewer points than any neighbourhood that hypotheses are made from, and lie amid points
//! on other surfaces or on none. But one point in the middle with its nearest neighbours all around
//! it, all exactly in one plane, is no accident: on a bent surface these neighbours leave the
//! tangent plane, and along the rulings of an extruded one they lie in rows, never all around.

use super::progress::{Cancelled, Observer, Stage};
use super::search::{EXACT, Search, widest_gap};
use super::{Candidate, Parameters, detect};
use crate::cloud::normals::Spread;
use crate::surface::{Plane, Surface};

/// Neighbours around the middle point.
const AROUND: [usize; 3] = [4, 5, 6];
/// Widest angle between two of them, seen from the middle, in radians: above that of a square.
const GAP: f64 = 1.7;

/// Finds the specks of a clean cloud among its unexplained points. O(n log n).
///
/// # Errors
/// If the observer stops the fit.
pub fn specks(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    if !search.scale.shows_rows() {
        return Ok(());
    }
    for (place, middle) in (0u32..).take(search.cloud.len()).enumerate() {
        if place % 1024 == 0 {
            observer.progress(Stage::Find, 1.0)?;
        }
        if search.is_explained(middle) {
            continue;
        }
        if let Some(speck) = around(search, middle) {
            detect::keep(search, speck, observer);
        }
    }
    Ok(())
}

/// The speck whose middle a point is.
fn around(search: &mut Search<'_>, middle: u32) -> Option<Candidate> {
    let near = search.unexplained_near(middle, AROUND[2] + 1);
    let near: Vec<u32> = near.into_iter().filter(|&index| index != middle).collect();
    let centre = *search.point(middle);
    let exact = EXACT * search.scale.tolerance;
    AROUND.iter().find_map(|&count| {
        let ring = search.points(near.get(..count)?);
        let spread = Spread::of(ring.iter().chain([&centre]))?;
        let plane = Surface::Plane(Plane::new(spread.centroid, spread.normal().into_inner()));
        let is_flat = ring.iter().all(|point| plane.distance(point) <= exact);
        if !is_flat || widest_gap(&centre, &spread.normal(), ring.iter()) > GAP {
            return None;
        }
        let mut seeds = near.get(..count)?.to_vec();
        seeds.push(middle);
        let speck = search.grow(&plane, &seeds)?;
        let smallest = Parameters::count(search.parameters.smallest);
        (speck.error <= exact && search.own(&speck) >= smallest).then_some(speck)
    })
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;
    use crate::cloud::{Cloud, Point};

    /// A bowl that belongs to no family: z = x⁴ + y⁴ on a grid of spacing 1/20 that leaves out
    /// |x|, |y| < `hole`.
    fn bowl(hole: f64) -> Vec<Point> {
        let steps = || (-20..=20).map(|i| f64::from(i) / 20.0);
        steps()
            .flat_map(|x| steps().map(move |y| Point::new(x, y, x.powi(4) + y.powi(4))))
            .filter(|point| point.x.abs().max(point.y.abs()) >= hole)
            .collect()
    }

    /// A middle point and `count` points around it, level at z = 0.
    fn disc(count: u32) -> impl Iterator<Item = Point> {
        let rim = (0..count).map(move |i| {
            let turn = TAU * f64::from(i) / f64::from(count);
            Point::new(0.05 * turn.cos(), 0.05 * turn.sin(), 0.0)
        });
        rim.chain([Point::origin()])
    }

    fn found(points: Vec<Point>) -> Vec<Candidate> {
        let cloud = Cloud::new(points);
        let mut search = Search::new(&cloud, &Parameters::default(), 1);
        specks(&mut search, &mut ()).unwrap();
        search.into_accepted()
    }

    #[test]
    fn a_disc_of_five_or_six_points_amid_a_free_form_is_found() {
        for count in [4, 5] {
            let free_form = bowl(0.3);
            let first = free_form.len() as u32;
            let specks = found(free_form.into_iter().chain(disc(count)).collect());
            assert_eq!(specks.len(), 1, "{count} points around");
            let whole: Vec<u32> = (first..first + count + 1).collect();
            assert_eq!(specks[0].support, whole);
        }
    }

    #[test]
    fn two_rulings_of_an_extruded_profile_are_no_speck() {
        let profile = (0..60).map(|i| f64::from(i) / 40.0);
        let rulings = profile.flat_map(|x| {
            (0..30).map(move |j| Point::new(x, f64::from(j) / 40.0, (3.0 * x).sin() + x.powi(3)))
        });
        assert_eq!(found(rulings.collect()), []);
    }

    #[test]
    fn a_free_form_has_no_specks() {
        // Away from its middle, where it is flatter than any tolerance.
        assert_eq!(found(bowl(0.3)), []);
    }
}
