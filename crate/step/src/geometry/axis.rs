//! Ranges of parameters: where they end, and whether they close.

/// The range of a parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Axis {
    /// Ends of the range; infinite where the surface has none.
    pub range: [f64; 2],
    /// After how much the surface is where it was.
    pub period: Option<f64>,
    /// Whether all of the surface at either end is one place.
    pub poles: [bool; 2],
}

impl Axis {
    pub const ENDLESS: Self = Self::from(f64::NEG_INFINITY, f64::INFINITY);

    pub const fn from(low: f64, high: f64) -> Self {
        Self {
            range: [low, high],
            period: None,
            poles: [false; 2],
        }
    }

    /// The value within the range, by whole periods; as it is where there is none.
    pub fn wrap(&self, value: f64) -> f64 {
        match self.period {
            Some(period) if !(self.range[0]..=self.range[1]).contains(&value) => {
                value - period * ((value - self.range[0]) / period).floor()
            }
            _ => value,
        }
    }

    pub const fn around(low: f64, period: f64) -> Self {
        Self {
            range: [low, low + period],
            period: Some(period),
            poles: [false; 2],
        }
    }
}
