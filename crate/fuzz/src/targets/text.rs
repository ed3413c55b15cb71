//! The readers of the four files, a model of all of them, and whether what is written is read again.

use fit4cad::cloud::{LARGEST, Numbering};
use fit4cad::diagnostics::Diagnostic;
use fit4cad::format::limits::MAX_SIMILAR_DIAGNOSTICS;
use fit4cad::format::{
    Role, SourceFile, SurfaceFile, read_cloud, read_cloud_by_pieces, read_model, read_primitives,
    read_surfaces, write_cloud, write_primitives, write_surfaces,
};
use fit4cad::model::{Model, Segmentation};
use fit4cad::sample::blocks::Operation;
use fit4cad::sample::{self, Block, Options, Shape};
use fit4cad::surface::{Form, Surface};

use super::MIB;
use crate::{Bytes, Target};

const WORDS: &[&str] = &[
    "Points:=[\n",
    "Primitive1:=[",
    "Primitive",
    ":=[",
    "];\n",
    "]];\n",
    "[",
    "]",
    ", ",
    " ",
    "\n",
    "\r\n",
    "\t",
    "\0",
    "\u{FEFF}",
    "%",
    "#",
    "...",
    "1",
    "0",
    "-0",
    "-1",
    "1.5",
    "1e308",
    "-1e-320",
    "1e31",
    "1e999",
    "NaN",
    "inf",
    "-Infinity",
    "4294967295",
    "4294967296",
    "99999999999999999999",
    "0.1234567890123456789",
    "Plane",
    "Cylinder",
    "Cone",
    "Sphere",
    "Torus",
    "BSpline",
    "[Plane, [",
    "[Torus, [Torus, [",
    "é",
    "Primitive4294967296:=[",
    ";",
    "'",
    "\"",
    "x y z",
    "//",
];

/// Between the files of a model in one input; a byte that is in no text.
const BETWEEN: u8 = 0xFF;

/// A reader of one file, but for what is special to each.
const READER: Target = Target {
    name: "",
    run: |_| (),
    seeds: super::none,
    words: WORDS,
    longest: 4096,
    floor: MIB / 4,
    quick: 20_000,
};

pub const CLOUD: Target = Target {
    name: "cloud",
    run: |input| {
        let (file, found) = read_cloud("PC1.txt", input);
        check_findings(&found);
        let piece = 1 + input.len() % 61;
        let (pieced, found_in_pieces) = read_cloud_by_pieces("PC1.txt", input, piece);
        assert_eq!(pieced, file, "by pieces of {piece}");
        assert_eq!(found_in_pieces, found, "by pieces of {piece}");
        check_points(&file.cloud);
        for segment in file.segments.iter().flatten() {
            check_list(&segment.points, file.cloud.len());
        }
    },
    seeds: || {
        let mut seeds: Vec<Vec<u8>> = models()
            .iter()
            .map(|model| text(write_cloud(&model.cloud)))
            .collect();
        let forms = [
            "1 2 3\n4 5 6\n",
            "1,2,3\n4,5,6\n",
            "x y z\n1;2;3\n",
            "x y z label\n1,5;2;3;1\n4;5;6;-1\n",
            "[1,2,3]\n[4,5,6]",
            "Points=[1 2 3;4 5 6]",
        ];
        seeds.extend(forms.map(|form| form.as_bytes().to_vec()));
        seeds
    },
    ..READER
};

/// Clouds of single primitives, as segments of another cloud and as one.
pub const PIECES: Target = Target {
    name: "pieces",
    run: |input| {
        let mut parts = input.split(|&byte| byte == BETWEEN);
        let mut next = || parts.next().unwrap_or_default();
        let cloud = next();
        let file = |path, role, bytes| SourceFile {
            path,
            role,
            method: None,
            bytes,
        };
        let [first, second] = [next(), next()];
        let beside = [
            file("PC1.txt", Role::Cloud, cloud),
            file("Plane_0001.txt", Role::Primitives, first),
            file("Leftovers.txt", Role::Primitives, cloud),
            file("Cone_0001.txt", Role::Primitives, second),
        ];
        let alone = [
            file("Plane_0001.txt", Role::Cloud, first),
            file("Leftovers.txt", Role::Cloud, cloud),
            file("Cone_0001.txt", Role::Cloud, second),
        ];
        for files in [&beside[..], &alone] {
            let (model, found) = read_model("PC1", files);
            check_findings(&found);
            check_points(&model.cloud);
            for primitive in model.truth.iter().flat_map(|truth| &truth.primitives) {
                check_list(&primitive.points, model.cloud.len());
            }
        }
    },
    seeds: || {
        // A face and a part of it, where it is and far out.
        let rows = |from: usize, to: usize, x: f64| {
            let row = |i: usize| format!("{} {} {}\n", x + (i * i % 37) as f64, i % 7, i / 7);
            (from..to).map(row).collect::<String>().into_bytes()
        };
        let seed = |x: f64| {
            let between = &[BETWEEN][..];
            [
                &rows(0, 40, x),
                between,
                &rows(0, 20, 0.0),
                between,
                &rows(20, 39, 0.0),
            ]
            .concat()
        };
        vec![seed(0.0), seed(4e5), seed(-1e30)]
    },
    floor: MIB,
    quick: 4_000,
    ..READER
};

