//! Parts written by Open Cascade, and what it says of our reading of them; where its Python wheel
//! (`cadquery-ocp`) is there. `FIT4CAD_PYTHON` names the interpreter that has it.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;

use fit4cad_step::{Amount, Document, Import, Options};
use serde_json::{Value, json};

/// The interpreter, if it has the wheel.
fn python() -> Option<PathBuf> {
    let given = std::env::var_os("FIT4CAD_PYTHON");
    let python = PathBuf::from(given.unwrap_or_else(|| "python3".into()));
    let asked = Command::new(&python).args(["-c", "import OCP"]).output();
    if asked.is_ok_and(|asked| asked.status.success()) {
        return Some(python);
    }
    eprintln!(
        "skipped: {} has no Open Cascade (pip install cadquery-ocp; FIT4CAD_PYTHON)",
        python.display()
    );
    None
}

fn run(python: &Path, what: &str, folder: &Path) -> String {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/open_cascade.py");
    let ran = Command::new(python)
        .arg(script)
        .arg(what)
        .arg(folder)
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.success(), "{errors}");
    String::from_utf8(ran.stdout).unwrap()
}

fn sample(path: &Path) -> Import {
    let document = Document::read(&std::fs::read(path).unwrap(), &mut |_| {}).unwrap();
    let options = Options {
        amount: Amount::Points(2000),
        join: false,
        ..Options::default()
    };
    document.sample("part", &options, &mut |_| {}).unwrap()
}

/// What Open Cascade calls a surface that STEP calls so.
fn kind(surface: &str) -> &str {
    match surface {
        "PLANE" => "Plane",
        "CYLINDRICAL_SURFACE" => "Cylinder",
        "CONICAL_SURFACE" => "Cone",
        "SPHERICAL_SURFACE" => "Sphere",
        "TOROIDAL_SURFACE" => "Torus",
        "SURFACE_OF_REVOLUTION" => "SurfaceOfRevolution",
        "SURFACE_OF_LINEAR_EXTRUSION" => "SurfaceOfExtrusion",
        name if name.starts_with("B_SPLINE") => "BSplineSurface",
        other => other,
    }
}

#[test]
fn faces_and_points_are_those_of_open_cascade() {
    let Some(python) = python() else {
        return;
    };
    let folder = std::env::temp_dir().join(format!("fit4cad-occ-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    run(&python, "make", &folder);
    let expected = std::fs::read_to_string(folder.join("expected.json")).unwrap();
    let expected: BTreeMap<String, Vec<Value>> = serde_json::from_str(&expected).unwrap();
    let mut found = serde_json::Map::new();
    for (name, faces) in &expected {
        let import = sample(&folder.join(name));
        assert_eq!(import.report.faces.len(), faces.len(), "{name}");
        let mut points = import.model.cloud.points().iter();
        let mut drawn = serde_json::Map::new();
        for face in &import.report.faces {
            assert_eq!(face.remark, "", "{name} #{}", face.face);
            let theirs = faces.iter().find(|it| it["face"] == face.face).unwrap();
            assert_eq!(kind(&face.surface), theirs["type"], "{name} #{}", face.face);
            let area = theirs["area"].as_f64().unwrap();
            let off = (face.area / area - 1.0).abs();
            assert!(
                off < 1e-3,
                "{name} #{}: area {} not {area}",
                face.face,
                face.area
            );
            // The points follow one another in the order of the faces.
            let own: Vec<_> = points.by_ref().take(face.points).collect();
            let few = own.iter().step_by(own.len().div_ceil(6)).take(6);
            let few: Vec<_> = few.map(|at| [at.x, at.y, at.z]).collect();
            drawn.insert(face.face.to_string(), json!(few));
        }
        let part = json!({ "diagonal": import.report.diagonal, "faces": drawn });
        found.insert(name.clone(), part);
    }
    std::fs::write(
        folder.join("found.json"),
        Value::from(found.clone()).to_string(),
    )
    .unwrap();
    let judged: Value = serde_json::from_str(&run(&python, "judge", &folder)).unwrap();
    for (name, faces) in judged.as_object().unwrap() {
        let near = 1e-5 * found[name]["diagonal"].as_f64().unwrap();
        for (face, off) in faces.as_object().unwrap() {
            let off = off.as_f64().unwrap();
            assert!(
                (0.0..near).contains(&off),
                "{name} #{face}: {off} off its face"
            );
        }
    }
    std::fs::remove_dir_all(&folder).unwrap();
}
