//! Mutated files: whatever the bytes, reading ends soon and without a panic.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use fit4cad::format::limits::MAX_SIMILAR_DIAGNOSTICS;
use fit4cad::format::{Role, SourceFile, group, read_model, write_cloud, write_surfaces};
use fit4cad::surface::Form;

const ROUNDS: usize = 8_000;

const CLOUD: &str = "Points:=[\n[3.843807000000, 3.233846, 0.0445], \n[-1, 2e-3, .5], \r\n\
                     [1.5, 2.5, -3.5], \n[0, -0, 5.], \n[7, 8, 9] \n ];\n";
const PRIMITIVES: &str = "Primitive1:=[1 2 3];\n\nPrimitive2 :=[3   4];\nPrimitive7:[5 1\n 2];\r\n";
const PARAMETRIC: &str = "Primitive1:=[Plane, [1 0 -0 -0 1 0 16.2277 0 29.21]];\n\n\
    Primitive2:=[Torus, [Torus, [-27.25 0 0 0 27.25 0 -2 0 0 0 2 0 0 0 -2 0 0 10]];\n\
    Primitive7:=[BSpline, []];\n";
const IMPLICIT: &str = "Primitive1 :=[Plane, [0 0 1 -29.21]];\n\
    Primitive2 :=[Cylinder, [1 1 0 0 0 0 0 -0 -0 -252.016]];\n\
    Primitive3 :=[Cone, [1 1 -0.333333 0 0 0 0 0 -1.82698 -10.0136]];\n";

const NASTY: [&str; 40] = [
    "[",
    "]",
    "];",
    "]];",
    ",",
    ";",
    ":=",
    ":=[",
    "Primitive",
    "Primitive1:=[",
    "Points:=[",
    "NaN",
    "-inf",
    "1e999",
    "-1e-999",
    "99999999999999999999",
    "0",
    "-1",
    "4294967296",
    "1.5",
    "...",
    "%",
    "#",
    "\n",
    "\r",
    "\r\n",
    "\t",
    "\0",
    "\u{FEFF}",
    "é",
    "Plane",
    "Torus",
    "BSpline",
    "'",
    "\"",
    "e",
    "+",
    "-",
    ".",
    "Primitive4294967296:=[",
];

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Generator(u64);

impl Generator {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound.max(1) as u64) as usize
    }

    fn range(&mut self, len: usize) -> std::ops::Range<usize> {
        let start = self.below(len + 1);
        start..start + self.below((len - start).min(60) + 1)
    }

    /// Flips, cuts, repeats, inserts or takes over a part of another text, one to six times.
    fn mutate(&mut self, text: &str) -> Vec<u8> {
        let mut bytes = text.as_bytes().to_vec();
        for _ in 0..=self.below(6) {
            let range = self.range(bytes.len());
            match self.below(7) {
                0 => {
                    if let Some(byte) = bytes.get_mut(range.start) {
                        *byte ^= 1 << self.below(8);
                    }
                }
                1 => {
                    bytes.drain(range);
                }
                2 => bytes.truncate(range.start),
                3 => {
                    let part = bytes[range.clone()].to_vec();
                    for _ in 0..=self.below(3) {
                        bytes.splice(range.start..range.start, part.iter().copied());
                    }
                }
                4 | 5 => {
                    let token = NASTY[self.below(NASTY.len())];
                    bytes.splice(range.start..range.start, token.bytes());
                }
                _ => {
                    let other = [CLOUD, PRIMITIVES, PARAMETRIC, IMPLICIT][self.below(4)].as_bytes();
                    let part = self.range(other.len());
                    bytes.splice(range, other[part].iter().copied());
                }
            }
        }
        bytes
    }
}

/// Reads a model of the four files and checks what holds whatever they contain.
fn read(cloud: &[u8], primitives: &[u8], parametric: &[u8], implicit: &[u8]) {
    let files = [
        ("c", Role::Cloud, cloud),
        ("p", Role::Primitives, primitives),
        ("q", Role::Parametric, parametric),
        ("i", Role::Implicit, implicit),
    ]
    .map(|(path, role, bytes)| SourceFile {
        path,
        role,
        method: None,
        bytes,
    });
    let (model, diagnostics) = read_model("PC1", &files);
    assert!(
        model
            .cloud
            .points()
            .iter()
            .all(|point| point.iter().all(|value| value.is_finite()))
    );
    let count = model.cloud.len();
    for primitive in model.truth.iter().flat_map(|truth| &truth.primitives) {
        assert!(primitive.points.is_sorted_by(|a, b| a < b));
        assert!(
            primitive
                .points
                .last()
                .is_none_or(|&last| (last as usize) < count)
        );
        let kind = primitive.kind;
        for (values, len) in [
            (
                primitive.parametric.values(),
                kind.map(|kind| kind.parametric_len()),
            ),
            (
                primitive.implicit.values(),
                kind.map(|kind| kind.implicit_len()),
            ),
        ] {
            let Some(values) = values else { continue };
            assert!(values.iter().all(|value| value.is_finite()));
            // Two files may disagree about the type; each vector then fits its own.
            assert!(len.is_some() && [4, 9, 10, 12, 18, 35].contains(&values.len()));
        }
    }
    for diagnostic in &diagnostics {
        assert!(!diagnostic.message.is_empty() && diagnostic.to_string().len() < 1000);
    }
    assert!(diagnostics.len() <= 60 * MAX_SIMILAR_DIAGNOSTICS);
}