pub const PRIMITIVES: Target = Target {
    name: "primitives",
    run: |input| {
        let mut bytes = Bytes::new(input);
        // So many that marking each costs little.
        let points = bytes.whole() as usize % 20_000;
        let (lists, found) =
            read_primitives("PC1_primitives.txt", bytes.rest(), &Numbering::of(points));
        check_findings(&found);
        for list in lists {
            check_list(&list.points, points);
        }
    },
    seeds: || {
        let list = |model: &Model| {
            Some((
                model.cloud.len(),
                write_primitives(model.truth.as_ref()?, model.cloud.numbering()),
            ))
        };
        let seed = |(points, text): (usize, String)| {
            [&[255], &(points as u32).to_le_bytes()[..], text.as_bytes()].concat()
        };
        models().iter().filter_map(list).map(seed).collect()
    },
    ..READER
};

pub const PARAMETRIC: Target = Target {
    name: "parametric",
    run: |input| surfaces(input, Form::Parametric),
    seeds: || surface_texts(Form::Parametric),
    quick: 40_000,
    ..READER
};

pub const IMPLICIT: Target = Target {
    name: "implicit",
    run: |input| surfaces(input, Form::Implicit),
    seeds: || surface_texts(Form::Implicit),
    quick: 60_000,
    ..READER
};

pub const MODEL: Target = Target {
    name: "model",
    run: |input| {
        let (model, found) = read(input);
        check_findings(&found);
        check_points(&model.cloud);
        let submitted = model.submissions.iter().map(|each| &each.segmentation);
        for segmentation in model.truth.iter().chain(submitted) {
            check_segmentation(segmentation, model.cloud.len());
        }
    },
    seeds: whole_models,
    longest: 8192,
    quick: 40_000,
    ..READER
};

pub const ROUND_TRIP: Target = Target {
    name: "round-trip",
    run: |input| {
        let (model, _) = read(input);
        let truth = model.truth.clone().unwrap_or_default();
        let written = join(&[
            write_cloud(&model.cloud),
            write_primitives(&truth, model.cloud.numbering()),
            write_surfaces(&truth, Form::Parametric),
            write_surfaces(&truth, Form::Implicit),
        ]);
        let (again, _) = read(&written);
        assert_eq!(again.cloud.points(), model.cloud.points());
        assert_eq!(again.cloud.numbering(), model.cloud.numbering());
        let read_back = again.truth.unwrap_or_default();
        assert_eq!(read_back.primitives.len(), truth.primitives.len());
        for (after, before) in read_back.primitives.iter().zip(&truth.primitives) {
            assert_eq!(
                (after.number, &after.points),
                (before.number, &before.points)
            );
            for form in Form::ALL {
                // Where two files name different types, one vector is of a type that is not written.
                let length = before.kind.map(|kind| match form {
                    Form::Parametric => kind.parametric_len(),
                    Form::Implicit => kind.implicit_len(),
                });
                let (after, before) = (after.coefficients(form), before.coefficients(form));
                if before.values().map(<[f64]>::len) != length {
                    continue;
                }
                assert!(
                    before.values().is_none() || before == after,
                    "{form:?} {before:?} {after:?}"
                );
            }
        }
    },
    seeds: whole_models,
    longest: 8192,
    floor: MIB,
    quick: 25_000,
    ..READER
};

/// Reads a model of the files in an input: cloud, truth in three files, the three of method `M`, the types of both.
pub fn read(input: &[u8]) -> (Model, Vec<Diagnostic>) {
    let roles = [
        Role::Cloud,
        Role::Primitives,
        Role::Parametric,
        Role::Implicit,
    ];
    let submitted = roles.iter().skip(1).map(|&role| (role, Some("M")));
    let types = [(Role::Types, None), (Role::Types, Some("M"))];
    let kinds = roles.iter().map(|&role| (role, None)).chain(submitted);
    let kinds = kinds.chain(types);
    let parts = input.split(|&byte| byte == BETWEEN);
    let files = kinds.zip(parts).map(|((role, method), bytes)| SourceFile {
        path: role.name(),
        role,
        method,
        bytes,
    });
    read_model("PC1", &files.collect::<Vec<_>>())
}

