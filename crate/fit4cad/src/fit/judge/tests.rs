//! Noisy clouds whose faces are known by construction.

use super::*;
use crate::cloud::{Cloud, Point, Vector};
use crate::fit::axes::direction_of;
use crate::fit::{Method, fit};
use crate::model::Segmentation;
use crate::surface::{Surface, SurfaceType};

/// Points of the faces of a box of 30 × 24 × 12 spacings, moved by noise given in spacings, and the face of
/// each.
fn noisy_box(noise: f64) -> (Vec<Point>, Vec<u32>) {
    let sides = [30.0, 24.0, 12.0];
    let mut random = Random::new(4, 0);
    let (mut points, mut faces) = (Vec::new(), Vec::new());
    for axis in 0..3 {
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
        for side in 0..2u32 {
            for _ in 0..(sides[u] * sides[v]) as usize {
                let mut at = Vector::zeros();
                at[u] = sides[u] * random.unit();
                at[v] = sides[v] * random.unit();
                at[axis] = sides[axis] * f64::from(side);
                let off = Vector::from_fn(|_, _| noise * random.normal());
                points.push(Point::from(at + off));
                faces.push(2 * axis as u32 + side);
            }
        }
    }
    (points, faces)
}

/// Points of a cylinder of radius 10 and height 24 with its caps, and noise, in spacings.
fn noisy_can(noise: f64) -> Vec<Point> {
    let mut random = Random::new(6, 0);
    let tau = std::f64::consts::TAU;
    let wall = (0..1500).map(|_| (10.0, 0.0));
    let caps = (0..628).map(|i| (0.0, f64::from(i % 2)));
    let places: Vec<(f64, f64)> = wall.chain(caps).collect();
    places
        .into_iter()
        .map(|(radius, cap)| {
            let angle = tau * random.unit();
            let (radius, height) = if radius > 0.0 {
                (radius, 24.0 * random.unit())
            } else {
                (10.0 * random.unit().sqrt(), 24.0 * cap)
            };
            let at = Vector::new(radius * angle.cos(), radius * angle.sin(), height);
            Point::from(at + Vector::from_fn(|_, _| noise * random.normal()))
        })
        .collect()
}

fn fitted(points: &[Point]) -> Segmentation {
    let cloud = Cloud::new(points.to_vec());
    let fit = fit(&cloud, Method::Hough, &Parameters::default(), 1, &mut ());
    fit.unwrap().segmentation
}

fn kinds(found: &Segmentation) -> Vec<SurfaceType> {
    let mut kinds: Vec<_> = found.primitives.iter().filter_map(|it| it.kind).collect();
    kinds.sort();
    kinds
}

#[test]
fn faces_along_one_direction_share_it() {
    let (points, _) = noisy_box(0.3);
    let found = fitted(&points);
    let mut normals: Vec<Vector> = Vec::new();
    for primitive in &found.primitives {
        if let Some(Surface::Plane(plane)) = primitive.surface
            && !normals.contains(&plane.normal)
        {
            normals.push(plane.normal.into_inner());
        }
    }
    assert_eq!(normals.len(), 3, "{normals:?}");
    let points = noisy_can(0.3);
    let directions: Vec<_> = fitted(&points)
        .primitives
        .iter()
        .filter_map(|it| it.surface.as_ref().and_then(direction_of))
        .collect();
    assert_eq!(directions.len(), 3);
    assert!(
        directions.iter().all(|it| *it == directions[0]),
        "{directions:?}"
    );
}

