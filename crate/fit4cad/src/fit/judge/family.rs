//! Which family of surfaces describes some points best: the one whose errors and parameters together take
//! fewest nats.

use super::energy::{self, Deviation, of_family, of_shared, of_surface};
use crate::cloud::Point;
use crate::cloud::normals::Spread;
use crate::fit::least_squares::{self, Loss, degrees_of_freedom};
use crate::fit::local;
use crate::fit::relations::Known;
use crate::surface::{Plane, Surface, SurfaceType};

/// Standard deviations from which on a point has no say in a fit.
const CUT_OFF: f64 = 4.5;
/// Largest radius, in diameters of the cloud: beyond it a face within the cloud is all but a plane.
const LARGEST: f64 = 3.0;
/// Smallest radius, in standard deviations.
const SMALLEST: f64 = 2.0;
/// Smallest half-angle of a cone, in radians; a slimmer one is a cylinder.
const SLIMMEST: f64 = 5e-3;
/// How far, in radians, the half-angle of a cone stays from a right one; a flatter one is a plane.
const FLATTEST: f64 = 2e-2;
/// Smallest major radius of a torus, in minor ones: within noise one that cuts its own axis may be a
/// piece of one that does not.
const FATTEST: f64 = 0.3;

/// What is known of a cloud where surfaces are fitted.
#[derive(Debug, Clone, Copy)]
pub struct Measures {
    /// How the points lie off their surfaces.
    pub deviation: Deviation,
    /// Diameter of the cloud.
    pub diameter: f64,
    /// Whether families are as likely as they are common. Where proposals begin as small patches all are alike: one that is
    /// taken for a plane at first grows no further than a plane does.
    pub weighs_families: bool,
}

/// Some points of a group, that stand for all.
#[derive(Debug, Clone)]
pub struct Sample {
    /// The points.
    pub points: Vec<Point>,
    /// How many they stand for.
    pub count: usize,
}

impl Sample {
    /// An even sample of up to `most` of the points of the given indices.
    pub fn of(points: &[Point], indices: &[u32], most: usize) -> Self {
        let stride = indices.len().div_ceil(most).max(1);
        let chosen = indices.iter().step_by(stride);
        Self {
            points: chosen.map(|&i| points[i as usize]).collect(),
            count: indices.len(),
        }
    }
}

impl Measures {
    /// What the points cost on a surface, itself included, in nats.
    pub fn cost(&self, surface: &Surface, sample: &Sample) -> f64 {
        self.errors(surface, sample) + self.price(surface.kind(), sample.count)
    }

    /// What a surface of a family costs that describes so many points, in nats.
    pub fn price(&self, kind: SurfaceType, points: usize) -> f64 {
        let family = if self.weighs_families {
            of_family(kind)
        } else {
            0.0
        };
        of_surface(kind, points) + family
    }

    /// What the errors of the points from a surface cost, in nats.
    pub fn errors(&self, surface: &Surface, sample: &Sample) -> f64 {
        let points = sample.points.iter();
        let costs = points.map(|p| self.deviation.cost(surface.distance(p)));
        let sum: f64 = costs.map(|cost| cost.min(energy::OUTLIER)).sum();
        let each = sample.count as f64 / sample.points.len().max(1) as f64;
        each * sum
    }

    /// The surface of the same family that fits points best, those far off it without a say. `None` where
    /// there is none within reach.
    pub fn refit(&self, surface: &Surface, points: &[Point]) -> Option<Surface> {
        let loss = Loss::Biweight(CUT_OFF * self.deviation.noise);
        let fitted = least_squares::approximate(surface, points, loss)?.surface;
        self.is_plausible(&fitted).then_some(fitted)
    }

    /// Whether a surface can be told from a simpler one within the cloud.
    fn is_plausible(&self, surface: &Surface) -> bool {
        let radii = SMALLEST * self.deviation.noise..LARGEST * self.diameter;
        let slopes = SLIMMEST..std::f64::consts::FRAC_PI_2 - FLATTEST;
        match surface {
            Surface::Plane(_) => true,
            Surface::Cylinder(s) => radii.contains(&s.radius),
            Surface::Cone(s) => slopes.contains(&s.half_angle),
            Surface::Sphere(s) => radii.contains(&s.radius),
            Surface::Torus(s) => {
                radii.contains(&s.minor_radius)
                    && s.major_radius < LARGEST * self.diameter
                    && s.major_radius > FATTEST * s.minor_radius
            }
        }
    }

    /// The cheapest description of some points: the given surface, fitted to them, or one of another
    /// family.
    pub fn best(&self, given: Option<Surface>, sample: &Sample) -> Option<Surface> {
        let mut best: Option<(Surface, f64)> = None;
        if let Some(given) = given {
            self.consider(&given, sample, &mut best);
        }
        let fewest = sample.points.len() as f64;
        for kind in SurfaceType::ALL {
            if given.is_some_and(|it| it.kind() == kind) {
                continue;
            }
            // Noise alone leaves half a nat for each degree of freedom, give or take half the root of twice as many.
            let spare = (fewest - degrees_of_freedom(kind) as f64).max(0.0);
            let each = sample.count as f64 / fewest.max(1.0);
            let least =
                self.price(kind, sample.count) + each * 0.5 * spare - (sample.count as f64).sqrt();
            if best.is_some_and(|(_, cost)| cost <= least) {
                continue;
            }
            for start in starts(kind, &sample.points, best.map(|it| it.0)) {
                self.consider(&start, sample, &mut best);
            }
        }
        best.map(|it| it.0)
    }

    /// A surface that shares a direction or an axis with one that is known and describes some points more cheaply than the given
    /// one; `None` where none does.
    ///
    /// What is shared makes a rare family cheap, and a plane bent by points of its neighbours is soon a cone about some axis. So cones
    /// and tori take the place of others but planes and cylinders only.
    pub fn shared(&self, known: &Known, sample: &Sample, given: &Surface) -> Option<Surface> {
        let is_common = |kind| matches!(kind, SurfaceType::Plane | SurfaceType::Cylinder);
        let may_be = |kind| is_common(kind) || !is_common(given.kind());
        let mut best = None;
        let mut least = self.cost(given, sample);
        for held in known.held(may_be, &sample.points, self.deviation.noise) {
            let cost = self.errors(&held.surface, sample) + of_shared(held, sample.count);
            if cost < least && self.is_plausible(&held.surface) {
                least = cost;
                best = Some(held.surface);
            }
        }
        best
    }

    /// Keeps a surface, fitted, where it is cheaper than the best.
    fn consider(&self, start: &Surface, sample: &Sample, best: &mut Option<(Surface, f64)>) {
        if let Some(surface) = self.refit(start, &sample.points) {
            let cost = self.cost(&surface, sample);
            if best.is_none_or(|(_, least)| cost < least) {
                *best = Some((surface, cost));
            }
        }
    }
}

/// Surfaces of a family from which a fit to some points may start.
fn starts(kind: SurfaceType, points: &[Point], best: Option<Surface>) -> Vec<Surface> {
    if kind == SurfaceType::Plane {
        let spread = Spread::of(points.iter());
        let plane = spread.map(|it| Plane::new(it.centroid, it.normal().into_inner()));
        return plane.map(Surface::Plane).into_iter().collect();
    }
    let mut starts = local::starts(kind, points);
    if kind == SurfaceType::Cone
        && let Some(Surface::Cylinder(near)) = best
    {
        let cone = least_squares::fit_cone_near(&near, points, Loss::Squares);
        starts.extend(cone.map(|it| it.surface));
    }
    starts
}
