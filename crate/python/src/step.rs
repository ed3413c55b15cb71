//! STEP files as models, and primitives back as STEP.

use fit4cad::surface::SurfaceType;
use fit4cad_step::{Amount, Document, Options, Progress, Spread, write_step};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::cloud::Cloud;
use crate::dict::{dict, refused};
use crate::segmentation::Segmentation;

/// Makes a model of the part in the bytes of a STEP file: cloud, truth, and what became of its faces.
#[pyfunction]
#[pyo3(signature = (name, bytes, *, points = None, spacing = None, spread = None, views = None, least = None, seed = None, named = None, outer = None, separate = None, bodies = None))]
#[allow(
    clippy::too_many_arguments,
    reason = "they are the options of the command line"
)]
pub(crate) fn import_step<'py>(
    py: Python<'py>,
    name: &str,
    bytes: &[u8],
    points: Option<usize>,
    spacing: Option<f64>,
    spread: Option<&str>,
    views: Option<usize>,
    least: Option<usize>,
    seed: Option<u64>,
    named: Option<bool>,
    outer: Option<bool>,
    separate: Option<bool>,
    bodies: Option<Vec<usize>>,
) -> PyResult<(Cloud, Option<Segmentation>, Bound<'py, PyDict>)> {
    let usual = Options::default();
    let amount = match (points, spacing) {
        (Some(_), Some(_)) => return Err(refused("give points or spacing, not both")),
        (Some(points), None) => Amount::Points(points),
        (None, Some(spacing)) => Amount::Spacing(spacing),
        (None, None) => usual.amount,
    };
    let spread = match spread {
        None => usual.spread,
        Some("even") => Spread::Even,
        Some("random") => Spread::Random,
        Some("scan") => Spread::Scan,
        Some(other) => {
            let message = format!("spread must be even, random or scan, not {other}");
            return Err(refused(message));
        }
    };
    let options = Options {
        amount,
        spread,
        views: views.unwrap_or(usual.views),
        least: least.unwrap_or(usual.least),
        seed: seed.unwrap_or(usual.seed),
        recognise: !named.unwrap_or(!usual.recognise),
        inner: !outer.unwrap_or(!usual.inner),
        join: !separate.unwrap_or(!usual.join),
    };
    let content = bytes.to_vec();
    let import = py.detach(|| {
        let mut unheard = |_: Progress| {};
        let mut document = Document::read(&content, &mut unheard)?;
        if let Some(kept) = &bodies {
            document.keep(kept)?;
        }
        document.sample(name, &options, &mut unheard)
    });
    let import = import.map_err(refused)?;
    let report = &import.report;
    let faces = PyList::empty(py);
    for face in &report.faces {
        faces.append(dict!(py;
            "face" => face.face,
            "body" => &face.body,
            "instance" => face.instance,
            "surface" => &face.surface,
            "type" => face.kind.map(SurfaceType::name),
            "recognised" => face.recognised,
            "area" => face.area,
            "points" => face.points,
            "primitive" => face.primitive,
            "remark" => &face.remark,
        ))?;
    }
    let choice = PyList::empty(py);
    for body in &report.choice {
        choice.append(dict!(py;
            "name" => &body.name,
            "faces" => body.faces,
            "kept" => body.kept,
        ))?;
    }
    let report = dict!(py;
        "system" => &report.system,
        "schema" => &report.schema,
        "bodies" => report.bodies,
        "instances" => report.instances,
        "choice" => choice,
        "diagonal" => report.diagonal,
        "area" => report.area,
        "spacing" => report.spacing,
        "faces" => faces,
        "lost" => report.lost(),
        "leftOut" => &report.left_out,
        "warnings" => &report.warnings,
        "doubts" => report.doubts(),
    );
    let model = import.model;
    Ok((
        model.cloud.into(),
        model.truth.map(Segmentation::from),
        report,
    ))
}

/// The primitives as the text of a STEP file, and how many were left out. The colours are red, green and
/// blue of each type, 0 to 255.
#[pyfunction]
pub(crate) fn export_step(
    py: Python<'_>,
    name: &str,
    cloud: &Cloud,
    segmentation: &Segmentation,
    colours: Vec<[u8; 3]>,
) -> (String, usize) {
    let colour = |kind: SurfaceType| {
        let places = SurfaceType::ALL.iter().zip(&colours);
        let own = places.into_iter().find(|(known, _)| **known == kind);
        own.map_or([0.5; 3], |(_, colour)| {
            colour.map(|it| f64::from(it) / 255.0)
        })
    };
    py.detach(|| write_step(name, &cloud.cloud, &segmentation.segmentation, colour))
}
