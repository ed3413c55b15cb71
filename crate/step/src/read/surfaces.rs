//! Surfaces of the file.

use fit4cad::cloud::Point;
use std::f64::consts::{FRAC_PI_2, PI};

use super::curves::{check_weights, degree, multiplicities, uniform};
use super::{DEEPEST, Reader, too_deep};
use crate::error::{Got, Trouble};
use crate::file::{number, reference};
use crate::geometry::families::{self, Sided};
use crate::geometry::shape::{Ring, Shape};
use crate::geometry::spline::{Knots, SplineSurface};
use crate::placement::{Frame, Motion, vector};

/// Every surface with control points, before what it adds of its own.
const SPLINES: [&str; 5] = [
    "B_SPLINE_SURFACE_WITH_KNOTS",
    "BEZIER_SURFACE",
    "QUASI_UNIFORM_SURFACE",
    "UNIFORM_SURFACE",
    "B_SPLINE_SURFACE",
];

impl Reader<'_> {
    /// Reads a surface.
    pub fn surface(&self, id: u64) -> Got<Sided> {
        self.surface_within(id, 0)
    }

    fn surface_within(&self, id: u64, depth: usize) -> Got<Sided> {
        if depth > DEEPEST {
            return Err(too_deep(id));
        }
        let (file, unit) = (self.file, self.units.length);
        if SPLINES.iter().any(|name| file.is(id, name)) {
            return Ok(self.spline_surface(id)?.into());
        }
        let is = |name| file.is(id, name);
        let fields = file.fields(id)?;
        let frame = || self.frame(fields.reference(1)?);
        let inner = |place| self.surface_within(fields.reference(place)?, depth + 1);
        if is("PLANE") {
            return Ok(Shape::Plane(frame()?).into());
        }
        if is("CYLINDRICAL_SURFACE") {
            return Ok(Shape::Cylinder(frame()?, fields.length(2)? * unit).into());
        }
        if is("SPHERICAL_SURFACE") {
            return Ok(Shape::Sphere(frame()?, fields.length(2)? * unit).into());
        }
        if is("CONICAL_SURFACE") {
            let angle = fields.number(3)? * self.units.angle;
            return Ok(cone(id, frame()?, fields.number(2)? * unit, angle)?.into());
        }
        if is("TOROIDAL_SURFACE") || is("DEGENERATE_TOROIDAL_SURFACE") {
            let (major, minor) = (fields.number(2)?, fields.length(3)?);
            let outer = file.part(id, "DEGENERATE_TOROIDAL_SURFACE", 4);
            let inner = outer.is_some_and(|own| own.flag(0) == Some(false)) && minor > major.abs();
            let (major, minor) = (major.abs() * unit, minor * unit);
            let frame = frame()?;
            if major == 0.0 {
                return Ok(Shape::Sphere(frame, minor).into());
            }
            let ring = Ring {
                frame,
                major,
                minor,
                inner,
            };
            return Ok(Shape::Torus(ring).into());
        }
        if is("SURFACE_OF_LINEAR_EXTRUSION") {
            let direction = vector(file, fields.reference(2)?)?;
            // Some write the direction alone and a length of nothing.
            let direction = direction
                .try_normalize(0.0)
                .ok_or_else(|| Trouble::new(id, "is moved along a vector of no length"))?;
            return Ok(families::extruded(
                self.curve(fields.reference(1)?)?,
                direction,
            ));
        }
        if is("SURFACE_OF_REVOLUTION") {
            let axis = self.frame(fields.reference(2)?)?;
            return Ok(families::turned(self.curve(fields.reference(1)?)?, axis));
        }
        if is("OFFSET_SURFACE") {
            let Sided { shape, turned } = inner(1)?;
            let distance = fields.number(2)? * unit;
            let shape = offset(shape, if turned { -distance } else { distance });
            return Ok(Sided { shape, turned });
        }
        if is("RECTANGULAR_TRIMMED_SURFACE") || is("CURVE_BOUNDED_SURFACE") {
            // The face has bounds of its own.
            return inner(1);
        }
        if is("SURFACE_REPLICA") {
            let motion = Motion::read_operator(file, fields.reference(2)?, unit)?;
            let Sided { shape, turned } = inner(1)?;
            return Ok(Sided {
                shape: shape.moved(&motion),
                turned,
            });
        }
        if is("ORIENTED_SURFACE") {
            return inner(2);
        }
        Err(Trouble::new(
            id,
            format!("is {}, a surface that is not read", file.name(id)),
        ))
    }

    fn spline_surface(&self, id: u64) -> Got<Shape> {
        let file = self.file;
        let own = SPLINES
            .iter()
            .find(|name| file.is(id, name) && file.types(id).count() == 1);
        let general = match own {
            Some(name) => file.part(id, name, 1),
            None => file.part(id, "B_SPLINE_SURFACE", 1),
        };
        let general = general.ok_or_else(|| Trouble::new(id, "has no control points"))?;
        let (u_degree, v_degree) = (degree(&general, 0)?, degree(&general, 1)?);
        let rows = general.table(2, reference)?;
        let [u_count, v_count] = [rows.len(), rows.first().map_or(0, Vec::len)];
        if rows.iter().any(|row| row.len() != v_count) {
            return Err(Trouble::new(
                id,
                "has rows of control points of different lengths",
            ));
        }
        let points: Vec<Point> = self.points(&rows.concat())?;
        let (u, v) = match file.part(id, "B_SPLINE_SURFACE_WITH_KNOTS", 8) {
            Some(own) => (
                Knots::repeated(&own.numbers(2)?, &multiplicities(&own, 0)?),
                Knots::repeated(&own.numbers(3)?, &multiplicities(&own, 1)?),
            ),
            None => {
                let (open, bezier) = (
                    file.is(id, "UNIFORM_SURFACE"),
                    file.is(id, "BEZIER_SURFACE"),
                );
                if u_count == 0 || v_count == 0 {
                    return Err(Trouble::new(id, "has no control points"));
                }
                (
                    uniform(u_degree, u_count, open, bezier),
                    uniform(v_degree, v_count, open, bezier),
                )
            }
        };
        let trouble = |why: String| Trouble::new(id, why);
        let u = Knots::new(u_degree, u, u_count).map_err(trouble)?;
        let v = Knots::new(v_degree, v, v_count).map_err(trouble)?;
        let weights = match file.part(id, "RATIONAL_B_SPLINE_SURFACE", usize::MAX) {
            Some(own) => own.table(0, number)?.concat(),
            None => vec![1.0; points.len()],
        };
        check_weights(id, &weights, points.len())?;
        Ok(Shape::Spline(SplineSurface::new(u, v, &points, &weights)))
    }
}

