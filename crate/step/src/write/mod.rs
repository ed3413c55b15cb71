//! Primitives back as CAD: an open shell of faces, each on its surface and within the outline of its points.

mod outline;
mod text;

use fit4cad::cloud::{Cloud, Point, Vector};
use fit4cad::model::{Primitive, Segmentation};
use fit4cad::surface::{Surface, SurfaceType};

use crate::geometry::chart::Chart;
use crate::geometry::shape::{Ring, Shape};
use crate::placement::Frame;
use outline::outline;
use text::Text;

/// A colour: red, green, blue, each 0 to 1.
pub type Colour = [f64; 3];

/// The primitives of a segmentation as the text of a STEP file (AP214), in millimetres: each a face on
/// its surface, trimmed by the outline of its points, holes kept, named and coloured. Primitives without
/// a surface, or with too few points to have an outline, are left out; they are counted in the result.
/// O(n log n) for n points.
pub fn write_step(
    name: &str,
    cloud: &Cloud,
    segmentation: &Segmentation,
    colour: impl Fn(SurfaceType) -> Colour,
) -> (String, usize) {
    let mut text = Text::new(name);
    let mut left_out = 0;
    for primitive in &segmentation.primitives {
        let drawn = primitive
            .surface
            .filter(Surface::is_in_range)
            .and_then(|surface| {
                let points = points_of(cloud, primitive);
                draw(
                    &mut text,
                    &surface,
                    &points,
                    primitive,
                    colour(surface.kind()),
                )
            });
        left_out += usize::from(drawn.is_none());
    }
    (text.finish(), left_out)
}

fn points_of(cloud: &Cloud, primitive: &Primitive) -> Vec<Point> {
    let listed = primitive.points.iter();
    listed
        .filter_map(|&index| cloud.points().get(index as usize).copied())
        .collect()
}

/// Writes a primitive as a face; `None` where its points have no outline.
fn draw(
    text: &mut Text,
    surface: &Surface,
    points: &[Point],
    primitive: &Primitive,
    colour: Colour,
) -> Option<()> {
    let shape = shape(surface, points)?;
    let chart = Chart::new(shape);
    let loops = outline(&chart, points)?;
    let number = primitive.number;
    text.face(
        &chart.shape,
        &loops,
        &format!("{} {number}", surface.kind().name()),
        colour,
    );
    Some(())
}

/// The surface with a frame: the first direction, where a chart that closes begins, where points are;
/// the nappe of a cone is that of its points, and the poles of a sphere lie across them.
fn shape(surface: &Surface, points: &[Point]) -> Option<Shape> {
    let centre =
        points.iter().map(|point| point.coords).sum::<Vector>() / points.len().max(1) as f64;
    let towards = |origin: Point| Some(centre - origin.coords);
    Some(match surface {
        Surface::Plane(it) => Shape::Plane(Frame::new(it.centre(), it.normal.into_inner(), None)?),
        Surface::Cylinder(it) => Shape::Cylinder(
            Frame::new(it.centre, it.axis.into_inner(), towards(it.centre))?,
            it.radius,
        ),
        Surface::Cone(it) => {
            let offset = centre - it.apex.coords;
            let axis = it.axis.into_inner() * offset.dot(&it.axis).signum();
            Shape::Cone(Frame::new(it.apex, axis, Some(offset))?, it.half_angle)
        }
        Surface::Sphere(it) => {
            let offset = centre - it.centre.coords;
            let axis = fit4cad::cloud::Direction::try_new(offset, 1e-9 * it.radius);
            let across = axis.map_or_else(Vector::z, |axis| {
                // Any direction across: poles away from the middle of the points.
                let helper = if axis.x.abs() < 0.6 {
                    Vector::x()
                } else {
                    Vector::y()
                };
                axis.cross(&helper)
            });
            Shape::Sphere(Frame::new(it.centre, across, Some(offset))?, it.radius)
        }
        Surface::Torus(it) => Shape::Torus(Ring {
            frame: Frame::new(it.centre, it.axis.into_inner(), towards(it.centre))?,
            major: it.major_radius,
            minor: it.minor_radius,
            inner: false,
        }),
    })
}
