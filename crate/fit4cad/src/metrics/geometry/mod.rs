//! How well predicted surfaces reproduce the true ones: the figures of fit that the field reports.
//!
//! True and predicted primitives are matched one to one by IoU, as SPFN does. What the field samples
//! on a true patch is taken here at the points of the true primitive, each moved to its foot on the
//! true surface: all of them, so that nothing is drawn at random and no figure hangs on a seed.

mod normalisation;
mod parameters;
#[cfg(test)]
mod tests;

pub(super) use normalisation::Lengths;
pub use normalisation::{Normalisation, UnknownNormalisation};

use parameters::between;

use super::hidden::{MatchedType, TypeConfusion};
use super::segmentation::assignment::Partner;
use crate::cloud::{Cloud, Direction, Point};
use crate::model::{Primitive, Segmentation};
use crate::surface::Surface;

/// How lengths are given, and what counts as near.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scale {
    /// What every length is divided by.
    pub normalisation: Normalisation,
    /// ε of the coverages, in units of the normalisation; not negative.
    pub epsilon: f64,
}

impl Default for Scale {
    /// SPFN's: a shape scaled to the unit sphere, ε = 0.01.
    fn default() -> Self {
        Self {
            normalisation: Normalisation::UnitSphere,
            epsilon: 0.01,
        }
    }
}

/// The figures of fit of one submission. Lengths in units of the normalisation, angles in degrees.
/// A figure is `None` where there is nothing to measure: no true primitive, no predicted surface at
/// all, no pair of the right type.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Geometry {
    /// Share of the cloud's points within ε of any predicted surface.
    pub p_coverage: Option<f64>,
    /// Mean over all true primitives of the share of their samples within ε of the matched surface;
    /// 0 without a match.
    pub s_coverage: Option<f64>,
    /// Mean over the matched true primitives of the mean distance of their samples to the matched
    /// surface.
    pub residual: Option<f64>,
    /// Mean over the matched true primitives of the root mean square of that distance.
    pub residual_rms: Option<f64>,
    /// Mean over the matched true primitives of the mean angle between true and matched surface at
    /// their samples, 0° to 90°.
    pub normal_error: Option<f64>,
    /// Mean angle between true and predicted axis over pairs of the right type, 0° to 90°; 0 of
    /// spheres, which have none.
    pub axis_error: Option<f64>,
    /// Mean difference of radii over pairs of cylinders, spheres and tori; of a torus the mean of both.
    pub radius_error: Option<f64>,
    /// Mean difference of half-angles over pairs of cones, in degrees.
    pub angle_error: Option<f64>,
    /// Share of the matched pairs that are of the same type, where both are known.
    pub type_accuracy: Option<f64>,
    /// Types of true primitives against types of their one-to-one partners.
    pub types: TypeConfusion,
}

/// The mean of what is there, added up as it comes.
#[derive(Default)]
struct Mean {
    sum: f64,
    count: u32,
}

impl Mean {
    fn add(&mut self, value: f64) {
        self.sum += value;
        self.count += 1;
    }

    fn value(&self) -> Option<f64> {
        (self.count > 0 && self.sum.is_finite()).then(|| self.sum / f64::from(self.count))
    }
}

/// Measures the surfaces of a submission. `partners` are those of the true primitives.
///
/// O(points · surfaces) at worst, for points near no surface: a point within ε of the surface of its
/// own primitive is not measured against any other.
pub fn measure(
    cloud: &Cloud,
    truth: &Segmentation,
    predicted: &Segmentation,
    partners: &[Option<Partner>],
    scale: Scale,
) -> Geometry {
    let lengths = Lengths::of(cloud, scale.normalisation);
    let has_surfaces = predicted.primitives.iter().any(|it| it.surface.is_some());
    let is_answered = has_surfaces || predicted.primitives.is_empty();
    let mut s_coverage = Mean::default();
    let (mut residual, mut rms, mut normal) = (Mean::default(), Mean::default(), Mean::default());
    let (mut axis, mut radius, mut angle) = (Mean::default(), Mean::default(), Mean::default());
    let mut right_type = Mean::default();
    let mut types = TypeConfusion::default();
    let rows = truth.primitives.iter().zip(partners);
    for (primitive, partner) in rows {
        let partner = partner.and_then(|partner| predicted.primitives.get(partner.predicted));
        types.add(primitive.kind, matched_type(partner));
        if let Some((one, other)) = primitive.kind.zip(partner.and_then(|it| it.kind)) {
            right_type.add(if one == other { 1.0 } else { 0.0 });
        }
        let Some(unit) = lengths.of_primitive(cloud, primitive) else {
            continue;
        };
        let surface = partner.and_then(|partner| partner.surface);
        let Some(surface) = surface else {
            s_coverage.add(0.0);
            continue;
        };
        let Some(fit) = sampled(cloud, primitive, &surface, scale.epsilon * unit) else {
            continue;
        };
        s_coverage.add(fit.near);
        residual.add(fit.mean / unit);
        rms.add(fit.rms / unit);
        if let Some(degrees) = fit.normal {
            normal.add(degrees);
        }
        if let Some(own) = primitive.surface {
            let differences = parameters::compare(&own, &surface);
            let each = [
                (&mut axis, differences.axis),
                (&mut radius, differences.radius.map(|radius| radius / unit)),
                (&mut angle, differences.half_angle),
            ];
            for (mean, value) in each {
                if let Some(value) = value {
                    mean.add(value);
                }
            }
        }
    }
    Geometry {
        p_coverage: is_answered
            .then(|| p_coverage(cloud, predicted, &lengths, scale.epsilon))
            .flatten(),
        s_coverage: is_answered.then(|| s_coverage.value()).flatten(),
        residual: residual.value(),
        residual_rms: rms.value(),
        normal_error: normal.value(),
        axis_error: axis.value(),
        radius_error: radius.value(),
        angle_error: angle.value(),
        type_accuracy: right_type.value(),
        types,
    }
}

