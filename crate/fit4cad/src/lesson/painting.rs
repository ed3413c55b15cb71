//! A part of two primitives, and predictions painted on it.

use std::f64::consts::PI;

use nalgebra::Isometry3;

use crate::cloud::{Cloud, Point, Vector};
use crate::metrics::matching::{Incidence, best_matches};
use crate::model::{Model, Primitive, Segmentation};
use crate::surface::{Cylinder, Plane, Surface};

/// Distance of neighbouring points; the niche's radius is one.
const SPACING: f64 = 0.07;
/// Height of the wall and depth of the floor before it.
const HEIGHT: f64 = 1.2;
const APRON: f64 = 0.5;

/// A niche: primitive 1 is its wall, half a cylinder, primitive 2 its floor, a plane. The points of
/// the arc where they meet belong to both. `rest` more points are a third primitive, a plate far
/// behind that stands for the rest of a larger part.
pub fn niche(rest: u32) -> Model {
    let mut points = Vec::new();
    let mut shared = Vec::new();
    let mut wall = Vec::new();
    let mut floor = Vec::new();
    let around = (PI / SPACING).round() as u32;
    let up = (HEIGHT / SPACING).round() as u32;
    for row in 0..=up {
        for step in 0..=around {
            let angle = PI * f64::from(step) / f64::from(around);
            let height = HEIGHT * f64::from(row) / f64::from(up);
            let index = points.len() as u32;
            points.push(Point::new(libm::cos(angle), libm::sin(angle), height));
            if row == 0 {
                shared.push(index);
            }
            wall.push(index);
        }
    }
    floor.extend_from_slice(&shared);
    let across = (2.0 / SPACING).round() as i32;
    for row in -((APRON / SPACING) as i32)..=(across / 2) {
        for column in 0..=across {
            let x = -1.0 + 2.0 * f64::from(column) / f64::from(across);
            let y = f64::from(row) * SPACING;
            // Points nearer to the arc than half a step would double its row.
            let inside = y <= 0.0 || libm::hypot(x, y) < 1.0 - 0.5 * SPACING;
            if inside && !(y == 0.0 && x.abs() == 1.0) {
                floor.push(points.len() as u32);
                points.push(Point::new(x, y, 0.0));
            }
        }
    }
    floor.sort_unstable();
    let upright = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 1.0));
    let level = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
    let mut primitives = vec![
        Primitive::on(upright, 1, wall),
        Primitive::on(level, 2, floor),
    ];
    if rest > 0 {
        let first = points.len() as u32;
        let side = f64::from(rest).sqrt().ceil().max(1.0) as u32;
        points.extend((0..rest).map(|i| {
            let (column, row) = (f64::from(i % side), f64::from(i / side));
            Point::new(column * SPACING - 1.0, 3.0, row * SPACING)
        }));
        let plate = Surface::Plane(Plane::new(Point::new(0.0, 3.0, 0.0), Vector::y()));
        let members = (first..points.len() as u32).collect();
        primitives.push(Primitive::on(plate, 3, members));
    }
    Model {
        name: "niche".to_owned(),
        cloud: Cloud::new(points),
        truth: Some(Segmentation { primitives }),
        submissions: Vec::new(),
    }
}

