//! Polynomials in x, y, z: the left side of an implicit form.

use std::iter;

use super::SurfaceType;
use crate::cloud::{Point, Vector};

/// A polynomial of given total degree. The coefficients follow the order of the files' tori: the
/// monomials xᵖ yᑫ zʳ with p falling, then q falling, then r falling (reverse lexicographic).
#[derive(Debug, Clone, PartialEq)]
pub struct Polynomial {
    degree: u32,
    coefficients: Vec<f64>,
}

impl SurfaceType {
    /// Total degree of its implicit form.
    pub const fn implicit_degree(self) -> u32 {
        match self {
            Self::Plane => 1,
            Self::Cylinder | Self::Cone | Self::Sphere => 2,
            Self::Torus => 4,
        }
    }
}

/// Exponents (p, q, r) of the monomials up to a total degree, in the order of the coefficients.
/// There are (d+1)(d+2)(d+3)/6 of them.
pub fn monomials(degree: u32) -> impl Iterator<Item = [u32; 3]> {
    (0..=degree).rev().flat_map(move |p| {
        (0..=degree - p)
            .rev()
            .flat_map(move |q| (0..=degree - p - q).rev().map(move |r| [p, q, r]))
    })
}

/// Of the vector `a b c d e f g h i l` (x², y², z², 2xy, 2xz, 2yz, 2x, 2y, 2z, 1): the place of
/// each monomial x², xy, xz, x, y², yz, y, z², z, 1, and its factor.
const QUADRIC: [(usize, f64); 10] = [
    (0, 1.0),
    (3, 2.0),
    (4, 2.0),
    (6, 2.0),
    (1, 1.0),
    (5, 2.0),
    (7, 2.0),
    (2, 1.0),
    (8, 2.0),
    (9, 1.0),
];

impl Polynomial {
    /// The polynomial with these coefficients; `None` if their count is not that of the degree.
    pub fn new(degree: u32, coefficients: Vec<f64>) -> Option<Self> {
        let polynomial = Self {
            degree,
            coefficients,
        };
        (monomials(degree).count() == polynomial.coefficients.len()).then_some(polynomial)
    }

    /// The polynomial of an implicit vector as the files order it; `None` if the vector has not
    /// the length of its type.
    pub fn from_implicit(kind: SurfaceType, values: &[f64]) -> Option<Self> {
        if values.len() != kind.implicit_len() {
            return None;
        }
        let coefficients = match kind {
            SurfaceType::Plane | SurfaceType::Torus => values.to_vec(),
            SurfaceType::Cylinder | SurfaceType::Cone | SurfaceType::Sphere => QUADRIC
                .iter()
                .filter_map(|&(place, factor)| Some(values.get(place)? * factor))
                .collect(),
        };
        Self::new(kind.implicit_degree(), coefficients)
    }

    /// The implicit vector as the files order it; `None` if the type has another degree.
    pub fn to_implicit(&self, kind: SurfaceType) -> Option<Vec<f64>> {
        if kind.implicit_degree() != self.degree {
            return None;
        }
        Some(match kind {
            SurfaceType::Plane | SurfaceType::Torus => self.coefficients.clone(),
            SurfaceType::Cylinder | SurfaceType::Cone | SurfaceType::Sphere => {
                let mut values = vec![0.0; QUADRIC.len()];
                for (&(place, factor), coefficient) in QUADRIC.iter().zip(&self.coefficients) {
                    if let Some(value) = values.get_mut(place) {
                        *value = coefficient / factor;
                    }
                }
                values
            }
        })
    }

    /// Total degree.
    pub fn degree(&self) -> u32 {
        self.degree
    }

    /// The coefficients, in the order of [`monomials`].
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// The same zero set with coefficients of Euclidean norm 1; unchanged if they are all zero.
    pub fn normalised(&self) -> Self {
        let norm = self.coefficients.iter().map(|c| c * c).sum::<f64>().sqrt();
        let scale = if norm > 0.0 { norm } else { 1.0 };
        Self {
            degree: self.degree,
            coefficients: self.coefficients.iter().map(|c| c / scale).collect(),
        }
    }

    /// Value and gradient at a point, by Horner's scheme nested over x, y, z. O(coefficients).
    pub fn evaluate(&self, point: &Point) -> (f64, Vector) {
        let mut coefficients = self.coefficients.iter();
        let (mut value, mut gradient) = (0.0, Vector::zeros());
        for p in (0..=self.degree).rev() {
            let (mut in_y, mut in_y_by_y, mut in_y_by_z) = (0.0, 0.0, 0.0);
            for q in (0..=self.degree - p).rev() {
                let (mut in_z, mut in_z_by_z) = (0.0, 0.0);
                for coefficient in coefficients
                    .by_ref()
                    .take(1 + (self.degree - p - q) as usize)
                {
                    in_z_by_z = in_z_by_z * point.z + in_z;
                    in_z = in_z * point.z + coefficient;
                }
                in_y_by_y = in_y_by_y * point.y + in_y;
                in_y_by_z = in_y_by_z * point.y + in_z_by_z;
                in_y = in_y * point.y + in_z;
            }
            gradient.x = gradient.x * point.x + value;
            gradient.y = gradient.y * point.x + in_y_by_y;
            gradient.z = gradient.z * point.x + in_y_by_z;
            value = value * point.x + in_y;
        }
        (value, gradient)
    }

