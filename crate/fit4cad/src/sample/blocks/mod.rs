//! Building blocks of parts: outlines swept into solids, solids added and cut away.
//!
//! A [`Part`] is plain data, so that it can be composed by hand, kept and read again. All
//! geometry follows from it: the faces and edges of each solid are known in closed form, and what
//! the others leave of them is found when the part is sampled.

mod frame;
mod outline;
mod segment;

pub use frame::Frame;
pub(super) use frame::Placement;
pub use outline::{Loop, Outline, QUARTER, Step};
pub(super) use segment::Segment;

/// An object built by adding solids and cutting solids away, in order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Part {
    /// What was done, first to last.
    pub features: Vec<Feature>,
}

/// One solid and what is done with it.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    /// Whether it is added or cut away.
    pub operation: Operation,
    /// The solid.
    pub solid: Solid,
}

/// What a feature does to the part so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Operation {
    /// Union.
    Add,
    /// Difference.
    Cut,
}

/// An outline swept through space. Lines and arcs make planes, cylinders, cones, spheres and tori;
/// free-form curves make faces that belong to no primitive.
#[derive(Debug, Clone, PartialEq)]
pub struct Solid {
    /// What is swept.
    pub outline: Outline,
    /// How it is swept.
    pub sweep: Sweep,
    /// Where it stands.
    pub frame: Frame,
}

/// The motion that makes a solid of an outline.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sweep {
    /// The outline, in the frame's x and y, moves along z from 0 to the height.
    Extrude {
        /// Length of the way, positive.
        height: f64,
    },
    /// The outline, whose abscissa is the distance from the frame's z axis (never negative) and
    /// whose ordinate is z, turns about that axis, from x towards y.
    Revolve {
        /// Angle in radians, up to a full turn.
        angle: f64,
    },
}

impl Solid {
    /// A prism on the xy plane.
    pub const fn extrude(outline: Outline, height: f64) -> Self {
        let sweep = Sweep::Extrude { height };
        Self {
            outline,
            sweep,
            frame: Frame::WORLD,
        }
    }

    /// A whole turn about the z axis.
    pub const fn revolve(outline: Outline) -> Self {
        Self::revolve_by(outline, std::f64::consts::TAU)
    }

    /// A turn about the z axis by an angle in radians.
    pub const fn revolve_by(outline: Outline, angle: f64) -> Self {
        let sweep = Sweep::Revolve { angle };
        Self {
            outline,
            sweep,
            frame: Frame::WORLD,
        }
    }

    /// An axis-parallel box between two opposite corners.
    pub fn cuboid(from: [f64; 3], to: [f64; 3]) -> Self {
        let [low, high] = [from, to].map(|corner| [corner[0], corner[1]]);
        Self::extrude(Outline::rectangle(low, high), to[2] - from[2]).at([0.0, 0.0, from[2]])
    }

    /// A round bar that stands on a point of the xy plane's parallel through it.
    pub fn rod(foot: [f64; 3], radius: f64, height: f64) -> Self {
        Self::extrude(Outline::disc([0.0, 0.0], radius), height).at(foot)
    }

    /// The solid with its frame moved to an origin.
    #[must_use]
    pub fn at(mut self, origin: [f64; 3]) -> Self {
        self.frame.origin = origin;
        self
    }

    /// The solid turned so that its z axis has one direction and its x axis comes as near as it
    /// can to another.
    #[must_use]
    pub fn facing(mut self, z: [f64; 3], x: [f64; 3]) -> Self {
        self.frame = Frame {
            origin: self.frame.origin,
            z,
            x,
        };
        self
    }
}

impl Part {
    /// A part of nothing.
    pub const fn new() -> Self {
        let features = Vec::new();
        Self { features }
    }

    /// The part with a solid added.
    #[must_use]
    pub fn join(self, solid: Solid) -> Self {
        self.with(Operation::Add, solid)
    }

    /// The part with a solid cut away.
    #[must_use]
    pub fn cut(self, solid: Solid) -> Self {
        self.with(Operation::Cut, solid)
    }

    fn with(mut self, operation: Operation, solid: Solid) -> Self {
        self.features.push(Feature { operation, solid });
        self
    }
}
