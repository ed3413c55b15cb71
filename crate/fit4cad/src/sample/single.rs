//! Clouds that are one primitive, as the SHREC 2022 track on recognising simple primitives has them
//! (Romanengo and others 2022): clean, noisy in part, sparse, with parts missing, bent, or two of these.

use std::f64::consts::{PI, TAU};

use crate::cloud::{Direction, Point, Vector};
use crate::random::Random;
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface, SurfaceType, Torus, across};

/// What is wrong with a cloud.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Strain {
    /// Share of the points that are moved.
    pub moved: f64,
    /// How far: half the width of uniform noise, or the standard deviation of normal noise, in median
    /// spacings.
    pub noise: f64,
    /// Whether the noise is normal rather than uniform.
    pub normal: bool,
    /// Share of the points that is left, spread evenly.
    pub kept: f64,
    /// How many holes are cut, each of a tenth of the points.
    pub holes: usize,
    /// Largest bend, as a share of the extent.
    pub bend: f64,
}

/// The kinds of clouds of the track, by name.
pub const STRAINS: [(&str, Strain); 8] = {
    const CLEAN: Strain = Strain {
        moved: 0.0,
        noise: 0.0,
        normal: false,
        kept: 1.0,
        holes: 0,
        bend: 0.0,
    };
    const UNIFORM: Strain = Strain {
        moved: 0.8,
        noise: 1.7,
        ..CLEAN
    };
    const NORMAL: Strain = Strain {
        moved: 0.8,
        noise: 0.8,
        normal: true,
        ..CLEAN
    };
    [
        ("clean", CLEAN),
        ("uniform noise", UNIFORM),
        ("normal noise", NORMAL),
        ("undersampled", Strain { kept: 0.1, ..CLEAN }),
        ("missing parts", Strain { holes: 4, ..CLEAN }),
        (
            "bent",
            Strain {
                bend: 0.01,
                ..CLEAN
            },
        ),
        (
            "uniform noise, missing parts",
            Strain {
                holes: 3,
                ..UNIFORM
            },
        ),
        (
            "normal noise, undersampled",
            Strain {
                kept: 0.3,
                ..NORMAL
            },
        ),
    ]
};

/// A random patch of a surface of a type, of about so many points, and the surface.
pub fn segment(
    kind: SurfaceType,
    count: usize,
    strain: &Strain,
    random: &mut Random,
) -> (Surface, Vec<Point>) {
    let axis = loop {
        let vector = Vector::new(random.signed(), random.signed(), random.signed());
        if let Some(axis) = Direction::try_new(vector, 0.1) {
            break axis;
        }
    };
    let origin = Point::new(random.signed(), random.signed(), random.signed()) * 5.0;
    let u = across(&axis).into_inner();
    let v = axis.cross(&u);
    let length = 1.0 + 2.0 * random.unit();
    let radius = 0.3 + random.unit();
    let start = TAU * random.unit();
    let sweep = TAU * (0.3 + 0.7 * random.unit());
    let half_angle = 0.2 + 0.9 * random.unit();
    let tube = radius * (0.15 + 0.6 * random.unit());
    let surface = match kind {
        SurfaceType::Plane => Surface::Plane(Plane::new(origin, axis.into_inner())),
        SurfaceType::Cylinder => {
            Surface::Cylinder(Cylinder::new(origin, axis.into_inner(), radius))
        }
        SurfaceType::Cone => Surface::Cone(Cone::new(origin, axis.into_inner(), half_angle)),
        SurfaceType::Sphere => Surface::Sphere(Sphere::new(origin, radius)),
        SurfaceType::Torus => Surface::Torus(Torus::new(origin, axis.into_inner(), radius, tube)),
    };
    let around = |angle: f64| {
        let (sin, cos) = libm::sincos(angle);
        u * cos + v * sin
    };
    let tube_sweep = TAU * (0.35 + 0.65 * random.unit());
    let low = 0.2 * random.unit();
    let opening = 0.4 + 0.6 * random.unit();
    let mut points: Vec<Point> = (0..count)
        .map(|_| {
            let (s, t) = (random.unit(), random.unit());
            let angle = start + sweep * s;
            match kind {
                SurfaceType::Plane => origin + u * (length * (s - 0.5)) + v * (1.5 * (t - 0.5)),
                SurfaceType::Cylinder => {
                    origin + around(angle) * radius + axis.into_inner() * (length * t)
                }
                SurfaceType::Cone => {
                    // Evenly over the area, which grows with the height.
                    let height = length * (low * low + (1.0 - low * low) * t).sqrt();
                    let wide = height * libm::tan(half_angle);
                    origin + around(angle) * wide + axis.into_inner() * height
                }
                SurfaceType::Sphere => {
                    let height = 1.0 - 2.0 * opening * t;
                    let wide = (1.0 - height * height).max(0.0).sqrt();
                    origin + (around(angle) * wide + axis.into_inner() * height) * radius
                }
                SurfaceType::Torus => {
                    let (sin, cos) = libm::sincos(PI * 0.3 + tube_sweep * t);
                    origin
                        + around(angle) * (radius + tube * cos)
                        + axis.into_inner() * (tube * sin)
                }
            }
        })
        .collect();
    if strain.kept < 1.0 {
        points.truncate((strain.kept * count as f64) as usize);
    }
    let spacing = spacing(&points);
    for _ in 0..strain.holes {
        let middle = points
            .get(random.below(points.len()))
            .copied()
            .unwrap_or(origin);
        let hole = points.len() / 10;
        points.sort_by(|a, b| {
            (a - middle)
                .norm_squared()
                .total_cmp(&(b - middle).norm_squared())
        });
        points.drain(..hole);
    }
    if strain.bend > 0.0 {
        let extent = length.max(radius);
        for point in &mut points {
            let offset = (*point - origin).dot(&u) / extent;
            *point += v * (strain.bend * extent * offset * offset);
        }
    }
    for point in &mut points {
        if random.unit() < strain.moved {
            let mut draw = || {
                let unit = if strain.normal {
                    random.normal()
                } else {
                    random.signed()
                };
                unit * strain.noise * spacing
            };
            *point += Vector::new(draw(), draw(), draw());
        }
    }
    random.shuffle(&mut points);
    (surface, points)
}

