//! How candidates compete for a cloud: which have evidence enough, what each is worth, and who wins
//! where several want the same points.

use super::least_squares::degrees_of_freedom;
use super::thin::borders::{BorderPoint, Borders, border};
use super::thin::curve::is_curve;
use super::thin::rows::{Proof, is_torus_by_chance, proof};
use super::{Candidate, Parameters, Search};
use crate::cloud::Point;
use crate::surface::SurfaceType;

/// Share of the smaller support above which two candidates compete for the same place.
const CONTEST: f64 = 0.5;

/// What shows that a candidate is there.
pub enum Evidence<'b> {
    /// Points that no accepted surface holds.
    Own,
    /// Points on open borders too, which one accepted surface holds.
    Borders(&'b mut Borders),
}

impl Evidence<'_> {
    /// Whether a candidate has points enough beyond those that any surface of its family would
    /// hold, and evidence of its own.
    fn suffices(&self, search: &Search<'_>, contender: &Contender) -> bool {
        let candidate = &contender.candidate;
        let smallest = Parameters::count(search.parameters.smallest);
        let redundant = degrees_of_freedom(candidate.surface.kind()) + search.scale.redundancy();
        let is_clean = search.scale.is_clean();
        // Small accidents fill the tolerance; true faces are far more exact.
        let is_exact = !is_clean
            || candidate.support.len() >= LARGE
            || candidate.error <= search.scale.largest_error(ACCIDENT);
        if candidate.support.len() < smallest.max(redundant) || !is_exact {
            return false;
        }
        match self {
            Self::Own => {
                let support = candidate.support.iter().copied();
                let own: Vec<u32> = support
                    .filter(|&index| !search.is_explained(index))
                    .collect();
                // Within noise a band along the edge of a face lies on many surfaces.
                let is_new = is_clean || 2 * own.len() >= candidate.support.len();
                let needed = if is_clean {
                    search.scale.redundancy()
                } else {
                    NOISY_OWN
                };
                is_new
                    && own.len() >= smallest.max(needed)
                    && !is_curve(&search.points(&own), 2.0 * search.scale.tolerance)
                    && (!is_clean || contender.is_wide(search))
                    && !(is_clean && is_torus_by_chance(search, candidate))
                    && contender.thickness >= THICKNESS
            }
            Self::Borders(borders) => {
                if !borders.is_exact(candidate) {
                    return false;
                }
                let loose = contender.loose(search);
                let closed = |share: f64| loose as f64 <= share * contender.border.len() as f64;
                let two_sided = borders
                    .evidence(&candidate.support)
                    .is_some_and(|free| free >= 3);
                match contender.proof {
                    Proof::None => false,
                    Proof::Chance => two_sided && closed(CLOSED),
                    Proof::Weak => {
                        let is_blend = candidate.surface.kind() == SurfaceType::Torus;
                        candidate.support.len() >= ROWS_APART
                            && two_sided
                            && borders.is_anchored(&candidate.support)
                            && closed(if is_blend { CLOSED } else { HALF_CLOSED })
                            && (!is_blend || contender.is_tangent(search))
                    }
                    Proof::Certain => {
                        let is_closed = !contender.border.is_empty() && closed(CLOSED);
                        two_sided && closed(OPEN) || is_closed && search.own(candidate) >= 3
                    }
                }
            }
        }
    }

    /// What a contender is worth. Among thin faces its points count by what they tell of the face:
    /// fully inside it, a third where it joins another, and nothing where it ends in nowhere.
    fn worth(&self, search: &Search<'_>, contender: &Contender) -> f64 {
        match self {
            Self::Own => search.worth(&contender.candidate),
            Self::Borders(_) => {
                search.worth(&contender.candidate) - 3.0 * contender.loose(search) as f64
            }
        }
    }
}

/// A candidate in competition.
struct Contender {
    worth: f64,
    candidate: Candidate,
    border: Vec<BorderPoint>,
    proof: Proof,
    thickness: f64,
}

impl Contender {
    fn new(search: &mut Search<'_>, candidate: Candidate, proof: Proof) -> Self {
        let thickness = search.thickness(&candidate);
        let is_thin = search.scale.is_clean() && thickness < WIDE;
        let border = if is_thin {
            border(search, &candidate)
        } else {
            Vec::new()
        };
        Self {
            worth: 0.0,
            candidate,
            border,
            proof,
            thickness,
        }
    }

    /// Points at which it would end in nowhere.
    fn loose(&self, search: &Search<'_>) -> usize {
        let is_loose = |point: &&BorderPoint| !search.is_explained(point.index);
        self.border.iter().filter(is_loose).count()
    }

    /// Whether it runs on tangentially into the surfaces at its border, at most points that have any.
    fn is_tangent(&self, search: &Search<'_>) -> bool {
        let surface = &self.candidate.surface;
        let (mut held, mut smooth) = (0u32, 0u32);
        for point in &self.border {
            let foot = search.point(point.index);
            let normal = surface.normal(foot);
            let Some(other) = search.holder(point.index) else {
                continue;
            };
            held += 1;
            smooth += u32::from(normal.cross(&other.surface.normal(foot)).norm() < TANGENT);
        }
        2 * smooth > held
    }

