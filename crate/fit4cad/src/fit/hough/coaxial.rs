//! Votes along known axes.
//!
//! CAD objects are turned and drilled: a fillet or a countersink shares its axis with the cylinder
//! it runs around. Once the axis is known, a surface of revolution is a curve in the half-plane
//! (ρ, z) of distance from the axis and height along it: a line (plane, cylinder, cone) or a circle
//! (sphere, torus). Few points determine these, so the axis turns neighbourhoods too small for a
//! torus of their own into votes.

use nalgebra::{Matrix3, Vector3};

use super::solutions::vote;
use super::vote::Vote;
use crate::cloud::{Direction, Point};
use crate::fit::{Candidate, Search};
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface, Torus, across};

/// A known axis of revolution.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct KnownAxis {
    /// A point of it.
    pub point: Point,
    /// Its direction.
    pub direction: Direction,
}

/// A place in the half-plane of an axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Profile {
    /// Distance from the axis.
    pub radius: f64,
    /// Height along it.
    pub height: f64,
}

/// Most axes considered; those of the largest surfaces are kept.
const MOST_AXES: usize = 48;
/// Directions closer than this, in radians, are one.
const SAME_DIRECTION: f64 = 1e-4;

/// The axes of the accepted surfaces, each once, those of the largest first.
pub fn known_axes(search: &Search<'_>) -> Vec<KnownAxis> {
    let mut owners: Vec<&Candidate> = search.accepted().iter().collect();
    owners.sort_by_key(|candidate| std::cmp::Reverse(candidate.support.len()));
    let near = 20.0 * search.scale.tolerance;
    let mut axes: Vec<KnownAxis> = Vec::new();
    for owner in owners {
        let axis = match owner.surface {
            Surface::Cylinder(Cylinder {
                centre: point,
                axis: direction,
                ..
            })
            | Surface::Cone(Cone {
                apex: point,
                axis: direction,
                ..
            })
            | Surface::Torus(Torus {
                centre: point,
                axis: direction,
                ..
            }) => KnownAxis { point, direction },
            Surface::Plane(_) | Surface::Sphere(_) => continue,
        };
        let known = axes.iter().any(|other| {
            let sine = axis.direction.cross(&other.direction).norm();
            sine < SAME_DIRECTION && other.profile(&axis.point).radius < near
        });
        if !known {
            axes.push(axis);
        }
        if axes.len() == MOST_AXES {
            break;
        }
    }
    axes
}

impl KnownAxis {
    /// Where a point lies in the half-plane.
    pub fn profile(&self, point: &Point) -> Profile {
        let offset = point - self.point;
        let height = offset.dot(&self.direction);
        Profile {
            radius: (offset - self.direction.into_inner() * height).norm(),
            height,
        }
    }

    fn at(&self, height: f64) -> Point {
        self.point + self.direction.into_inner() * height
    }

    /// The surface of revolution of the line through two places.
    pub fn turned_line(&self, a: Profile, b: Profile, tolerance: f64) -> Surface {
        let (run, rise) = (b.radius - a.radius, b.height - a.height);
        let axis = self.direction.into_inner();
        if rise.abs() <= tolerance {
            return Surface::Plane(Plane::new(self.at(0.5 * (a.height + b.height)), axis));
        }
        if run.abs() <= tolerance {
            let radius = 0.5 * (a.radius + b.radius);
            return Surface::Cylinder(Cylinder::new(self.point, axis, radius));
        }
        let apex = self.at(a.height - a.radius * rise / run);
        Surface::Cone(Cone::new(apex, axis, (run / rise).abs().atan()))
    }

    /// The surface of revolution of a circle: a sphere where its centre is on the axis.
    fn turned_circle(&self, centre: Profile, radius: f64, tolerance: f64) -> Surface {
        if centre.radius.abs() <= tolerance {
            return Surface::Sphere(Sphere::new(self.at(centre.height), radius));
        }
        let axis = self.direction.into_inner();
        Surface::Torus(Torus::new(
            self.at(centre.height),
            axis,
            centre.radius,
            radius,
        ))
    }
}

