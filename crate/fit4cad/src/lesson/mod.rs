//! What the lessons ask of the engine and no other part of the playground does: small models made to
//! be understood, and single steps of the methods on request. Everything here calls the same
//! functions as scoring and fitting do; nothing is imitated.

pub mod forms;
pub mod growing;
pub mod hough;
pub mod painting;
