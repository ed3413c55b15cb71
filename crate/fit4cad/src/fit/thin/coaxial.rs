//! Surfaces about known axes: few points determine a curve of the half-plane, so that with an axis
//! neighbourhoods too small for a torus of their own give one.

use super::axis::{KnownAxis, Profile};
use super::borders::Borders;
use super::curve::circle;
use crate::cloud::Point;
use crate::fit::Search;
use crate::fit::pure::agrees;
use crate::surface::Surface;

/// Free points of the neighbourhoods that [`coaxial`] is asked about, in this order.
pub const SIZES: [usize; 2] = [16, 8];
/// Fewest points of such a neighbourhood.
pub const FEWEST: usize = 6;
/// Neighbourhoods in vain, on no surface about any axis, after which no more are tried.
pub const VAIN: usize = 2000;

/// The surfaces of revolution about the known axes that all points of a neighbourhood lie on.
/// O(axes × points).
pub fn coaxial(search: &Search<'_>, axes: &[KnownAxis], patch: &[u32]) -> Vec<Surface> {
    let points = search.points(patch);
    let tolerance = search.scale.tolerance;
    about_each(search, axes, &points, |axis, places| {
        turned(axis, places, tolerance)
    })
}

/// The surfaces that each axis has for the places of some points, as far as they pass through all of
/// the points.
fn about_each(
    search: &Search<'_>,
    axes: &[KnownAxis],
    points: &[Point],
    surface: impl Fn(&KnownAxis, &[Profile]) -> Option<Surface>,
) -> Vec<Surface> {
    let tolerance = 2.0 * search.scale.tolerance;
    let through = |axis: &KnownAxis| {
        let places: Vec<Profile> = points.iter().map(|point| axis.profile(point)).collect();
        let surface = surface(axis, &places)?;
        let is_found = search.is_plausible(&surface) && agrees(&surface, points, tolerance);
        is_found.then_some(surface)
    };
    axes.iter().filter_map(through).collect()
}

/// Places that are told apart count once: a ring of points about the axis is one place.
fn distinct(places: &[Profile], tolerance: f64) -> Vec<Profile> {
    let mut distinct: Vec<Profile> = Vec::new();
    for place in places {
        let known = distinct.iter().any(|other| {
            (other.radius - place.radius)
                .abs()
                .max((other.height - place.height).abs())
                <= 4.0 * tolerance
        });
        if !known {
            distinct.push(*place);
        }
    }
    distinct
}

/// The line through at least three distinct places, or the circle through at least four.
fn turned(axis: &KnownAxis, places: &[Profile], tolerance: f64) -> Option<Surface> {
    // Most axes have nothing to do with a neighbourhood; a few places show it.
    let few = distinct(&places[..places.len().min(6)], tolerance);
    if let [a, b, c, ..] = few[..] {
        let span = [(a, b), (b, c), (a, c)]
            .into_iter()
            .max_by(|(p, q), (r, s)| squared(p, q).total_cmp(&squared(r, s)));
        let (a, b) = span?;
        let line = axis.turned_line(a, b, tolerance);
        let on_line = |place: &Profile| {
            let (u, v) = (b.radius - a.radius, b.height - a.height);
            let cross = u * (place.height - a.height) - v * (place.radius - a.radius);
            cross.abs() <= tolerance * libm::hypot(u, v)
        };
        if places.iter().all(on_line) {
            return Some(line);
        }
    }
    let flat: Vec<[f64; 2]> = places
        .iter()
        .map(|place| [place.radius, place.height])
        .collect();
    let ([at, height], radius) = circle(&flat)?;
    let centre = Profile { radius: at, height };
    let on_circle = |place: &Profile| {
        let (x, y) = (place.radius - centre.radius, place.height - centre.height);
        ((x * x + y * y).sqrt() - radius).abs() <= tolerance
    };
    let agreed = places.iter().all(on_circle) && distinct(places, tolerance).len() >= 4;
    agreed.then(|| axis.turned_circle(centre, radius, tolerance))
}

fn squared(a: &Profile, b: &Profile) -> f64 {
    (a.radius - b.radius).powi(2) + (a.height - b.height).powi(2)
}

