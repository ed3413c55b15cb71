//! What becomes of STEP files, natively: per file the faces, the time, and, where an `oracle.json` lies
//! beside them (areas by Open Cascade), how areas compare. After `--json`, a line of JSON per file in the
//! place of words: each face with its points, for other programs to judge.

use std::time::Instant;

use fit4cad_step::{Amount, Document, Import, Options};
use serde_json::{Value, json};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut paths: Vec<String> = std::env::args().skip(1).collect();
    let json = paths.first().is_some_and(|word| word == "--json");
    if json {
        paths.remove(0);
    }
    for path in paths {
        let bytes = std::fs::read(&path)?;
        let start = Instant::now();
        let document = match Document::read(&bytes, &mut |_| {}) {
            Ok(document) => document,
            Err(error) => {
                if json {
                    println!("{}", json!({ "path": path, "error": error.to_string() }));
                } else {
                    println!("{path}: {error}");
                }
                continue;
            }
        };
        let read = start.elapsed().as_secs_f64();
        let options = Options {
            amount: Amount::Points(if json { 2_000 } else { 20_000 }),
            join: !json,
            ..Options::default()
        };
        let import = match document.sample("part", &options, &mut |_| {}) {
            Ok(import) => import,
            Err(error) if json => {
                println!("{}", json!({ "path": path, "error": error.to_string() }));
                continue;
            }
            Err(error) => return Err(error.into()),
        };
        if json {
            println!("{}", lines_of(&path, &import));
            continue;
        }
        let total = start.elapsed().as_secs_f64();
        let report = &import.report;
        println!(
            "{path}: {} bodies, {} instances, {} faces, area {:.4}, {} points, {:.3} s to read, {:.3} s in all",
            report.bodies,
            report.instances,
            report.faces.len(),
            report.area,
            import.model.cloud.len(),
            read,
            total
        );
        for line in report.left_out.iter().chain(&report.warnings) {
            println!("  {line}");
        }
        for face in report.faces.iter().filter(|face| !face.remark.is_empty()) {
            println!(
                "  #{} {}: {} (area {:.6})",
                face.face, face.surface, face.remark, face.area
            );
        }
        let oracle = std::path::Path::new(&path).with_file_name("oracle.json");
        if let Ok(text) = std::fs::read_to_string(oracle) {
            compare(&text, &path, report)?;
        }
    }
    Ok(())
}

/// Every face with its points, which follow one another in the order of the faces.
fn lines_of(path: &str, import: &Import) -> Value {
    let mut points = import.model.cloud.points().iter();
    let report = &import.report;
    let faces = report.faces.iter().map(|face| {
        let own = points.by_ref().take(face.points);
        json!({
            "id": face.face,
            "instance": face.instance,
            "surface": face.surface,
            "type": face.kind.map(|kind| kind.name()),
            "area": face.area,
            "remark": face.remark,
            "points": own.map(|at| [at.x, at.y, at.z]).collect::<Vec<_>>(),
        })
    });
    let faces: Vec<Value> = faces.collect();
    json!({
        "path": path,
        "diagonal": report.diagonal,
        "bodies": report.bodies,
        "instances": report.instances,
        "faces": faces,
        "doubts": report.doubts(),
    })
}

fn compare(
    oracle: &str,
    path: &str,
    report: &fit4cad_step::Report,
) -> Result<(), Box<dyn std::error::Error>> {
    let oracle: Value = serde_json::from_str(oracle)?;
    let name = std::path::Path::new(path)
        .file_name()
        .and_then(|name| name.to_str());
    let Some(faces) = oracle[name.unwrap_or_default()]["faces"].as_array() else {
        return Ok(());
    };
    let mut theirs: Vec<(f64, &str)> = faces
        .iter()
        .filter(|face| face["type"] != "other")
        .map(|face| {
            (
                face["area"].as_f64().unwrap_or(0.0),
                face["type"].as_str().unwrap_or(""),
            )
        })
        .collect();
    let mut ours: Vec<(f64, String, u64)> = report
        .faces
        .iter()
        .map(|face| (face.area, face.surface.clone(), face.face))
        .collect();
    println!("  {} faces of theirs, {} of ours", theirs.len(), ours.len());
    theirs.sort_by(|a, b| a.0.total_cmp(&b.0));
    ours.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut worst = 0.0_f64;
    for (a, b) in theirs.iter().zip(&ours) {
        let off = (a.0 - b.0).abs() / a.0;
        worst = worst.max(off);
        if off > 1e-3 {
            println!("  area {} of a {} is {} of #{} {}", a.0, a.1, b.0, b.2, b.1);
        }
    }
    println!("  worst area off by {worst:.2e}");
    Ok(())
}
