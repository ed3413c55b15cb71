//! Whether an answer stays with the points when they are moved, turned, scaled and listed in another
//! order: none of these changes what a cloud shows.

use std::error::Error;

use fit4cad::cloud::{Cloud, Point};
use fit4cad::fit::{self, Method, Parameters};
use fit4cad::metrics::agreement::changed;
use fit4cad::model::Segmentation;
use fit4cad::random::Random;
use nalgebra::{Similarity3, Translation3, UnitQuaternion};

/// Share of the points whose labels may change.
const FEW: f64 = 0.005;
/// What is done to each cloud: a name and the similarity, of lengths in diagonals.
type Motion = (&'static str, fn(f64) -> Similarity3<f64>);
const MOTIONS: [Motion; 5] = [
    ("moved", |l| similarity(l, 3.0, 0.0, 1.0)),
    ("turned", |l| similarity(l, 0.0, 1.0, 1.0)),
    ("× 1000", |l| similarity(l, 0.0, 0.0, 1000.0)),
    ("/ 1000", |l| similarity(l, 0.0, 0.0, 0.001)),
    ("all", |l| similarity(l, 3.0, 1.0, 1000.0)),
];

fn similarity(diagonal: f64, away: f64, turn: f64, scale: f64) -> Similarity3<f64> {
    let turn = UnitQuaternion::from_euler_angles(0.7 * turn, -0.4 * turn, 1.3 * turn);
    let away = away * scale * diagonal;
    Similarity3::from_parts(
        Translation3::new(0.3 * away, -away, 0.7 * away),
        turn,
        scale,
    )
}

/// What is done beside the motions.
const OTHERS: [&str; 2] = ["shuffled", "seed"];

/// Shares of the points of a model whose labels change with each motion, when the points are shuffled,
/// and with another seed.
pub struct Row {
    name: String,
    changes: Vec<f64>,
}

/// Fits a cloud as it is and after each motion.
pub fn run(
    name: &str,
    cloud: &Cloud,
    method: Method,
    parameters: &Parameters,
    seed: u64,
) -> Result<Row, Box<dyn Error>> {
    let fitted = |cloud: &Cloud, seed| -> Result<Segmentation, Box<dyn Error>> {
        Ok(fit::fit(cloud, method, parameters, seed, &mut ())?.segmentation)
    };
    let still = fitted(cloud, seed)?;
    let diagonal = cloud.bounds().diagonal();
    let mut changes = Vec::new();
    for (_, motion) in MOTIONS {
        let motion = motion(diagonal);
        let points: Vec<Point> = cloud.points().iter().map(|p| motion * p).collect();
        let other = fitted(&Cloud::new(points), seed)?;
        changes.push(share(cloud.len(), &still, &other));
    }
    let mut order: Vec<u32> = (0u32..).take(cloud.len()).collect();
    Random::new(seed, 1).shuffle(&mut order);
    let points = order.iter().map(|&i| cloud.points()[i as usize]);
    let mut shuffled = fitted(&Cloud::new(points.collect()), seed)?;
    for primitive in &mut shuffled.primitives {
        for index in &mut primitive.points {
            *index = order[*index as usize];
        }
        primitive.points.sort_unstable();
    }
    changes.push(share(cloud.len(), &still, &shuffled));
    changes.push(share(cloud.len(), &still, &fitted(cloud, seed + 1)?));
    Ok(Row {
        name: name.to_owned(),
        changes,
    })
}

/// Share of the points whose labels differ.
fn share(points: usize, one: &Segmentation, other: &Segmentation) -> f64 {
    changed(points, one, other) as f64 / points.max(1) as f64
}

impl std::fmt::Display for Row {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:8}", self.name)?;
        for change in &self.changes {
            write!(f, " {:>8.3}", 100.0 * change)?;
        }
        Ok(())
    }
}

/// The head of the table.
pub fn head() -> String {
    let mut head = "model   ".to_owned();
    for name in MOTIONS.iter().map(|(name, _)| name).chain(&OTHERS) {
        head += &format!(" {name:>8}");
    }
    head + "   % of the points with other labels"
}

/// Mean, worst, and how many are more than few, of each column.
pub fn summarise(rows: &[Row]) {
    let column = |place: usize| rows.iter().map(move |row| 100.0 * row.changes[place]);
    let line = |name: &str, of: &dyn Fn(usize) -> String| {
        let cells = (0..MOTIONS.len() + OTHERS.len()).map(|place| format!(" {:>8}", of(place)));
        println!("{name:8}{}", cells.collect::<String>());
    };
    line("mean", &|place| {
        format!(
            "{:.3}",
            column(place).sum::<f64>() / rows.len().max(1) as f64
        )
    });
    line("worst", &|place| {
        format!("{:.3}", column(place).fold(0.0, f64::max))
    });
    line("above", &|place| {
        let above = column(place).filter(|&change| change > 100.0 * FEW);
        above.count().to_string()
    });
    line("equal", &|place| {
        column(place)
            .filter(|&change| change == 0.0)
            .count()
            .to_string()
    });
}
