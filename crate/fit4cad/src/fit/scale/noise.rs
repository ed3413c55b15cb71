//! How far the points of a cloud lie off their surfaces.
//!
//! A small neighbourhood inside a face is fitted with the simple families and its residual, corrected
//! for the degrees of freedom ν left over, is σ χ_ν / √ν: whatever the curvature, the surface absorbs
//! it. Neighbourhoods over edges, thin walls and free-form regions have larger residuals, never
//! smaller ones. Over a cloud the residuals therefore pile up at σ, and nothing lies below: σ is
//! where the lowest pile is. A low quantile, the usual robust choice, would depend on the share of
//! neighbourhoods that cross edges, which is anything from a twentieth to nine tenths.
//!
//! The pile is sought as the half-sample mode is (Bickel and Frühwirth 2006): in the window of a
//! given ratio with most residuals, here the lowest such window that is a maximum.

use crate::cloud::neighbours::{KdTree, Neighbourhoods};
use crate::cloud::normals::Spread;
use crate::cloud::{Ball, Point};
use crate::fit::least_squares::{self, Fitted, Loss, degrees_of_freedom};
use crate::fit::local::{self, CURVED, Curvature, through_sheet};
use crate::fit::quantile::quantile;
use crate::surface::{Surface, SurfaceType};

/// Neighbourhoods looked at first; of a clean cloud no more are needed.
const FIRST: usize = 120;
/// Neighbourhoods looked at before a cloud is held to be noisy.
const MORE: usize = 480;
/// Share of exact neighbourhoods at which no more are looked at.
const EXACT_SHARE: f64 = 0.1;
/// Share that suffices among [`MORE`], and least number: noise leaves none.
const FEWEST_EXACT: (f64, usize) = (0.02, 3);
/// Points of the smaller neighbourhoods, on one sheet where the sheets of a thin wall are close.
const FEW: usize = 10;
/// Residual, in floors, below which a neighbourhood is exact: of ten degrees of freedom left, one
/// residual in ten thousand is at a third of the noise.
const EXACT: f64 = 0.33;
/// As [`EXACT`], of a smaller neighbourhood: of four, one in a thousand is at a seventh.
const FEW_EXACT: f64 = 0.15;
/// Points beyond the degrees of freedom that must agree with a robust fit, which chooses them.
const SPARE: usize = 5;
/// Points of a neighbourhood that holds enough of both sheets of a shell.
const WIDE: usize = 32;
/// Half the thickness of a sheet, in radii of the patch.
const SHEET: f64 = 0.056;
/// Residual, in those halves, of points that are not on the sheet by being chosen for it.
const WELL_INSIDE: f64 = 0.2;
/// Ratio of the ends of a window: most residuals of ten degrees of freedom are within it.
const WINDOW: f64 = 2.5;
/// Share of all residuals that makes a pile.
const PILE: f64 = 0.08;
/// Median of the residuals in σ, of whole neighbourhoods and of the smaller ones: below one as that
/// of χ is, and as the best of several families is taken.
const MEDIANS: [f64; 2] = [0.94, 0.85];
/// Widest rounding of coordinates, in spacings, that a few residuals tell from points placed on a lattice.
const ROUNDING: f64 = 0.2;
/// And the widest at all: at more, points fall on each other, and are as far apart as if they were placed there.
const COARSE: f64 = 0.7;
/// Share of the residuals that rounding must have left where it is wider than [`ROUNDING`]: those of faces placed on
/// a lattice are exact, but for neighbourhoods over edges.
const MOSTLY: f64 = 0.5;

