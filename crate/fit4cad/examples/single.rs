//! How well single primitives are recognised: `cargo run --release --example single -- [COUNT] [POINTS]`.

use std::time::Instant;

use fit4cad::cloud::Ball;
use fit4cad::fit::single::fit_single;
use fit4cad::random::Random;
use fit4cad::sample::single::{STRAINS, parameter_error, segment};
use fit4cad::surface::SurfaceType;

fn main() {
    let mut arguments = std::env::args().skip(1).filter_map(|it| it.parse().ok());
    let count: usize = arguments.next().unwrap_or(1000);
    let points: usize = arguments.next().unwrap_or(2000);
    let each = count.div_ceil(STRAINS.len() * SurfaceType::ALL.len());
    println!(
        "{:<30} {:>6} {:>8} {:>10} {:>10} {:>8}",
        "cloud", "right", "of", "median", "95 %", "ms"
    );
    let (mut all, mut all_right) = (0, 0);
    for (name, strain) in STRAINS {
        let (mut right, mut errors, mut wrong) = (0, Vec::new(), Vec::new());
        let (mut seconds, mut tried) = (0.0, 0);
        for kind in SurfaceType::ALL {
            for seed in 0..each as u64 {
                let mut random = Random::new(seed, kind as u64);
                let (truth, cloud) = segment(kind, points, &strain, &mut random);
                let start = Instant::now();
                let single = fit_single(&cloud, &[]);
                seconds += start.elapsed().as_secs_f64();
                tried += 1;
                let found = single.best.surface;
                if found.kind() == kind {
                    right += 1;
                    errors.push(parameter_error(&found, &truth, Ball::of(&cloud).radius));
                } else {
                    wrong.push(format!(
                        "{kind}→{} {:.3} #{seed}",
                        found.kind(),
                        single.margin
                    ));
                }
            }
        }
        errors.sort_by(f64::total_cmp);
        let at = |share: f64| {
            errors
                .get((share * errors.len() as f64) as usize)
                .copied()
                .unwrap_or(f64::NAN)
        };
        println!(
            "{name:<30} {right:>6} {tried:>8} {:>10.1e} {:>10.1e} {:>8.1}  {}",
            at(0.5),
            at(0.95),
            1000.0 * seconds / f64::from(tried),
            wrong.join(", ")
        );
        all += tried;
        all_right += right;
    }
    println!(
        "{all_right} of {all} types right, {:.2} %",
        100.0 * f64::from(all_right) / f64::from(all)
    );
}
