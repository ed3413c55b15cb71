//! Surfaces, clouds and models out of bytes.

use fit4cad::cloud::{Cloud, LARGEST, Point, Vector};
use fit4cad::model::{Model, Primitive, Segmentation};
use fit4cad::surface::{
    Cone, Cylinder, Form, Plane, Sphere, Surface, SurfaceType, Torus, parametric_point,
};

use crate::Bytes;

/// Most points in a cloud that is made of bytes: few, so that runs are many.
const MOST_POINTS: usize = 250;

/// A type of surface.
pub fn kind(bytes: &mut Bytes<'_>) -> SurfaceType {
    bytes.one(SurfaceType::ALL)
}

/// A point whatever its numbers.
pub fn point(bytes: &mut Bytes<'_>) -> Point {
    Point::from(bytes.numbers::<3>())
}

/// A surface such as a file can give: from a vector, or from its own parameters where they are in range.
pub fn surface(bytes: &mut Bytes<'_>) -> Option<Surface> {
    let kind = kind(bytes);
    if bytes.below(4) == 0 {
        let form = bytes.one(Form::ALL);
        let length = match form {
            Form::Parametric => kind.parametric_len(),
            Form::Implicit => kind.implicit_len(),
        };
        let values: Vec<f64> = (0..length).map(|_| bytes.number()).collect();
        let conversion = Surface::from_form(form, kind, &values).ok()?;
        return Some(conversion.surface);
    }
    let at = point(bytes);
    let axis = Vector::from(bytes.numbers::<3>());
    let surface = match kind {
        SurfaceType::Plane => Surface::Plane(Plane::new(at, axis)),
        SurfaceType::Cylinder => Surface::Cylinder(Cylinder::new(at, axis, bytes.number())),
        SurfaceType::Cone => Surface::Cone(Cone::new(at, axis, bytes.number())),
        SurfaceType::Sphere => Surface::Sphere(Sphere::new(at, bytes.number())),
        SurfaceType::Torus => Surface::Torus(Torus::new(at, axis, bytes.number(), bytes.number())),
    };
    surface.is_in_range().then_some(surface)
}

/// Points on a lattice of a surface's own parameters, or loose ones.
fn patch(bytes: &mut Bytes<'_>, points: &mut Vec<Point>) {
    if bytes.below(4) == 0 {
        points.extend(bytes.list(60, point));
        return;
    }
    let Some(surface) = surface(bytes) else {
        return;
    };
    let values = surface.to_parametric();
    let (rows, columns) = (bytes.below(14) + 1, bytes.below(14) + 1);
    let [from, to, low, high] = bytes.numbers();
    let between = |from: f64, to: f64, step: usize, steps: usize| {
        from + (to - from) * step as f64 / steps as f64
    };
    for row in 0..rows {
        for column in 0..columns {
            let (u, v) = (
                between(from, to, column, columns),
                between(low, high, row, rows),
            );
            points.extend(parametric_point(surface.kind(), &values, u, v));
        }
    }
}

/// A small cloud: patches of surfaces and loose points, some of them doubled, all of it scaled.
pub fn cloud(bytes: &mut Bytes<'_>) -> Cloud {
    let mut points = Vec::new();
    for _ in 0..=bytes.below(4) {
        patch(bytes, &mut points);
    }
    points.truncate(MOST_POINTS);
    if bytes.flag() {
        let factor = bytes.number();
        points.iter_mut().for_each(|point| *point *= factor);
    }
    if bytes.flag() {
        points.extend_from_within(..points.len() / 2);
    }
    Cloud::new(points)
}

/// Point lists over a cloud, as files can have them: ascending, each point once, within the cloud.
pub fn segmentation(bytes: &mut Bytes<'_>, cloud: &Cloud) -> Segmentation {
    let count = cloud.len() as u32;
    let primitives = bytes.list(12, |bytes| {
        let number = bytes.whole();
        let mut points = Vec::new();
        for _ in 0..bytes.below(4) {
            let start = bytes.whole();
            let end = start.saturating_add(bytes.whole()).min(count);
            points.extend(start.min(end)..end);
        }
        points.sort_unstable();
        points.dedup();
        match surface(bytes) {
            Some(surface) => Primitive::on(surface, number, points),
            None => Primitive {
                number,
                points,
                ..Primitive::default()
            },
        }
    });
    Segmentation { primitives }
}

/// A model such as can be read of files: coordinates within what is computed with.
pub fn readable_model(bytes: &mut Bytes<'_>) -> Model {
    let mut model = model(bytes);
    let within = |x: f64| {
        if x.is_finite() {
            x.clamp(-LARGEST, LARGEST)
        } else {
            0.0
        }
    };
    let points = model.cloud.points().iter();
    model.cloud = Cloud::new(points.map(|point| point.map(within)).collect());
    model
}

/// A model with a truth and a submission, either of which may be absent.
pub fn model(bytes: &mut Bytes<'_>) -> Model {
    let cloud = cloud(bytes);
    let mut model = Model {
        name: bytes.text(),
        truth: bytes.flag().then(|| segmentation(bytes, &cloud)),
        ..Model::default()
    };
    if bytes.flag() {
        let submitted = segmentation(bytes, &cloud);
        model.submit(&bytes.text(), submitted);
    }
    model.cloud = cloud;
    model
}
