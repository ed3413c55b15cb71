//! The primitives of a segmentation, a row each.

use std::fmt::Write;

use super::About;
use crate::cloud::{Cloud, Point, Vector};
use crate::fit::least_squares::StandardErrors;
use crate::metrics::accuracy::fit_accuracy;
use crate::model::{Primitive, Segmentation};
use crate::surface::{OTHER, Surface};

/// What is known of one primitive; lengths in the units of the cloud.
struct Row {
    number: u32,
    kind: &'static str,
    points: usize,
    axis: Option<[f64; 3]>,
    position: Option<[f64; 3]>,
    radius: Option<f64>,
    minor_radius: Option<f64>,
    half_angle: Option<f64>,
    mfe: Option<f64>,
    d_haus: Option<f64>,
    errors: StandardErrors,
}

const HEAD: &str = "primitive,type,points,axis_x,axis_y,axis_z,position_x,position_y,position_z,radius,\
                    minor_radius,half_angle_rad,mfe,dhaus";

impl Row {
    /// A plane's position is the point of it nearest to the middle of its points; a cylinder's that of its
    /// axis.
    fn of(cloud: &Cloud, primitive: &Primitive) -> Self {
        let surface = primitive.surface.as_ref();
        let accuracy = surface.and_then(|it| fit_accuracy(cloud, &primitive.points, it));
        let mut row = Self {
            number: primitive.number,
            kind: primitive.kind.map_or(OTHER, |kind| kind.name()),
            points: primitive.points.len(),
            axis: None,
            position: None,
            radius: None,
            minor_radius: None,
            half_angle: None,
            mfe: accuracy.map(|it| it.mfe),
            d_haus: accuracy.map(|it| it.d_haus),
            errors: StandardErrors::of_primitive(cloud, primitive),
        };
        let middle = middle(cloud, &primitive.points);
        let set = |point: Point| Some(<[f64; 3]>::from(point));
        match surface {
            None => {}
            Some(Surface::Plane(plane)) => {
                let off = middle.coords.dot(&plane.normal) - plane.offset;
                row.axis = Some(plane.normal.into_inner().into());
                row.position = set(middle - plane.normal.into_inner() * off);
            }
            Some(Surface::Cylinder(it)) => {
                let along = (middle - it.centre).dot(&it.axis);
                row.axis = Some(it.axis.into_inner().into());
                row.position = set(it.centre + it.axis.into_inner() * along);
                row.radius = Some(it.radius);
            }
            Some(Surface::Cone(it)) => {
                row.axis = Some(it.axis.into_inner().into());
                row.position = set(it.apex);
                row.half_angle = Some(it.half_angle);
            }
            Some(Surface::Sphere(it)) => {
                row.position = set(it.centre);
                row.radius = Some(it.radius);
            }
            Some(Surface::Torus(it)) => {
                row.axis = Some(it.axis.into_inner().into());
                row.position = set(it.centre);
                row.radius = Some(it.major_radius);
                row.minor_radius = Some(it.minor_radius);
            }
        }
        row
    }
}

fn middle(cloud: &Cloud, points: &[u32]) -> Point {
    let listed = points
        .iter()
        .filter_map(|&index| cloud.points().get(index as usize));
    let (sum, count) = listed.fold((Vector::zeros(), 0.0), |(sum, count), point| {
        (sum + point.coords, count + 1.0)
    });
    Point::from(if count > 0.0 { sum / count } else { sum })
}

pub(super) fn csv(cloud: &Cloud, segmentation: &Segmentation) -> String {
    let mut text = HEAD.to_owned();
    for (name, unit) in StandardErrors::NAMES {
        let unit = if unit.is_empty() { "" } else { "_" }.to_owned() + unit;
        let _ = write!(text, ",{}_error{unit}", snake(name));
    }
    text.push('\n');
    let cell = |text: &mut String, value: Option<f64>| {
        text.push(',');
        if let Some(value) = value {
            let _ = write!(text, "{value}");
        }
    };
    for primitive in &segmentation.primitives {
        let row = Row::of(cloud, primitive);
        let _ = write!(text, "{},{},{}", row.number, row.kind, row.points);
        for triple in [row.axis, row.position] {
            for axis in 0..3 {
                cell(&mut text, triple.map(|triple| triple[axis]));
            }
        }
        for value in [
            row.radius,
            row.minor_radius,
            row.half_angle,
            row.mfe,
            row.d_haus,
        ] {
            cell(&mut text, value);
        }
        for value in row.errors.values() {
            cell(&mut text, value);
        }
        text.push('\n');
    }
    text
}

/// `minorRadius` as `minor_radius`.
fn snake(name: &str) -> String {
    let letters = name.chars().flat_map(|letter| {
        let before = letter.is_ascii_uppercase().then_some('_');
        before.into_iter().chain([letter.to_ascii_lowercase()])
    });
    letters.collect()
}

pub(super) fn json(cloud: &Cloud, segmentation: &Segmentation, about: &About) -> String {
    let mut text = String::from("{\n");
    let _ = writeln!(text, "  \"engine\": \"{}\",", env!("CARGO_PKG_VERSION"));
    let _ = writeln!(text, "  \"model\": {},", quoted(&about.model));
    let _ = writeln!(text, "  \"method\": {},", quoted(&about.method));
    let _ = writeln!(text, "  \"surfacesFitted\": {},", about.fitted);
    let _ = writeln!(text, "  \"points\": {},", cloud.len());
    text.push_str("  \"primitives\": [");
    for (place, primitive) in segmentation.primitives.iter().enumerate() {
        let row = Row::of(cloud, primitive);
        let number = |value: Option<f64>| match value {
            Some(value) if value.is_finite() => format!("{value:?}"),
            _ => "null".to_owned(),
        };
        let triple = |triple: Option<[f64; 3]>| match triple {
            Some(values) => {
                let values = values.map(|value| number(Some(value)));
                format!("[{}]", values.join(", "))
            }
            None => "null".to_owned(),
        };
        let errors = StandardErrors::NAMES.iter().zip(row.errors.values());
        let errors: Vec<String> = errors
            .map(|((name, _), value)| format!("\"{name}\": {}", number(value)))
            .collect();
        let _ = write!(
            text,
            "{}\n    {{ \"number\": {}, \"type\": \"{}\", \"points\": {}, \"axis\": {}, \"position\": {}, \
             \"radius\": {}, \"minorRadius\": {}, \"halfAngle\": {}, \"mfe\": {}, \"dHaus\": {}, \
             \"standardErrors\": {{ {} }} }}",
            if place == 0 { "" } else { "," },
            row.number,
            row.kind,
            row.points,
            triple(row.axis),
            triple(row.position),
            number(row.radius),
            number(row.minor_radius),
            number(row.half_angle),
            number(row.mfe),
            number(row.d_haus),
            errors.join(", "),
        );
    }
    text.push_str("\n  ]\n}\n");
    text
}

/// A text as JSON has it (RFC 8259).
pub(super) fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for character in text.chars() {
        match character {
            '"' | '\\' => quoted.extend(['\\', character]),
            _ if character.is_control() => {
                let _ = write!(quoted, "\\u{:04x}", character as u32);
            }
            _ => quoted.push(character),
        }
    }
    quoted.push('"');
    quoted
}
