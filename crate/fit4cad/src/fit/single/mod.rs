//! One primitive: the surface of a whole group of points, of whatever type, with what speaks for it and
//! what would be second best. There is always an answer.
//!
//! Points may be noisy, but for a share of them that is exact; some may be missing. So for each type
//! surfaces are started from closed forms and from axes that the normals tell (`starts`), the
//! nearest are polished by least squares under a loss that gives far points less and less say, as long as
//! points gather where the surface is (`polish`), and the types compete by how likely their
//! distances are and how many parameters they pay with (`score`).

mod polish;
mod starts;

use std::cmp::Ordering;

use nalgebra::Isometry3;

use super::least_squares::{self, Loss, degrees_of_freedom};
use super::quantile::quantile;
use crate::cloud::normals::Spread;
use crate::cloud::{Ball, Cloud, LARGEST, Point, Vector};
use crate::model::{Primitive, Segmentation};
use crate::random::Random;
use crate::surface::{Cone, Cylinder, Plane, Sphere, Surface, SurfaceType, Torus, across};

/// Points that starts are made of and judged by; surfaces that are in doubt are then polished on all. A
/// standard error of a twenty-fifth of the noise tells the types as well as a smaller one.
const SAMPLE: usize = 600;
/// Starts of a type that a few steps of least squares are tried on.
const TRIED: usize = 5;
/// Types that are polished on all points: the best by the sample.
const IN_DOUBT: usize = 2;
/// Distances below this share of the extent are as good as none: what files in single precision, or
/// of seven digits, leave of exact points.
const EXACT: f64 = 1e-7;
/// One in so many points may lie beyond the apex of a cone, as outliers do. A single primitive is on one
/// nappe; on both, a nearly flat cone passes for a plane, and through more of its noise.
const BEYOND_APEX: usize = 10;

/// A surface and how it fits its points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// The surface, in the units of the cloud.
    pub surface: Surface,
    /// Mean distance of the points.
    pub mean: f64,
    /// Root mean square distance of the points.
    pub rms: f64,
    /// Largest distance of a point.
    pub largest: f64,
    /// What decides between types: twice the negative logarithm of how likely the distances are, up to a
    /// constant, and ln n for each parameter. The less the better.
    pub score: f64,
}

/// What one group of points is.
#[derive(Debug, Clone, PartialEq)]
pub struct Single {
    /// The best surface.
    pub best: Verdict,
    /// The best of each other type, from the second best on.
    pub others: Vec<Verdict>,
    /// By how much the best is better than the second: the ratio of their typical (geometric mean)
    /// distances, parameters paid for. At least 1; 1 where nothing tells them apart or there is no other.
    pub margin: f64,
}

/// Fits one primitive of one of the types to points, of which those that are not finite, or too far to
/// be computed with ([`LARGEST`]), are passed over. The result does not depend on the order of the points, but for rounding.
///
/// Some 20 ms for a thousand points, linear beyond. There is an answer for any points, also for one or
/// none, and whatever the types; where none is given all five are tried.
///
/// ```
/// use fit4cad::cloud::Point;
/// use fit4cad::fit::single::fit_single;
/// use fit4cad::surface::SurfaceType;
/// let circle = (0..60).flat_map(|i| (0..5).map(move |z| {
///     let angle = f64::from(i) * std::f64::consts::TAU / 60.0;
///     Point::new(2.0 * angle.cos(), 2.0 * angle.sin(), f64::from(z))
/// }));
/// let found = fit_single(&circle.collect::<Vec<_>>(), &[]);
/// assert_eq!(found.best.surface.kind(), SurfaceType::Cylinder);
/// ```
pub fn fit_single(points: &[Point], kinds: &[SurfaceType]) -> Single {
    let kinds = if kinds.is_empty() {
        &SurfaceType::ALL
    } else {
        kinds
    };
    let finite = points
        .iter()
        .filter(|point| point.iter().all(|x| x.abs() <= LARGEST));
    let finite: Vec<Point> = finite.copied().collect();
    let frame = Frame::of(&finite);
    let local: Vec<Point> = finite.iter().map(|point| frame.enter(point)).collect();
    let sample = sampled(&local);
    let axes = starts::axes(&sample);
    let mut found: Vec<Surface> = kinds
        .iter()
        .map(|&kind| best_of(kind, &axes, &sample))
        .collect();
    if local.len() > sample.len() {
        let mut order: Vec<usize> = (0..found.len()).collect();
        order.sort_by(|&a, &b| {
            let close = |at: usize| {
                found
                    .get(at)
                    .map_or(0.0, |it| closeness(it, &sample, EXACT))
            };
            close(a).total_cmp(&close(b))
        });
        for at in order.into_iter().take(IN_DOUBT) {
            if let Some(surface) = found.get_mut(at) {
                *surface = polish::polish(surface, &local);
            }
        }
    }
    judge(found, &local, &frame)
}

