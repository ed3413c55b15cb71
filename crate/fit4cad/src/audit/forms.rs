//! Measuring the forms of one primitive against its points and each other.

use super::DISTANCE_LIMIT;
use crate::cloud::{Bounds, Cloud, Point};
use crate::metrics::accuracy::FitAccuracy;
use crate::model::Primitive;
use crate::surface::{Conversion, ConversionError, Form, Polynomial, Surface, SurfaceType};

/// One form against the points.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FormAudit {
    /// Mean and largest distance of the points, over the diagonal of their bounding box; `None`
    /// where there are no points or the vector is no surface at all.
    pub accuracy: Option<FitAccuracy>,
    /// How far the vector is from a surface of its type, see [`Conversion::misfit`]; `∞` where
    /// there is none near.
    pub misfit: f64,
    /// Whether the distances are Euclidean ones to that surface; else the vector is none of its
    /// type, and they are first-order ones to its zero set.
    pub euclidean: bool,
}

/// The measurements of one primitive.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PrimitiveAudit {
    /// Its number.
    pub number: u32,
    /// Its type, where it is one of the five.
    pub kind: Option<SurfaceType>,
    /// How many points it lists.
    pub points: usize,
    /// How many of them lie within [`DISTANCE_LIMIT`] of no form; 0 where there is no form.
    pub off: usize,
    /// The parametric form.
    pub parametric: Option<FormAudit>,
    /// The implicit form.
    pub implicit: Option<FormAudit>,
    /// The implicit form by first-order distances |f| / |∇f| (Taubin 1991), which no conversion
    /// goes into; they are too large near an apex, where the gradient vanishes.
    pub first_order: Option<FitAccuracy>,
    /// Largest distance of one form to the other over the feet of the points, over the diagonal.
    pub agreement: Option<f64>,
}

/// One form, measured.
#[derive(Debug, Clone)]
pub(super) struct MeasuredForm {
    pub(super) form: Form,
    /// Distance of each point over the diagonal; empty where the vector is no surface at all.
    pub(super) distances: Vec<f64>,
    pub(super) misfit: f64,
    /// The surface, if the vector is one of its type.
    pub(super) surface: Option<Surface>,
    /// Why there is no surface anywhere near.
    pub(super) defect: Option<ConversionError>,
}

/// The forms of one primitive, measured.
#[derive(Debug, Clone)]
pub(super) struct Measured {
    pub(super) forms: Vec<MeasuredForm>,
    pub(super) first_order: Vec<f64>,
    /// Distance of the forms at each point over the diagonal, empty without two forms.
    pub(super) apart: Vec<f64>,
}

/// Measures both forms of a primitive. O(points).
pub(super) fn measure(cloud: &Cloud, primitive: &Primitive) -> Measured {
    let patch = Patch::new(cloud, &primitive.points);
    let mut measured = Measured {
        forms: Vec::new(),
        first_order: Vec::new(),
        apart: Vec::new(),
    };
    let Some(kind) = primitive.kind else {
        return measured;
    };
    let zero_set = primitive
        .implicit
        .values()
        .and_then(|values| ZeroSet::new(kind, values));
    for form in Form::ALL {
        if let Some(values) = primitive.coefficients(form).values() {
            let conversion = Surface::from_form(form, kind, values);
            let zero_set = zero_set.as_ref().filter(|_| form == Form::Implicit);
            let form = measured_form(form, &conversion, zero_set, &patch);
            measured.forms.push(form);
        }
    }
    if let Some(zero_set) = &zero_set {
        measured.first_order = patch.distances(|point| zero_set.distance(point));
    }
    if let [parametric, implicit] = measured.forms.as_slice() {
        measured.apart = apart(parametric, implicit, zero_set.as_ref(), &patch);
    }
    measured
}

fn measured_form(
    form: Form,
    conversion: &Result<Conversion, ConversionError>,
    zero_set: Option<&ZeroSet>,
    patch: &Patch<'_>,
) -> MeasuredForm {
    let misfit = conversion.as_ref().map_or(f64::INFINITY, |c| c.misfit);
    let nearest = conversion.as_ref().ok().map(|c| c.surface);
    let surface = nearest.filter(|_| misfit <= Conversion::TOLERANCE);
    let distances = match (&surface, zero_set, &nearest) {
        (Some(surface), ..) => patch.distances(|point| surface.distance(point)),
        (None, Some(zero_set), _) => patch.distances(|point| zero_set.distance(point)),
        (None, None, Some(nearest)) => patch.distances(|point| nearest.distance(point)),
        (None, None, None) => Vec::new(),
    };
    MeasuredForm {
        form,
        distances,
        misfit,
        surface,
        defect: conversion.as_ref().err().copied(),
    }
}