/// The cone through a circle of a radius about the origin of a frame, opening along its axis.
fn cone(id: u64, frame: Frame, radius: f64, angle: f64) -> Got<Shape> {
    // Some write the angle as the one that the other nappe has.
    let angle = if angle > FRAC_PI_2 { angle - PI } else { angle };
    if angle.abs() < 1e-12 {
        return if radius > 0.0 {
            Ok(Shape::Cylinder(frame, radius))
        } else {
            Err(Trouble::new(id, "is a cone of no radius and no angle"))
        };
    }
    if angle.abs() >= FRAC_PI_2 - 1e-12 {
        return Ok(Shape::Plane(frame));
    }
    // Apex first, then the axis along which it opens.
    let origin = frame.origin - frame.z * (radius / libm::tan(angle));
    let frame = Frame { origin, ..frame };
    let frame = if angle < 0.0 { frame.flipped() } else { frame };
    Ok(Shape::Cone(frame, angle.abs()))
}

/// A surface at a distance from another along its normal; of the five families again one of them.
fn offset(basis: Shape, distance: f64) -> Shape {
    match basis {
        Shape::Plane(frame) => {
            let origin = frame.origin + frame.z * distance;
            Shape::Plane(Frame { origin, ..frame })
        }
        Shape::Cylinder(frame, radius) if radius + distance > 0.0 => {
            Shape::Cylinder(frame, radius + distance)
        }
        Shape::Sphere(frame, radius) if radius + distance > 0.0 => {
            Shape::Sphere(frame, radius + distance)
        }
        Shape::Torus(ring) if !ring.inner && ring.minor + distance > 0.0 => {
            let minor = ring.minor + distance;
            Shape::Torus(Ring { minor, ..ring })
        }
        Shape::Cone(frame, angle) => {
            // The outward normal has, along the axis, minus the sine of the half-angle.
            let origin = frame.origin - frame.z * (distance / libm::sin(angle));
            Shape::Cone(Frame { origin, ..frame }, angle)
        }
        other => Shape::Offset(Box::new(other), distance),
    }
}
