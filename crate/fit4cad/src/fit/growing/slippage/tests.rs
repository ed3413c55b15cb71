//! The seven classes by exact patches of surfaces, and where least squares starts from them.

use super::*;
use nalgebra::{Isometry3, Translation3, UnitQuaternion};

/// Slippage of the patch that a parametric surface (point and normal) covers over (-1, 1)²,
/// turned and moved away from where its formula puts it.
fn slippage(surface: impl Fn(f64, f64) -> (Vector, Vector)) -> (Slippage, Isometry3<f64>) {
    let turn = UnitQuaternion::from_euler_angles(0.4, -0.7, 1.1);
    let motion = Isometry3::from_parts(Translation3::new(30.0, -20.0, 10.0), turn);
    let (points, normals): (Vec<Point>, Vec<Vector>) = (0..400)
        .map(|i| {
            let at = |k: i32| (f64::from(k) - 9.5) / 10.0;
            let (point, normal) = surface(at(i % 20), at(i / 20));
            (motion * Point::from(point), motion * normal.normalize())
        })
        .unzip();
    (Slippage::of(&points, &normals).unwrap(), motion)
}

/// Whether the axis found is the z axis of the formula.
fn is_about_z((slippage, motion): &(Slippage, Isometry3<f64>)) -> bool {
    let (point, direction) = slippage.axis.unwrap();
    let (point, direction) = (motion.inverse() * point, motion.inverse() * direction);
    point.coords.xy().norm() < 1e-6 && direction.cross(&Vector::z()).norm() < 1e-6
}

#[test]
fn a_flat_patch_is_planar_and_its_axis_is_its_normal() {
    let found = slippage(|u, v| (Vector::new(u, v, 0.0), Vector::z()));
    assert_eq!(found.0.class, Invariance::Planar);
    assert!(is_about_z(&found));
    assert!(found.0.eigenvalues[2] < 1e-12 && found.0.eigenvalues[3] > SLIPPABLE);
}

#[test]
fn a_patch_of_a_sphere_is_spherical() {
    let on = |u: f64, v: f64| Vector::new(u.sin() * v.cos(), v.sin(), u.cos() * v.cos());
    let (found, _) = slippage(|u, v| (on(u, v), on(u, v)));
    assert_eq!((found.class, found.axis), (Invariance::Spherical, None));
}

#[test]
fn half_a_cylinder_is_cylindrical_about_its_axis() {
    let found = slippage(|u, v| {
        let out = Vector::new((1.5 * u).cos(), (1.5 * u).sin(), 0.0);
        (out + Vector::z() * v, out)
    });
    assert_eq!(found.0.class, Invariance::Cylindrical);
    assert!(is_about_z(&found));
}

#[test]
fn a_helicoid_is_helical_about_its_axis() {
    let found = slippage(|u, v| {
        let (turn, radius, rise) = (2.0 * v, 2.0 + u, 0.6);
        let (sin, cos) = turn.sin_cos();
        let point = Vector::new(radius * cos, radius * sin, rise * turn);
        (point, Vector::new(rise * sin, -rise * cos, radius))
    });
    assert_eq!(found.0.class, Invariance::Helical);
    assert!(is_about_z(&found));
}

#[test]
fn an_extruded_parabola_is_prismatic_along_its_rulings() {
    let (found, motion) = slippage(|u, v| {
        (
            Vector::new(u, 1.5 * u * u, v),
            Vector::new(-3.0 * u, 1.0, 0.0),
        )
    });
    assert_eq!(found.class, Invariance::Prismatic);
    let direction = motion.inverse() * found.axis.unwrap().1;
    assert!(direction.cross(&Vector::z()).norm() < 1e-6);
}

#[test]
fn cones_and_tori_are_revolute_about_their_axes() {
    let cone = slippage(|u, v| {
        let (sin, cos) = (1.4 * u).sin_cos();
        let radius = 1.5 + v;
        (
            Vector::new(radius * cos, radius * sin, v),
            Vector::new(cos, sin, -1.0),
        )
    });
    let torus = slippage(|u, v| {
        let (sin, cos) = (1.4 * u).sin_cos();
        let out = Vector::new(cos, sin, 0.0);
        let normal = out * (1.4 * v).cos() + Vector::z() * (1.4 * v).sin();
        (out * 3.0 + normal, normal)
    });
    for found in [cone, torus] {
        assert_eq!(found.0.class, Invariance::Revolute, "{:?}", found.0);
        assert!(is_about_z(&found));
    }
}

#[test]
fn a_patch_of_an_ellipsoid_is_complex() {
    let (found, _) = slippage(|u, v| {
        let on = Vector::new(u.sin() * v.cos(), v.sin(), u.cos() * v.cos());
        let axes = Vector::new(1.0, 2.0, 3.0);
        (on.component_mul(&axes), on.component_div(&axes))
    });
    assert_eq!((found.class, found.axis), (Invariance::Complex, None));
}

#[test]
fn too_few_points_have_no_slippage() {
    assert_eq!(Slippage::of(&[Point::origin(); 5], &[Vector::z(); 5]), None);
    assert_eq!(Slippage::of(&[Point::origin(); 9], &[Vector::z(); 9]), None);
}

#[test]
fn the_section_of_a_revolute_region_starts_its_surface_exactly() {
    let truth = crate::surface::Torus::new(Point::new(1.0, 2.0, 3.0), Vector::z(), 3.0, 1.0);
    let surface = Surface::Torus(truth);
    let points: Vec<Point> = (0..50)
        .map(|i| {
            let (s, t) = (f64::from(i % 7) * 0.3, f64::from(i / 7) * 0.25);
            surface.foot(&(truth.centre + Vector::new(3.9 * s.cos(), 3.9 * s.sin(), t - 0.8)))
        })
        .collect();
    let slippage = Slippage {
        eigenvalues: [0.0; 6],
        class: Invariance::Revolute,
        centre: Point::origin(),
        axis: Some((truth.centre + Vector::z(), Vector::z_axis())),
    };
    let starts = slippage.starts(&points);
    let torus = starts
        .iter()
        .find(|s| matches!(s, Surface::Torus(_)))
        .unwrap();
    assert!(points.iter().all(|p| torus.distance(p) < 1e-9));
}
