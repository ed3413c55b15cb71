//! The parts that come with the playground.

mod milled;
mod pipes;
mod turned;

use super::SampleError;
use super::blocks::Part;

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
    found.map(PartInfo::part).ok_or_else(unknown)
}

impl PartInfo {
    /// The part itself.
    pub(super) fn part(&self) -> Part {
        (self.make)()
    }
}

/// The part that the page opens with.
pub(super) const FIRST: PartInfo = PartInfo {
    name: "bracket",
    title: "Angle bracket",
    description: "Two legs with a rounded bend, a gusset, bolt holes and a countersink.",
    make: milled::bracket,
};

const PARTS: &[PartInfo] = &[
    FIRST,
    PartInfo {
        name: "flange",
        title: "Flange with bolt holes",
        description: "A pipe flange with six equal bolt holes, a hub with toroidal fillets and a \
                      chamfered rim.",
        make: turned::flange,
    },
    PartInfo {
        name: "shaft",
        title: "Stepped shaft",
        description: "Coaxial cylinders, conical chamfers, an undercut and a keyway.",
        make: turned::shaft,
    },
    PartInfo {
        name: "housing",
        title: "Bearing housing",
        description: "A pillow block: rounded foot with slots, an arched body, a stepped bore.",
        make: milled::housing,
    },
    PartInfo {
        name: "plate",
        title: "Countersunk plate",
        description: "Four countersunk holes and a pocket with rounded corners: small cones and \
                      fillets beside large planes.",
        make: milled::plate,
    },
    PartInfo {
        name: "ball-joint",
        title: "Ball joint",
        description: "A sphere on a neck with concave and convex toroidal fillets and two flats.",
        make: turned::ball_joint,
    },
    PartInfo {
        name: "elbow",
        title: "Pipe elbow",
        description: "A quarter of a torus, inside and out, between two flanged pipes.",
        make: pipes::elbow,
    },
    PartInfo {
        name: "branch",
        title: "Pipe branch",
        description: "Pipes that meet at 60 degrees in a space curve, tilted so that no axis is \
                      parallel to a coordinate axis.",
        make: pipes::branch,
    },
    PartInfo {
        name: "nozzle",
        title: "Nozzle",
        description: "Outer and inner cones of different angle, a hexagon and sharp steps.",
        make: turned::nozzle,
    },
    PartInfo {
        name: "spool",
        title: "Spool",
        description: "Coaxial cylinders of one radius that do not touch, parted by grooves, and \
                      coaxial fillets.",
        make: turned::spool,
    },
    PartInfo {
        name: "towers",
        title: "Two towers",
        description: "Two blocks of one height on a base: their tops lie in one plane but do not \
                      touch, so they are two primitives.",
        make: milled::towers,
    },
    PartInfo {
        name: "heat-sink",
        title: "Heat sink",
        description: "Sixteen thin fins, parallel and close together: over a hundred planes.",
        make: milled::heat_sink,
    },
    PartInfo {
        name: "gear",
        title: "Gear wheel",
        description: "Twenty tapered teeth with rounded roots, a hub and a bore with keyway.",
        make: milled::gear,
    },
    PartInfo {
        name: "knob",
        title: "Knob with a free-form grip",
        description: "The waist is a free-form surface: its points belong to no primitive.",
        make: turned::knob,
    },
];
