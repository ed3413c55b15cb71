//! At which stage a true primitive was lost, and where spurious ones come from.

use fit4cad::fit::{Candidate, Search, stages};
use fit4cad::metrics::{Counts, Report};
use fit4cad::model::{Primitive, Segmentation};
use fit4cad::surface::{Surface, SurfaceType};

/// Below this DSC a true primitive counts as lost, and a predicted one as spurious.
const LOST: f64 = 0.8;

/// One line per lost and per spurious primitive, from the search that led to what was found.
pub fn diagnose(
    search: &Search<'_>,
    truth: &Segmentation,
    found: &Segmentation,
    report: &Report,
) -> Vec<String> {
    let mut lines = Vec::new();
    let pruned = stages::prune(search, search.accepted().to_vec());
    let mut labels = vec![0u32; search.cloud.len()];
    for &index in truth.primitives.iter().flat_map(|p| &p.points) {
        labels[index as usize] += 1;
    }
    for (primitive, row) in truth.primitives.iter().zip(&report.primitives) {
        let dsc = dsc(&row.counts);
        if dsc >= LOST {
            continue;
        }
        let own = primitive
            .points
            .iter()
            .filter(|&&i| labels[i as usize] == 1);
        let matched = row.matched.map(|place| &found.primitives[place]);
        lines.push(format!(
            "lost {:8} {:>5} points, {:>4} own, {} DSC {dsc:.2}: {}",
            name(primitive.kind),
            primitive.points.len(),
            own.count(),
            size(primitive, search),
            fate(search, &pruned, primitive, matched),
        ));
    }
    for (row, prediction) in report.predictions.iter().zip(&found.primitives) {
        let dsc = row.dsc.unwrap_or(0.0);
        if dsc < LOST {
            let free = prediction
                .points
                .iter()
                .filter(|&&i| labels[i as usize] == 0);
            let over = row.matched.and_then(|place| truth.primitives[place].kind);
            lines.push(format!(
                "spurious {:8} {:>5} points, {:>4} of no primitive, {} DSC {dsc:.2} with {}",
                name(prediction.kind),
                prediction.points.len(),
                free.count(),
                size(prediction, search),
                name(over),
            ));
        }
    }
    lines
}

fn dsc(counts: &Counts) -> f64 {
    let both = 2.0 * counts.true_positives as f64;
    both / (both + (counts.false_positives + counts.false_negatives) as f64).max(1.0)
}

fn name(kind: Option<SurfaceType>) -> String {
    kind.map_or("free".to_owned(), |kind| format!("{kind:?}"))
}

/// Sizes of a surface in spacings.
fn size(primitive: &Primitive, search: &Search<'_>) -> String {
    let spacing = search.scale.spacing;
    match primitive.surface {
        Some(Surface::Cylinder(s)) => format!("r {:.2}", s.radius / spacing),
        Some(Surface::Sphere(s)) => format!("r {:.2}", s.radius / spacing),
        Some(Surface::Cone(s)) => format!("{:.0} deg", s.half_angle.to_degrees()),
        Some(Surface::Torus(s)) => {
            format!(
                "R {:.2} r {:.2}",
                s.major_radius / spacing,
                s.minor_radius / spacing
            )
        }
        _ => String::new(),
    }
}

/// Where a true primitive went.
fn fate(
    search: &Search<'_>,
    pruned: &[Candidate],
    primitive: &Primitive,
    matched: Option<&Primitive>,
) -> String {
    let shared = |candidate: &Candidate| {
        let on = |i: &&u32| candidate.surface.distance(search.point(**i)) <= search.scale.tolerance;
        primitive.points.iter().filter(on).count()
    };
    let held = |candidate: &Candidate| {
        let on = |i: &&u32| candidate.support.binary_search(i).is_ok();
        primitive.points.iter().filter(on).count()
    };
    let through = |candidate: &&Candidate| 5 * shared(candidate) >= 4 * primitive.points.len();
    let same = |candidate: &&Candidate| Some(candidate.surface.kind()) == primitive.kind;
    let off = primitive.surface.map_or(0.0, |surface| {
        let points = primitive.points.iter();
        let far = points.map(|&i| surface.distance(search.point(i)));
        far.fold(0.0, f64::max)
    });
    let exact = format!(
        "truth off by {:.1} tolerances",
        off / search.scale.tolerance
    );
    if pruned.iter().filter(same).any(|c| through(&c)) {
        let Some(matched) = matched else {
            return "found, then not labelled".to_owned();
        };
        let inside = matched
            .points
            .iter()
            .filter(|i| primitive.points.binary_search(i).is_ok())
            .count();
        return if 10 * inside >= 9 * matched.points.len() {
            format!("split: its largest piece has {inside} points")
        } else {
            format!("merged into {} points", matched.points.len())
        };
    }
    if search.accepted().iter().filter(same).any(|c| through(&c)) {
        return "pruned".to_owned();
    }
    if let Some(other) = pruned.iter().find(through) {
        return format!("typed {:?}; {exact}", other.surface.kind());
    }
    if let Some(other) = search.accepted().iter().find(through) {
        return format!("pruned as {:?}; {exact}", other.surface.kind());
    }
    let free = primitive.points.iter().filter(|&&i| {
        !search
            .accepted()
            .iter()
            .any(|c| c.support.binary_search(&i).is_ok())
    });
    let mut takers: Vec<(usize, SurfaceType)> = pruned
        .iter()
        .map(|candidate| (held(candidate), candidate.surface.kind()))
        .filter(|(count, _)| *count > 2)
        .collect();
    takers.sort_by_key(|(count, kind)| (std::cmp::Reverse(*count), *kind as usize));
    takers.truncate(4);
    format!(
        "not found, {} unexplained, held by {takers:?}; {exact}",
        free.count()
    )
}
