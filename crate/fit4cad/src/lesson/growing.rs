//! Primitive growing on a small part, step by step: the functions that PG is made of, each asked on
//! its own.

use nalgebra::{Isometry3, Translation3, UnitQuaternion};

use crate::cloud::neighbours::{KdTree, Neighbourhoods};
use crate::cloud::normals::estimate_normals;
use crate::cloud::{self, Cloud, Direction, Point, Vector};
use crate::fit::growing::slippage::{Invariance, Slippage};
use crate::fit::growing::variation::{Threshold, surface_variation, threshold};
use crate::fit::growing::{ransac, regions};
use crate::fit::{Cancelled, Candidate, Parameters, Search};
use crate::surface::{Surface, across};

/// Neighbours kept per point: what the surface variation looks at, and one to spare.
const NEIGHBOURS: usize = 16;
/// Neighbours that a normal is estimated from.
const NORMAL_NEIGHBOURS: usize = 10;

/// A cloud with what growing needs of it.
#[derive(Debug, Clone)]
pub struct Growing {
    graph: Neighbourhoods,
    normals: Vec<Direction>,
    variation: Vec<f64>,
}

/// The coarse partition at one threshold.
#[derive(Debug, Clone, PartialEq)]
pub struct Partition {
    /// The threshold.
    pub threshold: Threshold,
    /// The regions, largest first, the points of each ascending.
    pub regions: Vec<Vec<u32>>,
    /// For every point, after how many steps from its region's seed growth reached it;
    /// [`u32::MAX`] for sharp points.
    pub steps: Vec<u32>,
}

impl Growing {
    /// Prepares a cloud: neighbours, normals and the surface variation σ_n of every point. O(n log n).
    pub fn new(cloud: &Cloud) -> Self {
        let points = cloud.points();
        let graph = Neighbourhoods::new(points, &KdTree::new(points), NEIGHBOURS);
        let neighbours = Parameters::count(Parameters::default().variation_neighbours);
        Self {
            normals: estimate_normals(points, NORMAL_NEIGHBOURS),
            variation: surface_variation(points, &graph, neighbours),
            graph,
        }
    }

    /// σ_n of every point.
    pub fn variation(&self) -> &[f64] {
        &self.variation
    }

    /// The threshold at η, or for η = 0 the one that the fitter takes.
    pub fn threshold(&self, quantile: f64) -> Threshold {
        threshold(&self.variation, quantile)
    }

    /// Grows regions between the points above the threshold, from seeds in the order of the cloud.
    /// O(n).
    pub fn partition(&self, quantile: f64) -> Partition {
        let threshold = self.threshold(quantile);
        let order: Vec<u32> = (0..).take(self.variation.len()).collect();
        let is_sharp = |index: u32| self.variation[index as usize] > threshold.value;
        let regions = regions::grow(&self.graph, &order, is_sharp);
        let mut steps = vec![u32::MAX; self.variation.len()];
        for region in &regions {
            self.count_steps(region, &mut steps);
        }
        Partition {
            threshold,
            regions,
            steps,
        }
    }

    /// Steps from a region's seed, its first point, along the neighbours that growth follows.
    fn count_steps(&self, region: &[u32], steps: &mut [u32]) {
        let Some(&seed) = region.first() else { return };
        steps[seed as usize] = 0;
        let mut front = vec![seed];
        let mut step = 0;
        while !front.is_empty() {
            step += 1;
            let mut next = Vec::new();
            for &index in &front {
                for &other in self.graph.of(index).iter().take(regions::STEPS) {
                    if steps[other as usize] == u32::MAX && region.binary_search(&other).is_ok() {
                        steps[other as usize] = step;
                        next.push(other);
                    }
                }
            }
            front = next;
        }
    }

    /// The slippage of some points; `None` for fewer than six. O(points).
    pub fn slippage(&self, cloud: &Cloud, points: &[u32]) -> Option<Slippage> {
        let pairs = points.iter().filter_map(|&index| {
            let index = index as usize;
            let point = cloud.points().get(index)?;
            Some((*point, self.normals.get(index)?.into_inner()))
        });
        let (points, normals): (Vec<Point>, Vec<Vector>) = pairs.unzip();
        Slippage::of(&points, &normals)
    }
}

/// A motion that slides a region over itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Motion {
    /// Turning about an axis through the point.
    Turn(Point, Direction),
    /// Sliding along a direction.
    Slide(Direction),
}

