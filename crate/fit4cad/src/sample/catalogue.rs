//! The parts that come with the playground.

use super::SampleError;
use super::blocks::{Loop, Outline, Part, QUARTER, Solid};

/// A part of the catalogue.
#[derive(Debug, Clone, Copy)]
pub struct PartInfo {
    /// Name by which it is asked for.
    pub name: &'static str,
    /// Name to be shown.
    pub title: &'static str,
    /// One sentence: what it is and what is hard about it.
    pub description: &'static str,
    make: fn() -> Part,
}

/// The parts there are.
pub const fn parts() -> &'static [PartInfo] {
    PARTS
}

/// The part of a name.
pub(super) fn part(name: &str) -> Result<Part, SampleError> {
    let found = PARTS.iter().find(|part| part.name == name);
    let unknown = || SampleError::UnknownPart {
        name: name.to_owned(),
        known: PARTS.iter().map(|part| part.name).collect(),
    };
    found.map(|part| (part.make)()).ok_or_else(unknown)
}

const PARTS: &[PartInfo] = &[
    PartInfo {
        name: "flange",
        title: "Flange with bolt holes",
        description: "A pipe flange: six equal bolt holes, a hub with a fillet and chamfered rims.",
        make: flange,
    },
    PartInfo {
        name: "towers",
        title: "Two towers",
        description: "Two blocks of one height on a base: their tops lie in one plane but do not \
                      touch, so they are two primitives.",
        make: towers,
    },
    PartInfo {
        name: "shaft",
        title: "Stepped shaft",
        description: "A turned shaft: coaxial cylinders, chamfers, an undercut and a keyway.",
        make: shaft,
    },
];

fn flange() -> Part {
    let profile = Loop::rounded(&[
        [12.0, 0.0, 0.0],
        [48.0, 0.0, 0.0],
        [50.0, 2.0, 0.0],
        [50.0, 10.0, 0.0],
        [49.0, 11.0, 0.0],
        [22.0, 11.0, 5.0],
        [22.0, 36.0, 3.0],
        [12.0, 36.0, 0.0],
    ]);
    let mut part = Part::new().add(Solid::revolve(Outline::new(profile)));
    for k in 0..6 {
        let (sin, cos) = libm::sincos(f64::from(k) * std::f64::consts::FRAC_PI_3);
        part = part.cut(Solid::rod([37.0 * cos, 37.0 * sin, -1.0], 4.5, 13.0));
    }
    part
}

fn towers() -> Part {
    Part::new()
        .add(Solid::cuboid([0.0, 0.0, 0.0], [100.0, 60.0, 12.0]))
        .add(Solid::cuboid([10.0, 12.0, 6.0], [40.0, 48.0, 50.0]))
        .add(Solid::cuboid([60.0, 12.0, 6.0], [90.0, 48.0, 50.0]))
        .cut(Solid::rod([50.0, 30.0, -1.0], 6.0, 20.0))
}

fn shaft() -> Part {
    let profile = Loop::polygon(&[
        [0.0, 0.0],
        [9.0, 0.0],
        [11.0, 2.0],
        [11.0, 30.0],
        [10.0, 30.0],
        [10.0, 34.0],
        [18.0, 34.0],
        [18.0, 70.0],
        [14.0, 70.0],
        [14.0, 110.0],
        [11.0, 113.0],
        [0.0, 113.0],
    ]);
    let key = Loop::path([-4.0, 80.0])
        .arc([4.0, 80.0], 1.0)
        .line([4.0, 100.0])
        .arc([-4.0, 100.0], 1.0);
    let key = Solid::extrude(Outline::new(key), 20.0)
        .at([10.0, 0.0, 0.0])
        .facing([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]);
    let _ = QUARTER;
    Part::new()
        .add(Solid::revolve(Outline::new(profile)))
        .cut(key)
}