/// The votes of a neighbourhood along the known axes: surfaces of revolution that all of its points
/// lie on. O(axes × points).
pub fn coaxial_votes(
    search: &Search<'_>,
    axes: &[KnownAxis],
    index: u32,
    patch: &[u32],
    found: &mut Vec<Vote>,
) {
    let tolerance = search.scale.tolerance;
    let points = search.points(patch);
    for axis in axes {
        let places: Vec<Profile> = points.iter().map(|point| axis.profile(point)).collect();
        let Some(surface) = turned(axis, &places, tolerance) else {
            continue;
        };
        let plausible = search.is_plausible(&surface);
        if plausible
            && points
                .iter()
                .all(|p| surface.distance(p) <= 2.0 * tolerance)
        {
            found.push(vote(search, index, surface));
        }
    }
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
            cross.abs() <= tolerance * u.hypot(v)
        };
        if places.iter().all(on_line) {
            return Some(line);
        }
    }
    let (centre, radius) = circle(places)?;
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

/// The circle of least algebraic error (Kåsa, 1976): ρ² + z² = 2aρ + 2bz + c.
fn circle(places: &[Profile]) -> Option<(Profile, f64)> {
    let count = places.len() as f64;
    let mean = Profile {
        radius: places.iter().map(|place| place.radius).sum::<f64>() / count,
        height: places.iter().map(|place| place.height).sum::<f64>() / count,
    };
    let scale = places
        .iter()
        .map(|place| squared(place, &mean))
        .fold(0.0, f64::max)
        .sqrt();
    let mut matrix = Matrix3::zeros();
    let mut right = Vector3::zeros();
    for place in places {
        let (x, y) = (
            (place.radius - mean.radius) / scale,
            (place.height - mean.height) / scale,
        );
        let row = Vector3::new(2.0 * x, 2.0 * y, 1.0);
        matrix += row * row.transpose();
        right += row * (x * x + y * y);
    }
    let solution = matrix.cholesky()?.solve(&right);
    let radius = (solution[2] + solution[0].powi(2) + solution[1].powi(2)).sqrt() * scale;
    let centre = Profile {
        radius: mean.radius + solution[0] * scale,
        height: mean.height + solution[1] * scale,
    };
    (radius.is_finite() && centre.radius.is_finite()).then_some((centre, radius))
}

/// Places of a surface's circles about an axis, if it is one of revolution about it.
pub fn is_coaxial(surface: &Surface, axis: &KnownAxis, tolerance: f64) -> bool {
    let parallel = |d: &Direction| axis.direction.cross(d).norm() < SAME_DIRECTION;
    let on_axis = |p: &Point| axis.profile(p).radius <= 20.0 * tolerance;
    match surface {
        Surface::Plane(plane) => parallel(&plane.normal),
        Surface::Cylinder(s) => parallel(&s.axis) && on_axis(&s.centre),
        Surface::Cone(s) => parallel(&s.axis) && on_axis(&s.apex),
        Surface::Sphere(s) => on_axis(&s.centre),
        Surface::Torus(s) => parallel(&s.axis) && on_axis(&s.centre),
    }
}

/// Unit directions across an axis, from which a half-plane is turned.
pub fn half_plane(axis: &KnownAxis) -> Direction {
    across(&axis.direction)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;

    fn axis() -> KnownAxis {
        KnownAxis {
            point: Point::new(1.0, 2.0, 3.0),
            direction: Direction::new_normalize(Vector::new(1.0, 1.0, 0.5)),
        }
    }

    /// The profiles of points of a surface, `count` of them around the axis.
    fn profiles(surface: &Surface, count: u32) -> Vec<Profile> {
        let axis = axis();
        let out = half_plane(&axis).into_inner();
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
}
