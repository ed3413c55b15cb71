//! Which faces make one primitive: those of one surface that touch, as in the benchmark.

use std::collections::BTreeMap;

use fit4cad::cloud::{Direction, Point};
use fit4cad::surface::Surface;

/// How nearly two surfaces must be one, over the diagonal of the part.
const SAME: f64 = 1e-7;

/// For each face the first one of its primitive. `edges` are those of each face, with the instance it
/// is of. O(n log n).
pub(crate) fn join(
    surfaces: &[Option<Surface>],
    edges: &[(usize, &[u64])],
    diagonal: f64,
) -> Vec<usize> {
    let mut first: Vec<usize> = (0..surfaces.len()).collect();
    let mut along: BTreeMap<(usize, u64), Vec<usize>> = BTreeMap::new();
    for (face, (instance, keys)) in edges.iter().enumerate() {
        for &key in *keys {
            let faces = along.entry((*instance, key)).or_default();
            for &other in faces.iter() {
                if let (Some(a), Some(b)) = (&surfaces[face], &surfaces[other])
                    && is_same(a, b, diagonal)
                {
                    let (a, b) = (root(&mut first, face), root(&mut first, other));
                    first[a.max(b)] = a.min(b);
                }
            }
            faces.push(face);
        }
    }
    (0..first.len())
        .map(|face| root(&mut first, face))
        .collect()
}

fn root(first: &mut [usize], mut face: usize) -> usize {
    while first[face] != face {
        first[face] = first[first[face]];
        face = first[face];
    }
    face
}

/// Whether two surfaces are one, as far as files are exact.
fn is_same(a: &Surface, b: &Surface, diagonal: f64) -> bool {
    let near = SAME * diagonal;
    let place = |a: &Point, b: &Point| (a - b).norm() <= near;
    let axis = |a: &Direction, b: &Direction| a.cross(b).norm() <= SAME;
    let length = |a: f64, b: f64| (a - b).abs() <= near;
    // Places on an axis are those nearest the origin: far away, a turn too small to see moves them.
    let on = |p: &Point, q: &Point, along: &Direction| (p - q).cross(along).norm() <= near;
    match (a, b) {
        (Surface::Plane(a), Surface::Plane(b)) => {
            axis(&a.normal, &b.normal)
                && length(a.offset, b.offset * a.normal.dot(&b.normal).signum())
        }
        (Surface::Cylinder(a), Surface::Cylinder(b)) => {
            axis(&a.axis, &b.axis)
                && on(&a.centre, &b.centre, &a.axis)
                && length(a.radius, b.radius)
        }
        (Surface::Cone(a), Surface::Cone(b)) => {
            axis(&a.axis, &b.axis)
                && place(&a.apex, &b.apex)
                && (a.half_angle - b.half_angle).abs() <= SAME
        }
        (Surface::Sphere(a), Surface::Sphere(b)) => {
            place(&a.centre, &b.centre) && length(a.radius, b.radius)
        }
        (Surface::Torus(a), Surface::Torus(b)) => {
            axis(&a.axis, &b.axis)
                && place(&a.centre, &b.centre)
                && length(a.major_radius, b.major_radius)
                && length(a.minor_radius, b.minor_radius)
        }
        _ => false,
    }
}