/// One of several groups of points, each of which is one primitive.
#[derive(Debug, Clone, PartialEq)]
pub struct Recognised {
    /// Its number; 1 for the whole cloud.
    pub number: u32,
    /// Its points, by index.
    pub points: Vec<u32>,
    /// What it is.
    pub single: Single,
}

/// Takes each segment, or the whole cloud where there are none, for one primitive, as [`fit_single`] does.
/// There is an answer for each that has points.
///
/// ```
/// use fit4cad::fit::single::recognise;
/// use fit4cad::sample::{Options, generate};
/// let options = Options { spacing: 0.03, ..Options::default() };
/// let model = generate("spool", &options)?;
/// let found = recognise(&model.cloud, model.truth.as_ref());
/// let truth = model.truth.unwrap_or_default();
/// assert_eq!(found.len(), truth.primitives.len());
/// let right = found.iter().zip(&truth.primitives);
/// assert!(right.clone().all(|(it, _)| it.single.margin >= 1.0));
/// assert!(right.filter(|(it, truth)| Some(it.single.best.surface.kind()) == truth.kind).count() > found.len() / 2);
/// # Ok::<(), fit4cad::sample::SampleError>(())
/// ```
pub fn recognise(cloud: &Cloud, segments: Option<&Segmentation>) -> Vec<Recognised> {
    let groups: Vec<(u32, Vec<u32>)> = match segments {
        Some(segments) => {
            let primitives = segments.primitives.iter();
            let groups = primitives.map(|it| (it.number, it.points.clone()));
            groups.filter(|(_, points)| !points.is_empty()).collect()
        }
        None => vec![(1, (0u32..).take(cloud.len()).collect())],
    };
    let recognised = groups.into_iter().map(|(number, points)| {
        let own = points.iter();
        let own: Vec<Point> = own
            .filter_map(|&index| cloud.points().get(index as usize).copied())
            .collect();
        Recognised {
            number,
            single: fit_single(&own, &[]),
            points,
        }
    });
    recognised.collect()
}

/// Gives every primitive that has no surface the one its points lie on, of its own type where it has
/// one; primitives without points stay as they are. Gives how many got one.
///
/// ```
/// use fit4cad::cloud::{Cloud, Point};
/// use fit4cad::fit::single::fit_segments;
/// use fit4cad::model::{Primitive, Segmentation};
/// use fit4cad::surface::SurfaceType;
/// let grid = (0..100).map(|i| Point::new(f64::from(i % 10), f64::from(i / 10), 1.0));
/// let cloud = Cloud::new(grid.collect());
/// let points = (0..100).collect();
/// let primitives = vec![Primitive { number: 1, points, ..Primitive::default() }];
/// let mut segments = Segmentation { primitives };
/// assert_eq!(fit_segments(&cloud, &mut segments), 1);
/// let surface = segments.primitives[0].surface;
/// assert_eq!(surface.map(|surface| surface.kind()), Some(SurfaceType::Plane));
/// ```
pub fn fit_segments(cloud: &Cloud, segmentation: &mut Segmentation) -> usize {
    let mut fitted = 0;
    for primitive in &mut segmentation.primitives {
        if primitive.surface.is_some() || primitive.points.is_empty() {
            continue;
        }
        let indices = primitive.points.iter();
        let points: Vec<Point> = indices
            .filter_map(|&index| cloud.points().get(index as usize).copied())
            .collect();
        let kind: Vec<SurfaceType> = primitive.kind.into_iter().collect();
        let surface = fit_single(&points, &kind).best.surface;
        let listed = std::mem::take(&mut primitive.points);
        *primitive = Primitive::on(surface, primitive.number, listed);
        fitted += 1;
    }
    fitted
}

