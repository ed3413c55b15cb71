//! Why a form may be wrong.

use super::DISTANCE_LIMIT;
use super::forms::{Measured, MeasuredForm, Patch, is_far};
use super::verdict::Verdict;
use crate::cloud::Cloud;
use crate::model::{Primitive, Segmentation};
use crate::surface::{Form, Surface};

/// Why one form is off while the other is not, or not the same.
pub(super) fn wrong_form(
    cloud: &Cloud,
    truth: &Segmentation,
    primitive: &Primitive,
    measured: &Measured,
    wrong: &MeasuredForm,
    verdict: &Verdict,
) -> String {
    let right = measured.forms.iter().find(|form| {
        form.form != wrong.form && !verdict.off.contains(&form.form) && form.surface.is_some()
    });
    let mut hints = Vec::new();
    let owner = wrong
        .surface
        .and_then(|surface| owner(cloud, truth, primitive, &surface));
    if let Some(other) = owner {
        hints.push(format!("The vector fits the points of Primitive{other}"));
    } else if let Some(other) = same_vector(truth, primitive, wrong.form) {
        hints.push(format!("Primitive{other} has the very same vector"));
    } else if let Some(exact) = right.and_then(|right| right.surface)
        && wrong.form == Form::Implicit
        && is_rounded(&exact.to_implicit(), primitive.implicit.values())
    {
        hints.push(
            "Its coefficients are those of the parametric form to five digits: too few, this far \
             from the origin"
                .to_owned(),
        );
    }
    if let Some(right) = right {
        hints.push(format!(
            "The {} form fits; convert it exactly",
            right.form.name()
        ));
    }
    hints.join(". ")
}

/// Whether a surface on which both forms agree belongs to another primitive.
pub(super) fn other_primitive(
    cloud: &Cloud,
    truth: &Segmentation,
    primitive: &Primitive,
    measured: &Measured,
) -> String {
    let surface = measured.forms.iter().find_map(|form| form.surface);
    match surface.and_then(|surface| owner(cloud, truth, primitive, &surface)) {
        Some(other) => {
            format!("It fits the points of Primitive{other}: the entries may be in the wrong order")
        }
        None => "The points are noisy, or the surface is another".to_owned(),
    }
}

/// How many primitives are searched for the owner of a vector; ten times as many as any model has.
const SEARCHED: usize = 1_000;

/// The first other primitive of the same type on whose points the surface lies.
fn owner(
    cloud: &Cloud,
    truth: &Segmentation,
    primitive: &Primitive,
    surface: &Surface,
) -> Option<u32> {
    let far_away = DISTANCE_LIMIT * cloud.bounds().diagonal();
    let fits = |other: &&Primitive| {
        if std::ptr::eq(*other, primitive) || other.kind != Some(surface.kind()) {
            return false;
        }
        // One point is enough to rule most of them out.
        let first = other.points.first();
        let first = first.and_then(|&index| cloud.points().get(index as usize));
        if first.is_none_or(|point| surface.distance(point) > far_away) {
            return false;
        }
        let patch = Patch::new(cloud, &other.points);
        let distances = patch.distances(|point| surface.distance(point));
        !distances.is_empty() && !distances.iter().any(|&distance| is_far(distance))
    };
    let other = truth.primitives.iter().take(SEARCHED).find(fits);
    other.map(|other| other.number)
}

/// The first other primitive with the same vector, though its other form is another: two patches
/// of one surface rightly share both.
fn same_vector(truth: &Segmentation, primitive: &Primitive, form: Form) -> Option<u32> {
    let own = primitive.coefficients(form).values()?;
    let same = |other: &&Primitive| {
        !std::ptr::eq(*other, primitive)
            && other.kind == primitive.kind
            && other.coefficients(form).values() == Some(own)
            && other.coefficients(form.other()) != primitive.coefficients(form.other())
    };
    let mut others = truth.primitives.iter().take(SEARCHED);
    others.find(same).map(|other| other.number)
}

/// Whether a vector is an exact one, scaled, with its coefficients cut to five digits.
fn is_rounded(exact: &[f64], values: Option<&[f64]>) -> bool {
    const DIGITS: f64 = 1e-5;
    /// Below this share of the largest coefficient there are no digits to lose.
    const NEGLIGIBLE: f64 = 1e-9;
    let Some(values) = values.filter(|values| values.len() == exact.len()) else {
        return false;
    };
    // The quadratic part has no large terms that cancel, so it gives the scale.
    let leading = exact.iter().zip(values).take(6);
    let Some((&reference, &value)) = leading.max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())) else {
        return false;
    };
    let scale = value / reference;
    let largest = values
        .iter()
        .fold(0.0f64, |most, value| most.max(value.abs()));
    exact.iter().zip(values).all(|(exact, value)| {
        let exact = exact * scale;
        (exact - value).abs() <= DIGITS * value.abs() + NEGLIGIBLE * largest
    })
}
