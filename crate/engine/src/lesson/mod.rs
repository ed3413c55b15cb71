//! What the lessons ask for, and no other page.

pub mod forms;
pub mod hough;
pub mod painting;
