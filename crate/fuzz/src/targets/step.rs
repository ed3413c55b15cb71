//! STEP files: read, sampled, written.

use fit4cad::cloud::LARGEST;
use fit4cad_step::{Amount, Document, Options, Spread, write_step};

use super::{MIB, text};
use crate::{Bytes, Target, shapes};

pub const READ: Target = Target {
    name: "step",
    run: |input| {
        let Ok(document) = Document::read(input, &mut |_| ()) else {
            return;
        };
        let options = Options {
            amount: Amount::Points(200),
            least: 2,
            spread: [Spread::Even, Spread::Scan][input.len() % 2],
            ..Options::default()
        };
        let Ok(import) = document.sample("PC1", &options, &mut |_| ()) else {
            return;
        };
        let points = import.model.cloud.points().iter();
        assert!(
            points
                .flat_map(|point| point.iter())
                .all(|x| x.abs() <= LARGEST)
        );
        for primitive in import.model.truth.iter().flat_map(|it| &it.primitives) {
            text::check_list(&primitive.points, import.model.cloud.len());
        }
    },
    seeds: || {
        let models = text::models().into_iter();
        models
            .filter_map(|model| {
                let truth = model.truth.as_ref()?;
                let (text, _) = write_step(&model.name, &model.cloud, truth, |_| [0.5; 3]);
                Some(text.into_bytes()).filter(|text| text.len() <= LONGEST)
            })
            .collect()
    },
    words: &[
        "ISO-10303-21;\n",
        "DATA;\n",
        "ENDSEC;\n",
        "#1=",
        "PLANE",
        "CYLINDRICAL_SURFACE",
        "CONICAL_SURFACE",
        "SPHERICAL_SURFACE",
        "TOROIDAL_SURFACE",
        "B_SPLINE_SURFACE_WITH_KNOTS",
        "ADVANCED_FACE",
        "FACE_OUTER_BOUND",
        "ORIENTED_EDGE",
        "EDGE_CURVE",
        "CIRCLE",
        "LINE",
        "VERTEX_POINT",
        "CARTESIAN_POINT",
        "AXIS2_PLACEMENT_3D",
        "NEXT_ASSEMBLY_USAGE_OCCURRENCE",
        "SHAPE_REPRESENTATION",
        ".T.",
        ".F.",
        "$",
        "*",
        "1E308",
        "-1.",
        "0.",
        "1E-9",
    ],
    longest: LONGEST,
    floor: 16 * MIB,
    quick: 150,
};

const LONGEST: usize = 32 << 10;

pub const WRITE: Target = Target {
    name: "step-write",
    run: |input| {
        let model = shapes::readable_model(&mut Bytes::new(input));
        let Some(truth) = &model.truth else {
            return;
        };
        let (text, left_out) = write_step(&model.name, &model.cloud, truth, |_| [0.5; 3]);
        assert!(left_out <= truth.primitives.len());
        if left_out < truth.primitives.len() {
            let document = Document::read(text.as_bytes(), &mut |_| ());
            assert!(
                document.is_ok(),
                "what was written is not read: {:?}",
                document.err()
            );
        }
    },
    seeds: super::none,
    words: &[],
    longest: 2048,
    floor: 16 * MIB,
    quick: 300,
};
