//! The parameters of both fitters: name, unit, range, default and explanation in one table, which
//! the command line, the page and the documentation all read.

use thiserror::Error;

use super::Method;
use crate::cloud::Cloud;

/// What is to be known about one parameter.
#[derive(Debug, Clone, Copy)]
pub struct ParameterInfo {
    /// Field name.
    pub name: &'static str,
    /// Unit, empty for a plain number.
    pub unit: &'static str,
    /// Smallest value allowed.
    pub minimum: f64,
    /// Largest value allowed.
    pub maximum: f64,
    /// Value when nothing is said.
    pub default: f64,
    /// Whether only whole numbers make sense.
    pub whole: bool,
    /// The methods that heed it.
    pub methods: &'static [Method],
    /// What it does, in a sentence or two.
    pub explanation: &'static str,
    get: fn(&Parameters) -> f64,
    set: fn(&mut Parameters, f64),
}

/// A parameter that cannot be set as asked.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum ParameterError {
    /// There is no such parameter.
    #[error("there is no parameter `{0}`; there are {names}", names = names())]
    Unknown(String),
    /// The value is outside the range, or not whole.
    #[error("`{name}` must be {kind} from {minimum} to {maximum}, not {value}")]
    Range {
        /// Field name.
        name: &'static str,
        /// The value asked for.
        value: f64,
        /// `a number` or `a whole number`.
        kind: &'static str,
        /// Smallest value allowed.
        minimum: f64,
        /// Largest value allowed.
        maximum: f64,
    },
    /// The noise is larger than the cloud it is of.
    #[error(
        "`noise` is {noise}, and the cloud no more than {diagonal} from corner to corner: it is the standard deviation of the \
         points off their surfaces, in the units of the cloud"
    )]
    Noise {
        /// The value asked for.
        noise: f64,
        /// Diagonal of the bounding box.
        diagonal: f64,
    },
}

fn names() -> String {
    TABLE
        .iter()
        .map(|info| info.name)
        .collect::<Vec<_>>()
        .join(", ")
}

macro_rules! parameters {
    ($(
        $name:ident: $kind:tt in $minimum:literal ..= $maximum:literal, default $default:literal $unit:literal, $methods:expr,
        $explanation:literal;
    )*) => {
        /// Values of all parameters.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct Parameters {
            $(
                #[doc = $explanation]
                #[doc = concat!("\n\nFrom ", $minimum, " to ", $maximum, " ", $unit, ", ", $default, " by default.")]
                pub $name: f64,
            )*
        }

        impl Default for Parameters {
            fn default() -> Self {
                Self { $($name: $default as f64,)* }
            }
        }

        /// Every parameter, in the order to show them.
        pub static TABLE: &[ParameterInfo] = &[$(
            ParameterInfo {
                name: stringify!($name),
                unit: $unit,
                minimum: $minimum as f64,
                maximum: $maximum as f64,
                default: $default as f64,
                whole: parameters!(@whole $kind),
                methods: $methods,
                explanation: $explanation,
                get: |parameters| parameters.$name,
                set: |parameters, value| parameters.$name = value,
            },
        )*];
    };
    (@whole count) => { true };
    (@whole number) => { false };
}

const BOTH: &[Method] = &[Method::Hough, Method::Growing];

parameters! {
    tolerance: number in 0.0 ..= 0.05, default 0.0 "of the diagonal", BOTH,
    "How far from a surface a point may lie and still be on it. 0 estimates it from the cloud's own noise.";

    noise: number in 0.0 ..= 1e9, default 0.0 "in units of the cloud", BOTH,
    "Standard deviation of the points off their surfaces, where it is known, as from the data sheet of a scanner; a share of the diagonal times the diagonal. 0 measures it.";

    smallest: count in 4.0 ..= 1000.0, default 5.0 "points", BOTH,
    "Primitives of fewer points are not reported.";

    neighbours: count in 8.0 ..= 32.0, default 16.0 "points", BOTH,
    "Neighbours per point in the graph along which surfaces grow and patches connect.";

    fuzzy_border: number in 0.05 ..= 1.0, default 0.3 "share", BOTH,
    "A patch is rejected as accidental when more than this share of the points just outside it nearly lie on its surface: true faces end sharply, accidental fits fade out.";

    subsample: count in 0.0 ..= 10000000.0, default 0.0 "points", BOTH,
    "Where the cloud has more points, so many of them, spread over all of it, are fitted, and every point is labelled by what was found: a quick answer for a large cloud. 0 fits all.";

    persistence: number in 0.01 ..= 0.9, default 0.1 "of the highest peak", &[Method::Hough],
    "Maxima of the accumulator with less topological persistence than this are noise.";

    variation_neighbours: count in 6.0 ..= 60.0, default 15.0 "points", &[Method::Growing],
    "Neighbours over which the surface variation of a point is taken (the paper's n); at most `neighbours`.";

    sharp_quantile: number in 0.0 ..= 0.95, default 0.0 "quantile", &[Method::Growing],
    "Points whose surface variation is above this quantile are sharp (the paper's η, from 0.65 to 0.95). 0 finds it from the histogram of the cloud.";
}

