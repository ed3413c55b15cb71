//! Points on many faces at once.

use fit4cad::cloud::{Bounds, Cells, Point, Vector};
use fit4cad::random::Random;

use crate::face::Trimmed;
use crate::placement::Motion;

/// A face where an instance of its body puts it.
pub(crate) struct Patch<'a> {
    /// The face.
    pub face: &'a Trimmed,
    /// Where it is put.
    pub motion: Motion,
}

impl Patch<'_> {
    /// Its area in square millimetres.
    pub fn area(&self) -> f64 {
        self.face.area * self.motion.scale() * self.motion.scale()
    }

    fn draw(&self, random: &mut Random) -> Option<Point> {
        self.place(random).map(|(_, point)| point)
    }

    /// A place on it, all of its area as likely, with its coordinates.
    pub fn place(&self, random: &mut Random) -> Option<([f64; 2], Point)> {
        let (at, point) = self.face.draw(random)?;
        Some((at, self.motion.point(&point)))
    }

    /// A unit normal at coordinates, of either side; zero where there is none.
    pub fn normal(&self, at: [f64; 2]) -> Vector {
        let (_, normal) = self.face.chart.oriented(at);
        self.motion.vector(&normal) / self.motion.scale()
    }
}

/// Points with the patches they lie on.
pub(crate) type Points = Vec<(u32, Point)>;

/// Number of points per area of which the nearest neighbours lie at a median distance of one, spread
/// evenly. Found on planes, cylinders and spheres: 0.66 to 0.68.
pub(crate) const FILLING: f64 = 0.67;
/// The distance to begin with, over the side of the square that each point has to itself: at it there
/// is not yet room for all.
const FIRST: f64 = 0.8;

/// So many candidates per point: more find room for few.
const CANDIDATES: usize = 5;
/// By how much the distance falls from round to round until there is room for all points.
const FALL: f64 = 0.96;

