//! Profiles: faces that were extruded along one direction, seen along it, all at once.
//!
//! The faces of combs, racks and fins are so narrow that each shows but two or three rulings of
//! points, and every hypothesis from a small neighbourhood is a guess: any two rulings are in a
//! plane and any three on a cylinder, also those in the middle of which one face ends and the next
//! begins. Seen along the direction a ruling is one place, and the faces are lines and arcs of a
//! plane curve that runs from each ruling to the next. The curve as a whole tells its pieces: of all
//! partitions into lines and arcs the true one is the shortest to describe.
//!
//! What recurs decides where a piece alone would not: an arc of a circle that other faces are on, or
//! of a radius that other arcs have, is shorter to describe than another. And a piece that was
//! accepted from a neighbourhood, all of whose rulings have both their faces in the partition without
//! it, is taken back.
//!
//! ```text
//! rulings     points → rows along the direction
//! recurring   rows, accepted cylinders → circles and radii that recur
//! partition   places in order → lines and arcs
//! sections    all of it, and what is known
//! faces       pieces → each a face, and those that are proved
//! ```

mod face;
mod faces;
mod partition;
mod recurring;
mod rulings;
mod sections;

use sections::Section;

use super::{Candidate, Search};
use crate::cloud::Direction;

/// Decides the extruded faces of a clean cloud along some directions by their profiles: accepts the
/// pieces, telling `tell` of each, and takes back what was accepted across them. Returns of each point
/// whether all faces it is on are known from a profile.
///
/// O(n log n) per direction.
pub fn extruded(
    search: &mut Search<'_>,
    directions: &[Direction],
    tell: &mut dyn FnMut(&Candidate),
) -> Vec<bool> {
    let mut told = vec![false; search.cloud.len()];
    let sections = directions.iter().map(|&it| Section::of(search, it));
    let mut sections: Vec<Section> = sections.collect();
    // The direction that most points are in rows along has the fewest accidents.
    sections.sort_by_key(|section| std::cmp::Reverse(section.size()));
    for mut section in sections {
        section.link(search, &told);
        let faces = section.faces(search);
        section.settle(search, faces, &mut told, tell);
    }
    told
}

#[cfg(test)]
mod tests;
