//! Primitives written as CAD and read back.

use fit4cad::model::{Model, Primitive};
use fit4cad::sample::{Options as Sampling, generate, parts};
use fit4cad::surface::Surface;
use fit4cad_step::{Amount, Document, Options, write_step};

use crate::made::import;

/// How far two surfaces of one family are apart, by their vectors.
fn difference(a: &Surface, b: &Surface) -> f64 {
    if a.kind() != b.kind() {
        return f64::INFINITY;
    }
    let (a, b) = (a.to_implicit(), b.to_implicit());
    let length = |values: &[f64]| values.iter().map(|it| it * it).sum::<f64>().sqrt();
    let (la, lb) = (length(&a), length(&b));
    let dot: f64 = a.iter().zip(&b).map(|(x, y)| x * y).sum::<f64>() / (la * lb);
    (1.0 - dot.abs()).max(0.0).sqrt()
}

fn surfaces(model: &Model) -> Vec<Surface> {
    let primitives = model.truth.as_ref().map(|truth| &truth.primitives[..]);
    primitives
        .unwrap_or_default()
        .iter()
        .filter_map(|it| it.surface)
        .collect()
}

#[test]
fn every_generated_part_comes_back_with_the_same_surfaces() {
    for part in parts() {
        let coarse = Sampling {
            spacing: 0.02,
            ..Sampling::default()
        };
        let model = generate(part.name, &coarse).unwrap();
        let truth = model.truth.as_ref().unwrap();
        let (text, left_out) = write_step("it's ü", &model.cloud, truth, |_| [0.2, 0.4, 0.6]);
        let options = Options {
            join: false,
            ..Options::default()
        };
        let back = import(text.as_bytes(), &options);
        let (before, after) = (surfaces(&model), surfaces(&back.model));
        assert_eq!(after.len() + left_out, before.len(), "{}", part.name);
        let remarks: Vec<&str> = back
            .report
            .faces
            .iter()
            .map(|face| &face.remark[..])
            .collect();
        assert!(
            remarks.iter().all(|it| it.is_empty()),
            "{}: {remarks:?}",
            part.name
        );
        for surface in &after {
            let nearest = before
                .iter()
                .map(|it| difference(it, surface))
                .fold(1.0, f64::min);
            assert!(
                nearest < 1e-6,
                "{}: {surface:?} off by {nearest:e}",
                part.name
            );
        }
    }
}

/// The outline keeps holes, and is about as large as what its points cover.
#[test]
fn a_face_is_as_large_as_its_points_cover() {
    let model = generate("flange", &Sampling::default()).unwrap();
    let truth = model.truth.as_ref().unwrap();
    let (text, _) = write_step("flange", &model.cloud, truth, |_| [0.5; 3]);
    let document = Document::read(text.as_bytes(), &mut |_| {}).unwrap();
    let options = Options {
        amount: Amount::Points(20_000),
        join: false,
        ..Options::default()
    };
    let back = document.sample("back", &options, &mut |_| {}).unwrap();
    // Wherever there is a face, there are points of the part.
    let tree = fit4cad::cloud::neighbours::KdTree::new(model.cloud.points());
    let reach = 0.03 * model.cloud.bounds().diagonal();
    let mut found = Vec::new();
    for point in back.model.cloud.points() {
        tree.nearest(point, 1, reach, |_| true, &mut found);
        assert!(
            !found.is_empty(),
            "a face reaches beyond its points at {point}"
        );
    }
    // And wherever there are points, a face.
    let tree = fit4cad::cloud::neighbours::KdTree::new(back.model.cloud.points());
    let alone = model.cloud.points().iter().filter(|point| {
        tree.nearest(point, 1, reach, |_| true, &mut found);
        found.is_empty()
    });
    assert_eq!(alone.count(), 0);
}

#[test]
fn what_has_no_surface_or_too_few_points_is_left_out_and_counted() {
    let mut model = generate("flange", &Sampling::default()).unwrap();
    let truth = model.truth.as_mut().unwrap();
    truth.primitives[0].surface = None;
    truth.primitives[1].points.truncate(2);
    truth.primitives.push(Primitive::default());
    let (text, left_out) = write_step("x", &model.cloud, truth, |_| [0.5; 3]);
    assert_eq!(left_out, 3);
    assert!(Document::read(text.as_bytes(), &mut |_| {}).is_ok());
}