#[test]
fn thirty_two_thousand_mutated_files_are_read_without_a_panic() {
    let mut generator = Generator(1);
    for _ in 0..ROUNDS {
        let [cloud, primitives, parametric, implicit] =
            [CLOUD, PRIMITIVES, PARAMETRIC, IMPLICIT].map(|text| generator.mutate(text));
        // One mutated file among sound ones goes deeper than four mutated ones.
        match generator.below(5) {
            0 => read(
                &cloud,
                PRIMITIVES.as_bytes(),
                PARAMETRIC.as_bytes(),
                IMPLICIT.as_bytes(),
            ),
            1 => read(
                CLOUD.as_bytes(),
                &primitives,
                PARAMETRIC.as_bytes(),
                IMPLICIT.as_bytes(),
            ),
            2 => read(CLOUD.as_bytes(), PRIMITIVES.as_bytes(), &parametric, b""),
            3 => read(CLOUD.as_bytes(), PRIMITIVES.as_bytes(), b"", &implicit),
            _ => {}
        }
        read(&cloud, &primitives, &parametric, &implicit);
    }
}

#[test]
fn mutated_paths_are_grouped_without_a_panic() {
    const PATHS: &str = "a/pointCloud/PC1.txt\na\\pointCloud_primitives_HT/PC1_primitives.txt\n\
        PC10.txt\nPC10_implicit.txt\n__MACOSX/x\nb/PC1.txt\nc/pointCloud_/PC2-HT-primitives.TXT\n";
    let mut generator = Generator(2);
    for _ in 0..4_000 {
        let bytes = generator.mutate(PATHS);
        let text = String::from_utf8_lossy(&bytes);
        let paths: Vec<&str> = text.split('\n').collect();
        let grouping = group(&paths, &BTreeMap::new());
        let placed: usize = grouping.models.iter().map(|model| model.files.len()).sum();
        assert!(placed + grouping.unplaced.len() + grouping.ignored <= paths.len());
    }
}

#[test]
fn numbers_that_cannot_be_computed_with_are_told_and_nothing_else_is_written() {
    const CLOUD: &str = "Points:=[\n[0, 0, 0], \n[1e31, 0, 0], \n[1, 0, 0], \n[0, 1, 0] \n ];\n";
    const PRIMITIVES: &str = "Primitive1:=[1 2 3];\nPrimitive2:=[3 4];\nPrimitive3:=[4];\n";
    // Radii of which the fourth power is no number, and one whose inverse is none.
    const PARAMETRIC: &str = "\
        Primitive1:=[Torus, [3e154 0 0 0 3e154 0 1e154 0 0 0 1e154 0 0 0 1e154 0 0 0]];\n\
        Primitive2:=[Sphere, [1e-309 0 0 0 1e-309 0 0 0 1e-309 0 0 0]];\n\
        Primitive3:=[Plane, [1 0 0 0 1 0 0 0 0]];\n";
    let files = [
        ("PC1.txt", Role::Cloud, CLOUD),
        ("PC1_primitives.txt", Role::Primitives, PRIMITIVES),
        ("PC1_parametric.txt", Role::Parametric, PARAMETRIC),
    ];
    let sources = files.map(|(path, role, text)| SourceFile {
        path,
        role,
        method: None,
        bytes: text.as_bytes(),
    });
    let (model, diagnostics) = read_model("PC1", &sources);
    assert_eq!(model.cloud.len(), 3);
    let truth = model.truth.as_ref().unwrap();
    let has_surface = truth.primitives.iter().map(|it| it.surface.is_some());
    assert_eq!(has_surface.collect::<Vec<_>>(), [false, false, true]);
    let told: Vec<String> = diagnostics.iter().map(ToString::to_string).collect();
    let says = |text: &str| told.iter().filter(|line| line.contains(text)).count();
    assert_eq!(says("too far away to compute with"), 1, "{told:#?}");
    assert_eq!(
        says("too large or too small to compute with"),
        2,
        "{told:#?}"
    );
    for form in Form::ALL {
        let text = write_surfaces(truth, form);
        assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
    }
    assert!(!write_cloud(&model.cloud).contains("1e31"));
}

#[test]
#[cfg_attr(target_arch = "wasm32", ignore = "there is no clock")]
fn texts_made_to_be_slow_are_read_in_linear_time() {
    const LENGTH: usize = 4 << 20;
    let start = Instant::now();
    for part in [
        " ",
        "[",
        "]",
        "[1,",
        "[[",
        "1",
        "1e",
        "1 ",
        "1x",
        "Primitive",
        "Primitive1",
        "Primitive1:=[",
        "Primitive1:=[Plane, [",
        "x",
        "x\n",
        "\n",
        ";",
        "[ ;",
        "-",
        "%",
        "[Plane,",
        "...",
        "\r",
        "Primitive1:=[1;",
        "9",
        "Points:=[",
        "é",
        "[1,2,3]",
        "Primitive1 ",
        "; ",
    ] {
        for head in ["", "Points:=[", "Primitive1:=[", "Primitive1:=[Plane, ["] {
            let text = head.to_owned() + &part.repeat(LENGTH / part.len() / 16);
            let bytes = text.as_bytes();
            read(bytes, PRIMITIVES.as_bytes(), b"", b"");
            read(CLOUD.as_bytes(), bytes, b"", b"");
            read(CLOUD.as_bytes(), PRIMITIVES.as_bytes(), bytes, bytes);
        }
    }
    // A generous bound: what takes seconds here would take hours if time grew with the square.
    assert!(
        start.elapsed() < Duration::from_secs(120),
        "{:?}",
        start.elapsed()
    );
}