/// Distance of the two forms at each point: from the point's foot on either to the other. Where the
/// implicit form is no surface of its type, from the parametric foot to its zero set.
fn apart(
    parametric: &MeasuredForm,
    implicit: &MeasuredForm,
    zero_set: Option<&ZeroSet>,
    patch: &Patch<'_>,
) -> Vec<f64> {
    match (&parametric.surface, &implicit.surface, zero_set) {
        (Some(first), Some(second), _) => patch.distances(|point| {
            let there = second.distance(&first.foot(point));
            let back = first.distance(&second.foot(point));
            larger(there, back)
        }),
        (Some(first), None, Some(zero_set)) => {
            patch.distances(|point| zero_set.distance(&first.foot(point)))
        }
        _ => Vec::new(),
    }
}

impl Measured {
    pub(super) fn summary(&self, primitive: &Primitive) -> PrimitiveAudit {
        let of = |form: Form| {
            let measured = self.forms.iter().find(|measured| measured.form == form);
            measured.map(|measured| FormAudit {
                accuracy: accuracy(measured.distances.iter().copied()),
                misfit: measured.misfit,
                euclidean: measured.surface.is_some(),
            })
        };
        PrimitiveAudit {
            number: primitive.number,
            kind: primitive.kind,
            points: primitive.points.len(),
            off: self.off().len(),
            parametric: of(Form::Parametric),
            implicit: of(Form::Implicit),
            first_order: accuracy(self.first_order.iter().copied()),
            agreement: accuracy(self.apart.iter().copied()).map(|apart| apart.d_haus),
        }
    }

    /// Positions in the point list of the points that are off every form.
    pub(super) fn off(&self) -> Vec<usize> {
        let measured = self.forms.iter().filter(|form| !form.distances.is_empty());
        let Some(points) = measured.clone().map(|form| form.distances.len()).min() else {
            return Vec::new();
        };
        let is_off = |place: &usize| {
            let mut distances = measured.clone().map(|form| form.distances.get(*place));
            distances.all(|distance| distance.is_some_and(|&distance| is_far(distance)))
        };
        (0..points).filter(is_off).collect()
    }
}

/// Whether a distance is above the limit, or none.
pub(super) fn is_far(distance: f64) -> bool {
    distance.is_nan() || distance > DISTANCE_LIMIT
}

/// Mean and largest of some distances; `None` of no distances.
pub(super) fn accuracy(distances: impl Iterator<Item = f64>) -> Option<FitAccuracy> {
    let (mut sum, mut largest, mut count) = (0.0, 0.0, 0u32);
    for distance in distances {
        sum += distance;
        largest = larger(largest, distance);
        count += 1;
    }
    (count > 0).then(|| FitAccuracy {
        mfe: sum / f64::from(count),
        d_haus: largest,
    })
}

/// The larger; unlike `f64::max`, NaN if either is.
fn larger(a: f64, b: f64) -> f64 {
    if b > a || b.is_nan() { b } else { a }
}

/// The points of a primitive and the length by which they are measured.
pub(super) struct Patch<'a> {
    points: Vec<&'a Point>,
    diagonal: f64,
}

impl<'a> Patch<'a> {
    /// The points with these indices; others are left out. Where they all coincide the cloud's
    /// diagonal takes the place of theirs, as in the accuracy measures.
    pub(super) fn new(cloud: &'a Cloud, indices: &[u32]) -> Self {
        let points: Vec<&Point> = indices
            .iter()
            .filter_map(|&index| cloud.points().get(index as usize))
            .collect();
        let diagonal = cloud.length_of(&Bounds::of(points.iter().copied()));
        Self { points, diagonal }
    }

    /// A distance of each point over the diagonal; 0 where the distance is.
    pub(super) fn distances(&self, distance: impl Fn(&Point) -> f64) -> Vec<f64> {
        let relative = |point: &&Point| {
            let distance = distance(point);
            if distance == 0.0 {
                0.0
            } else {
                distance / self.diagonal
            }
        };
        self.points.iter().map(relative).collect()
    }
}

/// The zero set of an implicit form, for points near it.
struct ZeroSet {
    polynomial: Polynomial,
    /// The same with the absolute values of the coefficients, to bound rounding.
    bound: Polynomial,
}

impl ZeroSet {
    fn new(kind: SurfaceType, values: &[f64]) -> Option<Self> {
        let polynomial = Polynomial::from_implicit(kind, values)?;
        let absolute = polynomial.coefficients().iter().map(|c| c.abs()).collect();
        let bound = Polynomial::new(polynomial.degree(), absolute)?;
        Some(Self { polynomial, bound })
    }

    /// First-order distance |f| / |∇f|; 0 where f is within its rounding error, be the gradient
    /// what it may (an apex).
    fn distance(&self, point: &Point) -> f64 {
        const ROUNDING: f64 = 64.0 * f64::EPSILON;
        let (value, gradient) = self.polynomial.evaluate(point);
        let (bound, _) = self.bound.evaluate(&Point::from(point.coords.abs()));
        if value.abs() <= ROUNDING * bound {
            0.0
        } else {
            value.abs() / gradient.norm()
        }
    }
}
