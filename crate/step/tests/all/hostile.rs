//! Whatever the bytes are, the answer is an error or a report: no panic, and no end that does not come.

use crate::made::Made;
use fit4cad_step::{Amount, Document, Options, StepError};

/// A file with a face of every kind.
fn varied() -> String {
    let mut made = Made::new();
    let frame = made.frame([0.0; 3], [0.0, 0.0, 1.0], Some([1.0, 0.0, 0.0]));
    let mut faces = Vec::new();
    for surface in [
        "CYLINDRICAL_SURFACE('',#F,4.)",
        "CONICAL_SURFACE('',#F,4.,0.5)",
        "SPHERICAL_SURFACE('',#F,5.)",
        "TOROIDAL_SURFACE('',#F,5.,2.)",
        "DEGENERATE_TOROIDAL_SURFACE('',#F,2.,5.,.F.)",
        "PLANE('',#F)",
    ] {
        let surface = made.add(&surface.replace("#F", &format!("#{frame}")));
        let ends = [0.0, 3.0].map(|z| {
            made.round(
                [0.0, 0.0, z],
                [0.0, 0.0, 1.0],
                [1.0, 0.0, 0.0],
                4.0,
                z == 0.0,
            )
        });
        faces.push(made.face(&ends, surface, true));
    }
    let points: Vec<usize> = (0..9)
        .map(|k| made.point([f64::from(k / 3), f64::from(k % 3), f64::from(k * k % 4)]))
        .collect();
    let rows: Vec<String> = points
        .chunks(3)
        .map(|row| format!("({})", crate::made::list(row)))
        .collect();
    let spline = made.add(&format!(
        "B_SPLINE_SURFACE_WITH_KNOTS('',2,2,({}),.UNSPECIFIED.,.F.,.F.,.F.,(3,3),(3,3),(0.,1.),(0.,1.),.UNSPECIFIED.)",
        rows.join(",")
    ));
    let curve = made.add(&format!(
        "B_SPLINE_CURVE_WITH_KNOTS('',2,({}),.UNSPECIFIED.,.F.,.F.,(3,3),(0.,1.),.UNSPECIFIED.)",
        crate::made::list(&points[0..3])
    ));
    let (a, b) = (made.vertex([0.0; 3]), made.vertex([0.0, 2.0, 0.0]));
    let edge = made.edge(a, b, curve, true);
    let back = made.line([0.0, 2.0, 0.0], [0.0; 3]);
    let back = made.edge(b, a, back, true);
    let ring = made.ring(&[(edge, true), (back, true)]);
    let bound = made.bound(ring, true);
    faces.push(made.face(&[], spline, true));
    faces.push(made.face(&[bound], spline, true));
    made.shell(&faces);
    made.text()
}

fn try_all(bytes: &[u8]) -> Option<StepError> {
    let document = match Document::read(bytes, &mut |_| {}) {
        Ok(document) => document,
        Err(error) => return Some(error),
    };
    let options = Options {
        amount: Amount::Points(20),
        ..Options::default()
    };
    document.sample("x", &options, &mut |_| {}).err()
}

#[test]
fn what_is_no_step_file_is_told_from_one_that_is_cut_off() {
    let no = try_all(b"solid cube\nfacet normal 0 0 1").unwrap();
    assert!(no.to_string().contains("solid cube"), "{no}");
    assert!(matches!(try_all(b""), Some(StepError::NotStep { .. })));
    let text = varied();
    for share in 1..20 {
        let cut = &text[..text.len() * share / 20];
        let error = try_all(cut.as_bytes()).unwrap().to_string();
        assert!(
            error.contains("end of file") || error.contains("line"),
            "{error}"
        );
    }
}

#[test]
fn a_file_without_faces_says_what_it_holds() {
    let mut made = Made::new();
    let solid = made.add("TESSELLATED_SOLID('',(),$)");
    let context = made.context;
    made.representation("TESSELLATED_SHAPE_REPRESENTATION", &[solid], context);
    let error = try_all(made.text().as_bytes()).unwrap().to_string();
    assert!(error.contains("triangles for display"), "{error}");
}

