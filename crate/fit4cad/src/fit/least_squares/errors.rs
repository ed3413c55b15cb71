//! How well points determine the surface they are on: a standard error for each of its parameters.
//!
//! To first order the parameters of a least-squares surface scatter as (JᵀJ)⁻¹ s², with J the derivatives of the distances
//! by the coordinates of the chart and s² the variance that the points show, and what follows from those
//! coordinates scatters as its derivatives by them say. Both are taken over the points that are on the surface: what
//! Tukey's biweight passes over says nothing, and the rest as much as it does in such a fit (Huber 1981, section 7.6).

use nalgebra::{DMatrix, DVector, SVector};

use super::charts::{Chart, ConeChart, CylinderChart, SphereChart, TorusChart};
use super::{Frame, Loss};
use crate::cloud::{Cloud, Direction, Point, Vector};
use crate::fit::quantile::quantile;
use crate::model::Primitive;
use crate::surface::{Plane, Surface, across};

/// Standard deviations of normal noise beyond which a point has no say: 95 % as efficient as least squares (Huber 1981).
pub const BIWEIGHT: f64 = 4.685;
/// Standard deviation of normal noise over the median of its absolute value.
const MEDIAN: f64 = 1.4826;
/// Step of the differences by a coordinate of a chart, whose unit is the size of the patch.
const STEP: f64 = 1e-6;
/// Eigenvalue of the correlations of the coordinates, and share of a parameter's derivative along it, from which on the points
/// say nothing of the one and the other hangs on it: squares of what is left of 16 digits after differences.
const SINGULAR: f64 = 1e-13;
const HANGS_ON: f64 = 1e-12;

/// How far the parameters of a surface may be off by chance alone: standard errors, as the points of a primitive
/// show them. A direction or a position has one number, the root mean square of how far it is off. `None` where the
/// surface has no such parameter, or the points do not determine it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct StandardErrors {
    /// Angle, in radians, by which the axis of a surface or the normal of a plane is off.
    pub axis: Option<f64>,
    /// Distance by which the position is off: a sphere's and a torus's centre, a cone's apex, the axis of a
    /// cylinder and a plane where they pass the middle of the points.
    pub position: Option<f64>,
    /// Of the offset of a plane, its distance from the origin: where that is far off, more than that of its position.
    pub offset: Option<f64>,
    /// Of the radius; of a torus, the major one.
    pub radius: Option<f64>,
    /// Of the minor radius of a torus.
    pub minor_radius: Option<f64>,
    /// Of the half-angle of a cone, in radians.
    pub half_angle: Option<f64>,
}

impl StandardErrors {
    /// Names of all, as results have them, with the unit: empty where it is the cloud's.
    pub const NAMES: [(&'static str, &'static str); 6] = [
        ("axis", "rad"),
        ("position", ""),
        ("offset", ""),
        ("radius", ""),
        ("minorRadius", ""),
        ("halfAngle", "rad"),
    ];

    /// All, in the order of [`StandardErrors::NAMES`].
    pub const fn values(&self) -> [Option<f64>; 6] {
        [
            self.axis,
            self.position,
            self.offset,
            self.radius,
            self.minor_radius,
            self.half_angle,
        ]
    }

    /// Those of the surface of a primitive by its points; all are missing where it has no surface.
    pub fn of_primitive(cloud: &Cloud, primitive: &Primitive) -> Self {
        let Some(surface) = &primitive.surface else {
            return Self::default();
        };
        let all = cloud.points();
        let listed = primitive.points.iter();
        let points = listed.filter_map(|&index| all.get(index as usize).copied());
        Self::of(surface, &points.collect::<Vec<_>>())
    }

    /// Those of a surface by points that it has been fitted to. All are missing where there are no more points than
    /// degrees of freedom. O(points).
    ///
    /// ```
    /// use fit4cad::cloud::{Point, Vector};
    /// use fit4cad::fit::least_squares::StandardErrors;
    /// use fit4cad::surface::{Plane, Surface};
    /// // Rows of points that are a tenth above and below a plane by turns.
    /// let points = (0..100).map(|i| Point::new(f64::from(i / 10), f64::from(i % 10), 0.1 * f64::from(1 - 2 * (i % 2))));
    /// let points: Vec<Point> = points.collect();
    /// let plane = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
    /// let errors = StandardErrors::of(&plane, &points);
    /// // That of their mean, and a tenth for guarding against outliers.
    /// assert!((errors.position.unwrap() / (0.1 / 100f64.sqrt()) - 1.1).abs() < 0.05);
    /// assert_eq!(errors.radius, None);
    /// ```
    pub fn of(surface: &Surface, points: &[Point]) -> Self {
        let finite = points.iter().filter(|it| it.iter().all(|x| x.is_finite()));
        let finite: Vec<Point> = finite.copied().collect();
        let Some(frame) = Frame::of(&finite) else {
            return Self::default();
        };
        let local: Vec<Vector> = finite.iter().map(|point| frame.enter(point)).collect();
        let errors = match frame.enter_surface(surface) {
            Surface::Plane(shape) => of_chart(PlaneChart::new(&shape), &local, &frame),
            Surface::Cylinder(shape) => of_chart(CylinderChart::new(&shape), &local, &frame),
            Surface::Cone(shape) => of_chart(ConeChart::new(&shape, &local), &local, &frame),
            Surface::Sphere(shape) => of_chart(SphereChart::new(&shape), &local, &frame),
            Surface::Torus(shape) => of_chart(TorusChart::new(&shape, &local), &local, &frame),
        };
        errors.unwrap_or_default()
    }
}

