//! Greedy detection from local hypotheses: wherever points are unexplained, surfaces through small
//! neighbourhoods are grown and the best one is kept, until nothing is left to find.

use super::least_squares::{self, Loss};
use super::local::{polish, starts};
use super::progress::{Cancelled, Observer, Stage};
use super::search::Search;
use super::trace::Event;
use super::{Candidate, Parameters, axes};
use crate::cloud::{Direction, Point};
use crate::surface::{Surface, SurfaceType};

/// Sizes of the neighbourhoods that hypotheses are made from: the small ones fit into fillets and
/// thin faces, the large one says more about slightly curved surfaces.
const SIZES: [usize; 3] = [10, 16, 28];
/// A plane that grew to so many unexplained points needs no rival.
pub(super) const CLEAR: usize = 60;

/// What a pass looks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pass {
    /// Faces with an inside.
    Faces,
    /// Faces that are all border: thin walls, chamfers, rings, fillets of three rulings. Any sphere
    /// and torus about the axis passes through a ring, so only the simpler types count here.
    Borders,
}

/// Finds faces through unexplained points until no seed leads to another.
///
/// Seeds are visited in random order. Where a seed leads nowhere, as in free-form regions, its
/// neighbours are not tried in the same round: most of the time would go there.
pub fn faces(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    let order = shuffled(search);
    for block in [16, 6] {
        let patience = Patience::SHORT;
        round(search, Pass::Faces, &order, block, patience, observer)?;
    }
    Ok(())
}

/// Finds what must lie between the borders of the faces found so far.
pub fn borders(search: &mut Search<'_>, observer: &mut dyn Observer) -> Result<(), Cancelled> {
    search.reopen_borders();
    let order = shuffled(search);
    round(search, Pass::Borders, &order, 6, Patience::LONG, observer)
}

/// The points in random order.
pub(super) fn shuffled(search: &mut Search<'_>) -> Vec<u32> {
    let mut order: Vec<u32> = (0u32..).take(search.cloud.len()).collect();
    search.random.shuffle(&mut order);
    order
}

fn round(
    search: &mut Search<'_>,
    pass: Pass,
    order: &[u32],
    block: usize,
    patience: Patience,
    observer: &mut dyn Observer,
) -> Result<(), Cancelled> {
    let mut blocked = vec![false; order.len()];
    let mut failures = 0;
    let mut found = 0;
    for (place, &seed) in order.iter().enumerate() {
        if place % 256 == 0 {
            observer.progress(Stage::Find, place as f64 / order.len() as f64)?;
        }
        if search.is_explained(seed) || blocked[seed as usize] {
            continue;
        }
        match at(search, pass, seed) {
            Some(candidate) => {
                keep(search, candidate, observer);
                found += 1;
            }
            None => {
                for index in search.unexplained_near(seed, block) {
                    blocked[index as usize] = true;
                }
                failures += 1;
                if failures > patience.first + patience.each * found {
                    break;
                }
            }
        }
    }
    Ok(())
}

/// How many failed seeds a round bears.
#[derive(Debug, Clone, Copy)]
struct Patience {
    /// Before it finds anything.
    first: usize,
    /// More for each surface found.
    each: usize,
}

impl Patience {
    /// For borders, of which there are few.
    const LONG: Self = Self {
        first: 600,
        each: 0,
    };
    /// For what other searches left: thin faces next to each other, or a free-form region, which
    /// would take most of the time.
    const SHORT: Self = Self { first: 20, each: 4 };
}

/// Accepts a candidate, and tells so.
pub(super) fn keep(search: &mut Search<'_>, candidate: Candidate, observer: &mut dyn Observer) {
    if observer.wants_trace() {
        observer.trace(Event::Accepted {
            surface: candidate.surface,
            support: candidate.support.clone(),
        });
    }
    search.accept(candidate);
}

/// The best surface through the unexplained points around a seed, if any is worth keeping.
pub fn at(search: &mut Search<'_>, pass: Pass, seed: u32) -> Option<Candidate> {
    let mut candidates: Vec<Candidate> = Vec::new();
    for size in SIZES {
        let patch = search.unexplained_near(seed, size);
        if patch.len() < size.min(5) {
            continue;
        }
        for kind in [
            SurfaceType::Plane,
            SurfaceType::Sphere,
            SurfaceType::Cylinder,
            SurfaceType::Cone,
        ] {
            if kind == SurfaceType::Sphere && pass == Pass::Borders {
                continue;
            }
            hypotheses(search, pass, kind, &patch, &mut candidates);
            let clear = candidates
                .iter()
                .any(|c| c.surface.kind() == SurfaceType::Plane && search.own(c) >= CLEAR);
            if clear {
                return search.best(candidates);
            }
        }
    }
    if pass == Pass::Borders && candidates.is_empty() {
        rounded(search, seed, &mut candidates);
    }
    if pass == Pass::Faces && !candidates.iter().any(|c| search.own(c) >= CLEAR) {
        let patch = search.unexplained_near(seed, SIZES[2]);
        hypotheses(search, pass, SurfaceType::Torus, &patch, &mut candidates);
    }
    search.best(candidates)
}

