//! The Hough transform of a small part, step by step: one slice of a family's parameter space, the
//! cells that each point lights, and what becomes of the peaks.

use crate::cloud::{Bounds, Cloud, Direction, Point, Vector};
use crate::fit::axes::direction_of;
use crate::fit::hough::gamma::{Coordinate, Slice};
use crate::fit::hough::grid::Axis;
use crate::fit::hough::persistence::Diagram;
use crate::fit::hough::space::Space;
use crate::fit::least_squares::{self, Loss};
use crate::fit::{Candidate, Parameters, Search, local};
use crate::metrics::accuracy::{FitAccuracy, fit_accuracy};
use crate::surface::{Cone, Cylinder, Sphere, Surface, SurfaceType, Torus, across};

/// Cells along either side of the slice. The fitter's own are as long as the points are apart, and
/// half as many would fit here: as all other parameters are known, votes spread less and a finer
/// slice keeps a wider gap between surfaces and ripples. In much finer ones peaks fall apart.
const CELLS: usize = 90;
/// Radii and half-angles of a slice run from this share of the base's to its inverse.
const SMALLEST_SIZE: f64 = 0.4;
/// Points a rival family is first fitted to.
const SAMPLE: usize = 300;

/// A slice with the cells of every point.
#[derive(Debug, Clone)]
pub struct Transform {
    slice: Slice,
    base: Surface,
    free: [Coordinate; 2],
    axes: [Axis; 2],
    /// Cells lit by each point, ascending.
    lit: Vec<Vec<u32>>,
}

impl Transform {
    /// The transform of a cloud over the two telling parameters of the base's family (see
    /// [`Slice::telling`]); the other parameters are the base's. O(points · cells).
    pub fn new(cloud: &Cloud, base: Surface) -> Self {
        let bounds = cloud.bounds();
        let free = Slice::telling(base.kind());
        let pivot = match base {
            Surface::Plane(_) => bounds.centre(),
            _ => Point::origin(),
        };
        let axes = axes(&base, &bounds, cloud.points());
        let slice = Slice::new(base, pivot, free, axes);
        let lit = cloud.points().iter().map(|point| {
            let mut cells = Vec::new();
            slice.light(point, |cell| cells.push(cell as u32));
            cells
        });
        Self {
            lit: lit.collect(),
            slice,
            base,
            free,
            axes,
        }
    }

    /// The surface whose other parameters are held.
    pub fn base(&self) -> &Surface {
        &self.base
    }

    /// The free parameters, rows first.
    pub fn free(&self) -> [Coordinate; 2] {
        self.free
    }

    /// The ranges of the free parameters, rows first.
    pub fn axes(&self) -> &[Axis; 2] {
        &self.axes
    }

    /// Γ_P: the cells that a point lights, ascending; none for a point beyond the cloud.
    pub fn gamma(&self, point: u32) -> &[u32] {
        self.lit.get(point as usize).map_or(&[], Vec::as_slice)
    }

    /// 𝓗 after the points given have voted.
    pub fn heights(&self, points: impl IntoIterator<Item = u32>) -> Vec<f64> {
        let mut heights = vec![0.0; self.slice.grid().len()];
        for point in points {
            for &cell in self.gamma(point) {
                heights[cell as usize] += 1.0;
            }
        }
        heights
    }

    /// The points whose curve meets a cell, ascending.
    pub fn voters(&self, cell: u32) -> Vec<u32> {
        let lit = (0..).zip(&self.lit);
        lit.filter(|(_, cells)| cells.binary_search(&cell).is_ok())
            .map(|(point, _)| point)
            .collect()
    }

    /// The surface in the middle of a cell; `None` beyond the last.
    pub fn surface(&self, cell: u32) -> Option<Surface> {
        let cell = cell as usize;
        (cell < self.slice.grid().len()).then(|| self.slice.surface(cell))
    }

    /// All maxima of 𝓗 when every point has voted, most persistent first. O(cells log cells).
    pub fn diagram(&self) -> Diagram {
        let all = (0..).take(self.lit.len());
        self.slice.diagram(&self.heights(all))
    }
}

/// Ranges of the telling parameters that hold every face of the cloud.
fn axes(base: &Surface, bounds: &Bounds, points: &[Point]) -> [Axis; 2] {
    let reach = 0.5 * bounds.diagonal();
    let steps = |start: f64, end: f64| Axis::new(start, end, (end - start) / CELLS as f64);
    let sizes = |size: f64, most: f64| {
        let largest = (size / SMALLEST_SIZE).min(most);
        steps(SMALLEST_SIZE * size, largest)
    };
    // Extent of the cloud from a point along a direction, with a tenth to spare on either side.
    let extent = |from: &Point, along: &Direction| {
        let places = points.iter().map(|point| (point - from).dot(along));
        let (low, high) = places.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), place| {
            (low.min(place), high.max(place))
        });
        let spare = 0.1 * (high - low);
        steps(low - spare, high + spare)
    };
    match base {
        Surface::Plane(_) => {
            let half_turn = std::f64::consts::PI;
            let turn = Axis::wrapping(0.0, half_turn, half_turn / CELLS as f64);
            [turn, steps(-reach, reach)]
        }
        Surface::Cylinder(Cylinder { centre, axis, .. }) => {
            let first = across(axis);
            let second = Direction::new_normalize(axis.cross(&first));
            [extent(centre, &first), extent(centre, &second)]
        }
        Surface::Sphere(Sphere { centre, .. }) => {
            let [x, y, _] = base_axes();
            [extent(centre, &x), extent(centre, &y)]
        }
        Surface::Cone(Cone {
            apex,
            axis,
            half_angle,
        }) => {
            let widest = 0.49 * std::f64::consts::PI;
            [extent(apex, axis), sizes(*half_angle, widest)]
        }
        Surface::Torus(Torus {
            major_radius,
            minor_radius,
            ..
        }) => {
            // The inner side must stay outside the tube.
            let between = 0.5 * (major_radius + minor_radius);
            let major = steps(between, 2.0 * major_radius - between);
            [major, sizes(*minor_radius, 0.99 * between)]
        }
    }
}

