//! Clouds made harder, to see what a fitter is worth away from the clouds it was tuned on.

use fit4cad::cloud::neighbours::KdTree;
use fit4cad::cloud::{Cloud, Point, Vector};
use fit4cad::model::Model;
use nalgebra::{Isometry3, Translation3, UnitQuaternion};

/// What is done to a cloud, in this order.
#[derive(Debug, Default, Clone, Copy)]
pub struct Stress {
    /// Points are left out until hardly two are nearer than this many median spacings, faces before
    /// edges, edges before corners, as in a coarser mesh. Details get thin: a factor of 2 leaves about a
    /// quarter of the points.
    pub thin: f64,
    /// Share of the points left out at random.
    pub drop: f64,
    /// Share of the points cut away around one of them.
    pub missing: f64,
    /// Standard deviation of Gaussian noise, in diagonals of the bounding box.
    pub noise: f64,
    /// Decimals that coordinates are rounded to, after the diagonal's power of ten.
    pub digits: Option<u32>,
    /// Points spread evenly over the bounding box, per point of the cloud.
    pub outliers: f64,
    /// Whether the cloud is turned, moved and its points put in another order.
    pub turn: bool,
}

impl Stress {
    /// The model with its cloud made harder; points of the truth that are gone are dropped, and
    /// primitives that have none left.
    pub fn apply(&self, mut model: Model) -> Model {
        if self.thin > 0.0 {
            let kept = thinned(&model, self.thin);
            model = rearranged(model, &kept);
        }
        if self.drop > 0.0 {
            let mut random = fastrand::Rng::with_seed(9);
            let all = (0u32..).take(model.cloud.len());
            let kept: Vec<u32> = all.filter(|_| random.f64() >= self.drop).collect();
            model = rearranged(model, &kept);
        }
        self.wear(&mut model);
        if let Some(digits) = self.digits {
            round(&mut model, digits);
        }
        if self.turn {
            turn(&mut model);
            let mut order: Vec<u32> = (0u32..).take(model.cloud.len()).collect();
            fastrand::Rng::with_seed(3).shuffle(&mut order);
            model = rearranged(model, &order);
        }
        model
    }

    fn wear(&self, model: &mut Model) {
        if self.noise == 0.0 && self.outliers == 0.0 && self.missing == 0.0 {
            return;
        }
        let mut random = fastrand::Rng::with_seed(7);
        let bounds = model.cloud.bounds();
        let sigma = self.noise * bounds.diagonal();
        let old = model.cloud.points();
        let middle = old[random.usize(..old.len())];
        let mut distances: Vec<f64> = old.iter().map(|p| (p - middle).norm()).collect();
        distances.sort_by(f64::total_cmp);
        let cut = ((old.len() as f64 * self.missing) as usize)
            .checked_sub(1)
            .map(|i| distances[i]);
        let kept: Vec<u32> = (0u32..)
            .zip(old)
            .filter(|(_, p)| cut.is_none_or(|cut| (**p - middle).norm() > cut))
            .map(|(index, _)| index)
            .collect();
        let mut points: Vec<Point> = kept
            .iter()
            .map(|&i| old[i as usize] + Vector::from_fn(|_, _| sigma * gaussian(&mut random)))
            .collect();
        for _ in 0..(points.len() as f64 * self.outliers) as usize {
            let at = Vector::from_fn(|_, _| random.f64());
            points.push(bounds.min + bounds.size().component_mul(&at));
        }
        relist(model, &kept);
        model.cloud = Cloud::new(points);
    }
}

/// The model with the points of the given indices, in their order.
fn rearranged(mut model: Model, order: &[u32]) -> Model {
    let old = model.cloud.points();
    let points = order.iter().map(|&i| old[i as usize]).collect();
    relist(&mut model, order);
    model.cloud = Cloud::new(points);
    model
}

/// Point lists of the truth by the new places of the points.
fn relist(model: &mut Model, order: &[u32]) {
    let mut place = vec![None; model.cloud.len()];
    for (new, &old) in (0u32..).zip(order) {
        place[old as usize] = Some(new);
    }
    if let Some(truth) = &mut model.truth {
        for primitive in &mut truth.primitives {
            let points = primitive.points.iter();
            primitive.points = points.filter_map(|&i| place[i as usize]).collect();
            primitive.points.sort_unstable();
        }
        truth
            .primitives
            .retain(|primitive| !primitive.points.is_empty());
    }
}

/// Points in random order, each kept unless one kept before is too near (dart throwing): corners
/// first, then edges, as a mesher places its vertices.
fn thinned(model: &Model, factor: f64) -> Vec<u32> {
    let points = model.cloud.points();
    let tree = KdTree::new(points);
    let mut near = Vec::new();
    let mut nearest: Vec<f64> = points
        .iter()
        .map(|point| {
            tree.nearest(point, 2, f64::INFINITY, |_| true, &mut near);
            near.last().map_or(0.0, |n| n.distance_squared.sqrt())
        })
        .collect();
    nearest.sort_by(f64::total_cmp);
    let apart = factor * nearest[nearest.len() / 2];
    let mut order: Vec<u32> = (0u32..).take(points.len()).collect();
    fastrand::Rng::with_seed(11).shuffle(&mut order);
    let mut labels = vec![0u32; points.len()];
    let lists = model.truth.iter().flat_map(|truth| &truth.primitives);
    for &index in lists.flat_map(|primitive| &primitive.points) {
        labels[index as usize] += 1;
    }
    order.sort_by_key(|&index| std::cmp::Reverse(labels[index as usize]));
    let mut kept = vec![false; points.len()];
    for index in order {
        let point = &points[index as usize];
        tree.nearest(point, 1, apart, |i| kept[i as usize], &mut near);
        kept[index as usize] = near.is_empty();
    }
    (0u32..)
        .take(points.len())
        .filter(|&i| kept[i as usize])
        .collect()
}

/// A rigid motion of the points. True surfaces stay behind: no measure of the points needs them.
fn turn(model: &mut Model) {
    let turn = UnitQuaternion::from_euler_angles(0.7, -0.4, 1.3);
    let away = Vector::repeat(0.3 * model.cloud.bounds().diagonal());
    let motion = Isometry3::from_parts(Translation3::from(away), turn);
    let points = model.cloud.points().iter().map(|p| motion * p).collect();
    model.cloud = Cloud::new(points);
}

/// Coordinates as a file with few digits has them. True surfaces stay behind.
fn round(model: &mut Model, digits: u32) {
    let magnitude = model.cloud.bounds().diagonal().log10().round();
    let steps = 10f64.powf(f64::from(digits) - magnitude);
    let round = |x: f64| (x * steps).round() / steps;
    let points = model.cloud.points().iter().map(|p| p.map(round)).collect();
    model.cloud = Cloud::new(points);
}

/// A normal deviate (Box and Muller 1958).
fn gaussian(random: &mut fastrand::Rng) -> f64 {
    let radius = (-2.0 * (1.0 - random.f64()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.f64()).cos()
}