/// The surfaces of revolution about the known axes through a neighbourhood that may be mixed: circles
/// and lines through the place of its first point and two others that many of its places lie on.
/// O(axes × points).
pub fn mixed_coaxial(search: &Search<'_>, axes: &[KnownAxis], patch: &[u32]) -> Vec<Surface> {
    let mut found = Vec::new();
    let tolerance = search.scale.tolerance;
    let points = search.points(patch);
    for axis in axes {
        let places: Vec<Profile> = points.iter().map(|point| axis.profile(point)).collect();
        let places = distinct(&places, tolerance);
        let needed = AGREEING.max(places.len() / 2);
        let near = &places[..places.len().min(PARTNERS)];
        let [seed, partners @ ..] = near else {
            continue;
        };
        let pairs = (1..partners.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let best = pairs
            .filter_map(|(i, j)| {
                let triple = [*seed, partners[i], partners[j]];
                let surface = turned_triple(axis, &triple, tolerance)?;
                let on = |place: &&Profile| surface.distance(&axis.point_at(place)) <= tolerance;
                Some((places.iter().filter(on).count(), surface))
            })
            .max_by_key(|(count, _)| *count);
        if let Some((count, surface)) = best
            && count >= needed
            && search.is_plausible(&surface)
        {
            found.push(surface);
        }
    }
    found
}

/// Distinct places that must agree where a neighbourhood may be mixed.
const AGREEING: usize = 7;
/// Nearest places that a curve through the first is tried with.
const PARTNERS: usize = 7;

/// The surface of revolution through three places: of a line if they are on one, else of a circle.
fn turned_triple(axis: &KnownAxis, triple: &[Profile; 3], tolerance: f64) -> Option<Surface> {
    let flat = triple.map(|place| [place.radius, place.height]);
    let (a, b) = farthest(triple)?;
    match circle(&flat) {
        Some(([radius, height], size)) => {
            Some(axis.turned_circle(Profile { radius, height }, size, tolerance))
        }
        None => Some(axis.turned_line(a, b, tolerance)),
    }
}

/// The surfaces of revolution about the known axes through a neighbourhood of free points whose rings
/// are so few that lines and circles through them prove nothing by themselves. A circle must be
/// tangent to the surfaces it blends at both ends; a line must join rings of two surfaces.
pub fn rings(
    search: &Search<'_>,
    borders: &Borders,
    axes: &[KnownAxis],
    patch: &[u32],
) -> Vec<Surface> {
    let points = search.points(patch);
    let tolerance = search.scale.tolerance;
    about_each(search, axes, &points, |axis, places| {
        let rings = distinct(places, tolerance);
        if !(2..=4).contains(&rings.len()) || 2 * rings.len() > places.len() {
            return None;
        }
        // The two rings farthest apart are the borders.
        let (a, b) = farthest(&rings)?;
        let slope = |ring: &Profile| -> Option<Profile> {
            let at = places
                .iter()
                .position(|place| squared(place, ring) <= 64.0 * tolerance.powi(2))?;
            let owner = &search.accepted()[borders.owner(patch[at])? as usize];
            axis.tangent(&owner.surface, &points[at])
        };
        Some(match blend(a, b, slope(&a), slope(&b)) {
            // Two rings may be a fillet or a chamfer with equal legs: the simpler one.
            Some((centre, radius)) if rings.len() > 2 => {
                axis.turned_circle(centre, radius, tolerance)
            }
            _ => axis.turned_line(a, b, tolerance),
        })
    })
}

fn farthest(rings: &[Profile]) -> Option<(Profile, Profile)> {
    let pairs = rings
        .iter()
        .enumerate()
        .flat_map(|(i, a)| rings[..i].iter().map(move |b| (*a, *b)));
    pairs.max_by(|(p, q), (r, s)| squared(p, q).total_cmp(&squared(r, s)))
}

/// The circle through two places that is tangent to both directions there; `None` where there is
/// none, or only a line.
fn blend(
    a: Profile,
    b: Profile,
    at_a: Option<Profile>,
    at_b: Option<Profile>,
) -> Option<(Profile, f64)> {
    /// Largest departure from tangency, in radians.
    const TANGENT: f64 = 2e-3;
    let (at_a, at_b) = (at_a?, at_b?);
    let chord = Profile {
        radius: b.radius - a.radius,
        height: b.height - a.height,
    };
    let length = (chord.radius.powi(2) + chord.height.powi(2)).sqrt();
    let sine = |t: &Profile| (chord.radius * t.height - chord.height * t.radius) / length;
    let cosine = |t: &Profile| (chord.radius * t.radius + chord.height * t.height) / length;
    // The tangent-chord angle, lines having no direction.
    let angle = |t: &Profile| libm::atan(sine(t) / cosine(t));
    let (first, second) = (angle(&at_a), angle(&at_b));
    if (first + second).abs() > TANGENT || first.abs() < 10.0 * TANGENT {
        return None;
    }
    // The centre is on the normal at a; the chord subtends twice the tangent-chord angle.
    let radius = 0.5 * length / libm::sin(first).abs();
    let (middle_r, middle_h) = (0.5 * (a.radius + b.radius), 0.5 * (a.height + b.height));
    let rise = 0.5 * length / libm::tan(first);
    let centre = Profile {
        radius: middle_r + chord.height / length * rise,
        height: middle_h - chord.radius / length * rise,
    };
    Some((centre, radius))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::{Direction, Vector};
    use crate::surface::{Cone, Cylinder, Plane, Sphere, Torus, across};

    fn axis() -> KnownAxis {
        KnownAxis {
            point: Point::new(1.0, 2.0, 3.0),
            direction: Direction::new_normalize(Vector::new(1.0, 1.0, 0.5)),
        }
    }

    /// The profiles of points of a surface, `count` of them around the axis.
    fn profiles(surface: &Surface, count: u32) -> Vec<Profile> {
        let axis = axis();
        let out = across(&axis.direction).into_inner();
        (0..count)
            .map(|i| {
                let t = f64::from(i) * 0.05;
                let probe = axis.at(0.2 + t) + out * (0.9 - 0.3 * t);
                axis.profile(&surface.foot(&probe))
            })
            .collect()
    }

    #[test]
    fn profiles_of_every_surface_of_revolution_give_it_back() {
        let KnownAxis { point, direction } = axis();
        let d = direction.into_inner();
        for surface in [
            Surface::Plane(Plane::new(point + d, d)),
            Surface::Cylinder(Cylinder::new(point, d, 0.8)),
            Surface::Cone(Cone::new(point - d, d, 0.5)),
            Surface::Sphere(Sphere::new(point + d * 0.2, 0.9)),
            Surface::Torus(Torus::new(point + d * 0.3, d, 1.0, 0.25)),
        ] {
            let places = profiles(&surface, 9);
            let found = turned(&axis(), &places, 1e-9).unwrap();
            assert_eq!(found.kind(), surface.kind());
            for probe in [Point::new(1.5, 2.0, 3.0), Point::new(0.0, 2.5, 4.0)] {
                assert!((found.distance(&probe) - surface.distance(&probe)).abs() < 1e-7);
            }
        }
    }

    #[test]
    fn three_rings_of_points_are_no_evidence_of_a_circle() {
        let torus = Surface::Torus(Torus::new(
            axis().point,
            axis().direction.into_inner(),
            1.0,
            0.25,
        ));
        let three = profiles(&torus, 3);
        let repeated = [three.clone(), three].concat();
        assert_eq!(turned(&axis(), &repeated, 1e-9), None);
    }

    #[test]
    fn a_fillet_of_two_rings_is_the_circle_tangent_to_both_faces() {
        let corner = |radius: f64, height: f64| Profile { radius, height };
        // From the plane z = 0 up a cylinder of radius 2: centre (1.5, 0.5), radius 0.5.
        let (floor, wall) = (corner(1.5, 0.0), corner(2.0, 0.5));
        let (along, up) = (corner(1.0, 0.0), corner(0.0, 1.0));
        let (centre, radius) = blend(floor, wall, Some(along), Some(up)).unwrap();
        assert!((radius - 0.5).abs() < 1e-12);
        assert!(squared(&centre, &corner(1.5, 0.5)) < 1e-20);
        // A chamfer of other proportions is tangent to nothing.
        assert_eq!(blend(floor, corner(2.0, 0.8), Some(along), Some(up)), None);
    }
}