#[test]
fn a_noisy_box_is_six_planes() {
    for noise in [0.1, 0.3, 0.5] {
        let (points, faces) = noisy_box(noise);
        let found = fitted(&points);
        assert_eq!(kinds(&found), [SurfaceType::Plane; 6], "{noise}");
        for primitive in &found.primitives {
            let mut counts = [0usize; 6];
            for &index in &primitive.points {
                counts[faces[index as usize] as usize] += 1;
            }
            let most = counts.iter().max().unwrap();
            let share = *most as f64 / primitive.points.len() as f64;
            assert!(share > 0.85, "{noise}: {share}");
        }
        let listed: usize = found.primitives.iter().map(|it| it.points.len()).sum();
        assert!(
            listed as f64 > 0.97 * points.len() as f64,
            "{noise}: {listed}"
        );
    }
}

#[test]
fn a_noisy_can_is_a_cylinder_and_two_planes() {
    for noise in [0.1, 0.3] {
        let found = fitted(&noisy_can(noise));
        let expected = [
            SurfaceType::Plane,
            SurfaceType::Plane,
            SurfaceType::Cylinder,
        ];
        assert_eq!(kinds(&found), expected, "{noise}");
        let Some(Surface::Cylinder(cylinder)) = found.primitives[0].surface else {
            panic!("{found:?}");
        };
        assert!((cylinder.radius - 10.0).abs() < 0.05, "{cylinder:?}");
    }
}

#[test]
fn points_at_random_are_on_nothing() {
    let mut random = Random::new(8, 0);
    let points: Vec<Point> = (0..3000)
        .map(|_| Point::new(random.unit(), random.unit(), random.unit()))
        .collect();
    assert_eq!(fitted(&points).primitives, []);
}

#[test]
fn every_move_lowers_the_energy_by_what_it_says() {
    let (points, _) = noisy_box(0.3);
    let cloud = Cloud::new(points);
    let search = Search::new(&cloud, &Parameters::default(), 1);
    let points = cloud.points();
    let links = Links::of(&search.graph, points.len());
    let scene = Scene {
        points,
        tree: &search.tree,
        links: &links,
    };
    let measures = Measures {
        deviation: Deviation {
            noise: 0.3,
            step: 0.0,
        },
        diameter: search.scale.diameter,
        weighs_families: true,
    };
    let mut proposer = Proposer::new(points, &search.tree, &search.graph, measures);
    let mut random = Random::new(2, 0);
    let usable = vec![true; points.len()];
    let mut tell = |_| Ok(());
    let proposals = proposer.propose(&usable, 60, &mut random, &mut tell);
    let mut labelling = Labelling::empty(points.len(), measures.deviation);
    let mut energy = labelling.energy(&links);
    let mut check = |labelling: &Labelling, gain: i64| {
        let now = labelling.energy(&links);
        assert_eq!(energy - now, gain);
        assert!(gain >= 0);
        energy = now;
    };
    for proposal in proposals.unwrap() {
        let label = labelling.add(Priced::of(proposal.surface, proposal.support.len()));
        let gain = labelling.expand(&scene, label);
        check(&labelling, gain);
    }
    for label in 0..labelling.surfaces.len() as u32 {
        if labelling.sizes[label as usize] > 0 {
            let gain = labelling.expand(&scene, label);
            check(&labelling, gain);
        }
    }
    let gain = labelling.release(&scene);
    check(&labelling, gain);
}

#[test]
fn the_order_of_the_points_changes_nothing() {
    let (points, _) = noisy_box(0.3);
    let mut order: Vec<u32> = (0u32..).take(points.len()).collect();
    Random::new(9, 0).shuffle(&mut order);
    let shuffled: Vec<Point> = order.iter().map(|&i| points[i as usize]).collect();
    let lists = |found: Segmentation, name: &dyn Fn(u32) -> u32| {
        let named = found.primitives.into_iter().map(|it| {
            let mut points: Vec<u32> = it.points.into_iter().map(name).collect();
            points.sort_unstable();
            points
        });
        let mut lists: Vec<Vec<u32>> = named.collect();
        lists.sort();
        lists
    };
    assert_eq!(
        lists(fitted(&points), &|i| i),
        lists(fitted(&shuffled), &|i| order[i as usize])
    );
}