#[test]
fn a_broken_face_leaves_the_others() {
    let mut made = Made::new();
    let frame = made.frame([0.0; 3], [0.0, 0.0, 1.0], None);
    let sphere = made.add(&format!("SPHERICAL_SURFACE('',#{frame},5.)"));
    let good = made.face(&[], sphere, true);
    let missing = made.face(&[], 4711, true);
    let endless = made.add(&format!("PLANE('',#{frame})"));
    let endless = made.face(&[], endless, true);
    let flat = made.add(&format!("SPHERICAL_SURFACE('',#{frame},-1.)"));
    let flat = made.face(&[], flat, true);
    made.shell(&[good, missing, endless, flat]);
    let found = made.import();
    let remarks: Vec<&str> = found
        .report
        .faces
        .iter()
        .map(|face| &face.remark[..])
        .collect();
    assert_eq!(remarks[0], "");
    assert!(
        remarks[1].contains("#4711: is not in the file"),
        "{}",
        remarks[1]
    );
    assert!(
        remarks[2].contains("no bounds that close"),
        "{}",
        remarks[2]
    );
    assert!(remarks[3].contains("greater than zero"), "{}", remarks[3]);
    assert_eq!(found.model.truth.unwrap().primitives.len(), 1);
}

/// Numbers, references and names swapped, dropped and doubled, hundreds of times; thousands, where the build is fast.
#[test]
fn mutated_files_end_in_an_answer() {
    let text = varied();
    let mut random = fastrand::Rng::with_seed(7);
    let values = [
        "0.",
        "1.E300",
        "-1.",
        "1.E-300",
        "$",
        "*",
        "#1",
        "#9999",
        "()",
        "NAN",
        ".T.",
        "''",
        "99999999999",
    ];
    let rounds = if cfg!(debug_assertions) { 400 } else { 6000 };
    for _ in 0..rounds {
        let mut bytes = text.clone().into_bytes();
        for _ in 0..random.usize(1..4) {
            let at = random.usize(300..bytes.len() - 40);
            match random.u8(0..4) {
                0 => bytes[at] = b"0123456789#$*(),.'ATF;"[random.usize(0..22)],
                1 => {
                    let end = (at + random.usize(1..12)).min(bytes.len());
                    bytes.drain(at..end);
                }
                _ => {
                    // A whole attribute for another.
                    let is_end = |byte: &u8| matches!(byte, b',' | b'(' | b')');
                    let start = at + bytes[at..].iter().position(is_end).unwrap_or(0);
                    let length = bytes[start + 1..].iter().position(is_end).unwrap_or(0);
                    let value = values[random.usize(0..values.len())];
                    bytes.splice(start + 1..start + 1 + length, value.bytes());
                }
            }
        }
        let _ = try_all(&bytes);
    }
}

#[test]
fn options_out_of_range_are_named() {
    let mut made = Made::new();
    let frame = made.frame([0.0; 3], [0.0, 0.0, 1.0], None);
    let sphere = made.add(&format!("SPHERICAL_SURFACE('',#{frame},5.)"));
    let face = made.face(&[], sphere, true);
    made.shell(&[face]);
    let document = Document::read(made.text().as_bytes(), &mut |_| {}).unwrap();
    let sample = |amount| {
        let options = Options {
            amount,
            ..Options::default()
        };
        document
            .sample("x", &options, &mut |_| {})
            .err()
            .map(|error| error.to_string())
    };
    assert_eq!(
        sample(Amount::Points(5)).unwrap(),
        "points must be 10 to 2000000, not 5"
    );
    for amount in [
        Amount::Spacing(-1.0),
        Amount::Spacing(f64::NAN),
        Amount::Spacing(1e-6),
        Amount::Spacing(1e6),
        Amount::Share(0.9),
    ] {
        let error = sample(amount).unwrap();
        assert!(error.starts_with("spacing must be"), "{error}");
    }
    assert_eq!(sample(Amount::Points(1000)), None);
}
