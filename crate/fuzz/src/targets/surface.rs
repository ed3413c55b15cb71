//! Surfaces: their two forms, distances, motions and patches.

use fit4cad::cloud::Point;
use fit4cad::lesson::forms::{compare, implicit_terms};
use fit4cad::surface::implicitization::implicitize;
use fit4cad::surface::patch::Patch;
use fit4cad::surface::{Form, Polynomial, Surface, parametric_point, sample_parametric};
use nalgebra::{Isometry3, Vector3};

use super::MIB;
use crate::{Bytes, Target, shapes};

pub const CONVERSIONS: Target = Target {
    name: "conversions",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let (kind, form) = (shapes::kind(&mut bytes), bytes.one(Form::ALL));
        let (u, v) = (bytes.number(), bytes.number());
        let values = bytes.list(40, Bytes::number);
        parametric_point(kind, &values, u, v);
        let finite = |point: &Point| point.coords.iter().all(|x| x.is_finite());
        assert!(sample_parametric(kind, &values).iter().all(finite));
        if let Some(polynomial) = Polynomial::from_implicit(kind, &values) {
            polynomial.first_order_distance(&Point::new(u, v, u));
            let back = polynomial.to_implicit(kind);
            assert_eq!(back.map(|back| back.len()), Some(values.len()));
        }
        let Ok(conversion) = Surface::from_form(form, kind, &values) else {
            return;
        };
        let surface = conversion.surface;
        assert!(surface.is_in_range() && surface.kind() == kind);
        assert!(conversion.misfit >= 0.0);
        for form in Form::ALL {
            let vector = match form {
                Form::Parametric => surface.to_parametric(),
                Form::Implicit => surface.to_implicit(),
            };
            assert!(
                vector.iter().all(|value| value.is_finite()),
                "{surface:?} {vector:?}"
            );
            // What is written may be at the edge of what is read, but must be told then, not fail.
            if let Ok(again) = Surface::from_form(form, kind, &vector) {
                assert!(again.surface.is_in_range());
            }
        }
    },
    seeds: || vec![vec![0; 40], (0..200).collect()],
    words: &[],
    longest: 512,
    floor: MIB / 2,
    quick: 8_000,
};

pub const GEOMETRY: Target = Target {
    name: "geometry",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let Some(surface) = shapes::surface(&mut bytes) else {
            return;
        };
        let turn = Vector3::from(bytes.numbers::<3>());
        let motion = Isometry3::new(Vector3::from(bytes.numbers::<3>()), turn);
        let other = shapes::surface(&mut bytes).unwrap_or(surface);
        let points = bytes.list(20, shapes::point);
        for surface in [
            surface,
            surface.moved(&motion),
            surface.scaled(bytes.number()),
        ] {
            for point in &points {
                let distance = surface.distance(point);
                assert!(distance.is_nan() || distance >= 0.0);
                surface.foot(point);
            }
        }
        let usable = points
            .iter()
            .filter(|point| point.iter().all(|x| x.abs() <= fit4cad::cloud::LARGEST));
        for point in usable {
            assert!(surface.distance(point).is_finite(), "{surface:?} {point}");
            assert!(
                surface.foot(point).coords.iter().all(|x| x.is_finite()),
                "{surface:?} {point}"
            );
        }
        let (predicted, truth) = (surface.to_implicit(), other.to_implicit());
        let compared = compare(&predicted, &truth);
        // The sum of as many differences of unit vectors, whichever the sign.
        let most = (2.0 * predicted.len() as f64).sqrt() + 1e-9;
        assert!(
            compared
                .definition
                .is_none_or(|it| (0.0..=most).contains(&it)),
            "{compared:?}"
        );
        assert_eq!(implicit_terms(predicted.len()).len(), predicted.len());
    },
    seeds: super::none,
    words: &[],
    longest: 512,
    floor: MIB / 4,
    quick: 50_000,
};

pub const PATCH: Target = Target {
    name: "patch",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let Some(surface) = shapes::surface(&mut bytes) else {
            return;
        };
        let cloud = shapes::cloud(&mut bytes);
        let Some(patch) = Patch::new(&surface, cloud.points()) else {
            return;
        };
        assert_eq!(patch.vertices.len(), patch.normals.len());
        let exists = |corner: &u32| (*corner as usize) < patch.vertices.len();
        assert!(patch.triangles.iter().flatten().all(exists));
    },
    seeds: super::none,
    words: &[],
    longest: 1024,
    floor: 4 * MIB,
    quick: 40_000,
};

pub const IMPLICITIZE: Target = Target {
    name: "implicitize",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let degree = bytes.whole();
        let cloud = shapes::cloud(&mut bytes);
        if let Ok(found) = implicitize(cloud.points(), degree) {
            assert_eq!(found.polynomial.degree(), degree);
        }
    },
    seeds: super::none,
    words: &[],
    longest: 1024,
    floor: 2 * MIB,
    quick: 5_000,
};
