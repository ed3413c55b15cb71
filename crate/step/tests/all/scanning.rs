//! Points as a scanner takes them: what is hidden has none.

use crate::made::{Made, import, near};
use fit4cad::cloud::{Point, Vector};
use fit4cad_step::{Amount, Import, Options, Spread};

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

fn scan(text: &str, views: usize, points: usize, seed: u64) -> Import {
    let options = Options {
        amount: Amount::Points(points),
        spread: Spread::Scan,
        views,
        seed,
        ..Options::default()
    };
    import(text.as_bytes(), &options)
}

/// A whole sphere, without bounds but a vertex.
fn sphere(made: &mut Made, centre: [f64; 3], radius: f64) -> usize {
    let frame = made.frame(centre, Z, Some(X));
    let surface = made.add(&format!("SPHERICAL_SURFACE('',#{frame},{radius:?})"));
    let pole = made.vertex([centre[0], centre[1], centre[2] + radius]);
    let ring = made.add(&format!("VERTEX_LOOP('',#{pole})"));
    let bound = made.bound(ring, true);
    made.face(&[bound], surface, true)
}

/// The box of 2 `half`, its faces outward: planes, or free-form by their names. The last is its
/// lid, which may be missing.
fn cube(made: &mut Made, half: f64, free: bool, lid: bool) -> Vec<usize> {
    let mut faces = Vec::new();
    for axis in 0..3 {
        for side in [-1.0, 1.0] {
            if faces.len() == 5 && !lid {
                break;
            }
            let at = |u: f64, v: f64| {
                let mut place = [0.0; 3];
                place[axis] = side * half;
                place[(axis + 1) % 3] = u * half;
                place[(axis + 2) % 3] = v * half;
                place
            };
            let mut normal = [0.0; 3];
            normal[axis] = side;
            let surface = if free {
                let [a, b, c, d] = [(-1.0, -1.0), (-1.0, 1.0), (1.0, -1.0), (1.0, 1.0)]
                    .map(|(u, v)| made.point(at(u * side, v)));
                made.add(&format!(
                    "B_SPLINE_SURFACE_WITH_KNOTS('',1,1,((#{a},#{b}),(#{c},#{d})),.UNSPECIFIED.,.F.,.F.,.F.,(2,2),(2,2),(0.,1.),(0.,1.),.UNSPECIFIED.)"
                ))
            } else {
                let frame = made.frame(at(0.0, 0.0), normal, None);
                made.add(&format!("PLANE('',#{frame})"))
            };
            let ring = [at(-1.0, -1.0), at(1.0, -1.0), at(1.0, 1.0), at(-1.0, 1.0)];
            let ring: Vec<_> = if side > 0.0 {
                ring.to_vec()
            } else {
                ring.iter().rev().copied().collect()
            };
            faces.push(made.polygon(surface, &[&ring], true));
        }
    }
    faces
}

