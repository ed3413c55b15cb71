//! Surfaces in canonical form, as dictionaries with the names of the command line's JSON.

use fit4cad::cloud::{Direction, Point, Vector};
use fit4cad::surface::{Cone, Cylinder, Form, Plane, Sphere, Surface, SurfaceType, Torus};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::cloud::Cloud;
use crate::dict::{dict, refused};

/// A surface as a dictionary: its type, and its canonical form in the units of its cloud.
pub(crate) fn to_dict<'py>(py: Python<'py>, surface: &Surface) -> PyResult<Bound<'py, PyDict>> {
    let point = |point: Point| [point.x, point.y, point.z];
    let direction = |direction: Direction| [direction.x, direction.y, direction.z];
    let name = surface.kind().name();
    Ok(match *surface {
        Surface::Plane(plane) => dict!(py;
            "type" => name,
            "normal" => direction(plane.normal),
            "offset" => plane.offset,
        ),
        Surface::Cylinder(cylinder) => dict!(py;
            "type" => name,
            "centre" => point(cylinder.centre),
            "axis" => direction(cylinder.axis),
            "radius" => cylinder.radius,
        ),
        Surface::Cone(cone) => dict!(py;
            "type" => name,
            "apex" => point(cone.apex),
            "axis" => direction(cone.axis),
            "halfAngle" => cone.half_angle,
        ),
        Surface::Sphere(sphere) => dict!(py;
            "type" => name,
            "centre" => point(sphere.centre),
            "radius" => sphere.radius,
        ),
        Surface::Torus(torus) => dict!(py;
            "type" => name,
            "centre" => point(torus.centre),
            "axis" => direction(torus.axis),
            "majorRadius" => torus.major_radius,
            "minorRadius" => torus.minor_radius,
        ),
    })
}

/// The type of that name.
pub(crate) fn kind_of(name: &str) -> PyResult<SurfaceType> {
    SurfaceType::from_name(name.as_bytes()).ok_or_else(|| {
        let names = SurfaceType::ALL.map(SurfaceType::name).join(", ");
        refused(format!(
            "there is no type of surface `{name}`; there are {names}"
        ))
    })
}

/// The surface of such a dictionary.
pub(crate) fn from_dict(dict: &Bound<'_, PyDict>) -> PyResult<Surface> {
    let value = |key: &str| {
        dict.get_item(key)?
            .ok_or_else(|| refused(format!("the surface lacks `{key}`")))
    };
    let number = |key: &str| value(key)?.extract::<f64>();
    let triple = |key: &str| value(key)?.extract::<[f64; 3]>();
    let point = |key: &str| triple(key).map(Point::from);
    let axis = |key: &str| {
        let axis = Vector::from(triple(key)?);
        let length = axis.norm();
        if length > 0.0 && length.is_finite() {
            Ok(axis)
        } else {
            Err(refused(format!(
                "`{key}` is a vector of some length, not {axis:?}"
            )))
        }
    };
    let surface = match kind_of(&value("type")?.extract::<String>()?)? {
        SurfaceType::Plane => {
            let normal = axis("normal")?;
            let unit = normal / normal.norm();
            Surface::Plane(Plane::new(Point::from(unit * number("offset")?), normal))
        }
        SurfaceType::Cylinder => Surface::Cylinder(Cylinder::new(
            point("centre")?,
            axis("axis")?,
            number("radius")?,
        )),
        SurfaceType::Cone => Surface::Cone(Cone::new(
            point("apex")?,
            axis("axis")?,
            number("halfAngle")?,
        )),
        SurfaceType::Sphere => Surface::Sphere(Sphere::new(point("centre")?, number("radius")?)),
        SurfaceType::Torus => Surface::Torus(Torus::new(
            point("centre")?,
            axis("axis")?,
            number("majorRadius")?,
            number("minorRadius")?,
        )),
    };
    if surface.is_in_range() {
        Ok(surface)
    } else {
        Err(refused(
            "the numbers of the surface cannot be computed with",
        ))
    }
}

/// The surface nearest to a vector in the paper's `parametric` or `implicit` form, and its misfit.
#[pyfunction]
pub(crate) fn surface_of<'py>(
    py: Python<'py>,
    form: &str,
    kind: &str,
    values: Vec<f64>,
) -> PyResult<(Bound<'py, PyDict>, f64)> {
    let known = Form::ALL.into_iter().find(|known| known.name() == form);
    let known = known.ok_or_else(|| {
        let names = Form::ALL.map(Form::name).join(", ");
        refused(format!("there is no form `{form}`; there are {names}"))
    })?;
    let found = Surface::from_form(known, kind_of(kind)?, &values).map_err(refused)?;
    Ok((to_dict(py, &found.surface)?, found.misfit))
}

/// The distance of each point from a surface, in the units of the cloud.
#[pyfunction]
pub(crate) fn distances<'py>(
    py: Python<'py>,
    cloud: &Cloud,
    surface: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let surface = from_dict(surface)?;
    let points = cloud.cloud.points();
    let found: Vec<f64> =
        py.detach(|| points.iter().map(|point| surface.distance(point)).collect());
    Ok(found.into_pyarray(py))
}
