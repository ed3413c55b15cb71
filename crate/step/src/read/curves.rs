//! Curves of the file.

use fit4cad::cloud::Point;
use step_io::parser::Attribute;

use super::{DEEPEST, Reader, too_deep};
use crate::error::{Got, Trouble};
use crate::file::{Fields, number, reference};
use crate::geometry::curve::Curve;
use crate::geometry::spline::{Knots, SplineCurve};
use crate::placement::{Motion, vector};

/// Every curve with control points, before what it adds of its own.
const SPLINES: [&str; 5] = [
    "B_SPLINE_CURVE_WITH_KNOTS",
    "BEZIER_CURVE",
    "QUASI_UNIFORM_CURVE",
    "UNIFORM_CURVE",
    "B_SPLINE_CURVE",
];

impl Reader<'_> {
    /// Reads a curve.
    pub fn curve(&self, id: u64) -> Got<Curve> {
        self.curve_within(id, 0)
    }

    fn curve_within(&self, id: u64, depth: usize) -> Got<Curve> {
        if depth > DEEPEST {
            return Err(too_deep(id));
        }
        let file = self.file;
        if SPLINES.iter().any(|name| file.is(id, name)) {
            return self.spline_curve(id);
        }
        let is = |name| file.is(id, name);
        let fields = file.fields(id)?;
        let inner = |place| self.curve_within(fields.reference(place)?, depth + 1);
        if is("LINE") {
            let direction = vector(file, fields.reference(2)?)? * self.units.length;
            let origin = self.point(fields.reference(1)?)?;
            if direction.norm() <= 0.0 {
                return Err(Trouble::new(id, "is a line without a direction"));
            }
            return Ok(Curve::Line(origin, direction));
        }
        let unit = self.units.length;
        if is("CIRCLE") {
            let radius = fields.length(2)? * unit;
            return Ok(Curve::Ellipse(
                self.frame(fields.reference(1)?)?,
                radius,
                radius,
            ));
        }
        if is("ELLIPSE") {
            let (a, b) = (fields.length(2)? * unit, fields.length(3)? * unit);
            return Ok(Curve::Ellipse(self.frame(fields.reference(1)?)?, a, b));
        }
        if is("PARABOLA") {
            let focal = fields.length(2)? * unit;
            return Ok(Curve::Parabola(self.frame(fields.reference(1)?)?, focal));
        }
        if is("HYPERBOLA") {
            let (a, b) = (fields.length(2)? * unit, fields.length(3)? * unit);
            return Ok(Curve::Hyperbola(self.frame(fields.reference(1)?)?, a, b));
        }
        if is("POLYLINE") {
            let points = self.points(&fields.references(1)?)?;
            if points.len() < 2 {
                return Err(Trouble::new(id, "is a polyline of fewer than two points"));
            }
            return Ok(Curve::Polyline(points));
        }
        if is("TRIMMED_CURVE") {
            let basis = inner(1)?;
            let range = self.trims(&fields, &basis)?;
            return Ok(Curve::Joined(vec![(basis, range)]));
        }
        if is("COMPOSITE_CURVE") || is("COMPOSITE_CURVE_ON_SURFACE") || is("BOUNDARY_CURVE") {
            return self.composite(&fields, depth);
        }
        if is("OFFSET_CURVE_3D") {
            let direction = self.direction(fields.reference(4)?)?;
            return Ok(Curve::Offset(
                Box::new(inner(1)?),
                fields.number(2)? * unit,
                direction,
            ));
        }
        if is("CURVE_REPLICA") {
            let motion = Motion::read_operator(file, fields.reference(2)?, unit)?;
            return Ok(inner(1)?.moved(&motion));
        }
        let surface_curve = [
            "SURFACE_CURVE",
            "SEAM_CURVE",
            "INTERSECTION_CURVE",
            "BOUNDED_SURFACE_CURVE",
        ];
        if surface_curve.iter().any(|name| is(name)) {
            return inner(1);
        }
        Err(Trouble::new(
            id,
            format!("is {}, a curve that is not read", file.name(id)),
        ))
    }

    /// From which parameter of its basis to which a trimmed curve goes.
    fn trims(&self, fields: &Fields<'_>, basis: &Curve) -> Got<[f64; 2]> {
        let by_parameter = fields.word(5) == Some("PARAMETER");
        let one = |place: usize| -> Got<f64> {
            let items = fields.list(place)?;
            let parameter = items.iter().find_map(|it| match it {
                Attribute::EntityRef(_) => None,
                other => number(other),
            });
            let parameter = parameter.map(|value| match basis {
                Curve::Ellipse(..) => value * self.units.angle,
                _ => value,
            });
            let place = items.iter().find_map(reference);
            let at_place = || {
                place
                    .map(|id| Ok(basis.parameter(&self.point(id)?)))
                    .transpose()
            };
            let found = match (by_parameter, parameter) {
                (true, Some(value)) => Some(value),
                (_, other) => at_place()?.or(other),
            };
            found.ok_or_else(|| {
                Trouble::new(fields.id, "is trimmed at neither a point nor a parameter")
            })
        };
        let (from, mut to) = (one(2)?, one(3)?);
        let forward = fields.flag(4) != Some(false);
        if let Some(period) = basis.period() {
            let turns = ((to - from) / period).floor();
            to -= period * turns;
            if to - from < 1e-9 * period {
                to += period;
            }
            if !forward {
                to -= period;
                if from - to < 1e-9 * period {
                    to -= period;
                }
            }
        }
        if from == to {
            return Err(Trouble::new(fields.id, "is trimmed to nothing"));
        }
        Ok([from, to])
    }

    fn composite(&self, fields: &Fields<'_>, depth: usize) -> Got<Curve> {
        let mut pieces = Vec::new();
        for segment in fields.references(1)? {
            let own = self.file.fields(segment)?;
            let curve = self.curve_within(own.reference(2)?, depth + 1)?;
            let range = curve.range().ok_or_else(|| {
                Trouble::new(segment, "is a piece of a composite curve without ends")
            })?;
            let [from, to] = range;
            let forward = own.flag(1) != Some(false);
            pieces.push((curve, if forward { [from, to] } else { [to, from] }));
        }
        if pieces.is_empty() {
            return Err(Trouble::new(
                fields.id,
                "is a composite curve without pieces",
            ));
        }
        Ok(Curve::Joined(pieces))
    }

    fn spline_curve(&self, id: u64) -> Got<Curve> {
        let file = self.file;
        // Written as one, every kind has the name, then the five attributes of the general one.
        let own = SPLINES
            .iter()
            .find(|name| file.is(id, name) && file.types(id).count() == 1);
        let general = match own {
            Some(name) => file.part(id, name, 1),
            None => file.part(id, "B_SPLINE_CURVE", 1),
        };
        let general = general.ok_or_else(|| Trouble::new(id, "has no control points"))?;
        let degree = degree(&general, 0)?;
        let points: Vec<Point> = self.points(&general.references(1)?)?;
        let knots = match file.part(id, "B_SPLINE_CURVE_WITH_KNOTS", 6) {
            Some(own) => Knots::repeated(&own.numbers(1)?, &multiplicities(&own, 0)?),
            None => uniform(
                degree,
                points.len(),
                file.is(id, "UNIFORM_CURVE"),
                file.is(id, "BEZIER_CURVE"),
            ),
        };
        let knots = Knots::new(degree, knots, points.len()).map_err(|why| Trouble::new(id, why))?;
        let weights = match file.part(id, "RATIONAL_B_SPLINE_CURVE", usize::MAX) {
            Some(own) => own.numbers(0)?,
            None => vec![1.0; points.len()],
        };
        check_weights(id, &weights, points.len())?;
        Ok(Curve::Spline(SplineCurve::new(knots, &points, &weights)))
    }
}

