//! Known axes of revolution.
//!
//! CAD objects are turned and drilled: a fillet or a countersink shares its axis with the cylinder
//! it runs around. Once the axis is known, a surface of revolution is a curve in the half-plane
//! (ρ, z) of distance from the axis and height along it: a line (plane, cylinder, cone) or a circle
//! (sphere, torus).

use super::profile::Curve;
use crate::cloud::{Direction, Point};
use crate::fit::axes::axis_of;
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
        let Some(axis) = KnownAxis::of(&owner.surface) else {
            continue;
        };
        if !axes.iter().any(|other| other.is_same(&axis, near)) {
            axes.push(axis);
        }
        if axes.len() == MOST_AXES {
            break;
        }
    }
    axes
}

impl KnownAxis {
    /// The axis of a surface of revolution other than a sphere.
    pub fn of(surface: &Surface) -> Option<Self> {
        let (point, direction) = axis_of(surface)?;
        Some(Self { point, direction })
    }

    /// Whether another axis is this one: equally directed, and through points at most `near` apart.
    pub fn is_same(&self, other: &Self, near: f64) -> bool {
        let sine = other.direction.cross(&self.direction).norm();
        sine < SAME_DIRECTION && self.profile(&other.point).radius < near
    }

    /// Where a point lies in the half-plane.
    pub fn profile(&self, point: &Point) -> Profile {
        let offset = point - self.point;
        let height = offset.dot(&self.direction);
        Profile {
            radius: (offset - self.direction.into_inner() * height).norm(),
            height,
        }
    }

    /// The point of the axis at a height.
    pub fn at(&self, height: f64) -> Point {
        self.point + self.direction.into_inner() * height
    }

    /// A point at a place of the half-plane.
    pub fn point_at(&self, place: &Profile) -> Point {
        self.at(place.height) + across(&self.direction).into_inner() * place.radius
    }

    /// The direction in the half-plane along which a surface of revolution about the axis runs at
    /// one of its points; `None` where it is not one.
    pub fn tangent(&self, surface: &Surface, point: &Point) -> Option<Profile> {
        let normal = surface.normal(point);
        let offset = point - self.point;
        let height = offset.dot(&self.direction);
        let outward = Direction::try_new(offset - self.direction.into_inner() * height, 0.0)?;
        let sideways = normal.dot(&self.direction.cross(&outward));
        (sideways.abs() < SAME_DIRECTION).then(|| Profile {
            radius: -normal.dot(&self.direction),
            height: normal.dot(&outward),
        })
    }

    /// The surface of revolution of a curve of the half-plane.
    pub fn turned(&self, curve: &Curve, tolerance: f64) -> Surface {
        let profile = |[radius, height]: [f64; 2]| Profile { radius, height };
        match *curve {
            Curve::Line(a, b) => self.turned_line(profile(a), profile(b), tolerance),
            Curve::Circle(centre, radius) => self.turned_circle(profile(centre), radius, tolerance),
        }
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
        Surface::Cone(Cone::new(apex, axis, libm::atan((run / rise).abs())))
    }

    /// The surface of revolution of a circle: a sphere where its centre is on the axis.
    pub fn turned_circle(&self, centre: Profile, radius: f64, tolerance: f64) -> Surface {
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
