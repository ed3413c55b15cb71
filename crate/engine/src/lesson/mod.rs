//! What the lessons ask for, and no other page.

pub mod forms;
pub mod growing;
pub mod hough;
pub mod painting;
mod protocols;
