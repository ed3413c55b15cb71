//! Measures how fast files are read: `cargo run --release --example reading_speed`.

use std::fmt::Write;
use std::time::Instant;

use fit4cad::cloud::Numbering;
use fit4cad::cloud::{Cloud, Point};
use fit4cad::format::{read_cloud, read_primitives, write_cloud};

const POINTS: u32 = 400_000;
const REPETITIONS: u32 = 5;

fn main() {
    // A spiral, in the twelve decimals of the benchmark's files.
    let points: Vec<Point> = (0..POINTS)
        .map(|i| f64::from(i) * 1e-3)
        .map(|t| Point::new(20.0 * t.cos(), 20.0 * t.sin(), t - 200.0))
        .collect();
    let mut paper = String::from("Points:=[\n");
    for point in &points {
        let _ = writeln!(
            paper,
            "[{:.12}, {:.12}, {:.12}], ",
            point.x, point.y, point.z
        );
    }
    paper.push_str(" ];\n");
    let numbering = Numbering::of(points.len());
    let mut lists = String::new();
    for part in 0..20 {
        let _ = write!(lists, "Primitive{}:=[", part + 1);
        for index in (part..POINTS).step_by(20) {
            let _ = write!(lists, "{} ", index + 1);
        }
        lists.push_str("];\n");
    }
    let shortest = write_cloud(&Cloud::new(points));
    let bare = paper.replace(['[', ']', ','], "");

    measure("cloud, twelve decimals", &paper, |bytes| {
        read_cloud("", bytes).0.cloud.len()
    });
    measure("cloud, shortest digits", &shortest, |bytes| {
        read_cloud("", bytes).0.cloud.len()
    });
    measure("cloud, bare columns", &bare, |bytes| {
        read_cloud("", bytes).0.cloud.len()
    });
    measure("primitives", &lists, |bytes| {
        read_primitives("", bytes, &numbering).0.len()
    });
}

fn measure(name: &str, text: &str, read: impl Fn(&[u8]) -> usize) {
    let mut best = f64::INFINITY;
    let mut items = 0;
    for _ in 0..REPETITIONS {
        let start = Instant::now();
        items = read(text.as_bytes());
        best = best.min(start.elapsed().as_secs_f64());
    }
    let megabytes = text.len() as f64 / 1e6;
    println!(
        "{name:>24}: {:6.0} MB/s ({megabytes:.1} MB, {items} items)",
        megabytes / best
    );
}