    /// Whether its points inside are more than a single row: one row with the two beside it is on a
    /// cylinder or torus whatever it is. Three rows in one plane are no accident.
    fn is_wide(&self, search: &Search<'_>) -> bool {
        if self.candidate.surface.kind() == SurfaceType::Plane || self.border.is_empty() {
            return true;
        }
        let is_inside = |index: &&u32| {
            let found = self
                .border
                .binary_search_by_key(*index, |point| point.index);
            found.is_err()
        };
        let inside: Vec<Point> = self
            .candidate
            .support
            .iter()
            .filter(is_inside)
            .map(|&index| *search.point(index))
            .collect();
        !is_curve(&inside, 2.0 * search.scale.tolerance)
    }
}

/// Root mean square error, in tolerances, of a small patch on a surface by accident.
const ACCIDENT: f64 = 0.3;
/// Points above which a patch is no accident for its error alone.
const LARGE: usize = 400;

/// Share of the border that may end in nowhere, of a face whose rows are no proof: it must close a
/// gap on all sides.
const CLOSED: f64 = 0.3;
/// As [`CLOSED`], where the rows prove a little: one side may be closed by a face yet to be found.
const HALF_CLOSED: f64 = 0.8;

/// As [`CLOSED`], where the rows are proof: free-form regions have small accidents of any shape.
const OPEN: f64 = 0.6;
/// Points that three rows must have: with fewer in a row, the rows themselves are chance.
const ROWS_APART: usize = 12;
/// Sine of the angle below which surfaces run on into each other.
const TANGENT: f64 = 0.02;

/// Points of its own that a surface of a noisy cloud needs: over fewer, noise bends a plane into
/// anything.
const NOISY_OWN: usize = 12;

/// Mean number of a patch's own points among the eight nearest of each: along a row of points, which
/// lies on too many surfaces, it is two or three, in a strip of two rows five.
const THICKNESS: f64 = 3.5;

/// Thickness below which a patch may be all border: three rows of points have six or seven.
const WIDE: f64 = 7.2;

/// Whether the points of its own show that a candidate is there, and it ends sharply.
pub fn is_evident(search: &mut Search<'_>, candidate: &Candidate) -> bool {
    let contender = Contender::new(search, candidate.clone(), Proof::Certain);
    Evidence::Own.suffices(search, &contender) && !search.has_fuzzy_border(candidate)
}

/// Accepts candidates, the one worth most first, until none is worth keeping.
///
/// Every acceptance changes what the others are worth: the points it explains are theirs no more, and
/// a border that ended in nowhere may end there now. Returns how many were accepted; each is shown
/// to `accepted_one` first. O(candidates² × points of one).
pub fn accept_winners(
    search: &mut Search<'_>,
    candidates: Vec<Candidate>,
    evidence: &mut Evidence<'_>,
    accepted_one: &mut dyn FnMut(&Candidate),
) -> usize {
    let mut open: Vec<Contender> = Vec::new();
    for candidate in candidates {
        let proof = match evidence {
            Evidence::Own => Proof::Certain,
            Evidence::Borders(_) => proof(search, &candidate),
        };
        open.push(Contender::new(search, candidate, proof));
    }
    let mut accepted = 0;
    loop {
        open.retain(|contender| evidence.suffices(search, contender));
        for contender in &mut open {
            contender.worth = evidence.worth(search, contender);
        }
        open.sort_by(|a, b| b.worth.total_cmp(&a.worth));
        let Some(top) = open.first() else {
            return accepted;
        };
        let (places, contest): (Vec<usize>, Vec<(f64, &Candidate)>) = open
            .iter()
            .enumerate()
            .filter(|(_, other)| shared(&top.candidate.support, &other.candidate.support))
            .map(|(place, other)| (place, (other.worth, &other.candidate)))
            .unzip();
        let Some(best) = search.best_of(&contest) else {
            return accepted;
        };
        let Contender {
            candidate: winner,
            border,
            proof,
            ..
        } = open.swap_remove(places[best]);
        if !search.has_fuzzy_border(&winner) {
            if let Evidence::Borders(borders) = evidence {
                // Candidates are fewer than points, which u32 counts.
                let place = search.accepted().len() as u32;
                borders.settle(place, &winner, &border, proof == Proof::Certain);
            }
            accepted_one(&winner);
            search.accept(winner);
            accepted += 1;
        }
    }
}

/// Whether two ascending supports share more than half of the smaller one.
fn shared(a: &[u32], b: &[u32]) -> bool {
    let (small, large) = if a.len() <= b.len() { (a, b) } else { (b, a) };
    let common = small
        .iter()
        .filter(|index| large.binary_search(index).is_ok())
        .count();
    common as f64 > CONTEST * small.len() as f64
}
