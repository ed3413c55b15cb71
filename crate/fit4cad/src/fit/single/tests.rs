use super::*;
use crate::sample::single::{STRAINS, Strain, parameter_error, segment};

#[test]
fn every_type_is_told_with_its_parameters_where_a_fifth_of_the_points_is_exact() {
    for (name, strain) in STRAINS {
        for kind in SurfaceType::ALL {
            for seed in 0..1 {
                let mut random = Random::new(seed, kind as u64);
                let (truth, points) = segment(kind, 1500, &strain, &mut random);
                let single = fit_single(&points, &[]);
                let found = single.best.surface;
                // Bent, a surface may be nearer to one of another type.
                if strain.bend == 0.0 {
                    assert_eq!(found.kind(), kind, "{name} {seed}: {single:?}");
                    let error = parameter_error(&found, &truth, Ball::of(&points).radius);
                    assert!(
                        error < 1e-3,
                        "{name} {kind} {seed}: {error} {found:?} {truth:?}"
                    );
                }
                assert!(single.margin >= 1.0 && single.others.len() == 4);
            }
        }
    }
}

#[test]
fn there_is_an_answer_for_any_points_and_for_any_type() {
    let line = (0..20)
        .map(|i| Point::new(f64::from(i), 2.0, 3.0))
        .collect();
    let far = (0..9).map(|i| Point::new(1e29 + f64::from(i) * 1e25, 0.0, f64::from(i % 3) * 1e25));
    let odd = vec![
        Point::new(f64::NAN, 0.0, 0.0),
        Point::new(f64::INFINITY, 0.0, 0.0),
        Point::new(1e154, -1e200, 0.0),
    ];
    for points in [
        vec![],
        odd,
        vec![Point::new(1.0, 2.0, 3.0)],
        vec![Point::new(1.0, 2.0, 3.0); 7],
        vec![Point::new(1.0, 2.0, 3.0), Point::new(2.0, 2.0, 3.0)],
        line,
        far.collect(),
    ] {
        for kinds in [vec![], SurfaceType::ALL.to_vec()] {
            let single = fit_single(&points, &kinds);
            assert_eq!(single.best.surface.kind(), SurfaceType::Plane, "{points:?}");
        }
        for kind in SurfaceType::ALL {
            let single = fit_single(&points, &[kind]);
            assert_eq!(single.best.surface.kind(), kind);
            assert!(single.best.surface.is_in_range(), "{kind} {points:?}");
            assert_eq!((single.others.len(), single.margin), (0, 1.0));
        }
    }
}

#[test]
fn the_order_of_the_points_does_not_matter() {
    let strain = Strain {
        moved: 0.8,
        noise: 1.0,
        kept: 1.0,
        ..Strain::default()
    };
    let mut random = Random::new(5, 0);
    let (_, points) = segment(SurfaceType::Cone, 800, &strain, &mut random);
    let first = fit_single(&points, &[]).best.surface;
    let mut turned = points;
    turned.reverse();
    let second = fit_single(&turned, &[]).best.surface;
    assert!(parameter_error(&first, &second, 1.0) < 1e-6);
}

#[test]
fn segments_get_their_surfaces_and_keep_the_types_they_have() {
    let mut random = Random::new(1, 0);
    let clean = Strain {
        kept: 1.0,
        ..Strain::default()
    };
    let (truth, points) = segment(SurfaceType::Cylinder, 300, &clean, &mut random);
    let primitive = |kind, range: std::ops::Range<u32>| Primitive {
        number: 7,
        kind,
        points: range.collect(),
        ..Primitive::default()
    };
    let mut segmentation = Segmentation {
        primitives: vec![
            primitive(None, 0..300),
            primitive(Some(SurfaceType::Plane), 0..300),
            primitive(None, 0..0),
        ],
    };
    assert_eq!(fit_segments(&Cloud::new(points), &mut segmentation), 2);
    let [cylinder, plane, empty] = &segmentation.primitives[..] else {
        panic!("three");
    };
    assert!(parameter_error(&cylinder.surface.unwrap(), &truth, 1.0) < 1e-6);
    assert_eq!((cylinder.number, cylinder.points.len()), (7, 300));
    assert_eq!(plane.kind, Some(SurfaceType::Plane));
    assert!(plane.surface.is_some() && plane.parametric.values().is_some());
    assert_eq!(*empty, primitive(None, 0..0));
}