/// The similarity that takes points to the unit ball around the origin.
struct Frame {
    origin: Point,
    scale: f64,
}

impl Frame {
    fn of(points: &[Point]) -> Self {
        let nowhere = Self {
            origin: Point::origin(),
            scale: 1.0,
        };
        if points.is_empty() {
            return nowhere;
        }
        let Ball { centre, radius } = Ball::of(points);
        Self {
            origin: centre,
            scale: if radius > 0.0 && radius.is_finite() {
                radius
            } else {
                1.0
            },
        }
    }

    fn enter(&self, point: &Point) -> Point {
        Point::from((point - self.origin) / self.scale)
    }

    fn leave(&self, surface: &Surface) -> Surface {
        surface
            .scaled(self.scale)
            .moved(&Isometry3::from(self.origin.coords))
    }
}

/// Some of the points, the same whatever their order.
fn sampled(points: &[Point]) -> Vec<Point> {
    let mut ordered = points.to_vec();
    ordered.sort_by(|a, b| {
        let axes = a.iter().zip(b.iter());
        let mut unequal = axes.map(|(a, b)| a.total_cmp(b)).filter(|it| it.is_ne());
        unequal.next().unwrap_or(Ordering::Equal)
    });
    Random::new(1, 0x51).shuffle(&mut ordered);
    ordered.truncate(SAMPLE);
    ordered
}

/// The nearest surface of a type that could be found.
fn best_of(kind: SurfaceType, axes: &[starts::Axis], sample: &[Point]) -> Surface {
    let ranked = |surfaces: Vec<Surface>, most: usize| {
        let mut ranked: Vec<(f64, Surface)> = surfaces
            .into_iter()
            .filter(|surface| is_sound(surface, sample))
            .map(|surface| (median_distance(&surface, sample), surface))
            .collect();
        ranked.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Equal starts are followed once.
        ranked.dedup_by(|b, a| (a.0 - b.0).abs() <= 1e-9 * a.0);
        ranked.truncate(most);
        ranked.into_iter().map(|(_, surface)| surface)
    };
    let starts = ranked(starts::of(kind, axes, sample), TRIED);
    let tried = starts.map(|start| {
        let fitted = least_squares::approximate(&start, sample, Loss::Squares);
        fitted.map_or(start, |fitted| fitted.surface)
    });
    let mut best = ranked(tried.collect(), 1);
    match best.next() {
        Some(start) => polish::polish(&start, sample),
        None => any_of(kind, sample),
    }
}

/// Whether a surface can be computed with in the frame, and be that of one primitive through the points.
fn is_sound(surface: &Surface, points: &[Point]) -> bool {
    surface.is_in_range()
        && match surface {
            Surface::Torus(torus) => torus.major_radius < 1e6 && torus.minor_radius < 1e6,
            Surface::Cylinder(cylinder) => cylinder.radius < 1e6,
            Surface::Sphere(sphere) => sphere.radius < 1e6,
            Surface::Plane(_) => true,
            Surface::Cone(cone) => {
                let above = points
                    .iter()
                    .filter(|&point| (point - cone.apex).dot(&cone.axis) > 0.0)
                    .count();
                above.min(points.len() - above) * BEYOND_APEX <= points.len()
            }
        }
}

fn median_distance(surface: &Surface, points: &[Point]) -> f64 {
    let mut distances: Vec<f64> = points.iter().map(|point| surface.distance(point)).collect();
    quantile(&mut distances, 0.5)
}