fn join(texts: &[String]) -> Vec<u8> {
    let texts: Vec<&[u8]> = texts.iter().map(String::as_bytes).collect();
    texts.join(&BETWEEN)
}

fn text(text: String) -> Vec<u8> {
    text.into_bytes()
}

/// Small models of the generator's: each family of surfaces, in few points.
pub fn models() -> Vec<Model> {
    let options = Options {
        spacing: 0.1,
        ..Options::default()
    };
    let alone = [Shape::Cuboid, Shape::Cone, Shape::Sphere, Shape::Torus];
    let mut parts: Vec<Vec<Block>> = alone
        .iter()
        .map(|&shape| vec![block(Operation::Add, shape)])
        .collect();
    parts.push(vec![
        block(Operation::Add, Shape::Cuboid),
        block(Operation::Cut, Shape::Cylinder),
    ]);
    let model =
        |blocks: &Vec<Block>| sample::build("PC1", &sample::compose(blocks).ok()?, &options).ok();
    parts.iter().filter_map(model).collect()
}

fn block(operation: Operation, shape: Shape) -> Block {
    Block {
        operation,
        shape,
        sizes: shape.info().sizes.iter().map(|&(_, size)| size).collect(),
        position: [0.0; 3],
        rotation: [0.0; 3],
    }
}

/// Inputs of [`read`]: models with their truth, and a submission that is wrong on purpose.
pub fn whole_models() -> Vec<Vec<u8>> {
    let files = |segmentation: &Segmentation, model: &Model| {
        [
            write_primitives(segmentation, model.cloud.numbering()),
            write_surfaces(segmentation, Form::Parametric),
            write_surfaces(segmentation, Form::Implicit),
        ]
    };
    let seed = |model: &Model| {
        let truth = model.truth.clone().unwrap_or_default();
        let mut texts = vec![write_cloud(&model.cloud)];
        texts.extend(files(&truth, model));
        texts.extend(files(&sample::imperfect(model, 1), model));
        join(&texts)
    };
    let mut seeds: Vec<Vec<u8>> = models().iter().map(seed).collect();
    let mut small = join(&[
        "[0,0,0]\n[1,0,0]\n[x,0,0]\n[0,1,0]\n[1,1,1]".to_owned(),
        "Primitive1:=[1 2 4];Primitive3:=[5];".to_owned(),
    ]);
    small.push(BETWEEN);
    small.extend(b"Primitive1:=[Plane, [0 0 0 1 0 0 0 1 0]];");
    seeds.push(small);
    seeds
}

fn surface_texts(form: Form) -> Vec<Vec<u8>> {
    let texts = models().into_iter().filter_map(|model| model.truth);
    texts
        .map(|truth| text(write_surfaces(&truth, form)))
        .collect()
}

fn surfaces(input: &[u8], form: Form) {
    let (file, found) = read_surfaces("PC1_surfaces.txt", input, form);
    check_findings(&found);
    let SurfaceFile::Entries(entries) = file else {
        return;
    };
    for entry in entries {
        let (Some(kind), Some(values)) = (entry.kind, entry.coefficients.values()) else {
            continue;
        };
        assert!(values.iter().all(|value| value.is_finite()));
        if let Ok(conversion) = Surface::from_form(form, kind, values) {
            assert!(conversion.surface.is_in_range() && !conversion.misfit.is_nan());
        }
    }
}

pub fn check_points(cloud: &fit4cad::cloud::Cloud) {
    assert!(
        cloud
            .points()
            .iter()
            .flat_map(|point| point.iter())
            .all(|x| x.abs() <= LARGEST)
    );
    assert!(cloud.numbering().rows() >= cloud.len());
}

pub fn check_list(points: &[u32], count: usize) {
    assert!(points.is_sorted_by(|a, b| a < b));
    assert!(points.last().is_none_or(|&last| (last as usize) < count));
}

fn check_segmentation(segmentation: &Segmentation, count: usize) {
    for primitive in &segmentation.primitives {
        check_list(&primitive.points, count);
        assert!(
            primitive
                .surface
                .is_none_or(|surface| surface.is_in_range())
        );
        for form in Form::ALL {
            let values = primitive.coefficients(form).values().unwrap_or_default();
            assert!(values.iter().all(|value| value.is_finite()));
        }
    }
}

pub fn check_findings(found: &[Diagnostic]) {
    assert!(found.len() <= 100 * MAX_SIMILAR_DIAGNOSTICS);
    for finding in found {
        assert!(!finding.message.is_empty() && finding.to_string().len() < 2000);
    }
}
