//! Primitive growing from end to end on clouds whose faces are known.

use super::*;
use crate::cloud::Cloud;
use crate::fit::stages;
use crate::surface::{Cylinder, Plane, Surface, SurfaceType};

/// A pipe of radius 1 about the z axis, and the washer around its foot.
fn pipe_and_washer() -> Cloud {
    let around = (0..80).map(|i| f64::from(i) * std::f64::consts::TAU / 80.0);
    let profile = (0..=25)
        .map(|i| (1.0, 0.08 * f64::from(i)))
        .chain((1..=12).map(|i| (1.0 + 0.08 * f64::from(i), 0.0)));
    let points = profile.flat_map(|(radius, z)| {
        let at = move |angle: f64| Point::new(radius * angle.cos(), radius * angle.sin(), z);
        around.clone().map(at)
    });
    Cloud::new(points.collect())
}

fn found(cloud: &Cloud, seed: u64) -> Vec<Candidate> {
    let mut search = Search::new(cloud, &Parameters::default(), seed);
    find(&mut search, &mut ()).unwrap();
    search.into_accepted()
}

#[test]
fn the_edge_belongs_to_both_faces_by_growth() {
    let cloud = pipe_and_washer();
    let mut found = found(&cloud, 1);
    found.sort_by_key(|candidate| candidate.surface.kind());
    let kinds: Vec<SurfaceType> = found.iter().map(|it| it.surface.kind()).collect();
    assert_eq!(kinds, [SurfaceType::Plane, SurfaceType::Cylinder]);
    let sizes: Vec<usize> = found.iter().map(|it| it.support.len()).collect();
    assert_eq!(sizes, [13 * 80, 26 * 80]);
}

#[test]
fn a_seed_gives_the_same_surfaces_every_time() {
    let cloud = pipe_and_washer();
    for seed in [1, 2, 77] {
        let (first, second) = (found(&cloud, seed), found(&cloud, seed));
        assert_eq!(first, second);
        assert_eq!(first.len(), 2, "seed {seed}");
    }
}

#[test]
fn an_oversegmented_face_becomes_one_primitive() {
    // Half of the columns of a sheet is said to be sharp, so that the strips between are regions.
    let at = |i: u32| Point::new(f64::from(i % 40), f64::from(i / 40), 0.0);
    let cloud = Cloud::new((0..1600).map(at).collect());
    let mut search = Search::new(&cloud, &Parameters::default(), 1);
    let order: Vec<u32> = (0..1600).collect();
    let regions = regions::grow(&search.graph, &order, |i| (i % 40) % 8 < 4);
    assert_eq!(regions.len(), 5);
    for (place, region) in regions.iter().enumerate() {
        refine(&mut search, place, region, 0.0, &mut ()).unwrap();
    }
    let primitives = stages::finish(&search, &mut ()).unwrap().primitives;
    let whole: Vec<u32> = (0..1600).collect();
    assert_eq!(primitives.len(), 1);
    assert_eq!(primitives[0].points, whole);
}

/// A floor, a wall, and between them a chamfer of two rows of points, each an edge of its own.
#[test]
fn a_chamfer_without_points_inside_is_found_between_its_faces() {
    let row = |x: f64, z: f64| (0..=20).map(move |y| Point::new(x, f64::from(y), z));
    let floor = (0..=20).flat_map(|i| row(-f64::from(i), 0.0));
    let wall = (0..=20).flat_map(|i| row(1.0, -1.0 - f64::from(i)));
    let cloud = Cloud::new(floor.chain(wall).collect());
    let mut search = Search::new(&cloud, &Parameters::default(), 1);
    for (normal, place) in [(Vector::z(), 0u32), (Vector::x(), 441)] {
        let surface = Surface::Plane(Plane::new(*search.point(place), normal));
        let face = search
            .grow(&surface, &[place, place + 1, place + 30])
            .unwrap();
        assert_eq!(face.support.len(), 441);
        search.accept(face);
    }
    leftovers::thin_faces(&mut search, &mut ()).unwrap();
    let accepted = search.accepted();
    assert_eq!(accepted.len(), 3);
    let rows: Vec<u32> = (0..21).chain(441..462).collect();
    assert_eq!(accepted[2].support, rows);
}

/// A fillet that shows four rings a few points long, on a shaft whose axis is known.
#[test]
fn a_patch_too_small_for_an_axis_of_its_own_is_found_about_a_known_one() {
    let at =
        |radius: f64, angle: f64, z: f64| Point::new(radius * angle.cos(), radius * angle.sin(), z);
    let around = |count: u32| (0..count).map(|i| f64::from(i) * 0.05);
    let shaft = (0..40).flat_map(|z| around(63).map(move |t| at(2.0, t, 0.1 * f64::from(z))));
    let bend = |i: u32| 0.25 * f64::from(i);
    let fillet = (1..=5).flat_map(|i| {
        around(12).map(move |t| at(2.4 - 0.4 * bend(i).cos(), t, -0.4 * bend(i).sin()))
    });
    let cloud = Cloud::new(shaft.chain(fillet).collect());
    let mut search = Search::new(&cloud, &Parameters::default(), 1);
    let surface = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 2.0));
    let face = search
        .grow(&surface, &(0..63).collect::<Vec<u32>>())
        .unwrap();
    search.accept(face);
    leftovers::about_known_axes(&mut search, &mut ()).unwrap();
    let Some(Surface::Torus(torus)) = search.accepted().get(1).map(|it| it.surface) else {
        panic!("no torus in {:?}", search.accepted());
    };
    assert!((torus.major_radius - 2.4).abs() < 1e-9 && (torus.minor_radius - 0.4).abs() < 1e-9);
}

#[test]
fn too_small_a_cloud_has_no_surfaces() {
    assert_eq!(found(&Cloud::new(Vec::new()), 1), []);
    assert_eq!(found(&Cloud::new(vec![Point::origin(); 4]), 1), []);
}
