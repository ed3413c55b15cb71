//! Profiles: the plane curves that sweep out surfaces.
//!
//! CAD faces are extruded along a direction or turned about an axis. Seen along the direction, or in
//! the half-plane of the axis, a ruling or ring of points falls on one place, and a face is a line
//! or circle through a few places, however few points there are.

use super::curve::circle;

/// A place in the plane of a profile.
pub type Place = [f64; 2];

/// A line or circle of a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Curve {
    /// The line through two places.
    Line(Place, Place),
    /// A circle by its centre and radius.
    Circle(Place, f64),
}

impl Curve {
    /// Distance of a place from the curve.
    pub fn distance(&self, place: Place) -> f64 {
        match *self {
            Self::Line(a, b) => {
                let (run, rise) = (b[0] - a[0], b[1] - a[1]);
                let across = run * (place[1] - a[1]) - rise * (place[0] - a[0]);
                across.abs() / run.hypot(rise)
            }
            Self::Circle(centre, radius) => (apart(place, centre) - radius).abs(),
        }
    }
}

/// Distance between two places.
pub fn apart(a: Place, b: Place) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// Places that are told apart, in order of first appearance: a ruling or ring of points is one.
pub fn distinct(places: &[Place], tolerance: f64) -> Vec<Place> {
    let mut distinct: Vec<Place> = Vec::new();
    for &place in places {
        if distinct
            .iter()
            .all(|&other| apart(other, place) > 4.0 * tolerance)
        {
            distinct.push(place);
        }
    }
    distinct
}

/// Nearest places that a curve through the first is tried with.
const PARTNERS: usize = 6;
/// Points that must lie on a curve.
const AGREEING: usize = 6;

/// The curves through the first place and others near it that most points lie on: the best circle
/// or line through three rows of points, and the line to the nearest other row.
pub fn curves(places: &[Place], tolerance: f64) -> Vec<Curve> {
    let mut rows = distinct(places, tolerance);
    let Some((first, others)) = rows.split_first_mut() else {
        return Vec::new();
    };
    others.sort_by(|a, b| apart(*a, *first).total_cmp(&apart(*b, *first)));
    let others = &others[..others.len().min(PARTNERS)];
    let on = |curve: &Curve| {
        let near = |place: &&Place| curve.distance(**place) <= tolerance;
        places.iter().filter(near).count()
    };
    let mut best: Option<(usize, Curve)> = None;
    for (j, &b) in others.iter().enumerate() {
        for &a in &others[..j] {
            let curve = through(*first, a, b, tolerance);
            let count = on(&curve);
            if best.is_none_or(|(most, _)| count > most) {
                best = Some((count, curve));
            }
        }
    }
    let strip = others.first().map(|&nearest| {
        let line = Curve::Line(*first, nearest);
        (on(&line), line)
    });
    best.into_iter()
        .chain(strip)
        .filter(|(count, _)| *count >= AGREEING)
        .map(|(_, curve)| curve)
        .collect()
}

/// The line through three places, or else their circle.
fn through(a: Place, b: Place, c: Place, tolerance: f64) -> Curve {
    let sides = [(b, c), (a, c), (a, b)];
    let lengths = sides.map(|(p, q)| apart(p, q));
    let longest = if lengths[0] >= lengths[1] && lengths[0] >= lengths[2] {
        0
    } else if lengths[1] >= lengths[2] {
        1
    } else {
        2
    };
    let (p, q) = sides[longest];
    let line = Curve::Line(p, q);
    if line.distance([a, b, c][longest]) <= tolerance {
        return line;
    }
    match circle(&[a, b, c]) {
        Some((centre, radius)) => Curve::Circle(centre, radius),
        None => line,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn arc(angle: f64) -> Place {
        [2.0 + 0.5 * angle.cos(), 1.0 + 0.5 * angle.sin()]
    }

    #[test]
    fn rows_of_points_on_a_circle_give_it_among_others() {
        let mut places = Vec::new();
        for _ in 0..4 {
            places.extend([arc(0.0), arc(0.6), arc(-0.6), [3.0, 2.0]]);
        }
        let found = curves(&places, 1e-9);
        let Some(Curve::Circle(centre, radius)) = found.first() else {
            panic!("no circle in {found:?}");
        };
        assert!(apart(*centre, [2.0, 1.0]) < 1e-9 && (radius - 0.5).abs() < 1e-9);
    }

    #[test]
    fn three_rows_in_line_are_a_line() {
        let places: Vec<Place> = (0..9)
            .map(|i| [f64::from(i % 3), 2.0 * f64::from(i % 3)])
            .collect();
        assert!(matches!(curves(&places, 1e-9)[0], Curve::Line(..)));
    }

    #[test]
    fn too_few_points_have_no_curve() {
        assert!(curves(&[arc(0.0), arc(0.5), arc(1.0)], 1e-9).is_empty());
        assert!(curves(&[], 1e-9).is_empty());
    }
}
