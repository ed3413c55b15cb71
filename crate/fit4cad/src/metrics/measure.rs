//! The nine measures by name.

use std::fmt;

use super::classification::Classification;

/// One of the paper's measures.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Measure {
    /// Sørensen-Dice index.
    Dsc,
    /// Positive predictive value.
    Ppv,
    /// True positive rate.
    Tpr,
    /// True negative rate.
    Tnr,
    /// Negative predictive value.
    Npv,
    /// Accuracy.
    Acc,
    /// Mean fitting error.
    Mfe,
    /// Directed Hausdorff distance.
    DHaus,
    /// Coefficient distance.
    D1,
}

impl Measure {
    /// All nine, in the order of the paper's tables.
    pub const ALL: [Self; 9] = [
        Self::Dsc,
        Self::Ppv,
        Self::Tpr,
        Self::Tnr,
        Self::Npv,
        Self::Acc,
        Self::Mfe,
        Self::DHaus,
        Self::D1,
    ];

    /// The paper's abbreviation.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Dsc => "DSC",
            Self::Ppv => "PPV",
            Self::Tpr => "TPR",
            Self::Tnr => "TNR",
            Self::Npv => "NPV",
            Self::Acc => "ACC",
            Self::Mfe => "MFE",
            Self::DHaus => "dHaus",
            Self::D1 => "d1",
        }
    }

    /// Whether a perfect prediction scores 1; it scores 0 in the others.
    pub const fn is_better_high(self) -> bool {
        !matches!(self, Self::Mfe | Self::DHaus | Self::D1)
    }
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// A value for each measure; `None` where it cannot be had.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Measures {
    /// Sørensen-Dice index, 0 to 1.
    pub dsc: Option<f64>,
    /// Positive predictive value, 0 to 1.
    pub ppv: Option<f64>,
    /// True positive rate, 0 to 1.
    pub tpr: Option<f64>,
    /// True negative rate, 0 to 1.
    pub tnr: Option<f64>,
    /// Negative predictive value, 0 to 1.
    pub npv: Option<f64>,
    /// Accuracy, 0 to 1.
    pub acc: Option<f64>,
    /// Mean fitting error as a share of the primitive's diagonal, from 0.
    pub mfe: Option<f64>,
    /// Directed Hausdorff distance as a share of the primitive's diagonal, from 0.
    pub d_haus: Option<f64>,
    /// Coefficient distance, from 0.
    pub d1: Option<f64>,
}

/// The six of classification; the three of fit accuracy cannot be had from it.
impl From<Classification> for Measures {
    fn from(classification: Classification) -> Self {
        let Classification {
            dsc,
            ppv,
            tpr,
            tnr,
            npv,
            acc,
        } = classification;
        Self {
            dsc,
            ppv,
            tpr,
            tnr,
            npv,
            acc,
            ..Self::default()
        }
    }
}

impl Measures {
    /// The value of one measure.
    pub fn get(&self, measure: Measure) -> Option<f64> {
        match measure {
            Measure::Dsc => self.dsc,
            Measure::Ppv => self.ppv,
            Measure::Tpr => self.tpr,
            Measure::Tnr => self.tnr,
            Measure::Npv => self.npv,
            Measure::Acc => self.acc,
            Measure::Mfe => self.mfe,
            Measure::DHaus => self.d_haus,
            Measure::D1 => self.d1,
        }
    }
}
