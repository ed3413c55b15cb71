//! The last step: every surface is fitted by least squares to the points it has in the end.
//!
//! Patches of one surface stay on one, and have all their points in its fit. Points at the edges have no say where the others
//! suffice: within noise some of them are the neighbour's, all on the same side.

use super::least_squares::{self, BIWEIGHT, Loss, degrees_of_freedom};
use super::progress::{Cancelled, Observer, Stage};
use super::relations::Known;
use super::search::Search;
use crate::cloud::Point;
use crate::model::{Primitive, Segmentation};
use crate::surface::Surface;

/// Points that a fit begins with; all are then worth a few steps only.
const FIRST: usize = 2000;
/// These few, each of which leaves a hundredth of what there was to go.
const STEPS: usize = 4;
/// Neighbours of a point inside a face that are on the same surface, and on no other.
const INSIDE: usize = 10;
/// Share of its points that a surface has to have inside, and how many of them for each degree of freedom, to be fitted to these.
const ENOUGH: f64 = 0.25;
const EACH: usize = 4;
/// By how many standard deviations of what chance gains a fit has to be better than a surface that may be exact by what it shares
/// with others.
const SIGNIFICANT: f64 = 3.0;

/// The place of a point on no surface, and of one on several.
const NONE: u32 = u32::MAX;
const SEVERAL: u32 = u32::MAX - 1;

/// A surface as it was found, and as its points have it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Refitted {
    /// As it was found.
    pub from: Surface,
    /// As it is.
    pub to: Surface,
}

/// Fits every surface of what was found. O(points).
///
/// Of a cloud that is exact, surfaces that follow from others (an axis of a neighbour's, a plane at a right angle) stay as
/// they are unless their points say otherwise. Within noise a surface shares the direction or axis of one with more points, where its
/// own points do not say otherwise.
///
/// # Errors
/// If the observer stops the fit.
pub fn refit(
    search: &Search<'_>,
    found: &Segmentation,
    observer: &mut dyn Observer,
) -> Result<Vec<Refitted>, Cancelled> {
    let mut groups: Vec<(Surface, Vec<u32>)> = Vec::new();
    for primitive in &found.primitives {
        let Some(surface) = primitive.surface else {
            continue;
        };
        match groups.iter_mut().find(|(known, _)| *known == surface) {
            Some((_, points)) => points.extend_from_slice(&primitive.points),
            None => groups.push((surface, primitive.points.clone())),
        }
    }
    let mut surfaces = vec![NONE; search.cloud.len()];
    for (place, (_, points)) in (0u32..).zip(&mut groups) {
        points.sort_unstable();
        points.dedup();
        for &index in points.iter() {
            let on = &mut surfaces[index as usize];
            *on = if *on == NONE { place } else { SEVERAL };
        }
    }
    let mut order: Vec<_> = (0u32..).zip(groups).collect();
    order.sort_by_key(|(_, (_, points))| std::cmp::Reverse(points.len()));
    let mut known = Known::default();
    let mut refitted = Vec::new();
    for (place, (surface, all)) in order {
        observer.progress(Stage::Patches, 1.0)?;
        let is_own = |index: u32| surfaces[index as usize] == place;
        let is_inside = |&&index: &&u32| {
            let mut near = search.graph.of(index).iter().take(INSIDE);
            is_own(index) && near.all(|&other| is_own(other))
        };
        let mut own: Vec<u32> = all.iter().filter(is_inside).copied().collect();
        let needed = EACH * degrees_of_freedom(surface.kind());
        if own.len() < needed || (own.len() as f64) < ENOUGH * all.len() as f64 {
            own = all;
        }
        let points = search.points(&own);
        let mut to = fitted(search, surface, &points, observer)?.unwrap_or(surface);
        if !search.scale.is_clean() {
            to = sharing(&known, search.scale.noise, to, &points);
            known.add(&to);
        }
        if to != surface {
            refitted.push(Refitted { from: surface, to });
        }
    }
    Ok(refitted)
}

/// Puts primitives on their surfaces.
pub fn apply(segmentation: &mut Segmentation, refitted: &[Refitted]) {
    for primitive in &mut segmentation.primitives {
        let mut known = refitted.iter();
        if let Some(it) = known.find(|it| primitive.surface == Some(it.from)) {
            let points = std::mem::take(&mut primitive.points);
            *primitive = Primitive::on(it.to, primitive.number, points);
        }
    }
}

/// The points that a fit begins with: all, or so many of them evenly.
fn first(points: &[Point]) -> Vec<Point> {
    let stride = points.len().div_ceil(FIRST).max(1);
    points.iter().step_by(stride).copied().collect()
}

/// The surface as its points have it; `None` where it is to stay as it is.
fn fitted(
    search: &Search<'_>,
    surface: Surface,
    points: &[Point],
    observer: &mut dyn Observer,
) -> Result<Option<Surface>, Cancelled> {
    let noise = search.scale.noise;
    let loss = Loss::Biweight(BIWEIGHT * noise);
    let some = first(points);
    let Some(of_some) = least_squares::fit(&surface, &some, loss) else {
        return Ok(None);
    };
    let mut best = of_some.surface;
    for _ in 0..if some.len() < points.len() { STEPS } else { 0 } {
        observer.progress(Stage::Patches, 1.0)?;
        let Some(next) = least_squares::step(&best, points, loss) else {
            return Ok(None);
        };
        best = next.surface;
    }
    let is_kept = search.is_plausible(&best)
        && best.is_in_range()
        && (!search.scale.is_clean() || is_significant(&surface, &best, points, noise));
    Ok(is_kept.then_some(best))
}

/// The surface nearest to the points of those of its family that share a direction or an axis with one known, unless the surface
/// itself is better by more than chance.
fn sharing(known: &Known, noise: f64, surface: Surface, points: &[Point]) -> Surface {
    let some = first(points);
    let held = known.held(|kind| kind == surface.kind(), &some, noise);
    let nearest = held
        .map(|it| (it.surface, squares(&it.surface, &some, noise)))
        .filter(|(it, _)| it.is_in_range())
        .min_by(|(_, a), (_, b)| a.total_cmp(b));
    match nearest {
        Some((held, _)) if !is_significant(&held, &surface, points, noise) => held,
        _ => surface,
    }
}

/// Whether a fit is better than a surface by more than chance lets it be: by the variance of the points off it for each
/// degree of freedom, give or take.
fn is_significant(old: &Surface, new: &Surface, points: &[Point], noise: f64) -> bool {
    let freedom = degrees_of_freedom(new.kind()) as f64;
    let sum = |surface: &Surface| squares(surface, points, noise);
    let left = sum(new);
    let variance = left / (points.len() as f64 - freedom).max(1.0);
    let chance = freedom + SIGNIFICANT * (2.0 * freedom).sqrt();
    sum(old) - left > chance * variance
}

/// Sum of the squares of how far points are off a surface, those farther off than noise leaves any counted as at its end.
fn squares(surface: &Surface, points: &[Point], noise: f64) -> f64 {
    let distances = points.iter().map(|point| surface.distance(point));
    distances.map(|it| it.min(BIWEIGHT * noise).powi(2)).sum()
}