/// A degree that can be one.
pub(super) fn degree(fields: &Fields<'_>, place: usize) -> Got<usize> {
    let value = fields.number(place)?;
    if (1.0..=64.0).contains(&value) && value.fract() == 0.0 {
        Ok(value as usize)
    } else {
        Err(Trouble::new(fields.id, format!("has degree {value}")))
    }
}

/// How often each knot counts.
pub(super) fn multiplicities(fields: &Fields<'_>, place: usize) -> Got<Vec<usize>> {
    let values = fields.numbers(place)?;
    Ok(values
        .into_iter()
        .map(|value| value.max(0.0) as usize)
        .collect())
}

/// Knots of the kinds that write none: evenly spaced, with the ends repeated but for uniform ones, and
/// inner ones as often as the degree for Bézier's.
pub(super) fn uniform(degree: usize, count: usize, open: bool, bezier: bool) -> Vec<f64> {
    let total = count + degree + 1;
    let value = |k: usize| {
        if open {
            k as f64 - degree as f64
        } else if bezier {
            (k.saturating_sub(1) / degree).min((count - 1) / degree) as f64
        } else {
            (k.saturating_sub(degree)).min(count.saturating_sub(degree)) as f64
        }
    };
    (0..total).map(value).collect()
}

/// Whether there are as many weights as points, all greater than zero.
pub(super) fn check_weights(id: u64, weights: &[f64], count: usize) -> Got<()> {
    if weights.len() != count {
        let reason = format!("has {} weights for {count} control points", weights.len());
        return Err(Trouble::new(id, reason));
    }
    if weights.iter().all(|&weight| weight > 0.0) {
        Ok(())
    } else {
        Err(Trouble::new(
            id,
            "has weights that are not greater than zero",
        ))
    }
}
