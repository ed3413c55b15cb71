//! The targets, by what they are about.

mod fit;
mod foreign;
mod hdf5;
mod lesson;
mod paths;
mod planted;
mod sample;
mod score;
mod step;
mod surface;
mod text;
mod view;

use crate::Target;

/// A mebibyte.
const MIB: usize = 1 << 20;

/// No inputs to begin with: coverage finds the way through arguments by itself.
fn none() -> Vec<Vec<u8>> {
    Vec::new()
}

/// Every target of a normal run.
pub static TARGETS: &[Target] = &[
    text::CLOUD,
    text::PIECES,
    text::PRIMITIVES,
    text::PARAMETRIC,
    text::IMPLICIT,
    text::MODEL,
    text::ROUND_TRIP,
    foreign::FOREIGN,
    foreign::EXPORT,
    hdf5::OPEN,
    step::READ,
    step::WRITE,
    paths::GROUP,
    paths::PATHS,
    score::SCORE,
    score::FIELD,
    score::SUMMARIES,
    score::STATISTICS,
    score::AUDIT,
    surface::CONVERSIONS,
    surface::GEOMETRY,
    surface::PATCH,
    surface::IMPLICITIZE,
    sample::GENERATE,
    sample::COMPOSE,
    sample::CUT,
    lesson::HOUGH,
    lesson::GROWING,
    lesson::FORMS,
    lesson::PAINTING,
    fit::HOUGH,
    fit::GROWING,
    fit::SINGLE,
    fit::PARAMETERS,
    view::SCENE,
    view::CAMERA,
    view::PICTURE,
];

/// Faults on purpose, to see whether the runner finds them; never part of a normal run.
pub use planted::ALL as PLANTED;