fn base_axes() -> [Direction; 3] {
    [Vector::x_axis(), Vector::y_axis(), Vector::z_axis()]
}

/// Of some surfaces, the one of a family whose direction and size most others share, so that a slice
/// through it has many peaks; of equals, the first. O(n²).
pub fn typical(surfaces: &[Surface], kind: SurfaceType) -> Option<Surface> {
    let alike = |a: &Surface, b: &Surface| {
        let parallel = match (direction_of(a), direction_of(b)) {
            (Some(a), Some(b)) => a.cross(&b).norm() < 1e-6,
            _ => true,
        };
        parallel && (size(a) - size(b)).abs() < 1e-6
    };
    let of_kind: Vec<Surface> = surfaces
        .iter()
        .filter(|surface| surface.kind() == kind)
        .copied()
        .collect();
    let followers = |surface: &Surface| of_kind.iter().filter(|b| alike(surface, b)).count();
    let mut best: Option<(usize, Surface)> = None;
    for surface in &of_kind {
        let count = followers(surface);
        if best.is_none_or(|(most, _)| count > most) {
            best = Some((count, *surface));
        }
    }
    best.map(|(_, surface)| surface)
}

fn size(surface: &Surface) -> f64 {
    match surface {
        Surface::Plane(_) => 0.0,
        Surface::Cylinder(shape) => shape.radius,
        Surface::Cone(shape) => shape.half_angle,
        Surface::Sphere(shape) => shape.radius,
        Surface::Torus(shape) => shape.minor_radius,
    }
}

/// A peak's surface fitted to its voters and grown over the points that lie on it, as the fitter
/// does; `None` where too few points hold on to it. O(n log n).
pub fn polish(cloud: &Cloud, surface: &Surface, voters: &[u32]) -> Option<Candidate> {
    let mut search = Search::new(cloud, &Parameters::default(), 1);
    let near = 2.0 * search.scale.spacing;
    let seeds: Vec<u32> = voters
        .iter()
        .copied()
        .filter(|&index| surface.distance(search.point(index)) <= near)
        .collect();
    let start = least_squares::fit(surface, &search.points(&seeds), Loss::Biweight(near))?;
    let tolerance = search.scale.tolerance.max(0.1 * near);
    let held: Vec<u32> = seeds
        .into_iter()
        .filter(|&index| start.surface.distance(search.point(index)) <= tolerance)
        .collect();
    search.grow(&start.surface, &held)
}

/// A family's best surface through some points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rival {
    /// The surface.
    pub surface: Surface,
    /// Its mean fitting error and directed Hausdorff distance on the points.
    pub accuracy: FitAccuracy,
    /// Whether its mean fitting error is the least: the paper's choice.
    pub least: bool,
    /// Whether the fitter keeps it: of those that fit about as well, the simplest.
    pub kept: bool,
}

