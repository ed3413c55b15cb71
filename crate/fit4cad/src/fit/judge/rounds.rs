//! What is done to a labelling between its moves: surfaces are fitted to their points, neighbours that one
//! surface describes more cheaply are joined, and points that are badly explained are told.

use std::collections::BTreeMap;

use super::energy::{self, NO_SURFACE, Priced, counted};
use super::family::{Measures, Sample};
use super::labelling::{Labelling, Scene};
use super::propose::is_enough;
use crate::cloud::neighbours::Neighbourhoods;
use crate::fit::relations::Known;
use crate::surface::Surface;

/// Points that families are compared on, and that a surface is then fitted to.
const FITTED: [usize; 2] = [300, 1000];
/// Points that surfaces are compared on when they are joined.
const JOINED: usize = 600;
/// Neighbours of a point well inside a face that are of the same.
const INSIDE: usize = 10;
/// Neighbours over which it is told whether points are badly explained.
const AROUND: usize = 12;
/// What a point there costs on average, in nats, where noise alone leaves a half: the mean of thirteen is
/// larger by three standard deviations of its own.
const BADLY: f64 = 1.0;
/// Least cosine between the normals of two surfaces that may be one.
const SMOOTH: f64 = 0.8;

/// The points of a surface that are well inside, where points of others do not pass for its own; all
/// where these are few.
pub fn inner(labelling: &Labelling, graph: &Neighbourhoods, members: &[u32]) -> Vec<u32> {
    let is_inside = |&&index: &&u32| {
        let label = labelling.labels[index as usize];
        let mut near = graph.of(index).iter().take(INSIDE);
        near.all(|&other| labelling.labels[other as usize] == label)
    };
    let inner: Vec<u32> = members.iter().filter(is_inside).copied().collect();
    if is_enough(inner.len(), members.len()) {
        inner
    } else {
        members.to_vec()
    }
}

/// Fits every surface to its inner points, as the family that describes them best.
pub fn refit(
    labelling: &mut Labelling,
    scene: &Scene<'_>,
    graph: &Neighbourhoods,
    measures: &Measures,
) {
    let [compared_on, fitted] = FITTED;
    for (label, members) in labelling.members().into_iter().enumerate() {
        if members.is_empty() {
            continue;
        }
        let old = labelling.surfaces[label].surface;
        let inner = inner(labelling, graph, &members);
        let few = Sample::of(scene.points, &inner, compared_on);
        let many = Sample::of(scene.points, &inner, fitted);
        let best = measures.best(Some(old), &few);
        let surface = best.and_then(|it| measures.refit(&it, &many.points));
        if let Some(surface) = surface
            && measures.cost(&surface, &many) <= measures.cost(&old, &many)
        {
            labelling.surfaces[label].surface = surface;
        }
        let surface = labelling.surfaces[label].surface;
        labelling.surfaces[label] = Priced::of(surface, members.len());
    }
    labelling.revalue(scene.points);
}

/// Lets every surface share a direction or an axis with one that has more points, where that describes its own more cheaply.
pub fn share(
    labelling: &mut Labelling,
    scene: &Scene<'_>,
    graph: &Neighbourhoods,
    measures: &Measures,
) {
    let members = labelling.members();
    let mut order: Vec<usize> = (0..members.len()).collect();
    order.retain(|&it| !members[it].is_empty());
    order.sort_by_key(|&it| std::cmp::Reverse(members[it].len()));
    let mut known = Known::default();
    for label in order {
        let free = labelling.surfaces[label].surface;
        let inner = inner(labelling, graph, &members[label]);
        let sample = Sample::of(scene.points, &inner, FITTED[1]);
        let surface = measures.shared(&known, &sample, &free).unwrap_or(free);
        labelling.surfaces[label] = Priced::of(surface, members[label].len());
        known.add(&surface);
    }
    labelling.revalue(scene.points);
}

/// Joins neighbouring surfaces that one describes more cheaply, those with the longest borders first.
pub fn join(labelling: &mut Labelling, scene: &Scene<'_>, measures: &Measures) {
    let mut members = labelling.members();
    for (pair, border, at) in borders(labelling, scene) {
        let [first, second] = pair.map(|it| it as usize);
        if members[first].is_empty() || members[second].is_empty() {
            continue;
        }
        let surfaces = [first, second].map(|it| labelling.surfaces[it].surface);
        let normals = surfaces.map(|it| it.normal(&scene.points[at as usize]));
        if normals[0].dot(&normals[1]).abs() < SMOOTH {
            continue;
        }
        let of_first = members[first].iter();
        let mut joint: Vec<u32> = of_first.chain(&members[second]).copied().collect();
        joint.sort_unstable();
        let larger = usize::from(members[first].len() < members[second].len());
        let few = Sample::of(scene.points, &joint, FITTED[0]);
        let Some(surface) = measures.best(Some(surfaces[larger]), &few) else {
            continue;
        };
        // The same points on both sides: those of a large face stand for ten others each, by chance as off as they are.
        let samples = [first, second].map(|it| Sample::of(scene.points, &members[it], JOINED));
        let errors = |surface: &Surface| -> f64 {
            let each = samples.iter().map(|it| measures.errors(surface, it));
            each.sum()
        };
        let apart = measures.cost(&surfaces[0], &samples[0])
            + measures.cost(&surfaces[1], &samples[1])
            + energy::BORDER * border as f64;
        if errors(&surface) + measures.price(surface.kind(), joint.len()) < apart {
            labelling.surfaces[first] = Priced::of(surface, joint.len());
            for &index in &members[second] {
                labelling.set(index, pair[0], 0);
            }
            members[first] = joint;
            members[second] = Vec::new();
        }
    }
    labelling.revalue(scene.points);
}

/// Pairs of surfaces with neighbouring points, how many pairs of points these are, and one of the points;
/// the longest border first.
fn borders(labelling: &Labelling, scene: &Scene<'_>) -> Vec<([u32; 2], usize, u32)> {
    let mut borders: BTreeMap<[u32; 2], (usize, u32)> = BTreeMap::new();
    for (index, &label) in (0u32..).zip(&labelling.labels) {
        for &other in scene.links.at(index) {
            let theirs = labelling.labels[other as usize];
            if label < theirs && theirs != NO_SURFACE {
                borders.entry([label, theirs]).or_insert((0, index)).0 += 1;
            }
        }
    }
    let pairs = borders.into_iter();
    let mut pairs: Vec<_> = pairs.map(|(pair, (count, at))| (pair, count, at)).collect();
    pairs.sort_by_key(|it| std::cmp::Reverse(it.1));
    pairs
}

/// Every surface takes over what it had better have, then points go that had better be on none.
pub fn sweep(labelling: &mut Labelling, scene: &Scene<'_>) {
    for label in 0..labelling.surfaces.len() as u32 {
        if labelling.sizes[label as usize] > 0 {
            labelling.expand(scene, label);
        }
    }
    labelling.release(scene);
}

/// Which points are around others that cost more than noise alone makes them.
pub fn badly_explained(labelling: &Labelling, graph: &Neighbourhoods) -> Vec<bool> {
    let most = counted(energy::OUTLIER);
    let cost = |index: u32| i64::from(labelling.cost(index).min(most));
    let is_badly = |index: u32| {
        let near = graph.of(index).iter().take(AROUND);
        let count = near.len() as i64 + 1;
        let sum: i64 = near.map(|&it| cost(it)).sum::<i64>() + cost(index);
        sum > count * i64::from(counted(BADLY))
    };
    let all = (0u32..).take(labelling.labels.len());
    all.map(is_badly).collect()
}