/// Those of a surface in the frame, for the outside.
fn of_chart<const N: usize>(
    chart: impl Chart<N>,
    points: &[Vector],
    frame: &Frame,
) -> Option<StandardErrors> {
    let coordinates = Scatter::of(&chart, points)?;
    let of = |quantity: &dyn Fn(&Quantities) -> Option<Vector>| {
        let gradients = gradients(&chart, quantity)?;
        let variances = gradients.iter().map(|it| coordinates.variance(it));
        let variances: Vec<f64> = variances.collect::<Option<_>>()?;
        Some(variances.iter().sum::<f64>().sqrt()).filter(|it| it.is_finite())
    };
    let number = |value: Option<f64>| value.map(|value| Vector::new(value, 0.0, 0.0));
    let length = |error: Option<f64>| error.map(|error| error * frame.scale);
    let origin = frame.origin.coords / frame.scale;
    Some(StandardErrors {
        axis: of(&|it| it.axis),
        position: length(of(&|it| it.position)),
        offset: length(of(&|it| {
            let normal = it.axis?;
            number(it.offset.map(|offset| offset + normal.dot(&origin)))
        })),
        radius: length(of(&|it| number(it.radius))),
        minor_radius: length(of(&|it| number(it.minor_radius))),
        half_angle: of(&|it| number(it.half_angle)),
    })
}

/// What a surface is told by.
#[derive(Clone, Copy, Default)]
struct Quantities {
    axis: Option<Vector>,
    position: Option<Vector>,
    offset: Option<f64>,
    radius: Option<f64>,
    minor_radius: Option<f64>,
    half_angle: Option<f64>,
}

impl Quantities {
    /// Of a surface in the frame, whose origin is the middle of the points. Of the two signs of an axis it has the one
    /// nearer to another.
    fn of(surface: &Surface, near: Option<&Self>) -> Self {
        let sign = |axis: Direction| {
            let axis = axis.into_inner();
            let other = near.and_then(|it| it.axis);
            let is_other = other.is_some_and(|other| other.dot(&axis) < 0.0);
            if is_other { -1.0 } else { 1.0 }
        };
        match *surface {
            Surface::Plane(it) => {
                let (normal, sign) = (it.normal.into_inner(), sign(it.normal));
                Self {
                    axis: Some(normal * sign),
                    position: Some(normal * it.offset),
                    offset: Some(it.offset * sign),
                    ..Self::default()
                }
            }
            Surface::Cylinder(it) => Self {
                axis: Some(it.axis.into_inner() * sign(it.axis)),
                position: Some(it.centre.coords),
                radius: Some(it.radius),
                ..Self::default()
            },
            Surface::Cone(it) => Self {
                axis: Some(it.axis.into_inner() * sign(it.axis)),
                position: Some(it.apex.coords),
                half_angle: Some(it.half_angle),
                ..Self::default()
            },
            Surface::Sphere(it) => Self {
                position: Some(it.centre.coords),
                radius: Some(it.radius),
                ..Self::default()
            },
            Surface::Torus(it) => Self {
                axis: Some(it.axis.into_inner() * sign(it.axis)),
                position: Some(it.centre.coords),
                radius: Some(it.major_radius),
                minor_radius: Some(it.minor_radius),
                ..Self::default()
            },
        }
    }
}

/// The derivatives of the three components of a quantity by the coordinates of a chart.
fn gradients<const N: usize>(
    chart: &impl Chart<N>,
    quantity: &dyn Fn(&Quantities) -> Option<Vector>,
) -> Option<[SVector<f64, N>; 3]> {
    let middle = Quantities::of(&chart.surface()?, None);
    quantity(&middle)?;
    let mut gradients = [SVector::<f64, N>::zeros(); 3];
    for coordinate in 0..N {
        let at = |step: f64| {
            let mut steps = SVector::<f64, N>::zeros();
            steps[coordinate] = step;
            quantity(&Quantities::of(
                &chart.moved(&steps).surface()?,
                Some(&middle),
            ))
        };
        let difference = (at(STEP)? - at(-STEP)?) / (2.0 * STEP);
        for (gradient, slope) in gradients.iter_mut().zip(difference.iter()) {
            gradient[coordinate] = *slope;
        }
    }
    Some(gradients)
}