/// The best surface of every family through the points of a peak, simplest family first; a family
/// that no surface could be fitted of is left out. O(n log n).
pub fn rivals(cloud: &Cloud, winner: &Candidate) -> Vec<Rival> {
    let search = Search::new(cloud, &Parameters::default(), 1);
    let points = search.points(&winner.support);
    let stride = points.len().div_ceil(SAMPLE).max(1);
    let sample: Vec<Point> = points.iter().copied().step_by(stride).collect();
    let mut found: Vec<(Candidate, FitAccuracy)> = Vec::new();
    for kind in SurfaceType::ALL {
        let mut starts = local::starts(kind, &sample);
        if winner.surface.kind() == kind {
            starts.push(winner.surface);
        }
        let mut fits: Vec<least_squares::Fitted> = starts
            .iter()
            .filter_map(|start| least_squares::fit(start, &points, Loss::Squares))
            .collect();
        if let (SurfaceType::Cone, Surface::Cylinder(cylinder)) = (kind, &winner.surface) {
            fits.extend(least_squares::fit_cone_near(
                cylinder,
                &points,
                Loss::Squares,
            ));
        }
        let best = fits.into_iter().min_by(|a, b| a.error.total_cmp(&b.error));
        let Some(best) = best else { continue };
        if let Some(accuracy) = fit_accuracy(cloud, &winner.support, &best.surface) {
            let candidate = Candidate {
                surface: best.surface,
                support: winner.support.clone(),
                error: best.error,
            };
            found.push((candidate, accuracy));
        }
    }
    let least = found
        .iter()
        .map(|(_, accuracy)| accuracy.mfe)
        .fold(f64::INFINITY, f64::min);
    let candidates = found.iter().map(|(candidate, _)| candidate.clone());
    let kept = search.best(candidates.collect());
    let rival = |(candidate, accuracy): &(Candidate, FitAccuracy)| Rival {
        surface: candidate.surface,
        accuracy: *accuracy,
        least: accuracy.mfe <= least,
        kept: kept.as_ref() == Some(candidate),
    };
    found.iter().map(rival).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sample::{Options, generate};

    fn part(name: &str) -> (Cloud, Vec<Surface>) {
        let options = Options {
            spacing: 0.02,
            noise: 0.0005,
            ..Options::default()
        };
        let model = generate(name, &options).unwrap();
        let primitives = model.truth.unwrap().primitives;
        let surfaces = primitives.iter().filter_map(|p| p.surface).collect();
        (model.cloud, surfaces)
    }

    #[test]
    fn the_bolt_holes_of_a_flange_are_the_persistent_peaks_of_their_slice() {
        let (cloud, truth) = part("flange");
        let base = typical(&truth, SurfaceType::Cylinder).unwrap();
        let transform = Transform::new(&cloud, base);
        let holes: Vec<Surface> = truth
            .iter()
            .filter(|s| s.kind() == SurfaceType::Cylinder && (size(s) - size(&base)).abs() < 1e-6)
            .copied()
            .collect();
        assert_eq!(holes.len(), 6);
        let diagram = transform.diagram();
        for hole in &holes {
            let Surface::Cylinder(hole) = hole else {
                unreachable!()
            };
            let found = diagram.peaks.iter().take(12).any(|peak| {
                let Some(Surface::Cylinder(at)) = transform.surface(peak.position as u32) else {
                    unreachable!()
                };
                (at.centre - hole.centre).norm() < 0.5 * hole.radius
            });
            assert!(found, "no peak at {hole:?}");
        }
    }

    #[test]
    fn a_peak_is_as_high_as_it_has_voters_and_votes_add_up() {
        let (cloud, truth) = part("flange");
        for kind in [SurfaceType::Plane, SurfaceType::Cylinder] {
            let base = typical(&truth, kind).unwrap();
            let transform = Transform::new(&cloud, base);
            let peak = transform.diagram().peaks[0];
            let voters = transform.voters(peak.position as u32);
            assert_eq!(voters.len() as f64, peak.birth);
            let count = cloud.len() as u32;
            let half = transform.heights(0..count / 2);
            let other = transform.heights(count / 2..count);
            let all = transform.heights(0..count);
            let sums = half.iter().zip(&other).map(|(a, b)| a + b);
            assert!(sums.zip(&all).all(|(a, b)| a == *b));
        }
    }

    #[test]
    fn a_polished_peak_is_nearer_to_the_truth_than_its_cell_and_keeps_its_type() {
        let (cloud, truth) = part("flange");
        let base = typical(&truth, SurfaceType::Cylinder).unwrap();
        let transform = Transform::new(&cloud, base);
        let peak = transform.diagram().peaks[0];
        let cell = peak.position as u32;
        let coarse = transform.surface(cell).unwrap();
        let polished = polish(&cloud, &coarse, &transform.voters(cell)).unwrap();
        let error = |surface: &Surface| {
            fit_accuracy(&cloud, &polished.support, surface)
                .unwrap()
                .mfe
        };
        assert!(error(&polished.surface) < 0.5 * error(&coarse));
        let rivals = rivals(&cloud, &polished);
        assert_eq!(rivals.iter().filter(|rival| rival.kept).count(), 1);
        let kept = rivals.iter().find(|rival| rival.kept).unwrap();
        assert_eq!(kept.surface.kind(), SurfaceType::Cylinder);
        assert!(rivals.iter().any(|rival| rival.least));
    }

    #[test]
    fn every_family_has_a_slice_that_its_own_face_peaks_in() {
        for (name, kind) in [
            ("flange", SurfaceType::Cone),
            ("flange", SurfaceType::Torus),
            ("ball-joint", SurfaceType::Sphere),
        ] {
            let (cloud, truth) = part(name);
            let base = typical(&truth, kind).unwrap();
            let transform = Transform::new(&cloud, base);
            let diagram = transform.diagram();
            assert!(diagram.peaks[0].birth > 10.0, "{kind}");
        }
    }

    #[test]
    fn points_and_cells_beyond_the_last_have_nothing() {
        let (cloud, truth) = part("flange");
        let base = typical(&truth, SurfaceType::Cylinder).unwrap();
        let transform = Transform::new(&cloud, base);
        assert!(transform.gamma(u32::MAX).is_empty());
        assert!(transform.surface(u32::MAX).is_none());
        assert!(transform.voters(u32::MAX).is_empty());
        assert!(typical(&[], SurfaceType::Cone).is_none());
    }
}
