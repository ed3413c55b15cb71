//! A face: one segment of an outline swept through space, or an outline at either end of its way.

use nalgebra::{Point2, Vector2};

use super::super::blocks::{Placement, Segment, Sweep};
use super::solid::Placed;
use crate::cloud::{Bounds, Point, Vector};
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface, Torus};

/// Coordinates on a face: arc length along the segment and sweep, or the outline's plane.
pub type Chart = [f64; 2];

/// A face of one solid, before the others have their say.
#[derive(Debug, Clone)]
pub struct Face {
    /// Index of its solid.
    pub solid: usize,
    pub kind: Kind,
    /// The surface it is a patch of; none if it is free-form.
    pub surface: Option<Surface>,
    /// Faces of one surface share a number.
    pub carrier: usize,
    /// +1 where the gradient of the offset points out of the solid, else -1.
    pub outward: f64,
    /// Box around it.
    pub bounds: Bounds,
    /// The solids that may reach it, its own among them, in order.
    pub near: Vec<usize>,
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// The swept segment of that index.
    Side(usize),
    /// The outline after that sweep.
    Cap(f64),
}

/// Where a point stands to the carrier of a face.
#[derive(Debug, Clone, Copy)]
pub struct FaceFoot {
    pub chart: Chart,
    /// Signed distance.
    pub offset: f64,
    /// Its unit gradient.
    pub gradient: Vector,
}

/// The rectangle of a face's coordinates.
#[derive(Debug, Clone, Copy)]
pub struct Domain {
    pub low: Chart,
    pub high: Chart,
    /// Whether a coordinate returns to its start.
    pub closed: [bool; 2],
}

impl Face {
    pub fn new(solid: usize, placed: &Placed, kind: Kind) -> Option<Self> {
        let surface = match kind {
            Kind::Cap(sweep) => {
                let origin = placed.place(&Point2::origin(), sweep);
                Some(Surface::Plane(Plane::new(origin, placed.heading(sweep))))
            }
            Kind::Side(segment) => {
                let segment = placed.segments.get(segment)?;
                let [a, b] = segment.ends();
                let on_axis = a.x.abs().max(b.x.abs()) <= 1e-12 * (a - b).norm();
                let line = matches!(segment, Segment::Line { .. });
                if matches!(placed.sweep, Sweep::Revolve { .. }) && line && on_axis {
                    return None;
                }
                surface(segment, placed.sweep, placed.placement)
            }
        };
        let mut face = Self {
            solid,
            kind,
            surface,
            carrier: 0,
            outward: 1.0,
            bounds: Bounds::EMPTY,
            near: Vec::new(),
        };
        face.outward = face.orientation(placed);
        let Domain { low, high, .. } = face.domain(placed);
        for (i, j) in (0..=24).flat_map(|i| (0..=24).map(move |j| (i, j))) {
            let at = |k: usize, step: i32| low[k] + (high[k] - low[k]) * f64::from(step) / 24.0;
            face.bounds.add(&face.point(placed, [at(0, i), at(1, j)]));
        }
        let margin = Vector::repeat(0.05 * face.bounds.diagonal());
        face.bounds.min -= margin;
        face.bounds.max += margin;
        Some(face)
    }

    /// Found by a step aside from the middle of the segment.
    fn orientation(&self, placed: &Placed) -> f64 {
        match self.kind {
            Kind::Cap(sweep) => {
                if sweep > 0.0 {
                    1.0
                } else {
                    -1.0
                }
            }
            Kind::Side(segment) => {
                let segment = &placed.segments[segment];
                let middle = segment.at(segment.length() * 0.437);
                let aside = segment.foot(&middle).normal * (segment.length() * 1e-6);
                if placed.encloses(&(middle + aside)) {
                    -1.0
                } else {
                    1.0
                }
            }
        }
    }

    pub fn foot(&self, placed: &Placed, point: &Point) -> FaceFoot {
        match self.kind {
            Kind::Side(segment) => {
                let (outline, sweep) = placed.locate(point);
                let foot = placed.segments[segment].foot(&outline);
                FaceFoot {
                    chart: [foot.along, sweep],
                    offset: foot.offset,
                    gradient: placed.lift(&foot.normal, sweep),
                }
            }
            Kind::Cap(sweep) => {
                let gradient = placed.heading(sweep);
                let origin = placed.place(&Point2::origin(), sweep);
                let abscissa = placed.lift(&Vector2::x(), sweep);
                let ordinate = placed.lift(&Vector2::y(), sweep);
                let offset = point - origin;
                FaceFoot {
                    chart: [offset.dot(&abscissa), offset.dot(&ordinate)],
                    offset: offset.dot(&gradient),
                    gradient,
                }
            }
        }
    }

    pub fn point(&self, placed: &Placed, chart: Chart) -> Point {
        match self.kind {
            Kind::Side(segment) => placed.place(&placed.segments[segment].at(chart[0]), chart[1]),
            Kind::Cap(sweep) => placed.place(&chart.into(), sweep),
        }
    }

    /// Unit normal out of the solid.
    pub fn normal(&self, placed: &Placed, chart: Chart) -> Vector {
        let gradient = match self.kind {
            Kind::Side(segment) => {
                let segment = &placed.segments[segment];
                placed.lift(&segment.foot(&segment.at(chart[0])).normal, chart[1])
            }
            Kind::Cap(sweep) => placed.heading(sweep),
        };
        gradient * self.outward
    }

