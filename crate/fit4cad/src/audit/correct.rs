//! Replacing forms that are wrong by conversions of those that are right.

use super::forms::{self, Measured, MeasuredForm};
use super::verdict::{Verdict, without};
use crate::model::{Coefficients, Model, Primitive, Segmentation};
use crate::surface::{Conversion, Form, Surface};

/// One vector that was replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Correction {
    /// Number of the primitive.
    pub primitive: u32,
    /// The form that was wrong, unusable or missing.
    pub form: Form,
    /// The form that it was converted from: that nearer the points.
    pub from: Form,
}

/// The truth of a model with its wrong vectors replaced, and which those are; `None` without truth.
///
/// A vector is replaced where it is off the points, no surface of its type, unusable, missing or
/// too coarse near an apex, and the primitive has a form that fits. All others keep every bit.
/// Point lists stay as they are. O(points listed).
pub fn correct(model: &Model) -> Option<(Segmentation, Vec<Correction>)> {
    let mut truth = model.truth.clone()?;
    let mut corrections = Vec::new();
    for primitive in &mut truth.primitives {
        let measured = forms::measure(&model.cloud, primitive);
        let verdict = Verdict::of(&measured);
        let Some((surface, from)) = best(&measured, &verdict) else {
            continue;
        };
        for form in Form::ALL {
            if is_wrong(form, primitive, &measured, &verdict) {
                replace(form, &surface, primitive);
                corrections.push(Correction {
                    primitive: primitive.number,
                    form,
                    from,
                });
            }
        }
    }
    Some((truth, corrections))
}

/// Of the forms that fit the points the nearest, the parametric one where they are equally near.
fn best(measured: &Measured, verdict: &Verdict) -> Option<(Surface, Form)> {
    let fits = |form: &&MeasuredForm| !verdict.off.contains(&form.form);
    let mean = |form: &MeasuredForm| {
        let accuracy = without(&form.distances, &verdict.stray);
        accuracy.map_or(f64::INFINITY, |accuracy| accuracy.mfe)
    };
    measured
        .forms
        .iter()
        .filter(fits)
        .filter_map(|form| Some((form.surface?, form.form, mean(form))))
        .min_by(|a, b| a.2.total_cmp(&b.2))
        .map(|(surface, form, _)| (surface, form))
}

fn is_wrong(form: Form, primitive: &Primitive, measured: &Measured, verdict: &Verdict) -> bool {
    let no_member = || {
        let same = measured.forms.iter().find(|measured| measured.form == form);
        same.is_some_and(|measured| measured.misfit > Conversion::TOLERANCE)
    };
    primitive.coefficients(form).values().is_none()
        || verdict.off.contains(&form)
        || (form == Form::Implicit && verdict.first_order)
        || no_member()
}

fn replace(form: Form, surface: &Surface, primitive: &mut Primitive) {
    match form {
        Form::Parametric => {
            primitive.parametric = Coefficients::Given(surface.to_parametric());
            primitive.surface = Some(*surface);
        }
        Form::Implicit => primitive.implicit = Coefficients::Given(surface.to_implicit()),
    }
}