impl Motion {
    /// The motion by an amount: radians of a turn, or a length in the units of the cloud.
    pub fn by(&self, amount: f64) -> Isometry3<f64> {
        match self {
            Self::Turn(point, axis) => {
                let turn = cloud::turn(axis, amount);
                let back = point - turn * point.coords;
                Isometry3::from_parts(Translation3::from(back.coords), turn)
            }
            Self::Slide(direction) => {
                let way = direction.into_inner() * amount;
                Isometry3::from_parts(Translation3::from(way), UnitQuaternion::identity())
            }
        }
    }
}

/// The slippable motions of a region, as its class and axis give them; none for a complex region,
/// and of a helical one only the turn.
pub fn motions(slippage: &Slippage, points: &[Point]) -> Vec<Motion> {
    match (slippage.class, slippage.axis) {
        (Invariance::Planar, Some((point, normal))) => {
            let first = across(&normal);
            let second = Direction::new_normalize(normal.cross(&first));
            let turn = Motion::Turn(point, normal);
            vec![Motion::Slide(first), Motion::Slide(second), turn]
        }
        (Invariance::Cylindrical, Some((point, axis))) => {
            vec![Motion::Turn(point, axis), Motion::Slide(axis)]
        }
        (Invariance::Prismatic, Some((_, axis))) => vec![Motion::Slide(axis)],
        (Invariance::Revolute | Invariance::Helical, Some((point, axis))) => {
            vec![Motion::Turn(point, axis)]
        }
        (Invariance::Spherical, _) => {
            let centre = slippage
                .starts(points)
                .into_iter()
                .find_map(|start| match start {
                    Surface::Sphere(sphere) => Some(sphere.centre),
                    _ => None,
                });
            let axes = [Vector::x_axis(), Vector::y_axis(), Vector::z_axis()];
            let turns = centre.map(|centre| axes.map(|axis| Motion::Turn(centre, axis)));
            turns.into_iter().flatten().collect()
        }
        _ => Vec::new(),
    }
}

/// Splits a region into surfaces by RANSAC, as the fitter does with what one surface cannot explain.
///
/// # Errors
/// None in practice: nothing here cancels the search.
pub fn split(cloud: &Cloud, region: &[u32], seed: u64) -> Result<Vec<Candidate>, Cancelled> {
    let mut search = Search::new(cloud, &Parameters::default(), seed);
    let count = cloud.len();
    let region: Vec<u32> = region
        .iter()
        .copied()
        .filter(|&index| (index as usize) < count)
        .collect();
    ransac::split(&mut search, &region, 0.0, &mut ())?;
    Ok(search.into_accepted())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Options, generate};

    fn bracket() -> Cloud {
        let options = Options {
            spacing: 0.012,
            ..Options::default()
        };
        generate("bracket", &options).unwrap().cloud
    }

    #[test]
    fn every_point_that_is_not_sharp_is_reached_from_its_seed() {
        let cloud = bracket();
        let growing = Growing::new(&cloud);
        let partition = growing.partition(0.7);
        for (index, (&variation, &steps)) in
            growing.variation().iter().zip(&partition.steps).enumerate()
        {
            let sharp = variation > partition.threshold.value;
            assert_eq!(sharp, steps == u32::MAX, "point {index}");
        }
        assert!(partition.regions.len() > 3);
    }

    #[test]
    fn slippable_motions_leave_a_region_on_its_surface() {
        let cloud = bracket();
        let growing = Growing::new(&cloud);
        let partition = growing.partition(0.7);
        let mut planes = 0;
        for region in partition.regions.iter().filter(|region| region.len() > 60) {
            let Some(slippage) = growing.slippage(&cloud, region) else {
                continue;
            };
            if slippage.class != Invariance::Planar {
                continue;
            }
            planes += 1;
            let points: Vec<Point> = region.iter().map(|&i| cloud.points()[i as usize]).collect();
            let surface = slippage.starts(&points)[0];
            let motions = motions(&slippage, &points);
            assert_eq!(motions.len(), 3);
            for motion in motions {
                let moved = motion.by(0.3) * points[0];
                let off = surface.distance(&moved) - surface.distance(&points[0]);
                assert!(off.abs() < 1e-6);
            }
        }
        assert!(planes > 0);
    }

    #[test]
    fn a_region_of_several_surfaces_is_split() {
        let cloud = bracket();
        let growing = Growing::new(&cloud);
        let partition = growing.partition(0.7);
        let largest = &partition.regions[0];
        let slippage = growing.slippage(&cloud, largest).unwrap();
        assert_eq!(slippage.class, Invariance::Prismatic);
        let found = split(&cloud, largest, 1).unwrap();
        assert!(found.len() > 1);
        assert!(split(&cloud, &[], 1).unwrap().is_empty());
    }
}
