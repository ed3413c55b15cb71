//! Which forms of a primitive cannot be relied on, by its measurements.

use super::STRAY_SHARE;
use super::forms::{Measured, accuracy, is_far};
use crate::metrics::accuracy::FitAccuracy;
use crate::surface::Form;

/// The verdict on the forms of one primitive: which of them cannot be relied on.
#[derive(Debug, Clone, Default)]
pub(super) struct Verdict {
    /// Positions in the point list of points off a surface on which all others lie.
    pub(super) stray: Vec<usize>,
    /// The forms that are off the points, stray ones aside.
    pub(super) off: Vec<Form>,
    /// Whether both forms are the same surface, as far as the points tell.
    pub(super) agree: bool,
    /// Whether first-order distances to the implicit form are far too large.
    pub(super) first_order: bool,
}

impl Verdict {
    pub(super) fn of(measured: &Measured) -> Self {
        let mut stray = measured.off();
        let points = measured.forms.iter().map(|form| form.distances.len()).max();
        if stray.len() as f64 > STRAY_SHARE * points.unwrap_or(0) as f64 {
            stray.clear();
        }
        let far = |distances: &[f64]| {
            without(distances, &stray).is_some_and(|accuracy| is_far(accuracy.d_haus))
        };
        let off = measured.forms.iter().filter(|form| far(&form.distances));
        let off: Vec<Form> = off.map(|form| form.form).collect();
        let first_order = without(&measured.first_order, &stray);
        let fits = measured.forms.iter().any(|measured| {
            let Form::Implicit = measured.form else {
                return false;
            };
            measured.surface.is_some() && !off.contains(&Form::Implicit)
        });
        Self {
            agree: !far(&measured.apart),
            first_order: fits && first_order.is_some_and(|accuracy| is_far(accuracy.mfe)),
            off,
            stray,
        }
    }
}

/// Mean and largest of the distances of all but the stray points.
pub(super) fn without(distances: &[f64], stray: &[usize]) -> Option<FitAccuracy> {
    let kept = distances.iter().enumerate();
    let kept = kept.filter(|(place, _)| stray.binary_search(place).is_err());
    accuracy(kept.map(|(_, &distance)| distance))
}