/// How the coordinates of a chart scatter: their variances along directions in which they do so without each other.
struct Scatter {
    /// What the coordinates are divided by first: the root of what the points say of each alone.
    weights: DVector<f64>,
    directions: DMatrix<f64>,
    eigenvalues: DVector<f64>,
    variance: f64,
}

impl Scatter {
    fn of<const N: usize>(chart: &impl Chart<N>, points: &[Vector]) -> Option<Self> {
        let rows: Vec<f64> = points.iter().map(|point| chart.distance(point).0).collect();
        let left = |count: usize| count.checked_sub(N).filter(|&left| left > 0);
        let mut absolute: Vec<f64> = rows.iter().map(|distance| distance.abs()).collect();
        let spare = (points.len() as f64 / left(points.len())? as f64).sqrt();
        let deviation = MEDIAN * quantile(&mut absolute, 0.5) * spare;
        let loss = if deviation > 0.0 {
            Loss::Biweight(BIWEIGHT * deviation)
        } else {
            Loss::Squares
        };
        let mut normal = DMatrix::<f64>::zeros(N, N);
        let (mut squares, mut slopes, mut count) = (0.0, 0.0, 0usize);
        for (point, distance) in points.iter().zip(rows) {
            let weight = loss.weight(distance);
            if weight <= 0.0 {
                continue;
            }
            let row = chart.distance(point).1;
            for j in 0..N {
                for i in 0..N {
                    normal[(i, j)] += row[i] * row[j];
                }
            }
            squares += (weight * distance).powi(2);
            slopes += loss.slope(distance);
            count += 1;
        }
        let slope = slopes / count as f64;
        let variance = squares / left(count)? as f64 / (slope * slope);
        let weights = normal
            .diagonal()
            .map(|it| if it > 0.0 { 1.0 / it.sqrt() } else { 0.0 });
        let correlated = DMatrix::from_fn(N, N, |i, j| normal[(i, j)] * weights[i] * weights[j]);
        let is_finite = variance.is_finite() && correlated.iter().all(|it| it.is_finite());
        let eigen = is_finite.then(|| correlated.symmetric_eigen())?;
        Some(Self {
            weights,
            directions: eigen.eigenvectors,
            eigenvalues: eigen.eigenvalues,
            variance,
        })
    }

    /// The variance of what has these derivatives by the coordinates; `None` where the points do not determine it.
    fn variance<const N: usize>(&self, gradient: &SVector<f64, N>) -> Option<f64> {
        let is_lost = |i: usize| self.weights[i] == 0.0 && gradient[i].abs() > STEP;
        if (0..N).any(is_lost) {
            return None;
        }
        let scaled = DVector::from_fn(N, |i, _| gradient[i] * self.weights[i]);
        let mut sum = 0.0;
        for (direction, &eigenvalue) in self.directions.column_iter().zip(&self.eigenvalues) {
            let share = direction.dot(&scaled).powi(2);
            if eigenvalue > SINGULAR {
                sum += share / eigenvalue;
            } else if share > HANGS_ON * scaled.norm_squared() {
                return None;
            }
        }
        Some(sum * self.variance)
    }
}

/// Distance from the origin and two tilts about the point there.
#[derive(Clone, Copy)]
struct PlaneChart {
    normal: Vector,
    offset: f64,
    tilts: [Vector; 2],
}

impl PlaneChart {
    fn new(plane: &Plane) -> Self {
        let first = across(&plane.normal).into_inner();
        let normal = plane.normal.into_inner();
        Self {
            normal,
            offset: plane.offset,
            tilts: [first, normal.cross(&first)],
        }
    }
}

impl Chart<3> for PlaneChart {
    fn distance(&self, point: &Vector) -> (f64, SVector<f64, 3>) {
        let [first, second] = self.tilts.map(|tilt| tilt.dot(point));
        let distance = self.normal.dot(point) - self.offset;
        (distance, [-1.0, first, second].into())
    }

    fn moved(&self, step: &SVector<f64, 3>) -> Self {
        let tilted = self.normal + self.tilts[0] * step[1] + self.tilts[1] * step[2];
        let normal = Direction::new_normalize(tilted);
        let point = Point::from(normal.into_inner() * (self.offset + step[0]));
        Self::new(&Plane::new(point, normal.into_inner()))
    }

    fn surface(&self) -> Option<Surface> {
        let point = Point::from(self.normal * self.offset);
        let plane = Plane::new(point, self.normal);
        plane.offset.is_finite().then_some(Surface::Plane(plane))
    }
}

#[cfg(test)]
mod tests;
