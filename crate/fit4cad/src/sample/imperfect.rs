//! A segmentation that is wrong on purpose, to have something to score.

use nalgebra::{Isometry3, Quaternion, UnitQuaternion};

use crate::cloud::neighbours::{KdTree, Neighbour};
use crate::cloud::{Bounds, Point, Vector};
use crate::model::{Model, Primitive, Segmentation};
use crate::random::Random;
use crate::sorting::sort_by;
use crate::surface::Surface;

/// Standard deviation of the displacement that frays the borders, over the cloud's diagonal.
const FRAYING: f64 = 0.01;
/// Standard deviation of a surface's displacement, over the diagonal of its primitive.
const SHIFT: f64 = 0.004;
/// Standard deviation of a surface's rotation, in radians.
const TURN: f64 = 0.006;

/// Segments a model as a careless method would, in ways that all are common: borders fray, the
/// smallest primitive is merged into a neighbour, the next smallest missed, the largest split in
/// two, and every surface lies slightly off. With fewer than four primitives only the first and
/// the last of these. A model without truth gives nothing. O(n log n) for n points.
pub fn imperfect(model: &Model, seed: u64) -> Segmentation {
    let Some(truth) = &model.truth else {
        return Segmentation::default();
    };
    let points = model.cloud.points();
    let tree = KdTree::new(points);
    let mut random = Random::new(seed, u64::MAX - 3);
    let deviation = FRAYING * model.cloud.bounds().diagonal();
    let mut lists = fray(points, truth, &tree, deviation, &mut random);
    let mut surfaces: Vec<Option<Surface>> =
        truth.primitives.iter().map(|each| each.surface).collect();

    let mut by_size: Vec<usize> = (0..lists.len()).collect();
    sort_by(&mut by_size, |&one, &other| {
        (lists[one].len(), one).cmp(&(lists[other].len(), other))
    });
    if let [smallest, second, _, .., largest] = by_size[..] {
        let merged = std::mem::take(&mut lists[smallest]);
        lists[second].clear();
        let owner = owners(&lists, points.len());
        if let Some(target) = nearest_owner(&tree, at(points, &merged), &owner) {
            lists[target].extend(merged);
            lists[target].sort_unstable();
        }
        let half = split(&mut lists[largest], points);
        lists.push(half);
        surfaces.push(surfaces[largest]);
    }

    let found = lists.into_iter().zip(surfaces);
    let found = found.filter_map(|(list, surface)| (!list.is_empty()).then_some((list, surface?)));
    let primitives = found.zip(1u32..).map(|((list, surface), number)| {
        let surface = displaced(&surface, &Bounds::of(at(points, &list)), &mut random);
        Primitive::on(surface, number, list)
    });
    Segmentation {
        primitives: primitives.collect(),
    }
}

/// Gives each point to the primitive found at a place near by, a normal deviation away.
fn fray(
    points: &[Point],
    truth: &Segmentation,
    tree: &KdTree,
    deviation: f64,
    random: &mut Random,
) -> Vec<Vec<u32>> {
    let listed: Vec<&[u32]> = truth
        .primitives
        .iter()
        .map(|each| &each.points[..])
        .collect();
    let owner = owners(&listed, points.len());
    let mut lists = vec![Vec::new(); listed.len()];
    let mut nearest = Vec::new();
    for (index, point) in (0u32..).zip(points) {
        let beside = point + Vector::from_fn(|_, _| random.normal()) * deviation;
        tree.nearest(&beside, 1, f64::INFINITY, |_| true, &mut nearest);
        let found = nearest
            .first()
            .and_then(|found| owner[found.index as usize]);
        if let Some(place) = found {
            lists[place].push(index);
        }
    }
    lists
}

/// The first list that holds each of `count` points.
fn owners(lists: &[impl AsRef<[u32]>], count: usize) -> Vec<Option<usize>> {
    let mut owner = vec![None; count];
    for (place, list) in lists.iter().enumerate() {
        for &index in list.as_ref() {
            if let Some(owner) = owner.get_mut(index as usize) {
                owner.get_or_insert(place);
            }
        }
    }
    owner
}

/// The owner of the owned point that lies nearest to one of the points.
fn nearest_owner<'a>(
    tree: &KdTree,
    points: impl Iterator<Item = &'a Point>,
    owner: &[Option<usize>],
) -> Option<usize> {
    let mut found = Vec::new();
    let mut best: Option<Neighbour> = None;
    for point in points {
        // Only what is nearer than the best so far is worth finding.
        let reach = best.map_or(f64::INFINITY, |best| best.distance_squared.sqrt());
        let owned = |index: u32| owner[index as usize].is_some();
        tree.nearest(point, 1, reach, owned, &mut found);
        let nearer = |best: Neighbour| {
            found
                .first()
                .is_some_and(|it| it.distance_squared < best.distance_squared)
        };
        if best.is_none_or(nearer) {
            best = found.first().copied().or(best);
        }
    }
    best.and_then(|best| owner[best.index as usize])
}

/// Leaves the lower half along the longest edge of the list's box and returns the upper one.
fn split(list: &mut Vec<u32>, points: &[Point]) -> Vec<u32> {
    let bounds = Bounds::of(at(points, list));
    let (axis, middle) = (bounds.size().imax(), bounds.centre());
    let (upper, lower) = list
        .iter()
        .partition(|&&index| points[index as usize][axis] > middle[axis]);
    *list = lower;
    upper
}

/// The surface turned about the centre of a box and moved, both a little.
fn displaced(surface: &Surface, bounds: &Bounds, random: &mut Random) -> Surface {
    let mut vector = |size: f64| Vector::from_fn(|_, _| random.normal()) * size;
    // Small rotations without sines, which differ from platform to platform.
    let half = vector(0.5 * TURN);
    let turn = UnitQuaternion::new_normalize(Quaternion::new(1.0, half.x, half.y, half.z));
    let centre = bounds.centre().coords;
    let shift = centre - turn * centre + vector(SHIFT * bounds.diagonal());
    surface.moved(&Isometry3::from_parts(shift.into(), turn))
}

fn at<'a>(points: &'a [Point], list: &'a [u32]) -> impl Iterator<Item = &'a Point> {
    list.iter().filter_map(|&index| points.get(index as usize))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::{Measure, Protocol, evaluate};
    use crate::sample::{Options, generate, parts};

    #[test]
    fn every_part_gets_a_score_between_useless_and_perfect() {
        for part in parts() {
            let model = generate(part.name, &Options::default()).unwrap();
            let truth = model.truth.as_ref().unwrap();
            let found = imperfect(&model, 1);
            let report = evaluate(&model.cloud, truth, &found, Protocol::Definition);
            let dsc = report.mean[Measure::Dsc].unwrap();
            assert!((0.4..0.97).contains(&dsc), "{}: DSC {dsc}", part.name);
            assert!(!report.hidden.merged.is_empty(), "{}", part.name);
            let mfe = report.mean[Measure::Mfe].unwrap();
            assert!((1e-4..0.05).contains(&mfe), "{}: MFE {mfe}", part.name);
        }
    }

    #[test]
    fn a_seed_gives_the_same_segmentation_again() {
        let name = parts()[0].name;
        let model = generate(name, &Options::default()).unwrap();
        assert_eq!(imperfect(&model, 7), imperfect(&model, 7));
        assert_ne!(imperfect(&model, 7), imperfect(&model, 8));
    }

    #[test]
    fn a_model_without_truth_gives_nothing() {
        assert_eq!(imperfect(&Model::default(), 1), Segmentation::default());
    }
}
