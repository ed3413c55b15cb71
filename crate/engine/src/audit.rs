//! What is wrong with a ground truth, as plain objects.

use fit4cad::audit;
use fit4cad::diagnostics::Diagnostic;
use fit4cad::format::write_surfaces;
use fit4cad::metrics::accuracy::FitAccuracy;
use fit4cad::surface::Form;
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::diagnostic::Severity;
use crate::primitive::SurfaceType;
use crate::{Model, hand_over};

/// One thing that is wrong with a ground truth.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Finding {
    /// Number of the primitive; `null` where it is about a file or the cloud.
    pub primitive: Option<u32>,
    /// Name of the check that found it, e.g. `implicit distance`.
    pub check: &'static str,
    /// How much it matters.
    pub severity: Severity,
    /// What was measured, a share of the primitive's diagonal (or, for `family`, of the surface's
    /// size); `null` where nothing was, or it is infinite.
    pub value: Option<f64>,
    /// What it may be at most.
    pub limit: Option<f64>,
    /// One sentence: what is wrong.
    pub message: String,
    /// Why, or what to do; may be empty.
    pub hint: String,
}

impl From<&audit::Finding> for Finding {
    fn from(finding: &audit::Finding) -> Self {
        Self {
            primitive: finding.primitive,
            check: finding.check.name(),
            severity: finding.severity.into(),
            value: finding.value.and_then(finite),
            limit: finding.limit,
            message: finding.message.clone(),
            hint: finding.hint.clone(),
        }
    }
}

/// Distances of a primitive's points to one form, over the diagonal of their box.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct FormAudit {
    /// Mean distance; `null` where there is none.
    pub mean: Option<f64>,
    /// Largest distance; `null` where there is none.
    pub max: Option<f64>,
    /// How far the vector is from a surface of its type, over that surface's size; `null` where
    /// there is none near.
    pub misfit: Option<f64>,
    /// Whether the distances are Euclidean; else they are first-order ones.
    pub euclidean: bool,
}

impl From<audit::FormAudit> for FormAudit {
    fn from(form: audit::FormAudit) -> Self {
        Self {
            mean: form.accuracy.and_then(mean),
            max: form.accuracy.and_then(|accuracy| finite(accuracy.d_haus)),
            misfit: finite(form.misfit),
            euclidean: form.euclidean,
        }
    }
}

/// The measurements of one primitive.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(missing_as_null)]
pub struct PrimitiveAudit {
    /// Its number.
    pub number: u32,
    /// Its type, where it is one of the five.
    #[serde(rename = "type")]
    pub kind: Option<SurfaceType>,
    /// How many points it lists.
    pub points: u32,
    /// How many of them are off every form.
    pub off: u32,
    /// The parametric form.
    pub parametric: Option<FormAudit>,
    /// The implicit form.
    pub implicit: Option<FormAudit>,
    /// Mean first-order distance |f| / |∇f| to the implicit form.
    pub first_order: Option<f64>,
    /// Largest distance between the two forms at the points.
    pub agreement: Option<f64>,
}

impl From<&audit::PrimitiveAudit> for PrimitiveAudit {
    fn from(primitive: &audit::PrimitiveAudit) -> Self {
        Self {
            number: primitive.number,
            kind: primitive.kind.map(SurfaceType::from),
            points: primitive.points as u32,
            off: primitive.off as u32,
            parametric: primitive.parametric.map(FormAudit::from),
            implicit: primitive.implicit.map(FormAudit::from),
            first_order: primitive.first_order.and_then(mean),
            agreement: primitive.agreement.and_then(finite),
        }
    }
}

/// What an audit found in a model.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct Audit {
    /// Name of the model.
    pub model: String,
    /// What is wrong: first what concerns whole files, then by primitive.
    pub findings: Vec<Finding>,
    /// The measurements, in the order of the file.
    pub primitives: Vec<PrimitiveAudit>,
}

/// One vector that was replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
pub struct Correction {
    /// Number of the primitive.
    pub primitive: u32,
    /// The form that was wrong: `parametric` or `implicit`.
    pub form: &'static str,
    /// The form it was converted from.
    pub from: &'static str,
}

impl From<&audit::Correction> for Correction {
    fn from(correction: &audit::Correction) -> Self {
        Self {
            primitive: correction.primitive,
            form: correction.form.name(),
            from: correction.from.name(),
        }
    }
}

/// The surface files of a truth with wrong vectors replaced.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct Corrected {
    /// What was replaced; empty where nothing is wrong that could be.
    pub corrections: Vec<Correction>,
    /// `PCi_parametric.txt`, where a vector of it was replaced.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub parametric: Option<String>,
    /// `PCi_implicit.txt`, where a vector of it was replaced.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub implicit: Option<String>,
}

#[wasm_bindgen]
impl Model {
    /// Audits the ground truth: its files, and points, parametric and implicit form against each
    /// other. Without truth only the files.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn audit(&self) -> Result<Ts<Audit>, JsError> {
        let diagnostics: Vec<Diagnostic> = self.diagnostics_for(None).cloned().collect();
        let audit = audit::audit(&self.model, &diagnostics);
        hand_over(&Audit {
            model: self.model.name.clone(),
            findings: audit.findings.iter().map(Finding::from).collect(),
            primitives: audit.primitives.iter().map(PrimitiveAudit::from).collect(),
        })
    }

    /// The truth's surface files with vectors that are wrong replaced by exact conversions of
    /// those that are right.
    ///
    /// # Errors
    /// If there is no truth.
    pub fn corrected(&self) -> Result<Ts<Corrected>, JsError> {
        self.segmentation(None)?;
        let (truth, corrections) = audit::correct(&self.model).unwrap_or_default();
        let text = |form: Form| {
            let mut corrections = corrections.iter();
            let changed = corrections.any(|correction| correction.form == form);
            changed.then(|| write_surfaces(&truth, form))
        };
        hand_over(&Corrected {
            parametric: text(Form::Parametric),
            implicit: text(Form::Implicit),
            corrections: corrections.iter().map(Correction::from).collect(),
        })
    }
}

fn mean(accuracy: FitAccuracy) -> Option<f64> {
    finite(accuracy.mfe)
}

fn finite(value: f64) -> Option<f64> {
    value.is_finite().then_some(value)
}