/// Spreads `count` points over patches, all at about one distance or every place as likely, at least `least` on each that has an area. `progress` hears what
/// share of them is there.
pub(crate) fn spread(
    patches: &[Patch<'_>],
    count: usize,
    least: usize,
    even: bool,
    seed: u64,
    progress: &mut dyn FnMut(f64),
) -> Points {
    let areas: Vec<f64> = patches.iter().map(Patch::area).collect();
    let total: f64 = areas.iter().sum();
    if total <= 0.0 {
        return Vec::new();
    }
    let mut random = Random::new(seed, 1);
    let mut points = Points::new();
    // Faces that would have fewer by chance have theirs first; the rest share what is left.
    let density = count as f64 / total;
    let is_small: Vec<bool> = areas
        .iter()
        .map(|area| area * density < least as f64)
        .collect();
    for (patch, _) in is_small.iter().enumerate().filter(|(_, small)| **small) {
        apart(
            &patches[patch],
            patch as u32,
            least,
            &mut points,
            &mut random,
        );
    }
    let rest = count.saturating_sub(points.len());
    let weights: Vec<f64> = areas
        .iter()
        .zip(&is_small)
        .map(|(area, small)| if *small { 0.0 } else { *area })
        .collect();
    if even {
        evenly(patches, &weights, rest, &mut points, &mut random, progress);
    } else {
        scatter(patches, &weights, rest, &mut points, &mut random);
    }
    top_up(patches, &areas, least, count, &mut points, &mut random);
    points.sort_by_key(|(patch, _)| *patch);
    points
}

/// Draws patches in proportion to weights.
pub(crate) struct Wheel {
    sums: Vec<f64>,
}

impl Wheel {
    pub fn new(weights: &[f64]) -> Self {
        let mut sum = 0.0;
        let sums = weights.iter().map(|weight| {
            sum += weight;
            sum
        });
        Self {
            sums: sums.collect(),
        }
    }

    fn total(&self) -> f64 {
        self.sums.last().copied().unwrap_or(0.0)
    }

    pub fn draw(&self, random: &mut Random) -> usize {
        let target = random.unit() * self.total();
        self.sums
            .partition_point(|sum| *sum <= target)
            .min(self.sums.len() - 1)
    }
}

fn scatter(
    patches: &[Patch<'_>],
    weights: &[f64],
    count: usize,
    points: &mut Points,
    random: &mut Random,
) {
    let wheel = Wheel::new(weights);
    if wheel.total() <= 0.0 {
        return;
    }
    let mut misses = 0;
    let goal = points.len() + count;
    while points.len() < goal && misses < 100 + count {
        let patch = wheel.draw(random);
        match patches[patch].draw(random) {
            Some(point) => points.push((patch as u32, point)),
            None => misses += 1,
        }
    }
}

/// Darts that stick where no other is within a distance, which falls until there is room for all.
fn evenly(
    patches: &[Patch<'_>],
    weights: &[f64],
    count: usize,
    points: &mut Points,
    random: &mut Random,
    progress: &mut dyn FnMut(f64),
) {
    let mut darts = Points::new();
    scatter(patches, weights, CANDIDATES * count, &mut darts, random);
    let area: f64 = weights.iter().sum();
    if darts.is_empty() || count == 0 {
        return;
    }
    let goal = points.len() + count;
    let mut distance = FIRST * (area / count as f64).sqrt();
    let bounds = Bounds::of(darts.iter().map(|(_, point)| point));
    // Not so small that cells cannot be counted; a query then looks at eight, most of them empty.
    let least = (1e-9 * bounds.diagonal()).max(f64::MIN_POSITIVE);
    let mut cells = Cells::new(bounds.min, 2.0 * distance.max(least));
    for (_, point) in points.iter() {
        cells.add(*point);
    }
    // With each dart the square of its distance from one that it was too near to: as long as that is
    // within the distance, nothing needs to be looked for.
    let mut darts: Vec<(u32, Point, f64)> = darts
        .into_iter()
        .map(|(patch, point)| (patch, point, f64::INFINITY))
        .collect();
    while points.len() < goal && !darts.is_empty() {
        progress(points.len() as f64 / goal as f64);
        darts.retain_mut(|(patch, point, apart)| {
            if points.len() >= goal {
                return false;
            }
            if *apart < distance * distance {
                return true;
            }
            let mut near = None;
            let free = !cells.any_within(point, distance, |index| {
                near = points.get(index);
                true
            });
            if free {
                cells.add(*point);
                points.push((*patch, *point));
            } else if let Some((_, other)) = near {
                *apart = (other - *point).norm_squared();
            }
            !free
        });
        distance *= FALL;
    }
}

/// Adds points to one patch, each the farthest of a few from those it has.
fn apart(patch: &Patch<'_>, index: u32, count: usize, points: &mut Points, random: &mut Random) {
    let mut own: Vec<Point> = points
        .iter()
        .filter(|it| it.0 == index)
        .map(|it| it.1)
        .collect();
    while own.len() < count {
        let tries = (0..8).filter_map(|_| patch.draw(random));
        let room = |point: &Point| {
            let distances = own.iter().map(|other| (other - point).norm_squared());
            distances.fold(f64::INFINITY, f64::min)
        };
        let tries: Vec<(f64, Point)> = tries.map(|point| (room(&point), point)).collect();
        let Some((_, best)) = tries.into_iter().max_by(|a, b| a.0.total_cmp(&b.0)) else {
            return;
        };
        own.push(best);
        points.push((index, best));
    }
}

/// Gives every patch its least number; those with the most give as many back.
fn top_up(
    patches: &[Patch<'_>],
    areas: &[f64],
    least: usize,
    count: usize,
    points: &mut Points,
    random: &mut Random,
) {
    let mut counts = vec![0_usize; patches.len()];
    for (patch, _) in points.iter() {
        counts[*patch as usize] += 1;
    }
    let poor: Vec<usize> = (0..patches.len())
        .filter(|&patch| counts[patch] < least && areas[patch] > 0.0)
        .collect();
    for patch in poor {
        apart(&patches[patch], patch as u32, least, points, random);
        counts[patch] = least;
    }
    let mut place = points.len();
    // The last ones stuck where there was least room.
    while points.len() > count && place > 0 {
        place -= 1;
        let patch = points[place].0 as usize;
        if counts[patch] > 2 * least {
            counts[patch] -= 1;
            points.swap_remove(place);
        }
    }
}
