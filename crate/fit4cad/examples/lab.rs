//! lab
use fit4cad::cloud::{Cloud, Point};
use fit4cad::fit::{Parameters, Search, hough};
use std::time::Instant;

fn numbers(line: &str) -> Vec<f64> {
    line.split(|c: char| !(c.is_ascii_digit() || "+-.eE".contains(c)))
        .filter_map(|s| s.parse().ok())
        .collect()
}

fn main() {
    let dir = "/work/data/training/Fit4CAD-main/dataset/training_set";
    let names: Vec<String> = std::env::args().skip(1).collect();
    let mut total = 0.0;
    let mut times = vec![];
    for n in &names {
        let text = std::fs::read_to_string(format!("{dir}/PC{n}.txt")).unwrap();
        let points: Vec<Point> = text
            .lines()
            .map(numbers)
            .filter(|v| v.len() == 3)
            .map(|v| Point::new(v[0], v[1], v[2]))
            .collect();
        let cloud = Cloud::new(points);
        let prims = std::fs::read_to_string(format!("{dir}/PC{n}_primitives.txt")).unwrap();
        let param =
            std::fs::read_to_string(format!("{dir}/PC{n}_parametric.txt")).unwrap_or_default();
        let kinds: Vec<String> = param
            .split("Primitive")
            .skip(1)
            .map(|s| {
                s.split('[')
                    .nth(1)
                    .unwrap_or("")
                    .split(',')
                    .next()
                    .unwrap_or("")
                    .to_string()
            })
            .collect();
        let truth: Vec<Vec<u32>> = prims
            .split("Primitive")
            .skip(1)
            .map(|s| {
                let s = &s[s.find('[').unwrap()..];
                numbers(s).iter().map(|v| *v as u32 - 1).collect()
            })
            .collect();
        let t0 = Instant::now();
        let mut search = Search::new(&cloud, &Parameters::default(), 1);
        let t1 = Instant::now();
        hough::find(&mut search, &mut ()).unwrap();
        let t2 = Instant::now();
        let acc = search.accepted();
        let mut worst = vec![];
        let mut sum = 0.0;
        for (t, tr) in truth.iter().enumerate() {
            let set: std::collections::HashSet<u32> = tr.iter().copied().collect();
            // recall of best surface
            let best = acc
                .iter()
                .map(|c| {
                    (
                        c.support.iter().filter(|i| set.contains(i)).count() as f64
                            / tr.len() as f64,
                        c,
                    )
                })
                .max_by(|a, b| a.0.total_cmp(&b.0));
            let (r, k) = best.map_or((0.0, "-"), |(r, c)| (r, c.surface.kind().name()));
            sum += r;
            let tk = kinds.get(t).map_or("?", |s| s.as_str());
            if r < 0.9 || (tk != k) {
                worst.push(format!("{}:{}n{}>{}@{:.2}", t + 1, tk, tr.len(), k, r));
            }
        }
        total += sum / truth.len() as f64;
        times.push((t2 - t0).as_secs_f64());
        println!(
            "PC{n} n={} truth={} acc={} recall={:.4} prep {:.0}ms find {:.0}ms {}",
            cloud.len(),
            truth.len(),
            acc.len(),
            sum / truth.len() as f64,
            (t1 - t0).as_secs_f64() * 1e3,
            (t2 - t1).as_secs_f64() * 1e3,
            worst.join(" ")
        );
    }
    times.sort_by(f64::total_cmp);
    println!(
        "mean recall {:.4} median {:.3}s worst {:.3}s",
        total / names.len() as f64,
        times[times.len() / 2],
        times[times.len() - 1]
    );
}
