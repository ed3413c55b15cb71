//! How the time and memory of a fit grow with the cloud: one part at about 10 k, 100 k and 1 M points.
//!
//! ```text
//! cargo run --release --example growth -- [PART]
//! ```
//! Memory is the most that the fit held at a time beyond the cloud itself, counted by the allocator.

use std::alloc::{GlobalAlloc, Layout, System};
use std::error::Error;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::time::Instant;

use fit4cad::fit::{self, Method, Parameters};
use fit4cad::sample::{self, Options};

/// The system's allocator with a count of what is held, and of the most that ever was.
struct Counting;

static HELD: AtomicUsize = AtomicUsize::new(0);
static MOST: AtomicUsize = AtomicUsize::new(0);

// SAFETY: every call is passed on unchanged.
#[allow(unsafe_code)]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        let held = HELD.fetch_add(layout.size(), Relaxed) + layout.size();
        MOST.fetch_max(held, Relaxed);
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        HELD.fetch_sub(layout.size(), Relaxed);
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// Spacings, in diagonals, and the points they lead to are told apart by factors of about ten.
const COARSEST: f64 = 0.0077;

fn main() -> Result<(), Box<dyn Error>> {
    let part = std::env::args().nth(1).unwrap_or("bracket".to_owned());
    let coarse = generate(&part, COARSEST)?.cloud.len() as f64;
    println!("method   points primitives  seconds  bytes a point");
    for goal in [1e4, 1e5, 1e6] {
        // Points grow with the inverse square of the spacing.
        let spacing = COARSEST * (coarse / goal).sqrt();
        let model = generate(&part, spacing)?;
        for (name, method) in [("ht", Method::Hough), ("pg", Method::Growing)] {
            let before = HELD.load(Relaxed);
            MOST.store(before, Relaxed);
            let start = Instant::now();
            let fit = fit::fit(&model.cloud, method, &Parameters::default(), 1, &mut ())?;
            let seconds = start.elapsed().as_secs_f64();
            let bytes = MOST.load(Relaxed) - before;
            let points = model.cloud.len();
            println!(
                "{name:6} {points:>8} {:>10} {seconds:>8.2} {:>14.0}",
                fit.segmentation.primitives.len(),
                bytes as f64 / points as f64
            );
        }
    }
    Ok(())
}

fn generate(part: &str, spacing: f64) -> Result<fit4cad::model::Model, Box<dyn Error>> {
    let options = Options {
        spacing,
        ..Options::default()
    };
    Ok(sample::generate(part, &options)?)
}