    /// Length per unit of the second coordinate.
    pub fn pace(&self, placed: &Placed, along: f64) -> f64 {
        match self.kind {
            Kind::Side(segment) => placed.pace(&placed.segments[segment].at(along)),
            Kind::Cap(_) => 1.0,
        }
    }

    /// The most that [`pace`](Self::pace) is anywhere on the face.
    pub fn widest_pace(&self, placed: &Placed) -> f64 {
        let (low, high) = placed.frame();
        match self.kind {
            Kind::Side(_) => placed.pace(&low).max(placed.pace(&high)),
            Kind::Cap(_) => 1.0,
        }
    }

    pub fn domain(&self, placed: &Placed) -> Domain {
        match self.kind {
            Kind::Side(segment) => Domain {
                low: [0.0; 2],
                high: [placed.segments[segment].length(), placed.span()],
                closed: [placed.segments[segment].is_closed(), placed.is_closed()],
            },
            Kind::Cap(_) => {
                let (low, high) = placed.frame();
                Domain {
                    low: low.into(),
                    high: high.into(),
                    closed: [false; 2],
                }
            }
        }
    }

    /// Whether the face, before the others have their say, holds the point of its carrier.
    pub fn holds(&self, placed: &Placed, chart: Chart, slack: f64) -> bool {
        match self.kind {
            Kind::Side(_) => {
                let domain = self.domain(placed);
                let slack = [slack, slack / self.pace(placed, chart[0]).max(slack)];
                (0..2).all(|k| {
                    let range = domain.low[k] - slack[k]..=domain.high[k] + slack[k];
                    domain.closed[k] || range.contains(&chart[k])
                })
            }
            Kind::Cap(_) => placed.encloses(&chart.into()),
        }
    }
}

/// The surface a swept segment lies on; none for a free-form curve.
fn surface(segment: &Segment, sweep: Sweep, placement: Placement) -> Option<Surface> {
    const NEGLIGIBLE: f64 = 1e-12;
    let axis = placement.axes[2];
    let on_axis = |height: f64| placement.to_world(&Point::new(0.0, 0.0, height));
    Some(match (segment, sweep) {
        (Segment::Curve(_), _) => return None,
        (
            Segment::Line {
                from, direction, ..
            },
            Sweep::Extrude { .. },
        ) => {
            let normal = Vector::new(direction.y, -direction.x, 0.0);
            let origin = placement.to_world(&Point::new(from.x, from.y, 0.0));
            Surface::Plane(Plane::new(origin, placement.vector_to_world(&normal)))
        }
        (Segment::Arc(arc), Sweep::Extrude { .. }) => {
            let centre = Point::new(arc.centre.x, arc.centre.y, 0.0);
            Surface::Cylinder(Cylinder::new(placement.to_world(&centre), axis, arc.radius))
        }
        (
            Segment::Line {
                from, direction, ..
            },
            Sweep::Revolve { .. },
        ) => {
            if direction.y.abs() < NEGLIGIBLE {
                Surface::Plane(Plane::new(on_axis(from.y), axis))
            } else if direction.x.abs() < NEGLIGIBLE {
                Surface::Cylinder(Cylinder::new(on_axis(from.y), axis, from.x))
            } else {
                let apex = on_axis(from.y - from.x * direction.y / direction.x);
                let half_angle = libm::atan2(direction.x.abs(), direction.y.abs());
                Surface::Cone(Cone::new(apex, axis, half_angle))
            }
        }
        (Segment::Arc(arc), Sweep::Revolve { .. }) => {
            let centre = on_axis(arc.centre.y);
            if arc.centre.x.abs() < NEGLIGIBLE * arc.radius {
                Surface::Sphere(Sphere::new(centre, arc.radius))
            } else {
                Surface::Torus(Torus::new(centre, axis, arc.centre.x, arc.radius))
            }
        }
    })
}

/// Whether two surfaces are one within a tolerance of length.
pub fn coincide(a: &Surface, b: &Surface, tolerance: f64) -> bool {
    let near = |a: &Point, b: &Point| (a - b).norm() < tolerance;
    let along = |a: &Vector, b: &Vector| a.cross(b).norm() < 1e-9;
    let equal = |a: f64, b: f64| (a - b).abs() < tolerance;
    match (a, b) {
        (Surface::Plane(a), Surface::Plane(b)) => {
            along(&a.normal, &b.normal) && near(&a.centre(), &b.centre())
        }
        (Surface::Cylinder(a), Surface::Cylinder(b)) => {
            along(&a.axis, &b.axis) && near(&a.centre, &b.centre) && equal(a.radius, b.radius)
        }
        (Surface::Cone(a), Surface::Cone(b)) => {
            along(&a.axis, &b.axis)
                && near(&a.apex, &b.apex)
                && (a.half_angle - b.half_angle).abs() < 1e-9
        }
        (Surface::Sphere(a), Surface::Sphere(b)) => {
            near(&a.centre, &b.centre) && equal(a.radius, b.radius)
        }
        (Surface::Torus(a), Surface::Torus(b)) => {
            along(&a.axis, &b.axis)
                && near(&a.centre, &b.centre)
                && equal(a.major_radius, b.major_radius)
                && equal(a.minor_radius, b.minor_radius)
        }
        _ => false,
    }
}