/// Standard deviation σ of the points off their surfaces, at least `floor`, below which differences
/// do not matter; and the step their coordinates were rounded to, 0 where they were not. A few thousand small fits, whatever the size of the cloud.
pub fn noise(
    points: &[Point],
    tree: &KdTree,
    graph: &Neighbourhoods,
    spacing: f64,
    floor: f64,
) -> (f64, f64) {
    let fine = FEW_EXACT * floor;
    let rounding = rounding(points, spacing, floor);
    let [mut whole, mut few] = [const { Vec::new() }; 2];
    let mut exact = 0usize;
    let mut inexact = Vec::new();
    for (place, &index) in spread_out(points.len()).iter().enumerate() {
        let is_exact = exact as f64 >= EXACT_SHARE * FIRST as f64;
        if place == FIRST && is_exact && rounding.is_none() {
            break;
        }
        let patch = patch(points, graph, index);
        let Some(residual) = residual(&patch, EXACT * floor) else {
            continue;
        };
        whole.push(residual);
        if residual <= EXACT * floor {
            exact += 1;
        } else {
            let nearest = &patch[..patch.len().min(FEW)];
            let nearest = self::residual(nearest, fine).unwrap_or(f64::INFINITY);
            let part = nearest.min(on_one_sheet(&patch).unwrap_or(f64::INFINITY));
            few.push(part);
            if part <= fine || is_exact_in_part(&patch, fine) {
                exact += 1;
            } else {
                inexact.push(index);
            }
        }
    }
    whole.sort_unstable_by(f64::total_cmp);
    few.sort_unstable_by(f64::total_cmp);
    if let Some(step) = rounding {
        let is_shown = if step <= ROUNDING * spacing {
            shown_within(&whole, step) + shown_within(&few, step) >= FEWEST_EXACT.1
        } else {
            shown_within(&whole, step) as f64 >= MOSTLY * whole.len() as f64
        };
        if is_shown {
            return ((step / 12f64.sqrt()).max(floor), step);
        }
    }
    let (share, least) = FEWEST_EXACT;
    let enough = least.max((share * whole.len() as f64).ceil() as usize);
    if exact < enough {
        exact += on_thin_shells(points, tree, &inexact, fine, enough - exact);
    }
    if exact >= enough {
        return (floor, 0.0);
    }
    let piles = [lowest_pile(&whole), lowest_pile(&few)];
    let noise = match [
        piles[0].map(|r| r / MEDIANS[0]),
        piles[1].map(|r| r / MEDIANS[1]),
    ] {
        // The smaller neighbourhoods say less precisely what they say, but find room in narrow faces.
        [Some(whole), Some(few)] if few < 0.4 * whole => few,
        [Some(whole), _] => whole,
        [None, few] => few.unwrap_or_else(|| quantile(&mut whole, 0.3)),
    };
    (noise.max(floor), 0.0)
}

/// Indices in an order of which every beginning is spread evenly over all of them.
fn spread_out(count: usize) -> Vec<u32> {
    let stride = count.div_ceil(MORE).max(1);
    let sampled = count.div_ceil(stride);
    let step = sampled.div_ceil(FIRST).max(1);
    (0..step)
        .flat_map(|start| (start..sampled).step_by(step))
        .map(|place| (place * stride) as u32)
        .collect()
}

/// A point and its neighbours.
fn patch(points: &[Point], graph: &Neighbourhoods, index: u32) -> Vec<Point> {
    let neighbours = graph.of(index).iter();
    std::iter::once(index)
        .chain(neighbours.copied())
        .map(|i| points[i as usize])
        .collect()
}

/// Residual standard deviation of a patch off the simple surface that fits it best, or off one that
/// fits to `enough`. `None` for a row of points, which is on any number of surfaces.
pub fn residual(patch: &[Point], enough: f64) -> Option<f64> {
    let spread = Spread::of(patch.iter())?;
    if spread.variances[1] <= 1e-4 * spread.variances[2] {
        return None;
    }
    let of = |fitted: Option<Fitted>| {
        let residual = fitted.and_then(|fitted| corrected(&fitted, patch.len()));
        residual.unwrap_or(f64::INFINITY)
    };
    let mut best = f64::INFINITY;
    for kind in [
        SurfaceType::Plane,
        SurfaceType::Sphere,
        SurfaceType::Cylinder,
        SurfaceType::Cone,
    ] {
        for start in local::starts(kind, patch) {
            best = best.min(of(least_squares::fit(&start, patch, Loss::Squares)));
            // A slim cone is found from the cylinder it nearly is.
            if best > enough
                && let Surface::Cylinder(cylinder) = &start
            {
                let cone = least_squares::fit_cone_near(cylinder, patch, Loss::Squares);
                best = best.min(of(cone));
            }
            if best <= enough {
                return Some(best);
            }
        }
    }
    // A torus is worth its time where the patch is smooth and bends as none of the others does.
    let smooth = Curvature::of(patch).map_or(f64::INFINITY, |shape| shape.error);
    if 2.0 * smooth < best {
        for start in local::starts(SurfaceType::Torus, patch) {
            best = best.min(of(least_squares::fit(&start, patch, Loss::Squares)));
        }
        best = best.min(smooth);
    }
    best.is_finite().then_some(best)
}

/// Residual standard deviation of a fit to so many points, corrected for the degrees of freedom left.
/// `None` where none are left.
fn corrected(fitted: &Fitted, count: usize) -> Option<f64> {
    let left = count.checked_sub(degrees_of_freedom(fitted.surface.kind()));
    let left = left.filter(|&left| left > 0)?;
    Some(fitted.error * (count as f64 / left as f64).sqrt())
}