impl Parameters {
    /// Sets a parameter by its field name, as the command line and the page do.
    ///
    /// # Errors
    /// If there is no such parameter, or the value is out of its range or a broken count.
    ///
    /// ```
    /// use fit4cad::fit::Parameters;
    /// let mut parameters = Parameters::default();
    /// parameters.set("smallest", 20.0)?;
    /// assert_eq!(parameters.get("smallest"), Some(20.0));
    /// assert!(parameters.set("smallest", 2.5).is_err());
    /// # Ok::<(), fit4cad::fit::parameters::ParameterError>(())
    /// ```
    pub fn set(&mut self, name: &str, value: f64) -> Result<(), ParameterError> {
        let info = TABLE
            .iter()
            .find(|info| info.name == name)
            .ok_or_else(|| ParameterError::Unknown(name.to_owned()))?;
        let in_range = (info.minimum..=info.maximum).contains(&value);
        if !in_range || (info.whole && value.fract() != 0.0) {
            return Err(ParameterError::Range {
                name: info.name,
                value,
                kind: if info.whole {
                    "a whole number"
                } else {
                    "a number"
                },
                minimum: info.minimum,
                maximum: info.maximum,
            });
        }
        (info.set)(self, value);
        Ok(())
    }

    /// The value of a parameter by its field name, `None` for an unknown one.
    pub fn get(&self, name: &str) -> Option<f64> {
        let info = TABLE.iter().find(|info| info.name == name)?;
        Some((info.get)(self))
    }

    /// The most places to fit.
    pub(crate) fn most(&self) -> usize {
        match Self::count(self.subsample) {
            0 => usize::MAX,
            most => most,
        }
    }

    /// Whether they can be meant for a cloud.
    ///
    /// # Errors
    /// If the noise is not less than the diagonal of its bounding box. A cloud of no extent has none that could be less.
    pub fn suit(&self, cloud: &Cloud) -> Result<(), ParameterError> {
        let diagonal = cloud.bounds().diagonal();
        if diagonal > 0.0 && self.noise >= diagonal {
            let noise = self.noise;
            return Err(ParameterError::Noise { noise, diagonal });
        }
        Ok(())
    }

    /// A count among the parameters as an integer.
    pub(crate) fn count(value: f64) -> usize {
        // Saturates, and a NaN becomes 0.
        value as usize
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloud::Point;

    #[test]
    fn every_parameter_can_be_set_to_its_bounds_and_read_back() {
        let mut parameters = Parameters::default();
        for info in TABLE {
            assert_eq!(parameters.get(info.name), Some(info.default));
            for value in [info.minimum, info.maximum] {
                parameters.set(info.name, value).unwrap();
                assert_eq!(parameters.get(info.name), Some(value));
            }
        }
    }

    #[test]
    fn an_unknown_name_is_answered_with_the_known_ones() {
        let error = Parameters::default().set("tolerence", 1.0).unwrap_err();
        assert!(error.to_string().contains("tolerance, noise, smallest"));
    }

    #[test]
    fn noise_is_less_than_the_cloud_is_wide() {
        let cloud = Cloud::new(vec![Point::origin(), Point::new(3.0, 4.0, 0.0)]);
        let mut parameters = Parameters::default();
        parameters.set("noise", 0.1).unwrap();
        assert_eq!(parameters.suit(&cloud), Ok(()));
        assert_eq!(parameters.suit(&Cloud::default()), Ok(()));
        parameters.set("noise", 7.0).unwrap();
        let error = parameters.suit(&cloud).unwrap_err();
        let text = "`noise` is 7, and the cloud no more than 5 from corner to corner";
        assert!(error.to_string().starts_with(text), "{error}");
        for value in [-0.1, f64::NAN, f64::INFINITY] {
            assert!(parameters.set("noise", value).is_err());
        }
    }

    #[test]
    fn values_out_of_range_and_broken_counts_are_refused() {
        let mut parameters = Parameters::default();
        assert!(parameters.set("persistence", f64::NAN).is_err());
        let error = parameters.set("smallest", 5.5).unwrap_err();
        assert_eq!(
            error.to_string(),
            "`smallest` must be a whole number from 4 to 1000, not 5.5"
        );
    }
}