fn matched_type(partner: Option<&Primitive>) -> MatchedType {
    match partner {
        None => MatchedType::Missed,
        Some(partner) => partner.kind.map_or(MatchedType::Other, MatchedType::Type),
    }
}

/// What the samples of a true primitive say of a surface.
struct Sampled {
    near: f64,
    mean: f64,
    rms: f64,
    /// In degrees, where the true surface is known.
    normal: Option<f64>,
}

fn sampled(cloud: &Cloud, truth: &Primitive, surface: &Surface, near: f64) -> Option<Sampled> {
    let (mut sum, mut squares, mut inside, mut angles, mut count) = (0.0, 0.0, 0u32, 0.0, 0u32);
    for (sample, own) in samples(cloud, truth) {
        let distance = surface.distance(&sample);
        sum += distance;
        squares += distance * distance;
        inside += u32::from(distance <= near);
        if let Some(own) = own {
            angles += between(&own, &surface.normal(&sample));
        }
        count += 1;
    }
    let all = f64::from(count);
    (count > 0).then(|| Sampled {
        near: f64::from(inside) / all,
        mean: sum / all,
        rms: (squares / all).sqrt(),
        normal: truth.surface.map(|_| angles / all),
    })
}

/// The points of a true primitive; where its surface is known their feet on it, with its normal there.
fn samples(cloud: &Cloud, truth: &Primitive) -> impl Iterator<Item = (Point, Option<Direction>)> {
    let points = truth.points.iter();
    let points = points.filter_map(|&index| cloud.points().get(index as usize));
    points.map(|point| {
        let Some(surface) = &truth.surface else {
            return (*point, None);
        };
        let normal = surface.normal(point);
        let foot = point - normal.into_inner() * surface.signed_distance(point);
        (foot, Some(normal))
    })
}

/// Share of the points within ε of any predicted surface; `None` for an empty cloud.
fn p_coverage(
    cloud: &Cloud,
    predicted: &Segmentation,
    lengths: &Lengths,
    epsilon: f64,
) -> Option<f64> {
    let reaches: Vec<(Surface, f64)> = predicted
        .primitives
        .iter()
        .filter_map(|it| Some((it.surface?, epsilon * lengths.of_primitive(cloud, it)?)))
        .collect();
    let mut is_near = vec![false; cloud.len()];
    // First what a primitive lists itself: mostly that settles it.
    for primitive in &predicted.primitives {
        let Some((surface, unit)) = primitive
            .surface
            .zip(lengths.of_primitive(cloud, primitive))
        else {
            continue;
        };
        for &index in &primitive.points {
            if let Some(point) = cloud.points().get(index as usize)
                && let Some(near) = is_near.get_mut(index as usize)
            {
                *near = *near || surface.distance(point) <= epsilon * unit;
            }
        }
    }
    let rest = is_near.iter_mut().zip(cloud.points());
    for (near, point) in rest.filter(|(near, _)| !**near) {
        let mut surfaces = reaches.iter();
        *near = surfaces.any(|(surface, reach)| surface.distance(point) <= *reach);
    }
    let count = is_near.iter().filter(|near| **near).count();
    (!cloud.is_empty()).then(|| count as f64 / cloud.len() as f64)
}