/// A submission of painted point lists. Each gets the surface of the true primitive with which it
/// shares most points, moved by `shift` in the direction in which the surface bends or faces (a
/// cylinder sideways, a plane along its normal), so that the accuracy measures have a surface to be
/// measured to. Lists may overlap; they come out ascending, each index once, within the cloud.
/// O(n log n).
pub fn painted(model: &Model, lists: &[Vec<u32>], shift: f64) -> Segmentation {
    let count = model.cloud.len();
    let mut primitives = Vec::new();
    for (number, list) in (1..).zip(lists) {
        let mut points: Vec<u32> = list
            .iter()
            .copied()
            .filter(|&index| (index as usize) < count)
            .collect();
        points.sort_unstable();
        points.dedup();
        primitives.push(Primitive {
            number,
            points,
            ..Primitive::default()
        });
    }
    primitives.retain(|primitive| !primitive.points.is_empty());
    let mut segmentation = Segmentation { primitives };
    let Some(truth) = &model.truth else {
        return segmentation;
    };
    let matches = best_matches(&segmentation, &Incidence::new(truth, count));
    for (primitive, matched) in segmentation.primitives.iter_mut().zip(matches) {
        let partner = matched.and_then(|matched| truth.primitives.get(matched.index));
        if let Some(surface) = partner.and_then(|partner| partner.surface) {
            let moved = surface.moved(&Isometry3::translation(0.0, shift, shift));
            *primitive = Primitive::on(moved, primitive.number, primitive.points.clone());
        }
    }
    segmentation
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::metrics::{Measure, Protocol, evaluate};

    fn score(model: &Model, lists: &[Vec<u32>], shift: f64) -> crate::metrics::Report {
        let truth = model.truth.as_ref().unwrap();
        let painted = painted(model, lists, shift);
        evaluate(&model.cloud, truth, &painted, Protocol::Definition)
    }

    fn truth(model: &Model) -> Vec<Vec<u32>> {
        let primitives = &model.truth.as_ref().unwrap().primitives;
        primitives.iter().map(|p| p.points.clone()).collect()
    }

    #[test]
    fn painting_the_truth_scores_perfectly() {
        let model = niche(0);
        let report = score(&model, &truth(&model), 0.0);
        assert_eq!(report.mean[Measure::Dsc], Some(1.0));
        assert!(report.mean[Measure::DHaus].unwrap() < 1e-12);
        let [wall, floor] = &truth(&model)[..] else {
            unreachable!()
        };
        let shared = wall.iter().filter(|i| floor.contains(i)).count();
        assert!(shared > 30 && shared < wall.len() / 10);
    }

    #[test]
    fn every_true_point_lies_on_its_surface() {
        let model = niche(500);
        for primitive in &model.truth.as_ref().unwrap().primitives {
            let surface = primitive.surface.unwrap();
            for &index in &primitive.points {
                let point = &model.cloud.points()[index as usize];
                assert!(surface.distance(point) < 1e-12);
            }
        }
    }

    #[test]
    fn a_larger_part_lifts_acc_and_tnr_and_leaves_dsc() {
        let sloppy = |rest| {
            let model = niche(rest);
            let lists = truth(&model);
            let half: Vec<u32> = lists[0]
                .iter()
                .chain(&lists[1])
                .step_by(2)
                .copied()
                .collect();
            score(&model, &[half], 0.0).primitives[0].classification
        };
        let (alone, among) = (sloppy(0), sloppy(20_000));
        assert_eq!(alone[Measure::Dsc], among[Measure::Dsc]);
        assert!(alone[Measure::Acc].unwrap() < 0.7 && among[Measure::Acc].unwrap() > 0.9);
        assert!(alone[Measure::Tnr].unwrap() < 0.6 && among[Measure::Tnr].unwrap() > 0.9);
    }

    #[test]
    fn one_stray_point_moves_the_hausdorff_distance_and_hardly_the_mean() {
        let model = niche(0);
        let mut lists = truth(&model);
        let stray = *lists[0].last().unwrap();
        lists[1].push(stray);
        let floor = score(&model, &lists, 0.0).predictions[1].fit;
        assert!(floor[Measure::DHaus].unwrap() > 0.3);
        assert!(floor[Measure::Mfe].unwrap() < 0.002);
    }

    #[test]
    fn a_moved_surface_moves_both() {
        let model = niche(0);
        let lists = truth(&model);
        let floor = score(&model, &lists, 0.05).predictions[1].fit;
        assert!((floor[Measure::Mfe].unwrap() - floor[Measure::DHaus].unwrap()).abs() < 1e-12);
        assert!(floor[Measure::Mfe].unwrap() > 0.01);
    }

    #[test]
    fn indices_beyond_the_cloud_and_empty_lists_are_left_out() {
        let model = niche(0);
        let made = painted(&model, &[vec![], vec![u32::MAX, 3, 3]], 0.0);
        assert_eq!(made.primitives.len(), 1);
        assert_eq!(made.primitives[0].points, [3]);
        assert_eq!(made.primitives[0].number, 2);
    }
}
