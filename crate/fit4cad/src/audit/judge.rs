//! From the measurements of a primitive to what is wrong with it.

use super::forms::{Measured, MeasuredForm, accuracy};
use super::verdict::{Verdict, without};
use super::{Check, DISTANCE_LIMIT, Finding, SEVERE_DISTANCE, hint};
use crate::cloud::Cloud;
use crate::diagnostics::Severity;
use crate::metrics::accuracy::FitAccuracy;
use crate::model::{Primitive, Segmentation};
use crate::surface::{Conversion, Form};

/// Most stray points that are named.
const NAMED: usize = 5;

/// Adds what is wrong with the forms of a primitive.
pub(super) fn judge(
    cloud: &Cloud,
    truth: &Segmentation,
    primitive: &Primitive,
    measured: &Measured,
    findings: &mut Vec<Finding>,
) {
    let verdict = Verdict::of(measured);
    let mut judge = Judge {
        cloud,
        truth,
        primitive,
        measured,
        verdict: &verdict,
        findings,
    };
    judge.family();
    judge.distances();
    judge.stray_points();
    judge.agreement();
    judge.first_order();
}

/// Adds the findings about one primitive, check by check.
struct Judge<'a> {
    cloud: &'a Cloud,
    truth: &'a Segmentation,
    primitive: &'a Primitive,
    measured: &'a Measured,
    verdict: &'a Verdict,
    findings: &'a mut Vec<Finding>,
}

impl Judge<'_> {
    fn add(
        &mut self,
        check: Check,
        severity: Severity,
        (value, limit): (f64, f64),
        message: String,
        hint: String,
    ) {
        self.findings.push(Finding {
            primitive: Some(self.primitive.number),
            check,
            severity,
            value: Some(value),
            limit: Some(limit),
            message,
            hint,
        });
    }

    /// Adds a distance that is above the limit.
    fn add_distance(&mut self, check: Check, distance: f64, message: String, hint: String) {
        let severity = severity_of(distance);
        self.add(check, severity, (distance, DISTANCE_LIMIT), message, hint);
    }

    fn add_off(&mut self, check: Check, subject: &str, distances: FitAccuracy, hint: String) {
        let message = format!(
            "{subject} {} of the primitive's diagonal off the points at most, {} on average",
            percent(distances.d_haus),
            percent(distances.mfe)
        );
        self.add_distance(check, distances.d_haus, message, hint);
    }

    fn without_stray(&self, distances: &[f64]) -> Option<FitAccuracy> {
        without(distances, &self.verdict.stray)
    }

    fn family(&mut self) {
        for form in &self.measured.forms {
            if form.misfit <= Conversion::TOLERANCE {
                continue;
            }
            let (message, hint) = no_member(form, self.primitive, self.verdict);
            let severity = if form.defect.is_some() {
                Severity::Error
            } else {
                Severity::Warning
            };
            let value = (form.misfit, Conversion::TOLERANCE);
            self.add(Check::Family, severity, value, message, hint);
        }
    }

    fn distances(&mut self) {
        let (cloud, truth, primitive) = (self.cloud, self.truth, self.primitive);
        let (measured, verdict) = (self.measured, self.verdict);
        if verdict.off.len() == Form::ALL.len() && verdict.agree {
            let forms = measured.forms.iter();
            let distances = forms.filter_map(|form| self.without_stray(&form.distances));
            let largest = distances.max_by(|a, b| a.d_haus.total_cmp(&b.d_haus));
            if let Some(distances) = largest {
                let hint = hint::other_primitive(cloud, truth, primitive, measured);
                let subject = "The surface, on which both forms agree, is";
                self.add_off(Check::SurfaceDistance, subject, distances, hint);
            }
            return;
        }
        let is_off = |form: &&MeasuredForm| verdict.off.contains(&form.form);
        for form in measured.forms.iter().filter(is_off) {
            let (check, subject) = match form.form {
                Form::Parametric => (Check::ParametricDistance, "The parametric form is"),
                Form::Implicit => (Check::ImplicitDistance, "The implicit form is"),
            };
            if let Some(distances) = self.without_stray(&form.distances) {
                let hint = hint::wrong_form(cloud, truth, primitive, measured, form, verdict);
                self.add_off(check, subject, distances, hint);
            }
        }
    }

    fn stray_points(&mut self) {
        let stray = &self.verdict.stray;
        let Some(named) = named_points(self.primitive, stray) else {
            return;
        };
        let of_strays = |form: &MeasuredForm| {
            let distances = stray.iter().filter_map(|&place| form.distances.get(place));
            accuracy(distances.copied()).map(|accuracy| accuracy.d_haus)
        };
        let nearest = self.measured.forms.iter().filter_map(of_strays);
        let nearest = nearest.min_by(f64::total_cmp).unwrap_or(f64::NAN);
        let message = format!(
            "{named} {} of the primitive's diagonal off its surface",
            percent(nearest)
        );
        let them = if stray.len() == 1 {
            "this one"
        } else {
            "these"
        };
        let hint = format!("All its other points lie on the surface; take {them} out of its list");
        self.add_distance(Check::StrayPoint, nearest, message, hint);
    }

    fn agreement(&mut self) {
        if !self.verdict.off.is_empty() || self.verdict.agree {
            return;
        }
        let Some(apart) = self.without_stray(&self.measured.apart) else {
            return;
        };
        let message = format!(
            "The two forms are {} of the primitive's diagonal apart, though neither is off the points",
            percent(apart.d_haus)
        );
        self.add_distance(Check::Agreement, apart.d_haus, message, String::new());
    }

    fn first_order(&mut self) {
        let distances = self.without_stray(&self.measured.first_order);
        let Some(distances) = distances.filter(|_| self.verdict.first_order) else {
            return;
        };
        let message = format!(
            "The first-order distance |f| / |∇f| to the implicit form is {} of the primitive's \
             diagonal on average, though the surface fits",
            percent(distances.mfe)
        );
        let hint = "A point lies where the gradient vanishes (an apex), and there the few digits \
                    of the coefficients show; give more, and measure Euclidean distances"
            .to_owned();
        let value = (distances.mfe, DISTANCE_LIMIT);
        let check = Check::FirstOrderDistance;
        self.add(check, Severity::Note, value, message, hint);
    }
}

