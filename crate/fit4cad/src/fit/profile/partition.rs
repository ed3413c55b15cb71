//! The partition of a profile into lines and arcs that takes the fewest words to describe.
//!
//! Any two places are on a line and any three on a circle, so what a few rulings lie on proves
//! nothing by itself; but a whole profile is described by few pieces in one way only. The shortest
//! description (minimum description length, Rissanen 1978) is found by dynamic programming along the
//! profile (Bellman 1961).

use super::recurring::Recurring;
use crate::fit::thin::profile::{Curve, Place, apart, circumcircle};

/// A piece of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Positions of its first and last place.
    pub ends: [usize; 2],
    /// Its curve.
    pub curve: Curve,
}

/// Words, in quarters of a number: the end of a piece, which two numbers tell.
const END: u32 = 8;
/// A place within a piece that divides it unevenly.
const WITHIN: u32 = 4;
/// A radius.
const RADIUS: u32 = 4;
/// A radius that other arcs have.
const RECURRING: u32 = 1;
/// That a piece begins, and its family.
const BEGIN: u32 = 2;
/// Relative difference of equal lengths.
const EQUAL: f64 = 1e-3;
/// Widest angle between neighbours on an arc, in radians: little more than a quarter turn.
const STEP: f64 = 1.75;
/// Most places of a piece.
const LONGEST: usize = 400;

/// The partition of places in order. An arc of a recurring circle is told by its number, an arc of a
/// recurring radius by less than another. O(places × those of the longest piece squared).
pub fn partition(places: &[Place], tolerance: f64, recurring: &Recurring) -> Vec<Piece> {
    // The shortest description up to each place, and its last piece.
    let mut best: Vec<(u32, Option<Piece>)> = vec![(u32::MAX, None); places.len()];
    if let Some(first) = best.first_mut() {
        first.0 = 0;
    }
    for first in 0..places.len() {
        let before = best[first].0;
        let furthest = places.len().min(first + LONGEST);
        for last in first + 1..furthest {
            let run = &places[first..=last];
            let mut found = false;
            let curves = [
                recurring_arc(run, recurring),
                line(run, tolerance),
                arc(run, tolerance),
            ];
            for curve in curves.into_iter().flatten() {
                found = true;
                let length = length(run, &curve, recurring);
                let piece = Piece {
                    ends: [first, last],
                    curve,
                };
                let length = before.saturating_add(length);
                if length < best[last].0 {
                    best[last] = (length, Some(piece));
                }
            }
            // Parts of a line or arc are one.
            if !found {
                break;
            }
        }
    }
    let mut pieces = Vec::new();
    let mut at = places.len().saturating_sub(1);
    while let Some((_, Some(piece))) = best.get(at) {
        pieces.push(*piece);
        at = piece.ends[0];
    }
    pieces.reverse();
    pieces
}

/// Length of the description of a piece.
fn length(run: &[Place], curve: &Curve, recurring: &Recurring) -> u32 {
    let inside = run.len().saturating_sub(2) as u32;
    let radius = match *curve {
        Curve::Line(..) => 0,
        Curve::Circle(centre, radius) if recurring.has(centre, radius) => 0,
        Curve::Circle(_, radius) if recurring.has_radius(radius) => RECURRING,
        Curve::Circle(..) => RADIUS,
    };
    let within = if is_even(run) { 0 } else { WITHIN };
    BEGIN + END + radius + inside * within
}

/// The arc of a recurring circle through places in order.
fn recurring_arc(run: &[Place], recurring: &Recurring) -> Option<Curve> {
    let curve = recurring.through(run)?;
    let Curve::Circle(centre, _) = curve else {
        return None;
    };
    goes_around(run, centre).then_some(curve)
}

/// Whether places are equally far apart, as a mesher divides the edges of a face.
fn is_even(run: &[Place]) -> bool {
    let steps = || run.windows(2).map(|pair| apart(pair[0], pair[1]));
    let longest = steps().fold(0.0, f64::max);
    steps().all(|step| step >= (1.0 - EQUAL) * longest)
}

/// The line through places in order.
fn line(run: &[Place], tolerance: f64) -> Option<Curve> {
    let [a, .., b] = *run else {
        return None;
    };
    let curve = Curve::Line(a, b);
    let along = |p: Place| (p[0] - a[0]) * (b[0] - a[0]) + (p[1] - a[1]) * (b[1] - a[1]);
    let is_ahead = run.windows(2).all(|pair| along(pair[0]) < along(pair[1]));
    let is_on = run[1..run.len() - 1]
        .iter()
        .all(|&place| curve.distance(place) <= tolerance);
    (is_ahead && is_on).then_some(curve)
}

