//! B-spline curves and surfaces, rational or not.

use fit4cad::cloud::{Point, Vector};

/// Highest degree that is evaluated; what CAD systems write is at most 25.
const MAX_DEGREE: usize = 32;

/// The knots of one direction.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Knots {
    degree: usize,
    /// Every knot as often as its multiplicity says: `count + degree + 1` of them.
    knots: Vec<f64>,
    /// How many control points.
    count: usize,
}

/// The basis functions that are not zero at a parameter, and their derivatives.
struct Basis {
    first: usize,
    values: [f64; MAX_DEGREE + 1],
    slopes: [f64; MAX_DEGREE + 1],
}

impl Knots {
    /// Knots that fit `count` control points and rise.
    pub fn new(degree: usize, knots: Vec<f64>, count: usize) -> Result<Self, String> {
        if degree == 0 || degree > MAX_DEGREE {
            return Err(format!("has degree {degree}; 1 to {MAX_DEGREE} is read"));
        }
        if count <= degree {
            return Err(format!("has {count} control points for degree {degree}"));
        }
        if knots.len() != count + degree + 1 {
            let expected = count + degree + 1;
            return Err(format!("has {} knots where {expected} belong", knots.len()));
        }
        if knots.windows(2).any(|pair| pair[0] > pair[1]) {
            return Err("has knots that fall".to_owned());
        }
        let knots = Self {
            degree,
            knots,
            count,
        };
        let [from, to] = knots.range();
        if from < to {
            Ok(knots)
        } else {
            Err("has knots without a range".to_owned())
        }
    }

    /// Knots as the file writes them: each once, with its multiplicity.
    pub fn repeated(values: &[f64], multiplicities: &[usize]) -> Vec<f64> {
        // More than any control points need: a multiplicity of a billion is a fault.
        let pairs = values.iter().zip(multiplicities);
        pairs
            .flat_map(|(value, &times)| std::iter::repeat_n(*value, times.min(4 * MAX_DEGREE)))
            .collect()
    }

    /// The range of the parameter.
    pub fn range(&self) -> [f64; 2] {
        [self.knots[self.degree], self.knots[self.count]]
    }

    /// The distinct knots within the range, both ends included.
    pub fn breaks(&self) -> Vec<f64> {
        let [from, to] = self.range();
        let mut breaks = self.knots.clone();
        breaks.retain(|knot| (from..=to).contains(knot));
        breaks.dedup();
        breaks
    }

    /// The degree.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Cox and de Boor, after Piegl and Tiller's algorithms A2.1 to A2.3. O(degree²).
    fn basis(&self, t: f64) -> Basis {
        let (p, knots) = (self.degree, &self.knots);
        let [from, to] = self.range();
        let t = t.clamp(from, to);
        let after = knots[p + 1..=self.count].partition_point(|&knot| knot <= t);
        let mut span = (p + after).min(self.count - 1);
        while span > p && knots[span] >= knots[span + 1] {
            span -= 1;
        }
        let mut values = [0.0; MAX_DEGREE + 1];
        let mut lower = [0.0; MAX_DEGREE + 1];
        let (mut left, mut right) = ([0.0; MAX_DEGREE + 1], [0.0; MAX_DEGREE + 1]);
        values[0] = 1.0;
        for j in 1..=p {
            if j == p {
                lower[..p].copy_from_slice(&values[..p]);
            }
            left[j] = t - knots[span + 1 - j];
            right[j] = knots[span + j] - t;
            let mut saved = 0.0;
            for r in 0..j {
                let width = right[r + 1] + left[j - r];
                let share = if width > 0.0 { values[r] / width } else { 0.0 };
                values[r] = saved + right[r + 1] * share;
                saved = left[j - r] * share;
            }
            values[j] = saved;
        }
        let first = span - p;
        let mut slopes = [0.0; MAX_DEGREE + 1];
        for (r, slope) in slopes.iter_mut().enumerate().take(p + 1) {
            let share = |index: usize, value: f64| {
                let width = knots[index + p] - knots[index];
                if width > 0.0 {
                    p as f64 * value / width
                } else {
                    0.0
                }
            };
            if r > 0 {
                *slope += share(first + r, lower[r - 1]);
            }
            if r < p {
                *slope -= share(first + r + 1, lower[r]);
            }
        }
        Basis {
            first,
            values,
            slopes,
        }
    }
}

/// A control point times its weight, and the weight.
pub(crate) type Weighted = [f64; 4];

fn weighted(point: &Point, weight: f64) -> Weighted {
    [point.x * weight, point.y * weight, point.z * weight, weight]
}

fn add(sum: &mut Weighted, item: &Weighted, by: f64) {
    for (sum, item) in sum.iter_mut().zip(item) {
        *sum += by * item;
    }
}

fn place(sum: &Weighted) -> Point {
    Point::new(sum[0], sum[1], sum[2]) / sum[3]
}

/// The derivative of a quotient.
fn slope(sum: &Weighted, slope: &Weighted) -> Vector {
    let at = place(sum).coords;
    (Vector::new(slope[0], slope[1], slope[2]) - at * slope[3]) / sum[3]
}

