//! How many rows of points a thin patch consists of, and what that proves.
//!
//! A mesher puts the points of a narrow face on rulings or rings. Two rulings are in a plane and
//! three on a cylinder, two rings on a cone and three on a torus, whatever they are; more, or fewer
//! on a simpler surface, are no accident.

use super::axis::KnownAxis;
use super::plan::Plan;
use super::profile::{self, Curve, Place};
use crate::cloud::{Direction, Point};
use crate::fit::{Candidate, Search};
use crate::surface::Surface;

/// What the rows of a patch prove.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Proof {
    /// So few rows are on too many surfaces of the family.
    None,
    /// So few rows are on one surface of the family whatever they are: whether it is there, its
    /// borders must tell.
    Chance,
    /// As [`Proof::Chance`], but one more row than the fewest.
    Weak,
    /// So many rows on one surface are no accident.
    Certain,
}

/// More rows than this are not told apart.
const MANY: usize = 5;
/// Distinct places above which points are in no rows.
const MOST_ROWS: usize = 40;
/// Share of the points that rows must hold.
const NEARLY_ALL: f64 = 0.85;

/// What the rows of a candidate's points prove. O(points of the patch).
pub fn proof(search: &Search<'_>, candidate: &Candidate) -> Proof {
    let apart = apart(search);
    let points = candidate.support.iter().map(|&index| search.point(index));
    let rings = || rings(search, candidate).map_or(MANY, |rings| rings.len().min(MANY));
    match &candidate.surface {
        Surface::Plane(plane) => {
            let flat: Vec<Place> = points.clone().map(seen_along(&plane.normal)).collect();
            if is_two_lines(&flat, apart) {
                Proof::Chance
            } else {
                Proof::Certain
            }
        }
        Surface::Cylinder(cylinder) => {
            let rulings = count(points.clone().map(seen_along(&cylinder.axis)), apart);
            match (rulings, rings()) {
                (..=2, _) | (_, ..=1) => Proof::None,
                (3, 2) => Proof::None,
                // Two pairs of rulings, mirror images, are always on one.
                (3 | 4, _) => Proof::Weak,
                (_, 2) => Proof::Chance,
                _ => Proof::Certain,
            }
        }
        Surface::Cone(_) => match rings() {
            ..=1 => Proof::None,
            2 => Proof::Chance,
            _ => Proof::Certain,
        },
        Surface::Torus(_) => match rings() {
            ..=2 => Proof::None,
            3 | 4 => Proof::Weak,
            _ => Proof::Certain,
        },
        Surface::Sphere(_) => Proof::Certain,
    }
}

/// Whether a candidate is a torus through four rings that are two pairs of mirror images, across the
/// axis: the profile of the tube passes any such four. O(points of the patch).
pub fn is_torus_by_chance(search: &Search<'_>, candidate: &Candidate) -> bool {
    let Surface::Torus(_) = candidate.surface else {
        return false;
    };
    let Some(mut rings) = rings(search, candidate) else {
        return false;
    };
    rings.sort_by(|a, b| a[0].total_cmp(&b[0]));
    are_mirror_pairs(&rings, apart(search))
}

/// Whether places in order of their distance from the axis are two pairs, each at one distance and both
/// about the same height.
fn are_mirror_pairs(places: &[Place], tolerance: f64) -> bool {
    let [a, b, c, d] = *places else {
        return false;
    };
    let is_pair = |p: Place, q: Place| (p[0] - q[0]).abs() <= tolerance;
    is_pair(a, b) && is_pair(c, d) && (a[1] + b[1] - c[1] - d[1]).abs() <= 2.0 * tolerance
}

/// Distance within which points are in one row.
fn apart(search: &Search<'_>) -> f64 {
    4.0 * search.scale.tolerance
}

/// The rings about the axis of a candidate that its points are in; `None` without an axis, or where
/// they are too many.
fn rings(search: &Search<'_>, candidate: &Candidate) -> Option<Vec<Place>> {
    let axis = KnownAxis::of(&candidate.surface)?;
    let places = candidate.support.iter().map(|&index| {
        let place = axis.profile(search.point(index));
        [place.radius, place.height]
    });
    fullest(places, apart(search))
}