fn severity_of(distance: f64) -> Severity {
    if distance <= SEVERE_DISTANCE {
        Severity::Warning
    } else {
        Severity::Error
    }
}

fn no_member(form: &MeasuredForm, primitive: &Primitive, verdict: &Verdict) -> (String, String) {
    let name = form.form.name();
    let kind = primitive
        .kind
        .map_or_else(String::new, |kind| kind.name().to_lowercase());
    let Some(defect) = form.defect else {
        let message = format!(
            "The {name} form is no {kind}: the nearest one lies {} of its size away",
            percent(form.misfit)
        );
        let hint = if verdict.off.contains(&form.form) || form.distances.is_empty() {
            String::new()
        } else {
            "It fits the points all the same, which are few or on a small part of it".to_owned()
        };
        return (message, hint);
    };
    let hint = "Its distances are left out".to_owned();
    (format!("The {name} form is unusable: {defect}"), hint)
}

/// Names stray points by their numbers in the file, from 1.
fn named_points(primitive: &Primitive, stray: &[usize]) -> Option<String> {
    let numbers = stray
        .iter()
        .filter_map(|&place| primitive.points.get(place));
    let numbers: Vec<String> = numbers
        .take(NAMED)
        .map(|&index| (u64::from(index) + 1).to_string())
        .collect();
    let named = numbers.join(", ");
    match stray.len() {
        0 => None,
        1 => Some(format!("Point {named} is")),
        count if count <= NAMED => Some(format!("Points {named} are up to")),
        count => Some(format!("{count} points ({named}, …) are up to")),
    }
}

/// A share as a percentage of three digits.
fn percent(share: f64) -> String {
    let percent = share * 100.0;
    if !percent.is_finite() {
        return "infinitely many %".to_owned();
    }
    if percent != 0.0 && percent < 0.01 {
        return format!("{percent:.1e} %");
    }
    format!("{percent:.3} %")
}
