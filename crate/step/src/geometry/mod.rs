//! Curves and surfaces as STEP knows them, to be evaluated and inverted. Lengths in millimetres,
//! angles in radians.

pub(crate) mod axis;
pub(crate) mod chart;
pub(crate) mod curve;
pub(crate) mod edge;
pub(crate) mod families;
mod moved;
pub(crate) mod nearest;
pub(crate) mod shape;
pub(crate) mod spline;
pub(crate) mod swept;
