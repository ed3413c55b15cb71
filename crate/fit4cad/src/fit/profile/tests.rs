use super::partition::tests::profile;
use super::*;
use crate::cloud::{Cloud, Point, Vector};
use crate::fit::Parameters;
use crate::random::Random;
use crate::surface::{Plane, Surface, SurfaceType};

/// Height of the rulings, in spacings.
const HEIGHT: u32 = 30;

/// Two grooves between flat lands, extruded along z, with nothing at the ends: lands of six rulings,
/// flanks of three on quarter circles of radius `radius`.
fn comb(radius: f64) -> Vec<Point> {
    let mut profile = Vec::new();
    for groove in 0..3 {
        let left = f64::from(groove) * (5.0 + 2.0 * radius);
        profile.extend((0..6).map(|i| [left + f64::from(i), 0.0]));
        if groove < 2 {
            let turn = std::f64::consts::FRAC_PI_4;
            let flank = (1..4).map(|i| {
                let angle = f64::from(i) * turn;
                [
                    left + 5.0 + radius * (1.0 - angle.cos()),
                    -radius * angle.sin(),
                ]
            });
            profile.extend(flank);
        }
    }
    let ruling = |[x, y]: [f64; 2]| (0..=HEIGHT).map(move |z| Point::new(x, y, f64::from(z)));
    profile.into_iter().flat_map(ruling).collect()
}

fn decided(points: Vec<Point>, wrong: &[Surface]) -> (Vec<Candidate>, Vec<bool>) {
    let cloud = Cloud::new(points);
    let mut search = Search::new(&cloud, &Parameters::default(), 1);
    for surface in wrong {
        let on = (0u32..).zip(cloud.points());
        let on = on.filter(|(_, point)| surface.distance(point) < 1e-9);
        let support: Vec<u32> = on.map(|(index, _)| index).collect();
        assert!(!support.is_empty());
        search.accept(Candidate {
            surface: *surface,
            support,
            error: 0.0,
        });
    }
    let along = Vector::z_axis();
    let mut heard = 0;
    let told = extruded(&mut search, &[along], &mut |_| heard += 1);
    assert_eq!(heard, search.accepted().len());
    (search.into_accepted(), told)
}

#[test]
fn lands_and_grooves_are_found_from_rulings_alone() {
    let (found, told) = decided(comb(1.5), &[]);
    let mut kinds: Vec<SurfaceType> = found.iter().map(|face| face.surface.kind()).collect();
    kinds.sort();
    use SurfaceType::{Cylinder, Plane};
    assert_eq!(kinds, [Plane, Plane, Plane, Cylinder, Cylinder]);
    for face in &found {
        if let Surface::Cylinder(cylinder) = &face.surface {
            assert!((cylinder.radius - 1.5).abs() < 1e-9);
            assert_eq!(face.support.len(), 5 * (HEIGHT as usize + 1));
        }
    }
    // All but the ends of the rulings, and the first and last of them, whose other faces are missing.
    let rulings = told.len() / (HEIGHT as usize + 1);
    let inside = (rulings - 2) * (HEIGHT as usize - 1);
    assert_eq!(told.iter().filter(|told| **told).count(), inside);
}

#[test]
fn a_plane_across_two_rulings_of_other_faces_is_taken_back() {
    let points = comb(1.5);
    let row = HEIGHT as usize + 1;
    let (from, to) = (points[7 * row], points[8 * row]);
    let across = (to - from).cross(&Vector::z());
    let wrong = Surface::Plane(Plane::new(from, across));
    let (found, _) = decided(points, &[wrong]);
    assert_eq!(found.len(), 5);
    assert!(found.iter().all(|face| face.surface != wrong));
}

#[test]
fn a_free_form_profile_has_no_faces() {
    let steps = (0..60).map(|i| f64::from(i) * 0.9);
    let rulings = steps.flat_map(|x| {
        let y = 4.0 * (0.3 * x).sin() + 0.002 * x.powi(3);
        (0..=HEIGHT).map(move |z| Point::new(x, y, f64::from(z)))
    });
    let (found, told) = decided(rulings.collect(), &[]);
    assert_eq!(found, []);
    assert!(!told.contains(&true));
}

/// A flank by its pieces: lines by their length, arcs by radius and turn, and steps.
const FLANK: [(f64, f64, u32); 4] = [
    (0.9, -0.96, 2),
    (5.6, -0.37, 2),
    (1.2, 0.0, 1),
    (2.2, 1.33, 2),
];

/// What of the flanks between broad lands and roots is found once these and the faces across them at
/// both ends are known, of rulings of which one in `stride` points is kept.
fn flanks(stride: usize, teeth: usize) -> Vec<SurfaceType> {
    let land = (9.0, 0.0, 9);
    let mut up = FLANK;
    up.reverse();
    let tooth = [&[land][..], &FLANK, &[land], &up].concat();
    let places = profile(&[tooth.repeat(teeth), vec![land]].concat());
    let low = places.iter().map(|place| place[1]).fold(0.0, f64::min);
    let top = f64::from(HEIGHT);
    let mut random = Random::new(5, 0);
    let mut points: Vec<Point> = Vec::new();
    for (number, &[x, y]) in places.iter().enumerate() {
        let ruling = (0..=HEIGHT).map(|z| Point::new(x, y, f64::from(z)));
        points.extend(ruling.skip(number % stride).step_by(stride));
        for z in [0.0, top] {
            points.extend((1..6).map(|i| Point::new(x, y - f64::from(i), z)));
        }
    }
    for step in places.windows(2) {
        let [from, to] = [step[0], step[1]];
        // Lands and roots are more than rulings.
        if (from[1] - to[1]).abs() < 1e-9 {
            let within = |_| Point::new(from[0] + random.unit(), from[1], top * random.unit());
            points.extend((0..8).map(within));
        }
    }
    let cloud = Cloud::new(points);
    let mut search = Search::new(&cloud, &Parameters::default(), 1);
    let known = [(2, 0.0), (2, top), (1, 0.0), (1, low)];
    for (axis, level) in known {
        let on = (0u32..).zip(cloud.points());
        let on = on.filter(|(_, point)| (point[axis] - level).abs() < 1e-9);
        let mut at = Point::origin();
        at[axis] = level;
        search.accept(Candidate {
            surface: Surface::Plane(Plane::new(at, Vector::ith(axis, 1.0))),
            support: on.map(|(index, _)| index).collect(),
            error: 0.0,
        });
    }
    extruded(&mut search, &[Vector::z_axis()], &mut |_| ());
    let found = search.accepted()[known.len()..].iter();
    found.map(|face| face.surface.kind()).collect()
}

#[test]
fn flanks_are_found_between_known_faces_though_their_rulings_lost_their_ends() {
    for stride in [1, 2, 3] {
        let found = flanks(stride, 4);
        let arcs = found.iter().filter(|kind| **kind == SurfaceType::Cylinder);
        assert_eq!(
            (found.len(), arcs.count()),
            (4 * 2 * 4, 4 * 2 * 3),
            "{stride}"
        );
    }
}

#[test]
fn a_long_row_of_small_pieces_is_a_flank_where_many_are_congruent() {
    assert_eq!(flanks(1, 1).len(), 0);
    assert_eq!(flanks(1, 3).len(), 3 * 2 * 4);
}