/// Mean logarithm of the squared distances, where none counts as less than a floor.
fn closeness(surface: &Surface, points: &[Point], floor: f64) -> f64 {
    let logarithms = points.iter().map(|point| {
        let distance = surface.distance(point);
        libm::log(distance * distance + floor * floor)
    });
    logarithms.sum::<f64>() / points.len().max(1) as f64
}

/// A surface of a type that goes with any points, where nothing better is to be had.
fn any_of(kind: SurfaceType, points: &[Point]) -> Surface {
    let spread = Spread::of(points.iter());
    let (centre, normal, along) = spread.map_or_else(
        || (Point::origin(), Vector::z(), Vector::x()),
        |spread| {
            let [normal, _, along] = spread.directions.map(|it| it.into_inner());
            (spread.centroid, normal, along)
        },
    );
    let count = points.len().max(1) as f64;
    let mean = points
        .iter()
        .map(|point| (point - centre).norm())
        .sum::<f64>()
        / count;
    let mean = if mean > 0.0 { mean } else { 1.0 };
    match kind {
        SurfaceType::Plane => Surface::Plane(Plane::new(centre, normal)),
        SurfaceType::Sphere => Surface::Sphere(Sphere::new(centre + normal * mean, mean)),
        SurfaceType::Cylinder => {
            Surface::Cylinder(Cylinder::new(centre + normal * mean, along, mean))
        }
        SurfaceType::Cone => {
            let half_angle = std::f64::consts::FRAC_PI_4;
            let axis = along + normal;
            Surface::Cone(Cone::new(centre - along * mean, axis, half_angle))
        }
        SurfaceType::Torus => {
            let foot = centre + normal * mean;
            let side = across(&nalgebra::Unit::new_normalize(normal));
            Surface::Torus(Torus::new(
                foot - side.into_inner() * mean,
                normal,
                mean,
                mean,
            ))
        }
    }
}

/// Lets the types compete.
fn judge(found: Vec<Surface>, local: &[Point], frame: &Frame) -> Single {
    // Where a tenth of the points lie closer than the rounding of files, only the rounding counts;
    // else distances much below the noise say nothing.
    let tenths = found.iter().map(|surface| {
        let distances = local.iter().map(|point| surface.distance(point));
        let mut distances: Vec<f64> = distances.collect();
        quantile(&mut distances, 0.1)
    });
    let floor = tenths.fold(f64::INFINITY, f64::min);
    let floor = if floor.is_finite() {
        floor.max(EXACT)
    } else {
        EXACT
    };
    let count = local.len().max(1) as f64;
    let mut verdicts: Vec<Verdict> = found
        .iter()
        .map(|surface| {
            let paid = degrees_of_freedom(surface.kind()) as f64 * libm::log(count.max(2.0));
            let distances = local
                .iter()
                .map(|point| surface.distance(point) * frame.scale);
            let (mut sum, mut squares, mut largest) = (0.0, 0.0, 0.0f64);
            for distance in distances {
                sum += distance;
                squares += distance * distance;
                largest = largest.max(distance);
            }
            Verdict {
                surface: frame.leave(surface),
                mean: sum / count,
                rms: (squares / count).sqrt(),
                largest,
                score: count * closeness(surface, local, floor) + paid,
            }
        })
        .collect();
    // The sort is stable, and simpler types come first.
    verdicts.sort_by(|a, b| a.score.total_cmp(&b.score));
    let mut verdicts = verdicts.into_iter();
    let best = verdicts.next().unwrap_or_else(|| Verdict {
        surface: frame.leave(&any_of(SurfaceType::Plane, local)),
        mean: 0.0,
        rms: 0.0,
        largest: 0.0,
        score: 0.0,
    });
    let others: Vec<Verdict> = verdicts.collect();
    let margin = others.first().map_or(1.0, |second| {
        libm::exp(0.5 * (second.score - best.score) / count)
    });
    Single {
        best,
        others,
        margin,
    }
}

#[cfg(test)]
mod tests;