/// Residual standard deviation of those points of a patch that lie on the plane of the first: of one
/// sheet of a thin wall, whose sheets are in the patch alike. `None` where they are few, or not so
/// near the plane that being chosen for it says nothing of how near.
fn on_one_sheet(patch: &[Point]) -> Option<f64> {
    let band = SHEET * Ball::of(patch).radius;
    let (plane, on) = local::plane_through_seed(patch, band)?;
    if on < 3 + SPARE {
        return None;
    }
    let plane = Surface::Plane(plane);
    let is_on = |point: &&Point| plane.distance(point) <= band;
    let sheet: Vec<Point> = patch.iter().filter(is_on).copied().collect();
    let fitted = least_squares::fit(&plane, &sheet, Loss::Squares)?;
    let residual = corrected(&fitted, sheet.len())?;
    (residual <= WELL_INSIDE * band).then_some(residual)
}

/// Whether most points of a patch lie exactly on one surface: the others may be on the next face, or on
/// the other sheet of a thin wall.
fn is_exact_in_part(patch: &[Point], fine: f64) -> bool {
    if local::plane_through_seed(patch, fine).is_some_and(|(_, on)| on >= 3 + SPARE) {
        return true;
    }
    CURVED.into_iter().any(|kind| {
        let needed = (degrees_of_freedom(kind) + SPARE).max(patch.len().div_ceil(2));
        local::starts(kind, patch)
            .iter()
            .any(|start| local::polish(start, patch, fine, needed).is_some())
    })
}

/// How many of some points, up to `wanted`, are exactly on a curved sheet of a shell so thin that their
/// neighbourhoods hold no more points of the sheet than of the other. Where there are none among the
/// first, no more are looked at.
fn on_thin_shells(
    points: &[Point],
    tree: &KdTree,
    some: &[u32],
    fine: f64,
    wanted: usize,
) -> usize {
    let mut near = Vec::new();
    let mut count = 0;
    for (place, &index) in some.iter().enumerate() {
        if count == wanted || (place == FIRST && count == 0) {
            break;
        }
        let middle = &points[index as usize];
        tree.nearest(middle, WIDE, f64::INFINITY, |_| true, &mut near);
        let patch: Vec<Point> = near.iter().map(|n| points[n.index as usize]).collect();
        let mut kinds = CURVED.into_iter();
        let is_on = kinds.any(|kind| through_sheet(kind, &patch, fine, SPARE).next().is_some());
        count += usize::from(is_on);
    }
    count
}

/// Median of the lowest pile of the residuals, which are sorted.
fn lowest_pile(residuals: &[f64]) -> Option<f64> {
    let count_from = |start: usize| {
        let end = WINDOW * residuals[start];
        residuals.partition_point(|&residual| residual <= end) - start
    };
    let least = (PILE * residuals.len() as f64).max(3.0);
    let mut best: Option<(usize, usize)> = None;
    for start in 0..residuals.len() {
        let count = count_from(start);
        match best {
            // The window slides on as long as it overlaps the best one.
            Some((place, _)) if residuals[start] > WINDOW * residuals[place] => break,
            Some((_, most)) if count <= most => {}
            _ if count as f64 >= least => best = Some((start, count)),
            _ => {}
        }
    }
    best.map(|(start, count)| residuals[start + count / 2])
}

/// The step of the decimal lattice that all coordinates are on: those of a file written with few
/// digits. `None` where it is finer than matters, or points have been placed on it: then they are nowhere nearer
/// each other than its steps, or those few of its steps that they all keep to.
fn rounding(points: &[Point], spacing: f64, floor: f64) -> Option<f64> {
    let highest = libm::log10(COARSE * spacing).floor();
    let is_on = |x: f64, step: f64| {
        let place = x / step;
        (place - place.round()).abs() <= 1e-6 + 4.0 * f64::EPSILON * place.abs()
    };
    let step = (0..12)
        .map(|digits| libm::pow(10f64, highest - f64::from(digits)))
        .take_while(|step| *step > floor)
        .find(|&step| points.iter().all(|p| p.iter().all(|&x| is_on(x, step))))?;
    let kept_to = (0..3).map(|axis| step * common_steps(points, axis, step));
    (kept_to.fold(f64::INFINITY, f64::min) <= COARSE * spacing).then_some(step)
}

/// The largest number of steps of which all distances along an axis are multiples; infinite where there are none.
fn common_steps(points: &[Point], axis: usize, step: f64) -> f64 {
    let mut common = 0.0f64;
    for point in points {
        let mut rest = ((point[axis] - points[0][axis]) / step).round().abs();
        while rest > 0.0 {
            (common, rest) = (rest, common % rest);
        }
        if common == 1.0 {
            break;
        }
    }
    if common > 0.0 { common } else { f64::INFINITY }
}

/// How many of the residuals, which are sorted, rounding to a step may have left. Faces along the
/// coordinate planes stay exact however coarse the step; where there are only these and residuals of
/// other origin, nothing was rounded.
fn shown_within(residuals: &[f64], step: f64) -> usize {
    let below = |limit: f64| residuals.partition_point(|&residual| residual <= limit);
    below(0.6 * step) - below(0.05 * step)
}