/// From two diagonals of its box away, a sphere of radius 1 shows the cap whose edge the eye looks along:
/// cos θ = 1/d for the angle θ about the direction of the eye. Over directions of the eye the points are
/// spread evenly: within the angle α of them lie (1 - cos α) / (1 - cos α₀), sin α₀ = 1/d.
#[test]
fn one_viewpoint_sees_its_cap_of_a_sphere_and_every_direction_alike() {
    let mut made = Made::new();
    let face = sphere(&mut made, [3.0, 4.0, 5.0], 1.0);
    made.shell(&[face]);
    let found = scan(&made.text(), 1, 4000, 1);
    let offsets: Vec<Vector> = found
        .model
        .cloud
        .points()
        .iter()
        .map(|p| p - Point::new(3.0, 4.0, 5.0))
        .collect();
    assert_eq!(offsets.len(), 4000);
    let mean: Vector = offsets.iter().sum();
    let axis = mean.normalize();
    // The diagonal of the box of the sphere, and a hundredth more on either side of each axis.
    let distance = 2.0 * 3f64.sqrt() * 2.0 * 1.02;
    let least = offsets.iter().map(|it| it.dot(&axis)).fold(1.0, f64::min);
    // The direction of the eye is known by the mean alone, to a hundredth or so.
    assert!((least - 1.0 / distance).abs() < 0.02, "{least}");
    let whole = 1.0 - (1.0 - 1.0 / (distance * distance)).sqrt();
    for share in [0.25, 0.5, 0.75] {
        let cos = 1.0 - share * whole;
        let within = offsets.iter().filter(|it| {
            let way = axis * distance - **it;
            way.normalize().dot(&axis) > cos
        });
        let within = within.count() as f64 / 4000.0;
        // Three standard deviations are 0.024.
        assert!((within - share).abs() < 0.03, "{share}: {within}");
    }
    // The area of that cap over the sphere's, by the spacing that is told.
    let area = found.report.area * (1.0 - 1.0 / distance) / 2.0;
    let spacing = (0.67 * area / 4000.0).sqrt();
    assert!(
        near(found.report.spacing, spacing, 0.05),
        "{}",
        found.report.spacing
    );
}

#[test]
fn many_viewpoints_see_all_of_a_sphere() {
    let mut made = Made::new();
    let face = sphere(&mut made, [0.0; 3], 1.0);
    made.shell(&[face]);
    let found = scan(&made.text(), 12, 4000, 1);
    for sector in 0..8 {
        let own = |p: &&Point| (0..3).all(|k| (p[k] > 0.0) == ((sector >> k) & 1 == 1));
        let count = found.model.cloud.points().iter().filter(own).count();
        assert!((300..700).contains(&count), "{sector}: {count}");
    }
}

#[test]
fn a_sphere_inside_a_box_is_seen_by_none_and_the_report_says_so() {
    for free in [false, true] {
        let mut made = Made::new();
        let mut faces = cube(&mut made, 2.0, free, true);
        faces.push(sphere(&mut made, [0.0; 3], 1.0));
        made.shell(&faces);
        let found = scan(&made.text(), 20, 3000, 1);
        let inner = &found.report.faces[6];
        assert_eq!((inner.points, inner.primitive), (0, None));
        assert_eq!(inner.remark, "no points: no viewpoint sees it");
        assert!(found.report.warnings[0].starts_with("1 of 7 faces have no points"));
        assert_eq!(found.model.cloud.len(), 3000);
        for face in &found.report.faces[..6] {
            assert!((300..700).contains(&face.points), "{}", face.points);
        }
    }
}

/// Through the hole of a lid the eye sees a piece of the floor no wider than the hole; from below
/// all of the floor.
#[test]
fn what_lies_behind_a_hole_is_seen_through_it() {
    let mut made = Made::new();
    let frame = made.frame([0.0, 0.0, 1.0], Z, Some(X));
    let lid = made.add(&format!("PLANE('',#{frame})"));
    let square = |h: f64, z: f64| [[-h, -h, z], [h, -h, z], [h, h, z], [-h, h, z]];
    let (outer, mut hole) = (square(12.0, 1.0), square(4.0, 1.0));
    hole.reverse();
    let top = made.polygon(lid, &[&outer, &hole], true);
    let frame = made.frame([0.0; 3], Z, Some(X));
    let floor = made.add(&format!("PLANE('',#{frame})"));
    let bottom = made.polygon(floor, &[&square(6.0, 0.0)], true);
    made.shell(&[top, bottom]);
    let widths: Vec<f64> = (1..6)
        .map(|seed| {
            let found = scan(&made.text(), 1, 2000, seed);
            let points = found.model.cloud.points().iter();
            let floor: Vec<f64> = points.filter(|p| p.z < 0.5).map(|p| p.x).collect();
            let most = floor.iter().copied().fold(f64::MIN, f64::max);
            most - floor.iter().copied().fold(f64::MAX, f64::min)
        })
        .collect();
    // The floor is a little farther away than the hole: it shows less than a twentieth more.
    let through = widths.iter().filter(|it| **it < 8.4).count();
    let below = widths
        .iter()
        .filter(|it| (11.5..=12.0).contains(*it))
        .count();
    assert!(
        through > 0 && below > 0 && through + below == 5,
        "{widths:?}"
    );
}

