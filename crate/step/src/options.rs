//! How a part becomes a cloud.

use fit4cad::sample::MAX_POINTS;

use crate::error::StepError;

/// How many points there are to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Amount {
    /// So many on all faces together.
    Points(usize),
    /// So many that neighbours lie about this far apart, in millimetres.
    Spacing(f64),
    /// As spacing, over the diagonal of the part.
    Share(f64),
}

/// How points are spread over the faces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Spread {
    /// All at about one distance (Poisson discs), as the benchmark's are.
    #[default]
    Even,
    /// Every place as likely, as samplers of meshes give them.
    Random,
    /// As scanners take them from viewpoints around the part: what is hidden from all of them has none.
    Scan,
}

/// How a part becomes a cloud.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How many points.
    pub amount: Amount,
    /// How they are spread.
    pub spread: Spread,
    /// Of scans, how many viewpoints there are.
    pub views: usize,
    /// Fewest points of a face, however small it is. Scans have what is seen.
    pub least: usize,
    /// Seed of everything random.
    pub seed: u64,
    /// Whether free-form faces that are of one of the five families become primitives.
    pub recognise: bool,
    /// Whether faces have points that nothing outside sees.
    pub inner: bool,
    /// Whether faces of one surface that touch are one primitive, as in the benchmark.
    pub join: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            // The median spacing of the benchmark's clouds.
            amount: Amount::Share(0.0077),
            spread: Spread::Even,
            // One to each side, as a part is turned before a scanner.
            views: 6,
            // The smallest primitive of the benchmark.
            least: 5,
            seed: 1,
            recognise: true,
            inner: true,
            join: true,
        }
    }
}

/// Finest and widest spacing, over the diagonal of the part.
pub(crate) const SHARES: [f64; 2] = [0.0005, 0.2];

impl Options {
    /// Most viewpoints of a scan: more see nothing that these do not.
    pub const MOST_VIEWS: usize = 64;

    pub(crate) fn check(&self) -> Result<(), StepError> {
        let wrong = |what, expected: &str, found: String| StepError::OutOfRange {
            what,
            expected: expected.to_owned(),
            found,
        };
        match self.amount {
            Amount::Points(count) if !(10..=MAX_POINTS).contains(&count) => {
                let expected = format!("10 to {MAX_POINTS}");
                Err(wrong("points", &expected, count.to_string()))
            }
            Amount::Spacing(value) if !(value > 0.0 && value.is_finite()) => Err(wrong(
                "spacing",
                "a length in millimetres greater than zero",
                value.to_string(),
            )),
            Amount::Share(value) if !(SHARES[0]..=SHARES[1]).contains(&value) => {
                let expected = format!("{} to {} of the diagonal", SHARES[0], SHARES[1]);
                Err(wrong("spacing", &expected, value.to_string()))
            }
            _ if !(1..=Self::MOST_VIEWS).contains(&self.views) => {
                let expected = format!("1 to {}", Self::MOST_VIEWS);
                Err(wrong("views", &expected, self.views.to_string()))
            }
            _ if self.least > 10_000 => Err(wrong(
                "the least number of points per face",
                "0 to 10000",
                self.least.to_string(),
            )),
            _ => Ok(()),
        }
    }
}
