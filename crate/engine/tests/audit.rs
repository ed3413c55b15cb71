//! Audits and statistics as JavaScript meets them, under Node.
#![cfg(target_arch = "wasm32")]
#![allow(
    clippy::unwrap_used,
    reason = "clippy knows `#[test]`, not `#[wasm_bindgen_test]`"
)]

use fit4cad_engine::{Model, dataset_statistics};
use js_sys::{JSON, Reflect, Uint8Array};
use tsify::Ts;
use wasm_bindgen::JsValue;
use wasm_bindgen::closure::Closure;
use wasm_bindgen_test::wasm_bindgen_test;

/// What JavaScript sees under a dotted path.
fn at(value: impl Into<JsValue>, path: &str) -> JsValue {
    path.split('.').fold(value.into(), |value, key| {
        Reflect::get(&value, &key.into()).unwrap()
    })
}

/// A square of four points with two surface files.
fn square(parametric: &str, implicit: &str) -> Model {
    let cloud = "Points:=[\n[0, 0, 0], \n[3, 0, 0], \n[0, 4, 0], \n[3, 4, 0] \n ];\n";
    let files = [
        ("cloud", cloud),
        ("primitives", "Primitive1:=[1 2 3 4];\n"),
        ("parametric", parametric),
        ("implicit", implicit),
    ];
    let files = files.map(|(role, content)| {
        let path = format!("PC1_{role}.txt");
        let file = JSON::parse(&format!(r#"{{"path": "{path}", "role": "{role}"}}"#)).unwrap();
        let length = JsValue::from(content.len() as f64);
        Reflect::set(&file, &"size".into(), &length).unwrap();
        let bytes = Uint8Array::from(content.as_bytes());
        let read = Closure::once_into_js(move || bytes);
        Reflect::set(&file, &"read".into(), &read).unwrap();
        Ts::new_unchecked(file)
    });
    Model::read("PC1", files.into()).unwrap()
}

const FLOOR: &str = "Primitive1:=[Plane, [1 0 0 0 1 0 0 0 0]];\n";

#[wasm_bindgen_test]
fn an_audit_crosses_with_findings_and_measurements() {
    let model = square(FLOOR, "Primitive1:=[Plane, [0 0 1 -1]];\n");
    let audit = model.audit().unwrap();
    assert_eq!(at(audit.js_value(), "model"), JsValue::from("PC1"));
    let finding = at(audit.js_value(), "findings.0");
    assert_eq!(at(&finding, "check"), JsValue::from("implicit distance"));
    assert_eq!(at(&finding, "severity"), JsValue::from("error"));
    assert_eq!(at(&finding, "value"), JsValue::from(0.2));
    let primitive = at(audit.js_value(), "primitives.0");
    assert_eq!(at(&primitive, "type"), JsValue::from("Plane"));
    assert_eq!(at(&primitive, "parametric.max"), JsValue::from(0));
    assert_eq!(at(&primitive, "firstOrder"), JsValue::from(0.2));
    assert_eq!(at(&primitive, "agreement"), JsValue::from(0.2));

    let corrected = model.corrected().unwrap();
    let text = JsValue::from("Primitive1:=[Plane, [0 0 1 0]];\n");
    assert_eq!(at(corrected.js_value(), "implicit"), text);
    assert!(at(corrected.js_value(), "parametric").is_undefined());
    let correction = at(corrected, "corrections.0");
    assert_eq!(at(&correction, "form"), JsValue::from("implicit"));
    assert_eq!(at(&correction, "from"), JsValue::from("parametric"));
}

#[wasm_bindgen_test]
fn what_reading_found_is_part_of_the_audit() {
    let model = square(FLOOR, "Primitive1:=[Plane, [0 0 1]];\n");
    let audit = model.audit().unwrap();
    let finding = at(audit.js_value(), "findings.0");
    assert_eq!(at(&finding, "check"), JsValue::from("vector"));
    assert_eq!(at(&finding, "primitive"), JsValue::from(1));
    assert_eq!(at(&finding, "value"), JsValue::NULL);
    assert_eq!(at(audit, "primitives.0.implicit"), JsValue::NULL);
}

#[wasm_bindgen_test]
fn statistics_of_models_sum_up_to_those_of_a_set() {
    let implicit = "Primitive1:=[Plane, [0 0 1 0]];\n";
    let first = square(FLOOR, implicit).statistics().unwrap();
    let second = square(FLOOR, implicit).statistics().unwrap();
    assert_eq!(at(first.js_value(), "unsegmented"), JsValue::from(0));
    let set = dataset_statistics(vec![first, second]).unwrap();
    assert_eq!(at(set.js_value(), "types.Plane"), JsValue::from(2));
    assert_eq!(at(set.js_value(), "points"), JsValue::from(8));
    assert_eq!(at(set, "pointsPerModel.median"), JsValue::from(4));

    let nothing = dataset_statistics(Vec::new()).unwrap();
    assert_eq!(at(nothing.js_value(), "models"), JsValue::from(0));
    assert_eq!(at(nothing, "unsegmented"), JsValue::NULL);
}
