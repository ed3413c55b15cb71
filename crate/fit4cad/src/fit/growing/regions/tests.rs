//! Regions of clouds whose faces are known.

use super::super::variation::{surface_variation, threshold};
use super::*;
use crate::cloud::Point;
use crate::cloud::neighbours::KdTree;
use crate::random::Random;

#[test]
fn a_row_of_sharp_points_parts_a_strip_in_two() {
    let points: Vec<Point> = (0..210)
        .map(|i| Point::new(f64::from(i % 21), f64::from(i / 21) * 1.01, 0.0))
        .collect();
    let tree = KdTree::new(&points);
    let graph = Neighbourhoods::new(&points, &tree, 16);
    let order: Vec<u32> = (0..210).collect();
    let regions = grow(&graph, &order, |i| (9..=11).contains(&(i % 21)));
    assert_eq!(regions.iter().map(Vec::len).collect::<Vec<_>>(), [90, 90]);
    let labels = labels(points.len(), &regions);
    assert_eq!(labels[10], u32::MAX);
    assert_ne!(labels[0], labels[20]);
}

/// The points of a lattice on the surface of the cube [0, n]³.
fn cube(n: u32) -> Vec<Point> {
    let on = |i: u32| i == 0 || i == n;
    let axis = || 0..=n;
    axis()
        .flat_map(|x| axis().flat_map(move |y| axis().map(move |z| [x, y, z])))
        .filter(|at| at.iter().any(|&i| on(i)))
        .map(|[x, y, z]| Point::new(f64::from(x), f64::from(y), f64::from(z)))
        .collect()
}

#[test]
fn the_six_faces_of_a_box_grow_to_six_regions() {
    let points = cube(20);
    let tree = KdTree::new(&points);
    let graph = Neighbourhoods::new(&points, &tree, 16);
    let values = surface_variation(&points, &graph, 15);
    let threshold = threshold(&values, 0.0);
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    Random::new(5, 0).shuffle(&mut order);
    let regions = grow(&graph, &order, |i| values[i as usize] > threshold.value);
    assert_eq!(regions.len(), 6);
    for region in &regions {
        // More than half of a face, and points of this face alone.
        assert!(region.len() > 200, "{} points", region.len());
        let inside = |i: &u32, axis: usize, side: f64| points[*i as usize][axis] == side;
        let faces = (0..3).flat_map(|axis| [0.0, 20.0].map(|side| (axis, side)));
        let mut faces = faces.filter(|&(axis, side)| region.iter().all(|i| inside(i, axis, side)));
        assert!(faces.next().is_some());
    }
    let labels = labels(points.len(), &regions);
    let unlabelled = labels.iter().filter(|&&label| label == u32::MAX);
    let held: usize = regions.iter().map(Vec::len).sum();
    assert_eq!(unlabelled.count(), points.len() - held);
}

#[test]
fn every_order_of_seeds_gives_the_same_regions() {
    let points = cube(8);
    let tree = KdTree::new(&points);
    let graph = Neighbourhoods::new(&points, &tree, 16);
    // Sharp are the points on and next to an edge.
    let is_sharp = |i: u32| {
        let near = |x: &&f64| **x <= 1.0 || **x >= 7.0;
        points[i as usize].iter().filter(near).count() > 1
    };
    let ascending: Vec<u32> = (0..points.len() as u32).collect();
    let descending: Vec<u32> = ascending.iter().rev().copied().collect();
    let regions = grow(&graph, &ascending, is_sharp);
    assert_eq!(regions, grow(&graph, &descending, is_sharp));
    assert_eq!(regions.iter().map(Vec::len).collect::<Vec<_>>(), [25; 6]);
    assert!(regions.iter().flatten().all(|&i| !is_sharp(i)));
    assert_eq!(grow(&graph, &ascending, |_| true), Vec::<Vec<u32>>::new());
}
