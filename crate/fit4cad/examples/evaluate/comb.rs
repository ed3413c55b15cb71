//! Combs: extruded rows of narrow grooves, whose small faces show three rulings of points each.
//!
//! Such faces are where a search is easily fooled: any three rulings lie on a cylinder, also those in
//! the middle of which one face ends and the next begins.

use std::f64::consts::PI;

use fit4cad::cloud::{Cloud, Point, Vector};
use fit4cad::model::{Coefficients, Model, Primitive, Segmentation};
use fit4cad::surface::{Cylinder, Plane, Surface};

/// A piece of the profile, lengths in spacings of the points.
#[derive(Clone, Copy)]
enum Piece {
    /// A line of some length.
    Line(f64),
    /// An arc of some radius that turns by some degrees, to the left if positive.
    Arc(f64, f64),
    /// A corner of some degrees.
    Corner(f64),
}
use Piece::{Arc, Corner, Line};

/// The combs: a name, the share of points kept along the rulings, and the profile of one groove,
/// after which the heading is as before.
const COMBS: [(&str, f64, &[Piece]); 10] = [
    ("tangent", 1.0, TANGENT),
    ("sharp", 1.0, SHARP),
    ("round", 1.0, ROUND),
    ("chamfered", 1.0, CHAMFERED),
    ("wavy", 1.0, WAVY),
    ("sparse-tangent", 0.4, TANGENT),
    ("sparse-sharp", 0.4, SHARP),
    ("sparse-round", 0.4, ROUND),
    ("toothed", 1.0, TOOTHED),
    ("sparse-toothed", 0.35, TOOTHED),
];
const TANGENT: &[Piece] = &[
    Line(2.1),
    Arc(0.9, -55.0),
    Arc(5.6, -21.0),
    Arc(3.0, 152.0),
    Arc(5.6, -21.0),
    Arc(0.9, -55.0),
];
const SHARP: &[Piece] = &[
    Line(2.1),
    Arc(0.9, -50.0),
    Arc(5.6, -22.0),
    Corner(-15.0),
    Arc(3.0, 174.0),
    Corner(-15.0),
    Arc(5.6, -22.0),
    Arc(0.9, -50.0),
];
const ROUND: &[Piece] = &[
    Line(4.0),
    Arc(1.2, -90.0),
    Line(4.0),
    Arc(1.2, 90.0),
    Line(4.0),
    Arc(1.2, 90.0),
    Line(4.0),
    Arc(1.2, -90.0),
];
const CHAMFERED: &[Piece] = &[
    Line(3.0),
    Corner(-45.0),
    Line(1.0),
    Corner(-45.0),
    Line(3.0),
    Corner(90.0),
    Line(3.0),
    Corner(90.0),
    Line(3.0),
    Corner(-45.0),
    Line(1.0),
    Corner(-45.0),
];
const WAVY: &[Piece] = &[
    Arc(2.0, -60.0),
    Arc(3.0, 60.0),
    Arc(2.5, 60.0),
    Arc(1.7, -60.0),
];
/// Lands and roots so broad that they are known before the flanks between them.
const TOOTHED: &[Piece] = &[
    Line(9.0),
    Arc(0.9, -58.0),
    Arc(5.6, 21.0),
    Arc(2.2, -20.0),
    Corner(57.0),
    Line(9.0),
    Corner(57.0),
    Arc(2.2, -20.0),
    Arc(5.6, 21.0),
    Arc(0.9, -58.0),
];
/// Grooves in a row.
const GROOVES: usize = 8;
/// Length of the rulings.
const HEIGHT: f64 = 36.0;

/// All combs with their truths.
pub fn combs() -> Vec<Model> {
    COMBS
        .iter()
        .map(|(name, kept, groove)| comb(name, *kept, groove))
        .collect()
}

struct Builder {
    points: Vec<Point>,
    primitives: Vec<(Surface, Vec<u32>)>,
    random: fastrand::Rng,
    kept: f64,
}

impl Builder {
    fn add(&mut self, x: f64, y: f64, z: f64) -> u32 {
        let index = self.points.len() as u32;
        self.points.push(Point::new(x, y, z));
        index
    }

    /// Points of a ruling; its ends come first and last. Rulings have their own numbers of points.
    fn ruling(&mut self, [x, y]: [f64; 2]) -> Vec<u32> {
        let steps = (HEIGHT * (0.95 + 0.2 * self.random.f64())).round();
        let mut points = Vec::new();
        for i in 0..=steps as u32 {
            if self.random.f64() < self.kept {
                points.push(self.add(x, y, f64::from(i) * HEIGHT / steps));
            }
        }
        points
    }
}

