//! The boundary as JavaScript meets it, under Node.
#![cfg(target_arch = "wasm32")]
#![allow(
    clippy::unwrap_used,
    reason = "clippy knows `#[test]`, not `#[wasm_bindgen_test]`"
)]

use fit4cad_engine::{
    Model, compare, declarations, file_name, group, one_lines, path_of, summarise, version,
};
use js_sys::{Float64Array, JSON, Object, Reflect, Uint8Array, Uint32Array};
use tsify::{Ts, Tsify};
use wasm_bindgen::closure::Closure;
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

/// A function that gives the text as bytes.
fn handing_over(content: &str) -> JsValue {
    let bytes = Uint8Array::from(content.as_bytes());
    Closure::once_into_js(move || bytes)
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
        set("size", (content.len() as f64).into());
        set("read", handing_over(content));
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
    let offsets: Uint32Array = offsets.dyn_into().unwrap();
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
    assert!(message(error).contains("size"));
    let error = Model::generate("teapot", plain("{}")).err().unwrap();
    assert!(message(error).contains("flange"));
    let error = Model::generate("flange", plain(r#"{"noise": -1}"#))
        .err()
        .unwrap();
    assert!(message(error).contains("noise must be between"));
}

#[wasm_bindgen_test]
fn every_part_survives_being_written_and_read() {
    let parts = at(declarations().unwrap(), "parts");
    for part in js_sys::Array::from(&parts) {
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
    let known = declarations().unwrap();
    assert_eq!(text(known, "fitters.0.parameters.0.name"), "tolerance");
}

#[wasm_bindgen_test]
fn one_call_sums_up_the_reports_of_all_methods() {
    let scores = Object::new();
    let set = |key: &str, value: JsValue| Reflect::set(&scores, &key.into(), &value).unwrap();
    // Nine measures a row; the second report of HT has no DSC.
    let rows: Vec<f64> = [0.5, f64::NAN, 1.0]
        .into_iter()
        .flat_map(|dsc| std::iter::once(dsc).chain([1.0; 8]))
        .collect();
    set("methods", JSON::parse(r#"["HT", "PG"]"#).unwrap());
    set("method", Uint32Array::from([0, 0, 1].as_slice()).into());
    set("measures", Float64Array::from(rows.as_slice()).into());
    set("typeErrors", Uint32Array::from([2, 3, 0].as_slice()).into());
    let sums = summarise(Ts::new_unchecked(scores.into())).unwrap();
    let ht = sums[0].js_value();
    assert_eq!(text(&ht, "method"), "HT");
    assert_eq!(
        (number(&ht, "models"), number(&ht, "typeErrors")),
        (2.0, 5.0)
    );
    assert_eq!(number(&ht, "over.DSC.mean"), 0.5);
    assert_eq!(number(&ht, "over.DSC.count"), 1.0);
    assert_eq!(number(&ht, "over.PPV.count"), 2.0);
    assert_eq!(text(sums[1].js_value(), "method"), "PG");
}

#[wasm_bindgen_test]
fn figures_are_compared_measure_by_measure() {
    let own = [0.9, 1.0, 1.0, 1.0, 1.0, 1.0, f64::NAN, 0.0, 0.0];
    let theirs = [0.8, 1.0, 1.0, 1.0, 1.0, 1.0, 0.1, 0.1, 0.0];
    let compared = compare(&own, &theirs).unwrap();
    let measure = |place: usize| compared[place].js_value();
    assert_eq!(text(measure(0), "mean.outcome"), "better");
    assert_eq!(number(measure(0), "better"), 1.0);
    assert!(at(measure(6), "differences.0").is_null() && at(measure(6), "own").is_null());
    assert_eq!(text(measure(7), "differences.0.outcome"), "better");
    assert_eq!(text(measure(8), "differences.0.outcome"), "even");
    assert!(compare(&own, &theirs[..8]).is_err());
}

#[wasm_bindgen_test]
fn points_have_outcomes_labels_and_distances() {
    let model = unit_square("Primitive1:=[1 2];\n");
    let mine = || Some("MINE".to_owned());
    let outcomes = |truth, predicted| model.outcomes(mine(), truth, predicted).unwrap().to_vec();
    assert_eq!(outcomes(Some(0), Some(0)), [1, 1, 3, 3]);
    assert_eq!(outcomes(None, Some(0)), [2, 2, 0, 0]);
    assert_eq!(outcomes(Some(7), None), [0; 4]);
    assert_eq!(
        model.figure("MINE".to_owned()).unwrap().to_vec(),
        [1, 1, 0, 0]
    );
    assert_eq!(model.farthest(None).unwrap(), 0.0);
    let wanted = vec![
        plain(r#"{"places": [0]}"#),
        plain(r#"{"method": "MINE", "places": [0]}"#),
    ];
    let counted = model.histogram(wanted, 2, false).unwrap();
    let rows = |place: &str| Uint32Array::from(at(counted.js_value(), place)).to_vec();
    // The submission has no surface to measure from.
    assert_eq!(
        (rows("counts.0"), rows("counts.1")),
        (vec![4, 0], vec![0, 0])
    );
    assert_eq!(number(counted.js_value(), "edges.length"), 3.0);
    assert_eq!(number(model.types(None).unwrap(), "Plane"), 1.0);
}

#[wasm_bindgen_test]
fn paths_and_lines_are_the_same_for_every_face() {
    let path = |layout: &str, model: &str, method: Option<&str>| {
        let method = method.map(str::to_owned);
        path_of(word(layout), model, word("primitives"), method).unwrap()
    };
    assert_eq!(
        path("test-set", "set/PC1", Some("HT")),
        "set/pointCloud_primitives_HT/PC1_primitives.txt"
    );
    assert_eq!(path("beside", "../PC1", None), "PC1_primitives.txt");
    assert!(file_name("a:b").starts_with("a_b-"));
    let finding = r#"{"severity": "error", "file": "a\nb", "line": 2, "column": 3,
        "message": "No", "found": "x", "expected": "", "hint": "Mend it"}"#;
    let bare = r#"{"severity": "note", "file": "a", "message": "No", "found": "", "expected": "", "hint": ""}"#;
    let lines = one_lines(vec![plain(finding), plain(bare)]).unwrap();
    assert_eq!(
        lines,
        [
            "a\u{fffd}b:2:3: error: No (found x). Mend it",
            "a: note: No"
        ]
    );
}

#[wasm_bindgen_test]
fn a_case_knows_what_it_lost_and_what_is_thin() {
    let whole = Model::generate("flange", plain(r#"{"spacing": 0.05}"#)).unwrap();
    let info = whole.info().unwrap();
    let corner =
        |end: &str| [0, 1, 2].map(|axis| number(info.js_value(), &format!("bounds.{end}.{axis}")));
    let (min, max) = (corner("min"), corner("max"));
    let square: f64 = min
        .iter()
        .zip(max)
        .map(|(min, max)| (max - min).powi(2))
        .sum();
    let diagonal = number(info.js_value(), "bounds.diagonal");
    assert!((diagonal - square.sqrt()).abs() < 1e-12 * diagonal);

    let inside = whole.points_in_ball(&max, 0.6 * diagonal).unwrap();
    let rest = whole.without_ball(&max, 0.6 * diagonal).unwrap();
    let losses = whole.losses(&rest).unwrap();
    assert!(inside.length() > 0);
    assert_eq!(
        number(losses.js_value(), "points"),
        f64::from(inside.length())
    );
    let thin = rest.thin(0.05).unwrap();
    assert_eq!(number(thin.js_value(), "fewest"), 10.0);
    assert!(number(thin, "distance") <= 0.05 * diagonal);
    let around = rest.positions_around(&[0.0; 3]).unwrap();
    assert_eq!(
        f64::from(around.length()),
        3.0 * number(rest.info().unwrap(), "points")
    );
    assert!(rest.positions_around(&[0.0]).is_err());
}
