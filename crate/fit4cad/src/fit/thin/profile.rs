//! Profiles: the plane curves that sweep out surfaces.
//!
//! CAD faces are extruded along a direction or turned about an axis. Seen along the direction, or in
//! the half-plane of the axis, a ruling or ring of points falls on one place, and a face is a line
//! or circle through a few places, however few points there are.

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
                across.abs() / (run * run + rise * rise).sqrt()
            }
            Self::Circle(centre, radius) => (apart(place, centre) - radius).abs(),
        }
    }

    /// Whether a place is within a tolerance of the curve.
    fn holds(&self, place: Place, tolerance: f64) -> bool {
        match *self {
            Self::Line(a, b) => {
                let (run, rise) = (b[0] - a[0], b[1] - a[1]);
                let across = run * (place[1] - a[1]) - rise * (place[0] - a[0]);
                across * across <= tolerance * tolerance * (run * run + rise * rise)
            }
            Self::Circle(..) => self.distance(place) <= tolerance,
        }
    }
}

/// Distance between two places. Not by `hypot`, which took a third of the time of clouds with many
/// borders: no length here is near the ends of the range of numbers.
pub fn apart(a: Place, b: Place) -> f64 {
    squared(a, b).sqrt()
}

fn squared(a: Place, b: Place) -> f64 {
    let (x, y) = (a[0] - b[0], a[1] - b[1]);
    x * x + y * y
}

/// Places that are told apart, in order of first appearance: a ruling or ring of points is one.
pub fn distinct(places: &[Place], tolerance: f64) -> Vec<Place> {
    let mut distinct: Vec<Place> = Vec::new();
    let same = (4.0 * tolerance).powi(2);
    for &place in places {
        if distinct.iter().all(|&other| squared(other, place) > same) {
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
    others.sort_by(|a, b| squared(*a, *first).total_cmp(&squared(*b, *first)));
    let others = &others[..others.len().min(PARTNERS)];
    let on = |curve: &Curve| {
        let near = |place: &&Place| curve.holds(**place, tolerance);
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
    let lengths = sides.map(|(p, q)| squared(p, q));
    let longest = if lengths[0] >= lengths[1] && lengths[0] >= lengths[2] {
        0
    } else if lengths[1] >= lengths[2] {
        1
    } else {
        2
    };
    let (p, q) = sides[longest];
    let line = Curve::Line(p, q);
    if line.holds([a, b, c][longest], tolerance) {
        return line;
    }
    circumcircle(a, b, c).unwrap_or(line)
}

/// The circle through three places; `None` where they are on one line.
pub fn circumcircle(a: Place, b: Place, c: Place) -> Option<Curve> {
    let (bx, by) = (b[0] - a[0], b[1] - a[1]);
    let (cx, cy) = (c[0] - a[0], c[1] - a[1]);
    let (bb, cc) = (bx * bx + by * by, cx * cx + cy * cy);
    let area = 2.0 * (bx * cy - by * cx);
    let (x, y) = ((cy * bb - by * cc) / area, (bx * cc - cx * bb) / area);
    let radius = (x * x + y * y).sqrt();
    radius
        .is_finite()
        .then(|| Curve::Circle([a[0] + x, a[1] + y], radius))
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
