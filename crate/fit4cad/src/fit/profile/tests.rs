use super::*;
use crate::cloud::{Cloud, Point, Vector};
use crate::fit::Parameters;
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
