//! One face of a profile, and which have the same shape.

use super::recurring::VOTES;
use crate::fit::Candidate;
use crate::surface::Surface;

/// How far apart chords, and radii, of congruent pieces may be, in tolerances: the radius of a short arc
/// is not known well.
const CONGRUENT: [f64; 2] = [4.0, 30.0];

/// An extruded face.
pub struct Face {
    /// The positions of its rulings, in order.
    pub rulings: Vec<usize>,
    /// Its surface with the points on it.
    pub candidate: Candidate,
    /// Whether it is there whatever is beside it.
    pub is_sure: bool,
    /// Whether the profile has many congruent pieces.
    pub recurs: bool,
    /// Distance from its first ruling to its last.
    pub chord: f64,
}

impl Face {
    /// Whether two faces have the same shape, in tolerances.
    fn is_congruent(&self, other: &Self, tolerance: f64) -> bool {
        let near = |a: f64, b: f64, limit: f64| (a - b).abs() <= limit * tolerance;
        near(self.chord, other.chord, CONGRUENT[0])
            && match (&self.candidate.surface, &other.candidate.surface) {
                (Surface::Cylinder(a), Surface::Cylinder(b)) => {
                    near(a.radius, b.radius, CONGRUENT[1])
                }
                (a, b) => a.kind() == b.kind(),
            }
    }
}

/// Tells of each face whether it is one of many congruent ones. O(faces × those of about its chord).
pub fn tell_recurring(faces: &mut [Vec<Option<Face>>], tolerance: f64) {
    let mut all: Vec<&mut Face> = faces.iter_mut().flatten().flatten().collect();
    all.sort_by(|a, b| a.chord.total_cmp(&b.chord));
    for place in 0..all.len() {
        let chord = all[place].chord;
        let from = all.partition_point(|face| face.chord < chord - CONGRUENT[0] * tolerance);
        let about = all[from..]
            .iter()
            .take_while(|face| face.chord <= chord + CONGRUENT[0] * tolerance);
        let same = about.filter(|face| face.is_congruent(all[place], tolerance));
        let recurs = same.take(VOTES).count() == VOTES;
        all[place].recurs = recurs;
    }
}
