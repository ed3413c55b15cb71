//! Real parts against what Open Cascade says of them, where they are there.

use std::path::{Path, PathBuf};

use fit4cad::cloud::Point;
use fit4cad::surface::Surface;
use fit4cad_step::{Amount, Document, FaceReport, Import, Options};
use serde_json::Value;

/// Where the parts are: never in the repository, as the benchmark's files are not.
fn folder() -> Option<PathBuf> {
    let given = std::env::var_os("FIT4CAD_SHARED").map(PathBuf::from);
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared");
    let folder = given.unwrap_or(beside).join("step");
    if folder.join("oracle.json").exists() {
        return Some(folder);
    }
    eprintln!("skipped: there are no parts in {}", folder.display());
    None
}

fn sample(path: &Path) -> Import {
    let document = Document::read(&std::fs::read(path).unwrap(), &mut |_| {}).unwrap();
    let options = Options {
        amount: Amount::Points(5000),
        join: false,
        ..Options::default()
    };
    document.sample("part", &options, &mut |_| {}).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn place(value: &Value) -> Point {
    let at = |k: usize| number(&value[k]);
    Point::new(at(0), at(1), at(2))
}

fn family(face: &FaceReport) -> &'static str {
    match face.surface.as_str() {
        "PLANE" => "plane",
        "CYLINDRICAL_SURFACE" => "cylinder",
        "CONICAL_SURFACE" => "cone",
        "SPHERICAL_SURFACE" => "sphere",
        "TOROIDAL_SURFACE" => "torus",
        name if name.starts_with("B_SPLINE_SURFACE") => "bspline",
        _ => "other",
    }
}

/// How far, relative to the size of the numbers, a surface is from what the oracle says.
fn difference(surface: &Surface, expected: &Value) -> f64 {
    let size = |point: Point| 1.0 + point.coords.norm();
    let axis = expected.get("n").map(|n| place(n).coords);
    let across = |found: &fit4cad::cloud::Direction| found.cross(&axis.unwrap()).norm();
    let off_line = |centre: &Point, found: &fit4cad::cloud::Direction, on: Point| {
        (on - centre).cross(found).norm() / size(on)
    };
    match surface {
        Surface::Plane(it) => {
            let on = place(&expected["o"]);
            across(&it.normal).max((on.coords.dot(&it.normal) - it.offset).abs() / size(on))
        }
        Surface::Cylinder(it) => {
            let radius = number(&expected["r"]);
            across(&it.axis)
                .max(off_line(&it.centre, &it.axis, place(&expected["o"])))
                .max((it.radius / radius - 1.0).abs())
        }
        Surface::Cone(it) => {
            let apex = place(&expected["apex"]);
            across(&it.axis)
                .max((it.apex - apex).norm() / size(apex))
                .max((it.half_angle / number(&expected["angle"]).abs() - 1.0).abs())
        }
        Surface::Torus(it) => {
            let centre = place(&expected["o"]);
            across(&it.axis)
                .max((it.centre - centre).norm() / size(centre))
                .max((it.major_radius / number(&expected["R"]) - 1.0).abs())
                .max((it.minor_radius / number(&expected["r"]) - 1.0).abs())
        }
        Surface::Sphere(it) => (it.radius / number(&expected["r"]) - 1.0).abs(),
    }
}

#[test]
fn faces_types_parameters_and_areas_are_those_of_open_cascade() {
    let Some(folder) = folder() else {
        return;
    };
    let oracle = std::fs::read_to_string(folder.join("oracle.json")).unwrap();
    let oracle: Value = serde_json::from_str(&oracle).unwrap();
    for (name, part) in oracle.as_object().unwrap() {
        let import = sample(&folder.join(name));
        // Triangles for display are in the oracle as faces of another kind.
        let faces = part["faces"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|face| face["type"] != "other");
        let mut theirs: Vec<&Value> = faces.collect();
        let mut ours: Vec<&FaceReport> = import.report.faces.iter().collect();
        assert_eq!(ours.len(), theirs.len(), "{name}");
        let mut worst = (0.0_f64, 0.0_f64);
        for face in &mut ours {
            assert_eq!(face.remark, "", "{name} #{}", face.face);
            // Both list faces in their own order: the one of the type that agrees best.
            let kind = family(face);
            let primitives = &import.model.truth.as_ref().unwrap().primitives;
            let surface = face
                .primitive
                .and_then(|number| primitives[number as usize - 1].surface);
            let cost = |other: &Value| {
                let area = (face.area / number(&other["area"]) - 1.0).abs();
                let parameters = match (kind, surface) {
                    ("bspline", _) => 0.0,
                    (_, Some(surface)) => difference(&surface, other),
                    (_, None) => f64::INFINITY,
                };
                (area, parameters)
            };
            let matching = theirs
                .iter()
                .enumerate()
                .filter(|(_, other)| other["type"] == kind);
            let (index, (area, parameters)) = matching
                .map(|(index, other)| (index, cost(other)))
                .min_by(|a, b| (a.1.0 + 1e3 * a.1.1).total_cmp(&(b.1.0 + 1e3 * b.1.1)))
                .unwrap();
            theirs.swap_remove(index);
            assert!(
                parameters < 1e-9,
                "{name} #{}: parameters off by {parameters:e}",
                face.face
            );
            assert!(area < 3e-3, "{name} #{}: area off by {area:e}", face.face);
            worst = (worst.0.max(area), worst.1.max(parameters));
        }
        eprintln!(
            "{name}: {} faces, areas within {:.1e}, parameters within {:.1e}",
            ours.len(),
            worst.0,
            worst.1
        );
    }
}