/// A B-spline curve.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SplineCurve {
    pub knots: Knots,
    pub(super) points: Vec<Weighted>,
}

impl SplineCurve {
    /// A curve of control points with weights greater than zero.
    pub fn new(knots: Knots, points: &[Point], weights: &[f64]) -> Self {
        let points = points.iter().zip(weights);
        Self {
            knots,
            points: points
                .map(|(point, weight)| weighted(point, *weight))
                .collect(),
        }
    }

    /// Place and derivative at a parameter.
    pub fn at(&self, t: f64) -> (Point, Vector) {
        let basis = self.knots.basis(t);
        let (mut sum, mut change) = ([0.0; 4], [0.0; 4]);
        for k in 0..=self.knots.degree {
            let control = &self.points[basis.first + k];
            add(&mut sum, control, basis.values[k]);
            add(&mut change, control, basis.slopes[k]);
        }
        (place(&sum), slope(&sum, &change))
    }
}

/// A B-spline surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct SplineSurface {
    pub u: Knots,
    pub v: Knots,
    /// Row by row: those of one place in u follow one another.
    pub(super) points: Vec<Weighted>,
}

impl SplineSurface {
    /// A surface of rows of control points with weights greater than zero.
    pub fn new(u: Knots, v: Knots, points: &[Point], weights: &[f64]) -> Self {
        let points = points.iter().zip(weights);
        Self {
            u,
            v,
            points: points
                .map(|(point, weight)| weighted(point, *weight))
                .collect(),
        }
    }

    /// Place and both derivatives.
    pub fn at(&self, u: f64, v: f64) -> (Point, Vector, Vector) {
        let (along_u, along_v) = (self.u.basis(u), self.v.basis(v));
        let (mut sum, mut change_u, mut change_v) = ([0.0; 4], [0.0; 4], [0.0; 4]);
        for k in 0..=self.u.degree {
            let row = (along_u.first + k) * self.v.count + along_v.first;
            let (mut inner, mut change) = ([0.0; 4], [0.0; 4]);
            for l in 0..=self.v.degree {
                let control = &self.points[row + l];
                add(&mut inner, control, along_v.values[l]);
                add(&mut change, control, along_v.slopes[l]);
            }
            add(&mut sum, &inner, along_u.values[k]);
            add(&mut change_u, &inner, along_u.slopes[k]);
            add(&mut change_v, &change, along_u.values[k]);
        }
        (place(&sum), slope(&sum, &change_u), slope(&sum, &change_v))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The quarter of a circle that every book has.
    fn quarter() -> SplineCurve {
        let knots = Knots::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0], 3).unwrap();
        let points = [
            Point::new(1.0, 0.0, 0.0),
            Point::new(1.0, 1.0, 0.0),
            Point::new(0.0, 1.0, 0.0),
        ];
        SplineCurve::new(knots, &points, &[1.0, 0.5_f64.sqrt(), 1.0])
    }

    #[test]
    fn a_rational_curve_of_degree_two_is_a_circle() {
        let curve = quarter();
        for k in 0..=20 {
            let (point, tangent) = curve.at(f64::from(k) / 20.0);
            assert!((point.coords.norm() - 1.0).abs() < 1e-15);
            assert!(point.coords.dot(&tangent).abs() < 1e-14);
        }
    }

    #[test]
    fn derivatives_are_those_of_differences_and_survive_repeated_knots() {
        let knots = vec![0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0];
        let u = Knots::new(3, knots, 8).unwrap();
        let v = Knots::new(1, vec![0.0, 0.0, 1.0, 1.0], 2).unwrap();
        let points: Vec<Point> = (0..16)
            .map(f64::from)
            .map(|k| Point::new((k * 1.7).sin(), k / 5.0, (k * 0.6).cos()))
            .collect();
        let weights: Vec<f64> = (0..16).map(|k| 1.0 + 0.1 * f64::from(k % 3)).collect();
        let surface = SplineSurface::new(u, v, &points, &weights);
        let step = 1e-6;
        for (u, v) in [(0.3, 0.2), (1.5, 0.9), (2.4, 0.5)] {
            let (_, along_u, along_v) = surface.at(u, v);
            let by_u = (surface.at(u + step, v).0 - surface.at(u - step, v).0) / (2.0 * step);
            let by_v = (surface.at(u, v + step).0 - surface.at(u, v - step).0) / (2.0 * step);
            assert!((along_u - by_u).norm() < 1e-7);
            assert!((along_v - by_v).norm() < 1e-7);
        }
        assert_eq!(surface.u.breaks(), [0.0, 1.0, 2.0, 3.0]);
        let end = surface.at(3.0, 1.0).0;
        assert!((end - points[15]).norm() < 1e-12, "{end}");
    }

    #[test]
    fn knots_that_do_not_fit_are_refused() {
        assert!(Knots::new(2, vec![0.0; 6], 3).is_err());
        assert!(Knots::new(2, vec![0.0, 0.0, 0.0, 1.0, 1.0], 3).is_err());
        assert!(Knots::new(2, vec![0.0, 0.0, 2.0, 1.0, 1.0, 1.0], 3).is_err());
        assert!(Knots::new(0, vec![0.0, 1.0], 1).is_err());
    }
}
