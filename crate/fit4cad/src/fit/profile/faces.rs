//! Which pieces of the profiles along one direction are faces.

use super::face::{Face, tell_recurring};
use super::partition::{Piece, partition};
use super::recurring::Recurring;
use super::rulings::{Ruling, is_empty_between};
use super::sections::Section;
use crate::fit::least_squares::{self, Loss};
use crate::fit::thin::borders;
use crate::fit::thin::chains::Chain;
use crate::fit::thin::profile::{Curve, Place, apart};
use crate::fit::{Candidate, Search};
use crate::surface::Surface;

/// Steps from ruling to ruling of an arc that is no accident.
const SURE_ARC: usize = 4;
/// Pieces in a row that prove nothing by themselves, of which the known faces on both sides prove
/// that they are there. A free-form profile is a long row of such pieces.
const UNSURE: usize = 3;

impl Section {
    /// The faces that the profiles prove.
    pub fn faces(&self, search: &mut Search<'_>) -> Vec<Face> {
        let exact = borders::exact(search);
        let recurring = self.recurring(search, exact);
        let mut faces: Vec<Vec<Option<Face>>> = Vec::new();
        for chain in &self.chains {
            let pieces = self.partition(chain, exact, &recurring).into_iter();
            let pieces = pieces.map(|piece| {
                let face = self.face(search, chain, &piece, exact);
                face.or_else(|| self.face(search, chain, &self.straightened(chain, &piece)?, exact))
            });
            faces.push(pieces.collect());
        }
        tell_recurring(&mut faces, search.scale.tolerance);
        let chains = self.chains.iter().zip(faces);
        chains
            .flat_map(|(chain, faces)| self.proved(search, chain, faces))
            .collect()
    }

    /// The line through a piece of two rulings on an arc. Where a row of faces goes around an axis, any
    /// two rulings that are mirror images are on a circle that recurs.
    fn straightened(&self, chain: &Chain, piece: &Piece) -> Option<Piece> {
        let [first, last] = piece.ends.map(|end| self.rulings[chain.places[end]].place);
        let is_arc = matches!(piece.curve, Curve::Circle(..));
        (is_arc && piece.ends[1] - piece.ends[0] == 1).then_some(Piece {
            curve: Curve::Line(first, last),
            ..*piece
        })
    }

    /// Those faces of a chain that are sure, or in a short run between known ones. Of a run, congruent
    /// pieces elsewhere prove as much as a known face does.
    fn proved(&self, search: &Search<'_>, chain: &Chain, faces: Vec<Option<Face>>) -> Vec<Face> {
        let is_short = |run: &[Face]| run.iter().filter(|face| !face.recurs).count() <= UNSURE;
        let has_sure = faces.iter().flatten().any(|face| face.is_sure);
        let mut proved = Vec::new();
        let mut run: Vec<Face> = Vec::new();
        // Whether what comes before the run is known.
        let mut anchored = self.is_end_known(chain, chain.places.first());
        for face in faces {
            match face {
                Some(face) if face.is_sure => {
                    if anchored && is_short(&run) {
                        proved.append(&mut run);
                    }
                    run.clear();
                    proved.push(face);
                    anchored = true;
                }
                Some(face) if has_sure || self.ends_at_faces(search, &face) => run.push(face),
                _ => {
                    run.clear();
                    anchored = false;
                }
            }
        }
        if anchored && is_short(&run) && self.is_end_known(chain, chain.places.last()) {
            proved.append(&mut run);
        }
        proved
    }

    /// Whether a known face goes on from an end of a chain.
    fn is_end_known(&self, chain: &Chain, end: Option<&usize>) -> bool {
        !chain.is_closed && end.is_some_and(|&row| self.known[row] > 0)
    }

    fn partition(&self, chain: &Chain, exact: f64, recurring: &Recurring) -> Vec<Piece> {
        let rulings = chain.places.iter();
        let places: Vec<Place> = rulings.map(|&it| self.rulings[it].place).collect();
        partition(&places, exact, recurring)
    }