    /// Distance of a point to the zero set, to first order: |f| / |∇f|. Not finite where the
    /// gradient vanishes.
    pub fn first_order_distance(&self, point: &Point) -> f64 {
        let (value, gradient) = self.evaluate(point);
        value.abs() / gradient.norm()
    }

    /// The polynomial g with g(x) = f((x − origin) / scale): from a frame's coordinates to those
    /// in which the frame has this origin and unit. O(coefficients²).
    pub fn out_of_frame(&self, origin: &Point, scale: f64) -> Self {
        let powers =
            [origin.x, origin.y, origin.z].map(|shift| shifted_powers(-shift, self.degree));
        let mut sums = vec![0.0; self.coefficients.len()];
        for (exponents, coefficient) in monomials(self.degree).zip(&self.coefficients) {
            let degree: u32 = exponents.iter().sum();
            let scaled = coefficient / scale.powi(degree as i32);
            for (sum, lower) in sums.iter_mut().zip(monomials(self.degree)) {
                let mut term = scaled;
                for axis in 0..3 {
                    let row = &powers[axis][exponents[axis] as usize];
                    term *= row.get(lower[axis] as usize).copied().unwrap_or(0.0);
                }
                *sum += term;
            }
        }
        Self {
            degree: self.degree,
            coefficients: sums,
        }
    }
}

/// Coefficients of (x + shift)ⁿ by rising power of x, for each n up to the degree.
fn shifted_powers(shift: f64, degree: u32) -> Vec<Vec<f64>> {
    let next = |row: &Vec<f64>| {
        let below = iter::once(0.0).chain(row.iter().copied());
        let same = row.iter().map(|c| c * shift).chain(iter::once(0.0));
        Some(below.zip(same).map(|(below, same)| below + same).collect())
    };
    iter::successors(Some(vec![1.0]), next)
        .take(degree as usize + 1)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_monomials_of_degree_four_come_in_the_order_of_the_files() {
        let order: Vec<_> = monomials(4).collect();
        assert_eq!(order.len(), 35);
        let start = [
            [4, 0, 0],
            [3, 1, 0],
            [3, 0, 1],
            [3, 0, 0],
            [2, 2, 0],
            [2, 1, 1],
            [2, 1, 0],
        ];
        assert_eq!(order[..7], start);
        assert_eq!(
            order[30..],
            [[0, 0, 4], [0, 0, 3], [0, 0, 2], [0, 0, 1], [0, 0, 0]]
        );
    }

    #[test]
    fn value_and_gradient_agree_with_the_sum_of_monomials() {
        let coefficients: Vec<f64> = (0..35).map(|i| f64::from(i * i % 11) - 5.0).collect();
        let polynomial = Polynomial::new(4, coefficients.clone()).unwrap();
        let point = Point::new(0.5, -2.0, 3.0);
        let sum = |at: Point| -> f64 {
            monomials(4)
                .zip(&coefficients)
                .map(|([p, q, r], c)| {
                    c * at.x.powi(p as i32) * at.y.powi(q as i32) * at.z.powi(r as i32)
                })
                .sum()
        };
        let (value, gradient) = polynomial.evaluate(&point);
        assert!((value - sum(point)).abs() < 1e-10);
        for axis in 0..3 {
            let mut step = Vector::zeros();
            step[axis] = 1e-5;
            let slope = (sum(point + step) - sum(point - step)) / 2e-5;
            assert!((gradient[axis] - slope).abs() < 1e-4, "{axis}");
        }
    }

    #[test]
    fn leaving_a_frame_keeps_the_value_at_every_place() {
        let coefficients: Vec<f64> = (0..35).map(|i| f64::from(i * 7 % 13) - 6.0).collect();
        let inner = Polynomial::new(4, coefficients).unwrap();
        let (origin, scale) = (Point::new(3.0, -1.0, 2.0), 2.5);
        let outer = inner.out_of_frame(&origin, scale);
        let place = Point::new(0.3, 0.7, -0.4);
        let (expected, _) = inner.evaluate(&place);
        let (value, _) = outer.evaluate(&(origin + place.coords * scale));
        assert!((value - expected).abs() < 1e-9 * expected.abs());
    }

    #[test]
    fn the_vector_of_a_quadric_survives_the_round_trip() {
        let vector: Vec<f64> = (1..=10).map(f64::from).collect();
        let polynomial = Polynomial::from_implicit(SurfaceType::Cone, &vector).unwrap();
        // a x² + b y² + c z² + 2(d xy + e xz + f yz) + 2(g x + h y + i z) + l at (1, 2, 3)
        let (value, _) = polynomial.evaluate(&Point::new(1.0, 2.0, 3.0));
        let by_hand = 1. + 8. + 27. + 2. * (8. + 15. + 36.) + 2. * (7. + 16. + 27.) + 10.;
        assert_eq!(value, by_hand);
        assert_eq!(polynomial.to_implicit(SurfaceType::Cone).unwrap(), vector);
    }

    #[test]
    fn a_wrong_count_of_coefficients_makes_no_polynomial() {
        assert_eq!(Polynomial::new(2, vec![0.0; 9]), None);
        assert_eq!(
            Polynomial::from_implicit(SurfaceType::Torus, &[0.0; 10]),
            None
        );
    }
}
