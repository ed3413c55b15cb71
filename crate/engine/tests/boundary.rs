//! The boundary as JavaScript meets it, under Node.
#![cfg(target_arch = "wasm32")]
#![allow(
    clippy::unwrap_used,
    reason = "clippy knows `#[test]`, not `#[wasm_bindgen_test]`"
)]

use fit4cad_engine::{Model, fit_parameters, group, parts, version};
use js_sys::{JSON, Object, Reflect, Uint8Array};
use tsify::{Ts, Tsify};
use wasm_bindgen::{JsCast, JsError, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

/// A plain object out of JSON.
fn plain<T: Tsify>(json: &str) -> Ts<T> {
    Ts::new_unchecked(JSON::parse(json).unwrap())
}

fn word<T: Tsify>(word: &str) -> Ts<T> {
    Ts::new_unchecked(JsValue::from_str(word))
}

/// What JavaScript sees under a dotted path.
fn at(value: impl Into<JsValue>, path: &str) -> JsValue {
    path.split('.').fold(value.into(), |value, key| {
        Reflect::get(&value, &key.into()).unwrap()
    })
}

fn number(value: impl Into<JsValue>, path: &str) -> f64 {
    at(value, path).as_f64().unwrap()
}

fn text(value: impl Into<JsValue>, path: &str) -> String {
    at(value, path).as_string().unwrap()
}

fn message(error: impl Into<JsValue>) -> String {
    text(error.into(), "message")
}

fn unit_square(primitives: &str) -> Model {
    let cloud = "Points:=[\n[0, 0, 0], \n[1, 0, 0], \n[0, 1, 0], \n[1, 1, 0] \n ];\n";
    read(&[
        ("PC1.txt", "cloud", None, cloud),
        (
            "PC1_primitives.txt",
            "primitives",
            None,
            "Primitive1:=[1 2 3 4];\n",
        ),
        (
            "PC1_parametric.txt",
            "parametric",
            None,
            "Primitive1:=[Plane, [1 0 0 0 1 0 0 0 0]];\n",
        ),
        (
            "MINE/PC1_primitives.txt",
            "primitives",
            Some("MINE"),
            primitives,
        ),
    ])
}

fn read(files: &[(&str, &str, Option<&str>, &str)]) -> Model {
    let files = files.iter().map(|&(path, role, method, content)| {
        let file = Object::new();
        let set = |key: &str, value: JsValue| {
            Reflect::set(&file, &key.into(), &value).unwrap();
        };
        set("path", path.into());
        set("role", role.into());
        if let Some(method) = method {
            set("method", method.into());
        }
        set("bytes", Uint8Array::from(content.as_bytes()).into());
        Ts::new_unchecked(file.into())
    });
    read_result(files.collect()).unwrap()
}

fn read_result(files: Vec<Ts<fit4cad_engine::InputFile>>) -> Result<Model, JsError> {
    Model::read("PC1", files)
}

#[wasm_bindgen_test]
fn the_version_is_that_of_the_package() {
    assert_eq!(version(), env!("CARGO_PKG_VERSION"));
}

#[wasm_bindgen_test]
fn paths_become_models_and_overrides_are_heeded() {
    let paths = ["a/PC2.txt", "a/PC2_primitives.txt", "a/result.txt"];
    let overrides =
        plain(r#"{"a/result.txt": {"role": "primitives", "model": "PC2", "method": "X"}}"#);
    let grouping = group(paths.map(str::to_owned).to_vec(), Some(overrides)).unwrap();
    assert_eq!(text(grouping.js_value(), "models.0.name"), "PC2");
    assert_eq!(number(grouping.js_value(), "models.0.number"), 2.0);
    assert_eq!(number(grouping.js_value(), "models.0.files.length"), 3.0);
    assert_eq!(text(grouping.js_value(), "models.0.files.2.method"), "X");
    assert!(at(grouping.js_value(), "models.0.files.0.method").is_undefined());
    assert_eq!(number(grouping, "unplaced.length"), 0.0);
}

#[wasm_bindgen_test]
fn a_model_is_read_and_tells_what_it_holds() {
    let model = unit_square("Primitive1:=[1 2 3];\nPrimitive2:=[4];\n");
    let info = model.info().unwrap();
    assert_eq!(number(info.js_value(), "points"), 4.0);
    assert_eq!(at(info.js_value(), "hasTruth"), JsValue::TRUE);
    assert_eq!(text(info.js_value(), "methods.0"), "MINE");
    assert_eq!(number(info, "bounds.max.0"), 1.0);
    assert_eq!(model.centre().to_vec(), [0.5, 0.5, 0.0]);
    assert_eq!(model.positions().to_vec()[..3], [-0.5, -0.5, 0.0]);

    let primitives = model.primitives(None).unwrap();
    let plane = primitives[0].js_value();
    assert_eq!(text(&plane, "type"), "Plane");
    assert_eq!(text(&plane, "surface.type"), "Plane");
    assert_eq!(number(plane, "surface.normal.2"), 1.0);

    let members = model.members(Some("MINE".to_owned())).unwrap();
    let offsets = at(members.js_value(), "offsets");
    let offsets: js_sys::Uint32Array = offsets.dyn_into().unwrap();
    assert_eq!(offsets.to_vec(), [0, 3, 4]);
    assert_eq!(model.distances(None).unwrap().to_vec(), [0.0; 4]);
    let unknown = model.distances(Some("MINE".to_owned())).unwrap().to_vec();
    assert!(unknown.len() == 4 && unknown.iter().all(|distance| distance.is_nan()));
}

#[wasm_bindgen_test]
fn a_report_is_a_plain_object_with_null_for_what_cannot_be_had() {
    let model = unit_square("Primitive7:=[1 2];\n");
    let report = model
        .score(Some("MINE".to_owned()), word("definition"))
        .unwrap();
    let report = report.js_value();
    assert_eq!(number(&report, "mean.TPR"), 0.5);
    assert_eq!(number(&report, "primitives.0.PPV"), 1.0);
    assert_eq!(number(&report, "primitives.0.match"), 7.0);
    assert!(at(&report, "mean.MFE").is_null());
    assert_eq!(number(&report, "hidden.labelled"), 0.5);
    let itself = model.score(None, word("definition")).unwrap();
    assert_eq!(text(itself.js_value(), "method"), "truth");
    assert_eq!(number(itself, "mean.dHaus"), 0.0);
}

#[wasm_bindgen_test]
fn findings_about_other_methods_stay_out_of_a_report() {
    let model = unit_square("Primitive1:=[1 2 99];\n");
    let count = |report: JsValue| number(report, "diagnostics.length");
    let mine = model
        .score(Some("MINE".to_owned()), word("definition"))
        .unwrap();
    assert_eq!(count(mine.js_value()), 1.0);
    assert_eq!(number(mine, "diagnostics.0.line"), 1.0);
    let truth = model.score(None, word("definition")).unwrap();
    assert_eq!(count(truth.into()), 0.0);
}

#[wasm_bindgen_test]
fn what_is_not_there_or_not_of_its_type_is_an_error_with_a_text() {
    let model = unit_square("Primitive1:=[1];\n");
    let error = model.members(Some("HT".to_owned())).err().unwrap();
    assert_eq!(
        message(error),
        "PC1 has no submission of `HT`; there is MINE"
    );
    let error = model.score(None, word("guess")).err().unwrap();
    assert!(message(error).contains("definition"));
    let error = read_result(vec![plain(r#"{"path": "PC1.txt", "role": "cloud"}"#)])
        .err()
        .unwrap();
    assert!(message(error).contains("bytes"));
    let error = Model::generate("teapot", plain("{}")).err().unwrap();
    assert!(message(error).contains("flange"));
    let error = Model::generate("flange", plain(r#"{"noise": -1}"#))
        .err()
        .unwrap();
    assert!(message(error).contains("noise must be between"));
}

#[wasm_bindgen_test]
fn every_part_survives_being_written_and_read() {
    for part in parts().unwrap() {
        let name = text(part, "name");
        let made = Model::generate(&name, plain(r#"{"spacing": 0.04, "seed": 3}"#)).unwrap();
        let texts = made.write(None).unwrap();
        let content = |key: &str| text(texts.js_value(), key);
        let (cloud, primitives) = (content("cloud"), content("primitives"));
        let (parametric, implicit) = (content("parametric"), content("implicit"));
        let again = read(&[
            ("a.txt", "cloud", None, &cloud),
            ("a_primitives.txt", "primitives", None, &primitives),
            ("a_parametric.txt", "parametric", None, &parametric),
            ("a_implicit.txt", "implicit", None, &implicit),
        ]);
        assert_eq!(
            number(again.info().unwrap(), "diagnostics.length"),
            0.0,
            "{name}"
        );
        assert_eq!(text(again.write(None).unwrap(), "cloud"), cloud, "{name}");
        assert_eq!(
            text(again.write(None).unwrap(), "primitives"),
            primitives,
            "{name}"
        );
        assert_eq!(
            text(again.write(None).unwrap(), "parametric"),
            parametric,
            "{name}"
        );
        assert_eq!(
            text(again.write(None).unwrap(), "implicit"),
            implicit,
            "{name}"
        );
    }
}

#[wasm_bindgen_test]
fn a_fit_is_a_submission_like_any_other_and_can_be_ended() {
    let mut model = Model::generate("towers", plain(r#"{"spacing": 0.03}"#)).unwrap();
    let first = model.fit(word("pg"), plain("{}"), 1, None).unwrap();
    let second = model
        .fit(word("pg"), plain(r#"{"smallest": 20}"#), 1, None)
        .unwrap();
    assert_eq!((first.as_str(), second.as_str()), ("PG", "PG 2"));
    let report = model.score(Some(first), word("definition")).unwrap();
    assert!(number(report, "mean.DSC") > 0.8);

    let stop = js_sys::Function::new_with_args("stage, fraction", "throw new Error('enough')");
    let error = model
        .fit(word("ht"), plain("{}"), 1, Some(stop))
        .unwrap_err();
    assert_eq!(message(error), "enough");
    let error = model
        .fit(word("ht"), plain(r#"{"tolerance": 9}"#), 1, None)
        .unwrap_err();
    assert!(message(error).contains("`tolerance` must be"));
    let known = fit_parameters(word("ht")).unwrap();
    assert_eq!(text(known[0].js_value(), "name"), "tolerance");
}