/// Adds what a face that is all border may be besides a plane, cylinder and cone: a torus about the
/// axis of a surface beside it, or a sphere. Through any two rings about an axis there is a sphere
/// and through any three a torus, so only points on more rows than that count.
fn rounded(search: &mut Search<'_>, seed: u32, candidates: &mut Vec<Candidate>) {
    let apart = 8.0 * search.scale.tolerance;
    for size in [SIZES[1], SIZES[2]] {
        let patch = search.unexplained_near(seed, size);
        let points = search.points(&patch);
        let beside = search.surfaces_beside(&patch);
        for (origin, axis) in beside.iter().filter_map(axes::axis_of) {
            let section = axes::half_plane(&points, &origin, &axis);
            if axes::rows(&section, apart) <= 3 {
                continue;
            }
            for start in robust_tori(&section, &origin, &axis) {
                grow_start(search, Pass::Borders, &start, &patch, candidates);
            }
        }
        let is_on_rings = beside
            .iter()
            .filter_map(axes::axis_of)
            .any(|(origin, axis)| {
                axes::rows(&axes::half_plane(&points, &origin, &axis), apart) <= 2
            });
        if !is_on_rings {
            hypotheses(
                search,
                Pass::Borders,
                SurfaceType::Sphere,
                &patch,
                candidates,
            );
        }
        if !candidates.is_empty() {
            return;
        }
    }
}

/// Grows the hypotheses of one family through a patch and adds those worth keeping.
fn hypotheses(
    search: &mut Search<'_>,
    pass: Pass,
    kind: SurfaceType,
    patch: &[u32],
    candidates: &mut Vec<Candidate>,
) {
    let points = search.points(patch);
    let mut surfaces = starts(kind, &points);
    if kind == SurfaceType::Cone {
        // A cylinder that almost fits may be a cone.
        for start in starts(SurfaceType::Cylinder, &points) {
            if let Surface::Cylinder(cylinder) = start
                && let Some(cone) = least_squares::fit_cone_near(&cylinder, &points, Loss::Squares)
            {
                surfaces.push(cone.surface);
            }
        }
    }
    for start in surfaces {
        grow_start(search, pass, &start, patch, candidates);
    }
}

/// Polishes a surface on the points of a patch, grows it, and adds it if it is worth keeping.
pub(super) fn grow_start(
    search: &mut Search<'_>,
    pass: Pass,
    start: &Surface,
    patch: &[u32],
    candidates: &mut Vec<Candidate>,
) {
    let kind = start.kind();
    let points = search.points(patch);
    // A third suffices for a plane: the patch may hold both sheets of a thin wall and its rim.
    let needed = if kind == SurfaceType::Plane {
        points.len() / 3
    } else {
        points.len() / 2
    };
    let Some((surface, inliers)) = polish(start, &points, search.scale.tolerance, needed) else {
        return;
    };
    if !search.is_plausible(&surface) {
        return;
    }
    let seeds: Vec<u32> = inliers.iter().map(|&i| patch[i]).collect();
    let known = candidates.iter().any(|c| {
        c.surface.kind() == kind && seeds.iter().all(|i| c.support.binary_search(i).is_ok())
    });
    if known || search.is_known(kind, &seeds) {
        return;
    }
    if let Some(candidate) = search.grow(&surface, &seeds)
        && is_worth_keeping(search, pass, &candidate)
    {
        candidates.push(candidate);
    }
}

/// Tori about an axis through all points of the half-plane, and through the nearest half of them: the
/// patch may hold points of the faces beside.
fn robust_tori(section: &[Point], origin: &Point, axis: &Direction) -> Vec<Surface> {
    let few = &section[..section.len().div_ceil(2)];
    [section, few]
        .into_iter()
        .filter_map(|part| axes::torus(part, origin, axis))
        .collect()
}

/// Whether a candidate explains enough that nothing else does, is a face rather than a curve, and
/// ends sharply.
pub(super) fn is_worth_keeping(search: &mut Search<'_>, pass: Pass, candidate: &Candidate) -> bool {
    let smallest = Parameters::count(search.parameters.smallest);
    let freedom = least_squares::degrees_of_freedom(candidate.surface.kind());
    // A few exact points more than a surface has freedoms are no accident; noisy ones are, in
    // numbers that grow with the share of space the tolerance takes up.
    let redundant = if search.scale.is_clean() {
        freedom + 3
    } else {
        NOISY * freedom
    };
    let own = search.own(candidate);
    if candidate.support.len() < smallest.max(redundant) || own < smallest.max(redundant / 3) {
        return false;
    }
    let thickness = search.thickness(candidate);
    let is_wide = match pass {
        Pass::Faces => thickness >= FACE,
        Pass::Borders => thickness >= ROWS && 2 * own >= candidate.support.len(),
    };
    is_wide && !search.has_fuzzy_border(candidate)
}

/// Noisy points needed per degree of freedom.
const NOISY: usize = 8;

/// Mean number of own neighbours among the eight nearest: of a patch with an inside.
const FACE: f64 = 5.2;
/// And of two rows of points, rather than one.
const ROWS: f64 = 3.0;