fn comb(name: &str, kept: f64, groove: &[Piece]) -> Model {
    let mut builder = Builder {
        points: Vec::new(),
        primitives: Vec::new(),
        random: fastrand::Rng::with_seed(3),
        kept,
    };
    let (mut at, mut heading) = ([0.0, 0.0], 0f64);
    let mut outline: Vec<Vec<u32>> = Vec::new();
    let mut path = vec![at];
    let wide = [Corner(40.0), Line(9.0), Corner(-40.0)];
    let rows = (0..GROOVES).flat_map(|_| groove).chain(&wide);
    let mut last = builder.ruling(at);
    outline.push(last.clone());
    for &piece in wide.iter().chain(rows) {
        let (surface, length, turn) = match piece {
            Corner(degrees) => {
                heading += degrees * PI / 180.0;
                continue;
            }
            Line(length) => {
                let normal = Vector::new(-heading.sin(), heading.cos(), 0.0);
                let surface = Surface::Plane(Plane::new(Point::new(at[0], at[1], 0.0), normal));
                (surface, length, 0.0)
            }
            Arc(radius, degrees) => {
                let side = f64::signum(degrees);
                let centre = Point::new(
                    at[0] - side * radius * heading.sin(),
                    at[1] + side * radius * heading.cos(),
                    0.0,
                );
                let turn = degrees * PI / 180.0;
                (
                    Surface::Cylinder(Cylinder::new(centre, Vector::z(), radius)),
                    radius * turn.abs(),
                    turn,
                )
            }
        };
        let steps = length.round().max(2.0) as u32;
        let mut points = last.clone();
        for _ in 0..steps {
            let step = turn / f64::from(steps);
            let chord = if turn == 0.0 {
                length / f64::from(steps)
            } else {
                2.0 * (length / turn).abs() * (0.5 * step).sin().abs()
            };
            let way = heading + 0.5 * step;
            at = [at[0] + chord * way.cos(), at[1] + chord * way.sin()];
            heading += step;
            path.push(at);
            last = builder.ruling(at);
            points.extend(&last);
            outline.push(last.clone());
        }
        builder.primitives.push((surface, points));
    }
    caps(&mut builder, &outline, &path);
    finish(name, builder)
}

/// The two faces across the rulings, and the bottom and sides.
fn caps(builder: &mut Builder, outline: &[Vec<u32>], path: &[[f64; 2]]) {
    let low = path.iter().map(|p| p[1]).fold(0.0, f64::min).floor() - 8.0;
    let high = path.iter().map(|p| p[1]).fold(0.0, f64::max);
    let width = path.last().map_or(0.0, |p| p[0]);
    let columns = width.ceil() as u32;
    let across = |i: u32| f64::from(i) * width / f64::from(columns);
    let mut bottom = Vec::new();
    for (height, end) in [(0.0, 0), (HEIGHT, usize::MAX)] {
        let at_end = |ruling: &Vec<u32>| {
            let index = *ruling.get(end.min(ruling.len().checked_sub(1)?))?;
            (builder.points[index as usize].z == height).then_some(index)
        };
        let mut cap: Vec<u32> = outline.iter().filter_map(at_end).collect();
        for i in 0..=columns {
            for j in 0..(high - low).ceil() as u32 {
                let (x, y) = (across(i), low + f64::from(j));
                let clear = path.iter().all(|p| (p[0] - x).hypot(p[1] - y) > 0.8);
                // Under the profile where it passes straight above.
                let above = path
                    .windows(2)
                    .filter(|w| (w[0][0] <= x) != (w[1][0] <= x))
                    .map(|w| w[0][1] + (w[1][1] - w[0][1]) * (x - w[0][0]) / (w[1][0] - w[0][0]));
                let under = above.filter(|&top| top > y).count() % 2 == 1;
                if clear && under {
                    let index = builder.add(x, y, height);
                    cap.push(index);
                    if j == 0 {
                        bottom.push(index);
                    }
                }
            }
        }
        let plane = Plane::new(Point::new(0.0, 0.0, height), Vector::z());
        builder.primitives.push((Surface::Plane(plane), cap));
    }
    for i in 0..=columns {
        for z in 1..HEIGHT as u32 {
            let index = builder.add(across(i), low, f64::from(z));
            bottom.push(index);
        }
    }
    let plane = Plane::new(Point::new(0.0, low, 0.0), Vector::y());
    builder.primitives.push((Surface::Plane(plane), bottom));
}

fn finish(name: &str, builder: Builder) -> Model {
    let primitives = (1..)
        .zip(builder.primitives)
        .map(|(number, (surface, mut points))| {
            points.sort_unstable();
            Primitive {
                number,
                points,
                kind: Some(surface.kind()),
                surface: Some(surface),
                parametric: Coefficients::Missing,
                implicit: Coefficients::Missing,
            }
        })
        .collect();
    Model {
        name: name.to_owned(),
        cloud: Cloud::new(builder.points),
        truth: Some(Segmentation { primitives }),
        submissions: Vec::new(),
    }
}