/// Median distance to the nearest neighbour.
fn spacing(points: &[Point]) -> f64 {
    let tree = crate::cloud::neighbours::KdTree::new(points);
    let mut found = Vec::new();
    let nearest = points.iter().map(|point| {
        tree.nearest(point, 2, f64::INFINITY, |_| true, &mut found);
        found
            .last()
            .map_or(0.0, |nearest| nearest.distance_squared.sqrt())
    });
    let mut nearest: Vec<f64> = nearest.collect();
    nearest.sort_by(f64::total_cmp);
    nearest.get(nearest.len() / 2).copied().unwrap_or(0.0)
}

/// How far the parameters of a surface are from those of another of its type: the largest difference of
/// lengths, over the other's extent, and of angles in radians; infinite for another type.
pub fn parameter_error(found: &Surface, truth: &Surface, extent: f64) -> f64 {
    let angle = |a: &Direction, b: &Direction| a.cross(b).norm();
    let apart = |a: &Point, b: &Point| (a - b).norm() / extent;
    let along = |a: &Point, b: &Point, axis: &Direction| {
        let offset = a - b;
        (offset - axis.into_inner() * offset.dot(axis)).norm() / extent
    };
    let length = |a: f64, b: f64| (a - b).abs() / extent;
    let largest = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    match (found, truth) {
        (Surface::Plane(a), Surface::Plane(b)) => {
            // Where the truth's foot lies from what was found.
            let foot = Point::from(b.normal.into_inner() * b.offset);
            let off = (foot.coords.dot(&a.normal) - a.offset).abs() / extent;
            largest(&[angle(&a.normal, &b.normal), off])
        }
        (Surface::Cylinder(a), Surface::Cylinder(b)) => largest(&[
            angle(&a.axis, &b.axis),
            along(&a.centre, &b.centre, &b.axis),
            length(a.radius, b.radius),
        ]),
        (Surface::Cone(a), Surface::Cone(b)) => largest(&[
            angle(&a.axis, &b.axis),
            apart(&a.apex, &b.apex),
            (a.half_angle - b.half_angle).abs(),
        ]),
        (Surface::Sphere(a), Surface::Sphere(b)) => {
            largest(&[apart(&a.centre, &b.centre), length(a.radius, b.radius)])
        }
        (Surface::Torus(a), Surface::Torus(b)) => largest(&[
            angle(&a.axis, &b.axis),
            apart(&a.centre, &b.centre),
            length(a.major_radius, b.major_radius),
            length(a.minor_radius, b.minor_radius),
        ]),
        _ => f64::INFINITY,
    }
}
