//! The units of a representation: every context of a file has its own.

use std::collections::BTreeMap;

use crate::file::{File, reference};

/// What to multiply by: lengths for millimetres, angles for radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Units {
    /// Millimetres in the unit of length.
    pub length: f64,
    /// Radians in the unit of plane angles.
    pub angle: f64,
}

impl Default for Units {
    /// What a file that says nothing most likely means.
    fn default() -> Self {
        Self {
            length: 1.0,
            angle: 1.0,
        }
    }
}

impl Units {
    /// The units of a context; what it does not say is as `otherwise`.
    pub fn of(file: &File, context: u64, otherwise: Self) -> Self {
        let mut units = otherwise;
        let Some(assigned) = file.part(context, "GLOBAL_UNIT_ASSIGNED_CONTEXT", 2) else {
            return units;
        };
        for id in assigned.references(0).unwrap_or_default() {
            let factor = |depth| factor(file, id, depth).filter(|it| *it > 0.0);
            if file.is(id, "LENGTH_UNIT") {
                units.length = factor(0).map_or(units.length, |metres| 1000.0 * metres);
            } else if file.is(id, "PLANE_ANGLE_UNIT") {
                units.angle = factor(0).unwrap_or(units.angle);
            }
        }
        // Twenty-five times 1000 × 0.001 is not 25: what is a whole number of millimetres is said so.
        let round = (units.length * 1e9).round() / 1e9;
        if (units.length - round).abs() <= 1e-13 * units.length {
            units.length = round;
        }
        units
    }

    /// The units that most contexts of a file have: for what is in no representation.
    pub fn usual(file: &File) -> Self {
        let mut votes: BTreeMap<[u64; 2], (usize, Self)> = BTreeMap::new();
        for context in file.all("GLOBAL_UNIT_ASSIGNED_CONTEXT") {
            let units = Self::of(file, context, Self::default());
            let key = [units.length.to_bits(), units.angle.to_bits()];
            votes.entry(key).or_insert((0, units)).0 += 1;
        }
        let most = votes.into_values().max_by_key(|(count, _)| *count);
        most.map_or_else(Self::default, |(_, units)| units)
    }
}

/// How many of the basic unit (metre, radian) a unit is.
fn factor(file: &File, unit: u64, depth: usize) -> Option<f64> {
    // A conversion of a conversion of … that ends nowhere.
    if depth > 8 {
        return None;
    }
    if file.is(unit, "CONVERSION_BASED_UNIT") {
        let own = file.part(unit, "CONVERSION_BASED_UNIT", 1)?;
        let measure = own.reference(1).ok()?;
        let fields = file.fields(measure).ok()?;
        let value = fields.number(0).ok()?;
        return Some(value * factor(file, fields.reference(1).ok()?, depth + 1)?);
    }
    let own = file.part(unit, "SI_UNIT", 1)?;
    Some(prefix(own.word(0)))
}

/// The factor of a prefix of the international system.
fn prefix(word: Option<&str>) -> f64 {
    match word {
        Some("EXA") => 1e18,
        Some("PETA") => 1e15,
        Some("TERA") => 1e12,
        Some("GIGA") => 1e9,
        Some("MEGA") => 1e6,
        Some("KILO") => 1e3,
        Some("HECTO") => 1e2,
        Some("DECA") => 1e1,
        Some("DECI") => 1e-1,
        Some("CENTI") => 1e-2,
        Some("MILLI") => 1e-3,
        Some("MICRO") => 1e-6,
        Some("NANO") => 1e-9,
        Some("PICO") => 1e-12,
        _ => 1.0,
    }
}

/// The context of a representation.
pub(crate) fn context_of(file: &File, representation: u64) -> Option<u64> {
    let fields = file.fields(representation).ok()?;
    // Name, items, context; some types write more after them.
    fields.optional(2).ok()?
}

/// The items of a representation.
pub(crate) fn items_of(file: &File, representation: u64) -> Vec<u64> {
    let fields = file.fields(representation);
    fields
        .and_then(|fields| Ok(fields.list(1)?.iter().filter_map(reference).collect()))
        .unwrap_or_default()
}