/// Of a torus that is seen from one place no point has a normal, turned outward, that looks away from the eye.
#[test]
fn places_that_look_away_from_the_eye_are_hidden_by_their_own_face() {
    let mut made = Made::new();
    let frame = made.frame([0.0; 3], Z, Some(X));
    let torus = made.add(&format!("TOROIDAL_SURFACE('',#{frame},3.,1.)"));
    let pole = made.vertex([4.0, 0.0, 0.0]);
    let ring = made.add(&format!("VERTEX_LOOP('',#{pole})"));
    let bound = made.bound(ring, true);
    let face = made.face(&[bound], torus, true);
    made.shell(&[face]);
    for seed in 1..6 {
        let found = scan(&made.text(), 1, 1500, seed);
        let points = found.model.cloud.points();
        assert_eq!(points.len(), 1500);
        let normals: Vec<Vector> = points
            .iter()
            .map(|p| {
                let across = Vector::new(p.x, p.y, 0.0).normalize() * 3.0;
                p.coords - across
            })
            .collect();
        // Some direction looks at all of them: the mean of the normals is near enough to begin with.
        let mut eye = normals.iter().sum::<Vector>().normalize();
        for _ in 0..200 {
            let worst = normals
                .iter()
                .min_by(|a, b| a.dot(&eye).total_cmp(&b.dot(&eye)));
            if let Some(worst) = worst.filter(|it| it.dot(&eye) < 0.0) {
                eye = (eye + worst * 0.2).normalize();
            }
        }
        let away = normals.iter().filter(|it| it.dot(&eye) < -0.15).count();
        assert!(away == 0, "{seed}: {away}");
    }
}

/// Inside a closed box nothing is seen, in a box without a lid all that is in it.
#[test]
fn inner_faces_have_points_or_not_as_is_asked() {
    for (lid, inner) in [(true, true), (true, false), (false, false)] {
        let mut made = Made::new();
        let mut faces = cube(&mut made, 2.0, false, lid);
        faces.push(sphere(&mut made, [0.0; 3], 1.0));
        made.shell(&faces);
        let options = Options {
            inner,
            ..Options::default()
        };
        let found = import(made.text().as_bytes(), &options);
        let face = &found.report.faces[faces.len() - 1];
        let expected = if lid && !inner {
            "no points: nothing outside sees it"
        } else {
            ""
        };
        assert_eq!(face.remark, expected);
        assert_eq!(face.points == 0, lid && !inner);
        // Points are as dense on the others as if it were not there.
        assert_eq!(found.model.cloud.len(), 2000);
        assert!(
            found.report.warnings.is_empty(),
            "{:?}",
            found.report.warnings
        );
    }
}

#[test]
fn views_are_checked_and_a_seed_gives_the_same_scan_again() {
    let mut made = Made::new();
    let faces = cube(&mut made, 1.0, false, true);
    made.shell(&faces);
    let text = made.text();
    assert_eq!(scan(&text, 3, 300, 7).model, scan(&text, 3, 300, 7).model);
    assert_ne!(scan(&text, 3, 300, 7).model, scan(&text, 3, 300, 8).model);
    let document = fit4cad_step::Document::read(text.as_bytes(), &mut |_| {}).unwrap();
    for views in [0, 65] {
        let options = Options {
            spread: Spread::Scan,
            views,
            ..Options::default()
        };
        let error = document.sample("x", &options, &mut |_| {}).unwrap_err();
        assert!(
            error.to_string().contains("views must be 1 to 64"),
            "{error}"
        );
    }
}
