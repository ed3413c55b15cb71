//! The energy that a labelling of a cloud by surfaces is judged by, in nats: minus the logarithm of how
//! likely cloud and description are together.
//!
//! Per point, its distance in standard deviations squared and halved, beyond some deviations linear
//! (Huber), or the price of being on no surface; per pair of neighbours on different surfaces, a price for
//! the border between them; per surface, a price for its description.

use crate::cloud::Point;
use crate::cloud::neighbours::Neighbourhoods;
use crate::fit::least_squares::degrees_of_freedom;
use crate::fit::relations::Held;
use crate::surface::{Surface, SurfaceType};

/// The label of a point on no surface.
pub const NO_SURFACE: u32 = u32::MAX;
/// Whole numbers in which one nat is counted: cuts of whole numbers are exact.
pub const NAT: f64 = 256.0;
/// What a point on no surface costs, in nats: as one of a surface at four standard deviations.
pub const OUTLIER: f64 = 8.0;
/// Standard deviations from which on the cost of a distance is linear.
const LINEAR: f64 = 4.0;
/// Neighbours of a point that its label is compared with.
const LINKED: usize = 6;
/// What a pair of neighbours on different surfaces costs, in nats.
pub const BORDER: f64 = 1.0;
/// What a surface costs besides its parameters, in nats.
const SURFACE: f64 = 5.5;
/// What a parameter costs besides its precision, in nats.
const PARAMETER: f64 = 2.0;
/// Largest cost of a point that is counted, in nats: far beyond any that a labelling may choose.
const LARGEST: f64 = 1e4;

/// Nats as the whole number they are counted in.
pub fn counted(nats: f64) -> i32 {
    (nats * NAT).round() as i32
}

/// How the points of a cloud lie off their surfaces, in the units of the cloud.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// Standard deviation.
    pub noise: f64,
    /// Step to which their coordinates were rounded, 0 where they were not.
    pub step: f64,
}

impl Deviation {
    /// What it costs a point to be so far from its surface. Rounding moves every point by up to half a step
    /// along each axis, all of it as likely: within that, to be nearer says nothing. Else the flat spots that
    /// rounding leaves on a curved face would be planes.
    pub fn cost(self, distance: f64) -> f64 {
        let deviations = (distance - 0.5 * self.step).max(0.0) / self.noise;
        if deviations <= LINEAR {
            0.5 * deviations * deviations
        } else {
            LINEAR * (deviations - 0.5 * LINEAR)
        }
    }
}

/// What a surface costs that describes so many points, its family left out: for each of its parameters half the logarithm of
/// their number (Rissanen 1978), and something for being one of those that might do.
pub fn of_surface(kind: SurfaceType, points: usize) -> f64 {
    of_parameters(degrees_of_freedom(kind), points)
}

/// What one costs that shares some of its parameters, its family included: of those only which they are.
pub fn of_shared(held: Held, points: usize) -> f64 {
    of_parameters(held.parameters, points)
        + of_family(held.surface.kind())
        + libm::log(held.choices as f64)
}

fn of_parameters(parameters: usize, points: usize) -> f64 {
    SURFACE + parameters as f64 * (PARAMETER + 0.5 * libm::log(points.max(2) as f64))
}

/// Minus the logarithm of how common a family is: of the 2,670 primitives of the benchmark's training models 1,513 are planes,
/// 945 cylinders, 120 cones, 19 spheres and 73 tori.
pub fn of_family(kind: SurfaceType) -> f64 {
    match kind {
        SurfaceType::Plane => 0.57,
        SurfaceType::Cylinder => 1.04,
        SurfaceType::Cone => 3.10,
        SurfaceType::Sphere => 4.95,
        SurfaceType::Torus => 3.60,
    }
}

/// The pairs of neighbours of a cloud: each point's list holds the others of its pairs.
#[derive(Debug, Clone)]
pub struct Links {
    starts: Vec<u32>,
    others: Vec<u32>,
}

impl Links {
    /// Of every point with its nearest, each pair once whoever is nearest to whom.
    pub fn of(graph: &Neighbourhoods, points: usize) -> Self {
        let near = |index: u32| graph.of(index).iter().take(LINKED).copied();
        let all = (0u32..).take(points);
        // A pair of mutual neighbours comes from the one with the smaller index.
        let pairs = all.flat_map(|a| {
            near(a)
                .filter(move |&b| a < b || !near(b).any(|it| it == a))
                .map(move |b| (a, b))
        });
        let mut starts = vec![0u32; points + 1];
        for (a, b) in pairs.clone() {
            starts[a as usize + 1] += 1;
            starts[b as usize + 1] += 1;
        }
        for i in 0..points {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut others = vec![0; starts[points] as usize];
        for (a, b) in pairs {
            for (from, to) in [(a, b), (b, a)] {
                let slot = &mut next[from as usize];
                others[*slot as usize] = to;
                *slot += 1;
            }
        }
        Self { starts, others }
    }

    /// The points that a point is paired with.
    pub fn at(&self, index: u32) -> &[u32] {
        let i = index as usize;
        &self.others[self.starts[i] as usize..self.starts[i + 1] as usize]
    }
}

/// A surface with what it costs.
#[derive(Debug, Clone, Copy)]
pub struct Priced {
    /// The surface.
    pub surface: Surface,
    /// Its price, in whole numbers.
    pub price: i32,
}

impl Priced {
    /// A surface that is to describe so many points.
    pub fn of(surface: Surface, points: usize) -> Self {
        let kind = surface.kind();
        let price = counted(of_surface(kind, points) + of_family(kind));
        Self { surface, price }
    }

    /// What a point costs on it, in whole numbers.
    pub fn cost(&self, point: &Point, deviation: Deviation) -> i32 {
        counted(deviation.cost(self.surface.distance(point)).min(LARGEST))
    }
}
