//! One surface in both forms, and points to show it by.

use crate::cloud::Point;
use crate::metrics::coefficients::{
    coefficient_distance, normalised, opposite_signs, published_distance,
};
use crate::surface::Surface;
use crate::surface::polynomial::monomials;

/// Steps of the lattice along each side of the box that a surface is shown in.
const LATTICE: i32 = 24;

/// Points of the surface inside the cube from −`half` to `half`, about evenly spaced: the feet of the
/// lattice points nearest to the surface. O(1).
pub fn shown_points(surface: &Surface, half: f64) -> Vec<Point> {
    let step = 2.0 * half / f64::from(LATTICE);
    let at = |i: i32| f64::from(i) * step - half;
    let mut points = Vec::new();
    for i in 0..=LATTICE {
        for j in 0..=LATTICE {
            for k in 0..=LATTICE {
                let corner = Point::new(at(i), at(j), at(k));
                if surface.distance(&corner) <= 0.5 * step {
                    points.push(surface.foot(&corner));
                }
            }
        }
    }
    points
}

/// What the coefficients of an implicit vector stand before, in the order of the files: `x`, `y`,
/// `z` and `1` for a plane's four, `x²` … `1` for the ten of a quadric (mixed and linear ones
/// doubled), the monomials of degree up to four for a torus. Empty for another length.
pub fn implicit_terms(length: usize) -> Vec<String> {
    let quadric = ["x²", "y²", "z²", "2xy", "2xz", "2yz", "2x", "2y", "2z", "1"];
    match length {
        4 => ["x", "y", "z", "1"].map(str::to_owned).to_vec(),
        10 => quadric.map(str::to_owned).to_vec(),
        35 => monomials(4).map(term).collect(),
        _ => Vec::new(),
    }
}

fn term(exponents: [u32; 3]) -> String {
    let power = |letter: &str, exponent: u32| match exponent {
        0 => String::new(),
        1 => letter.to_owned(),
        2 => format!("{letter}²"),
        3 => format!("{letter}³"),
        _ => format!("{letter}⁴"),
    };
    let [p, q, r] = exponents;
    let name = power("x", p) + &power("y", q) + &power("z", r);
    if name.is_empty() {
        "1".to_owned()
    } else {
        name
    }
}

/// Two implicit vectors compared both ways.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// The vectors scaled to norm 1; empty where one cannot be.
    pub unit: [Vec<f64>; 2],
    /// d1 by the paper's definition.
    pub definition: Option<f64>,
    /// d1 as the authors' script has it.
    pub published: Option<f64>,
    /// Places whose entries have opposite signs: any of them makes the script negate.
    pub opposite: Vec<u32>,
}

/// Compares a predicted implicit vector with the true one.
pub fn compare(predicted: &[f64], truth: &[f64]) -> Comparison {
    let opposite = opposite_signs(predicted, truth).map(|place| place as u32);
    Comparison {
        unit: [predicted, truth].map(|vector| normalised(vector).unwrap_or_default()),
        definition: coefficient_distance(predicted, truth),
        published: published_distance(predicted, truth),
        opposite: opposite.collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Vector;
    use crate::surface::{Cone, Cylinder, Plane, Polynomial, Sphere, SurfaceType, Torus};

    fn families() -> [Surface; 5] {
        let (p, d) = (Point::new(0.1, -0.2, 0.1), Vector::new(0.2, 0.3, 1.0));
        [
            Surface::Plane(Plane::new(p, d)),
            Surface::Cylinder(Cylinder::new(p, d, 0.5)),
            Surface::Cone(Cone::new(p, d, 0.5)),
            Surface::Sphere(Sphere::new(p, 0.7)),
            Surface::Torus(Torus::new(p, d, 0.7, 0.2)),
        ]
    }

    #[test]
    fn every_family_shows_by_points_on_it() {
        for surface in families() {
            let points = shown_points(&surface, 1.0);
            assert!(points.len() > 300, "{surface:?} has {}", points.len());
            assert!(points.iter().all(|point| surface.distance(point) < 1e-9));
        }
    }

    #[test]
    fn the_terms_times_their_coefficients_are_the_polynomial() {
        let (x, y, z) = (0.3f64, -0.7f64, 1.1f64);
        let value_of = |term: &str| -> f64 {
            let mut product = 1.0;
            let mut last = 1.0;
            for letter in term.chars() {
                match letter {
                    'x' => last = x,
                    'y' => last = y,
                    'z' => last = z,
                    '2' => last = 2.0,
                    '²' => {}
                    '³' => product *= last,
                    '⁴' => product *= last * last,
                    _ => last = 1.0,
                }
                product *= last;
            }
            product
        };
        for surface in families() {
            let kind = surface.kind();
            if kind == SurfaceType::Plane {
                continue;
            }
            let vector = surface.to_implicit();
            let terms = implicit_terms(vector.len());
            let sum: f64 = vector
                .iter()
                .zip(&terms)
                .map(|(c, t)| c * value_of(t))
                .sum();
            let polynomial = Polynomial::from_implicit(kind, &vector).unwrap();
            assert!(
                (sum - polynomial.evaluate(&Point::new(x, y, z)).0).abs() < 1e-9,
                "{kind}"
            );
        }
    }

    #[test]
    fn noise_of_opposite_sign_turns_the_published_distance_and_not_the_definition() {
        let truth = Surface::Cylinder(Cylinder::new(Point::origin(), Vector::z(), 0.5));
        let truth = truth.to_implicit();
        let mut predicted = truth.clone();
        let mut noisy = truth.clone();
        predicted[3] = -1e-18;
        noisy[3] = 1e-18;
        let compared = compare(&predicted, &noisy);
        assert!(compared.definition.unwrap() < 1e-12);
        assert!(compared.published.unwrap() > 1.0);
        assert_eq!(compared.opposite, [3]);
        assert_eq!(compare(&truth, &truth).published, Some(0.0));
    }
}
