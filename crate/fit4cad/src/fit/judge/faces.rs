//! From a labelling to primitives: connected faces, the points of whose edges are on both.

use super::labelling::Labelling;
use crate::cloud::Point;
use crate::cloud::neighbours::Neighbourhoods;
use crate::surface::Surface;

/// How far off the next face a point may lie, in standard deviations, to be on the edge between both.
const ON_EDGE: f64 = 3.0;
/// And in spacings: the next row of points of a face that meets another at a right angle is one spacing off it.
const WITHIN_ROW: f64 = 0.4;
/// Neighbours among which an edge is looked for.
const BESIDE: usize = 8;

/// A face of a surface.
#[derive(Debug, Clone)]
pub struct Face {
    /// The surface.
    pub surface: Surface,
    /// The points on it, ascending.
    pub points: Vec<u32>,
}

/// The connected faces of every surface that have so many points.
pub fn faces(
    labelling: &Labelling,
    points: &[Point],
    graph: &Neighbourhoods,
    spacing: f64,
    smallest: usize,
) -> Vec<Face> {
    let near = (ON_EDGE * labelling.deviation.noise).min(WITHIN_ROW * spacing);
    let mut seen = vec![false; points.len()];
    let mut faces = Vec::new();
    for (label, members) in (0u32..).zip(labelling.members()) {
        let surface = labelling.surfaces[label as usize].surface;
        let is_own = |index: u32| labelling.labels[index as usize] == label;
        for start in members {
            if std::mem::replace(&mut seen[start as usize], true) {
                continue;
            }
            let mut group = vec![start];
            let mut next = 0;
            while next < group.len() {
                for &other in graph.of(group[next]) {
                    if is_own(other) && !std::mem::replace(&mut seen[other as usize], true) {
                        group.push(other);
                    }
                }
                next += 1;
            }
            if group.len() < smallest {
                continue;
            }
            let beside = group
                .iter()
                .flat_map(|&it| graph.of(it).iter().take(BESIDE).copied());
            let is_on_edge =
                |&it: &u32| !is_own(it) && surface.distance(&points[it as usize]) <= near;
            let edge: Vec<u32> = beside.filter(is_on_edge).collect();
            group.extend(edge);
            group.sort_unstable();
            group.dedup();
            faces.push(Face {
                surface,
                points: group,
            });
        }
    }
    faces
}