/// The arc through three or more places in order.
fn arc(run: &[Place], tolerance: f64) -> Option<Curve> {
    let third = run.len() / 3;
    let [first, .., last] = *run else {
        return None;
    };
    let (middle, last) = if apart(first, last) <= tolerance {
        (run[third], run[2 * third])
    } else {
        (run[run.len() / 2], last)
    };
    if run.len() < 3 || line(run, 4.0 * tolerance).is_some() {
        return None;
    }
    let curve = circumcircle(first, middle, last)?;
    let Curve::Circle(centre, _) = curve else {
        return None;
    };
    let is_on = run.iter().all(|&place| curve.distance(place) <= tolerance);
    (is_on && goes_around(run, centre)).then_some(curve)
}

/// Whether places follow each other around a centre in short steps.
fn goes_around(run: &[Place], centre: Place) -> bool {
    let angle = |pair: &[Place]| {
        let (a, b) = (from(centre, pair[0]), from(centre, pair[1]));
        libm::atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1])
    };
    let side = angle(&run[..2]).signum();
    run.windows(2)
        .all(|pair| (0.0..STEP).contains(&(side * angle(pair))))
}

fn from(centre: Place, place: Place) -> Place {
    [place[0] - centre[0], place[1] - centre[1]]
}

#[cfg(test)]
pub mod tests {
    use super::*;

    /// A profile that starts eastward at the origin: lines by their length, arcs by radius and angle,
    /// divided into so many steps.
    pub fn profile(pieces: &[(f64, f64, u32)]) -> Vec<Place> {
        let (mut at, mut heading) = ([0.0f64, 0.0f64], 0.0f64);
        let mut places = vec![at];
        for &(size, turn, steps) in pieces {
            let step = turn / f64::from(steps);
            let chord = if turn == 0.0 {
                size / f64::from(steps)
            } else {
                2.0 * size * (0.5 * step).sin().abs()
            };
            for _ in 0..steps {
                let way = heading + 0.5 * step;
                at = [at[0] + chord * way.cos(), at[1] + chord * way.sin()];
                heading += step;
                places.push(at);
            }
        }
        places
    }

    fn ends(pieces: &[Piece]) -> Vec<[usize; 2]> {
        pieces.iter().map(|piece| piece.ends).collect()
    }

    #[test]
    fn grooves_of_three_rulings_are_told_apart_by_their_line_and_arcs() {
        // Line, fillet, wall arc, bottom: one groove of a comb and half the next.
        let groove = [
            (2.1, 0.0, 2),
            (0.9, -0.96, 2),
            (5.6, -0.37, 2),
            (3.0, 2.66, 8),
            (5.6, -0.37, 2),
            (0.9, -0.96, 2),
        ];
        let places = profile(&[groove, groove].concat());
        let pieces = partition(&places, 1e-9, &Recurring::default());
        let mut borders = vec![0];
        for (_, _, steps) in [groove, groove].concat() {
            borders.push(borders.last().unwrap() + steps as usize);
        }
        let expected: Vec<[usize; 2]> = borders.windows(2).map(|it| [it[0], it[1]]).collect();
        assert_eq!(ends(&pieces), expected);
        for (piece, &(size, turn, _)) in pieces.iter().zip([groove, groove].as_flattened()) {
            match piece.curve {
                Curve::Line(..) => assert_eq!(turn, 0.0),
                Curve::Circle(_, radius) => assert!((radius - size).abs() < 1e-9),
            }
        }
    }

    #[test]
    fn two_places_are_on_a_line_unless_a_circle_recurs_there() {
        let places = profile(&[(4.0, 0.5, 1)]);
        let line = partition(&places, 1e-9, &Recurring::default());
        assert!(matches!(
            line[..],
            [Piece {
                curve: Curve::Line(..),
                ..
            }]
        ));
        let circle = Curve::Circle([0.0, 4.0], 4.0);
        let recurring = Recurring::of(&[circle], &[], 1e-9);
        let arc = partition(&places, 1e-9, &recurring);
        assert_eq!(
            arc,
            [Piece {
                ends: [0, 1],
                curve: circle
            }]
        );
    }

    #[test]
    fn a_whole_circle_is_one_piece() {
        let places = profile(&[(2.0, std::f64::consts::TAU, 12)]);
        let pieces = partition(&places, 1e-9, &Recurring::default());
        assert_eq!(ends(&pieces), [[0, 12]]);
    }

    #[test]
    fn no_places_have_no_pieces() {
        assert_eq!(partition(&[], 1e-9, &Recurring::default()), []);
        assert_eq!(partition(&[[0.0, 0.0]], 1e-9, &Recurring::default()), []);
    }
}
