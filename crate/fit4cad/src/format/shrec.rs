//! The answers of the SHREC 2022 track on recognising simple primitives: a column of numbers, first
//! the type, for a cloud that is one primitive (Romanengo and others 2022).
//!
//! 1 plane: normal, point; 2 cylinder: radius, axis, point; 3 sphere: radius, centre; 4 cone: half-angle in
//! radians, axis, apex; 5 torus: two radii in either order, axis, centre.

use crate::cloud::{Point, Vector};
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface, Torus};

/// The column of a surface.
pub fn write_answer(surface: &Surface) -> String {
    let mut numbers = Vec::new();
    let mut add = |parts: &[&[f64]]| {
        parts
            .iter()
            .for_each(|part| numbers.extend_from_slice(part))
    };
    match surface {
        Surface::Plane(it) => {
            let foot = it.normal.into_inner() * it.offset;
            add(&[&[1.0], it.normal.as_slice(), foot.as_slice()]);
        }
        Surface::Cylinder(it) => {
            add(&[
                &[2.0, it.radius],
                it.axis.as_slice(),
                it.centre.coords.as_slice(),
            ]);
        }
        Surface::Sphere(it) => add(&[&[3.0, it.radius], it.centre.coords.as_slice()]),
        Surface::Cone(it) => {
            add(&[
                &[4.0, it.half_angle],
                it.axis.as_slice(),
                it.apex.coords.as_slice(),
            ]);
        }
        Surface::Torus(it) => add(&[
            &[5.0, it.major_radius, it.minor_radius],
            it.axis.as_slice(),
            it.centre.coords.as_slice(),
        ]),
    }
    numbers.iter().map(|number| format!("{number}\n")).collect()
}

/// The surface of a column; `None` where it is none.
pub fn read_answer(text: &str) -> Option<Surface> {
    let numbers: Option<Vec<f64>> = text
        .split(|character: char| character.is_whitespace() || character == ',')
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().ok())
        .collect();
    let numbers = numbers?;
    let finite = numbers.iter().all(|number| number.is_finite());
    let (&kind, rest) = numbers.split_first().filter(|_| finite)?;
    let point = |at: &[f64]| Point::new(at[0], at[1], at[2]);
    let vector = |at: &[f64]| Vector::new(at[0], at[1], at[2]);
    let surface = match (kind as i64, rest.len()) {
        _ if kind.fract() != 0.0 => return None,
        (1, 6) => Surface::Plane(Plane::new(point(&rest[3..]), vector(rest))),
        (2, 7) => Surface::Cylinder(Cylinder::new(
            point(&rest[4..]),
            vector(&rest[1..]),
            rest[0],
        )),
        (3, 4) => Surface::Sphere(Sphere::new(point(&rest[1..]), rest[0])),
        (4, 7) => Surface::Cone(Cone::new(point(&rest[4..]), vector(&rest[1..]), rest[0])),
        (5, 8) => {
            let (major, minor) = (
                rest[0].abs().max(rest[1].abs()),
                rest[0].abs().min(rest[1].abs()),
            );
            Surface::Torus(Torus::new(
                point(&rest[5..]),
                vector(&rest[2..]),
                major,
                minor,
            ))
        }
        _ => return None,
    };
    surface.is_in_range().then_some(surface)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::Random;
    use crate::sample::single::{Strain, parameter_error, segment};
    use crate::surface::SurfaceType;

    #[test]
    fn answers_read_back_and_anything_else_is_none() {
        for kind in SurfaceType::ALL {
            let clean = Strain {
                kept: 1.0,
                ..Strain::default()
            };
            let (surface, _) = segment(kind, 10, &clean, &mut Random::new(3, kind as u64));
            let read = read_answer(&write_answer(&surface)).unwrap();
            assert!(
                parameter_error(&read, &surface, 1.0) < 1e-12,
                "{read:?} {surface:?}"
            );
        }
        for text in [
            "",
            "1",
            "6 1 2 3",
            "3 1 0 0",
            "1.5 1 0 0 0",
            "3 nan 0 0 0",
            "3 1e99 0 0 0",
            "x",
        ] {
            assert_eq!(read_answer(text), None, "{text}");
        }
        let torus = read_answer("5,0.5,2,0,0,1,0,0,0").unwrap();
        assert!(matches!(torus, Surface::Torus(it) if it.major_radius == 2.0));
    }
}