/// Where points appear in the plane across a direction.
fn seen_along(direction: &Direction) -> impl Fn(&Point) -> Place {
    let plan = Plan::new(Point::origin(), *direction);
    move |point| plan.place(point)
}

/// How many of [`fullest`] there are, up to [`MANY`].
fn count(places: impl Iterator<Item = Place>, tolerance: f64) -> usize {
    fullest(places, tolerance).map_or(MANY, |rows| rows.len().min(MANY))
}

/// The places, the fullest first, that hold nearly all points: a few stray points make no row. `None`
/// where points are in no rows.
fn fullest(places: impl Iterator<Item = Place>, tolerance: f64) -> Option<Vec<Place>> {
    let mut rows: Vec<(Place, usize)> = Vec::new();
    let mut all = 0;
    for place in places {
        all += 1;
        let known = rows
            .iter()
            .position(|(row, _)| profile::apart(*row, place) <= tolerance);
        match known {
            Some(row) => rows[row].1 += 1,
            None if rows.len() < MOST_ROWS => rows.push((place, 1)),
            None => return None,
        }
    }
    rows.sort_by_key(|&(_, members)| std::cmp::Reverse(members));
    let mut held = 0;
    let needed = rows.iter().position(|(_, members)| {
        held += members;
        held as f64 >= NEARLY_ALL * all as f64
    });
    rows.truncate(needed.map_or(0, |last| last + 1));
    Some(rows.into_iter().map(|(place, _)| place).collect())
}

/// Whether all places lie on two lines. One of the lines holds two of any three places.
fn is_two_lines(places: &[Place], tolerance: f64) -> bool {
    let [a, b, c] = match places {
        [a, .., c] if places.len() > 2 => [*a, places[places.len() / 2], *c],
        _ => return true,
    };
    let pairs = [(a, b), (b, c), (a, c)];
    // Through equal places there is no line.
    pairs.into_iter().filter(|(p, q)| p != q).any(|(p, q)| {
        let off: Vec<Place> = places
            .iter()
            .copied()
            .filter(|&place| distance(p, q, place) > tolerance)
            .collect();
        match off[..] {
            [] | [_] => true,
            [first, .., last] => {
                let is_on =
                    |&place: &Place| place == first || distance(first, last, place) <= tolerance;
                off.iter().all(is_on)
            }
        }
    })
}

/// Distance of a place from the line through two others.
fn distance(a: Place, b: Place, place: Place) -> f64 {
    Curve::Line(a, b).distance(place)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_of_two_lines_in_any_order_are_two_lines_and_a_third_is_too_many() {
        let line = |i: u32, row: u32| [f64::from(i) + 0.3 * f64::from(row), f64::from(row)];
        let mut places: Vec<Place> = (0..12).map(|i| line(i, i % 2)).collect();
        assert!(is_two_lines(&places, 1e-9));
        places.push(line(3, 2));
        places.push(line(5, 2));
        assert!(!is_two_lines(&places, 1e-9));
    }

    #[test]
    fn places_are_counted_once() {
        let places = [[0.0, 0.0], [1.0, 0.0], [1.0, 1e-12], [0.0, 0.0]];
        assert_eq!(count(places.into_iter(), 1e-9), 2);
        let rows = (0..60).map(|i| [f64::from(i % 3), 0.0]);
        let stray = (0..4).map(|i| [0.5, f64::from(i)]);
        assert_eq!(count(rows.chain(stray), 1e-9), 3);
    }

    #[test]
    fn corners_of_a_rectangle_are_mirror_pairs_and_rings_of_a_fillet_are_not() {
        let rectangle = [[2.0, 0.0], [2.0, 1.0], [3.0, 1.0], [3.0, 0.0]];
        assert!(are_mirror_pairs(&rectangle, 1e-9));
        let trapezoid = [[2.0, 0.0], [2.0, 1.0], [3.0, 1.5], [3.0, -0.5]];
        assert!(are_mirror_pairs(&trapezoid, 1e-9));
        let fillet = [0.0f64, 0.5, 1.0, 1.5].map(|angle| [3.0 - angle.cos(), angle.sin()]);
        assert!(!are_mirror_pairs(&fillet, 1e-9));
        assert!(!are_mirror_pairs(&rectangle[..3], 1e-9));
    }
}
