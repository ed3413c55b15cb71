//! How types are numbered, and what arrays of them are called. No two networks agree.

use super::Told;
use crate::format::purpose::Purpose;
use crate::surface::SurfaceType::{Cone, Cylinder, Plane, Sphere};

/// How types are numbered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Coding {
    /// ParseNet's and HPNet's: 1 plane, 3 cone, 4 cylinder, 5 sphere; the others are splines and the like.
    ParseNet,
    /// SPFN's and CPFN's: 0 sphere, 1 plane, 2 cylinder, 3 cone.
    Spfn,
}

impl Coding {
    /// The type of a number; `None` where it is none of the five.
    ///
    /// ```
    /// use fit4cad::format::types::Coding;
    /// use fit4cad::surface::SurfaceType;
    /// assert_eq!(Coding::ParseNet.kind(4.0), Some(SurfaceType::Cylinder));
    /// assert_eq!(Coding::Spfn.kind(0.0), Some(SurfaceType::Sphere));
    /// assert_eq!(Coding::Spfn.kind(-1.0), None);
    /// ```
    pub fn kind(self, number: f64) -> Told {
        let kinds: &[Told] = match self {
            Self::ParseNet => &[
                None,
                Some(Plane),
                None,
                Some(Cone),
                Some(Cylinder),
                Some(Sphere),
            ],
            Self::Spfn => &[Some(Sphere), Some(Plane), Some(Cylinder), Some(Cone)],
        };
        let is_place = number.fract() == 0.0 && number >= 0.0;
        kinds
            .get(number as usize)
            .copied()
            .flatten()
            .filter(|_| is_place)
    }

    /// The coding that types are in of which this is the largest number: ParseNet's where SPFN's has none so
    /// large; `None` where no network's has. Of files with planes and cones alone both say the same.
    pub fn of_largest(number: f64) -> Option<Self> {
        /// ParseNet's largest: of splines, closed ones among them.
        const LARGEST: f64 = 9.0;
        if number <= 3.0 {
            Some(Self::Spfn)
        } else {
            (number <= LARGEST).then_some(Self::ParseNet)
        }
    }

    /// What its numbers mean.
    pub(in crate::format) const fn words(self) -> &'static str {
        match self {
            Self::ParseNet => {
                "1 plane, 3 cone, 4 cylinder, 5 sphere, as ParseNet and HPNet number them"
            }
            Self::Spfn => "0 sphere, 1 plane, 2 cylinder, 3 cone, as SPFN numbers them",
        }
    }
}

/// What the name of an array of types tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Named {
    /// Whose they are.
    pub whose: Purpose,
    /// How likely an array of that name is the one wanted; the less the likelier.
    pub rank: usize,
    /// How they are numbered; `None` where the numbers tell.
    pub coding: Option<Coding>,
}

impl Named {
    /// The coding of numbers; `None` where they are of none.
    pub fn coding_of(&self, numbers: impl IntoIterator<Item = f64>) -> Option<Coding> {
        let largest = || numbers.into_iter().fold(0.0, f64::max);
        self.coding.or_else(|| Coding::of_largest(largest()))
    }
}

/// What arrays of types are called, whose these are, and how they are numbered.
const NAMES: [(&str, Purpose, Option<Coding>); 14] = [
    ("prim", Purpose::Truth, Some(Coding::ParseNet)),
    ("gt_prim", Purpose::Truth, Some(Coding::ParseNet)),
    ("primitives", Purpose::Truth, Some(Coding::ParseNet)),
    ("t_gt", Purpose::Truth, Some(Coding::Spfn)),
    ("gt_type", Purpose::Truth, Some(Coding::Spfn)),
    ("type", Purpose::Truth, None),
    ("types", Purpose::Truth, None),
    ("primitive_type", Purpose::Truth, None),
    (
        "pred_primitives",
        Purpose::Submission,
        Some(Coding::ParseNet),
    ),
    ("pred_prim", Purpose::Submission, Some(Coding::ParseNet)),
    ("pred_type", Purpose::Submission, Some(Coding::Spfn)),
    (
        "pred_type_per_point",
        Purpose::Submission,
        Some(Coding::Spfn),
    ),
    ("type_per_point", Purpose::Submission, Some(Coding::Spfn)),
    ("pred_types", Purpose::Submission, None),
];

/// What an array of such a name tells of types, in any case; `None` where it is none of types.
pub fn named(name: &str) -> Option<Named> {
    let rank = NAMES
        .iter()
        .position(|(known, ..)| name.eq_ignore_ascii_case(known))?;
    let &(_, whose, coding) = NAMES.get(rank)?;
    Some(Named {
        whose,
        rank,
        coding,
    })
}