    /// What recurs: the circles of accepted cylinders that are more than rulings, and of arcs with more
    /// rulings than any circle is on.
    fn recurring(&self, search: &Search<'_>, exact: f64) -> Recurring {
        let mut sure: Vec<Curve> = Vec::new();
        for candidate in search.accepted() {
            if let Surface::Cylinder(cylinder) = &candidate.surface
                && self.is_along(&candidate.surface)
                && !Self::is_rows_only(candidate, &self.rows(candidate))
            {
                let centre = self.plan.place(&cylinder.centre);
                sure.push(Curve::Circle(centre, cylinder.radius));
            }
        }
        for chain in &self.chains {
            let pieces = self
                .partition(chain, exact, &Recurring::default())
                .into_iter();
            let long = pieces.filter(|piece| piece.ends[1] - piece.ends[0] >= SURE_ARC);
            sure.extend(long.map(|piece| piece.curve));
        }
        let linked = self.chains.iter().flat_map(|chain| &chain.places);
        let places: Vec<Place> = linked.map(|&row| self.rulings[row].place).collect();
        Recurring::of(&sure, &places, search.scale.tolerance)
    }

    /// The face of a piece; `None` where its points are on no such surface.
    fn face(
        &self,
        search: &mut Search<'_>,
        chain: &Chain,
        piece: &Piece,
        exact: f64,
    ) -> Option<Face> {
        let rulings = &chain.places[piece.ends[0]..=piece.ends[1]];
        let [first, .., last] = *rulings else {
            return None;
        };
        let start = self.plan.surface(&piece.curve);
        let rows = rulings.iter().flat_map(|&it| &self.rulings[it].points);
        let mut support: Vec<u32> = rows.copied().collect();
        support.sort_unstable();
        support.dedup();
        // Two rulings on a recurring circle say no more about it.
        let is_told = rulings.len() < 3 && matches!(piece.curve, Curve::Circle(..));
        let surface = if is_told {
            start
        } else {
            least_squares::fit(&start, &search.points(&support), Loss::Squares)?.surface
        };
        let error = search.error(&surface, &support);
        let limit = if is_told {
            search.scale.tolerance
        } else {
            exact
        };
        if !search.is_plausible(&surface) || error > limit {
            return None;
        }
        let candidate = Candidate {
            surface,
            support,
            error,
        };
        let rows: Vec<&Ruling> = rulings.iter().map(|&it| &self.rulings[it]).collect();
        let needed = match piece.curve {
            Curve::Line(..) => 3,
            Curve::Circle(..) => 4,
        };
        let is_sure = rulings.len() >= needed && !search.has_fuzzy_border(&candidate);
        let is_bare = |pair: &[&Ruling]| {
            is_empty_between(search, &self.plan, &candidate.surface, pair[0], pair[1])
        };
        if !is_sure && !rows.windows(2).all(is_bare) {
            return None;
        }
        Some(Face {
            rulings: rulings.to_vec(),
            candidate,
            is_sure,
            recurs: false,
            chord: apart(self.rulings[first].place, self.rulings[last].place),
        })
    }

    /// Whether at least half the ends of a face's rulings are on two faces already known: it begins and
    /// ends where others do.
    fn ends_at_faces(&self, search: &Search<'_>, face: &Face) -> bool {
        let rows = face.rulings.iter().map(|&row| &self.rulings[row]);
        let held: usize = rows.map(|row| self.ends_held(search, row)).sum();
        held >= face.rulings.len()
    }

    /// How many ends of a ruling are held by two faces, or have a face across the rulings within the
    /// ruling's own longest gap: of a cloud that was thinned out, few rulings have their last points.
    fn ends_held(&self, search: &Search<'_>, ruling: &Ruling) -> usize {
        let heights: Vec<f64> = ruling
            .points
            .iter()
            .map(|&index| self.plan.height(search.point(index)))
            .collect();
        let gap = heights
            .windows(2)
            .map(|it| it[1] - it[0])
            .fold(0.0, f64::max);
        let is_held = |&&index: &&u32| {
            if self.held[index as usize] >= 2 {
                return true;
            }
            let reach = gap + search.scale.spacing;
            let mut found = Vec::new();
            let is_across = |other: u32| self.across[other as usize];
            search
                .tree
                .nearest(search.point(index), 1, reach, is_across, &mut found);
            !found.is_empty()
        };
        let ends = [ruling.points.first(), ruling.points.last()];
        ends.into_iter().flatten().filter(is_held).count()
    }
}
