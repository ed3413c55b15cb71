//! The judge of noisy clouds: one energy decides what surfaces there are and which points they have.
//!
//! Within noise no small neighbourhood tells its surface, and no threshold tells a face from an accident.
//! So surfaces are proposed in numbers (`propose`), and what an energy (`energy`) makes of them is kept:
//! the sum of what points cost on their surfaces, what borders between surfaces cost, and what each surface
//! costs for being there. It is lowered by turns (PEaRL; Isack and Boykov 2012): surfaces take over points
//! (`labelling`), are fitted to those they have, joined where one describes two more cheaply, and proposed
//! anew among points that are badly explained (`rounds`). In the end those that may share a direction or an axis do, which tells
//! families apart that the points of one face do not. What is left becomes faces (`faces`).

mod energy;
mod faces;
mod family;
mod height;
mod labelling;
mod maxflow;
mod noise;
mod propose;
mod rounds;

pub use faces::Face;
pub use noise::{measure, measure_plateau};

use super::Parameters;
use super::progress::{Cancelled, Observer, Stage};
use super::scale::Scale;
use super::search::Search;
use crate::random::Random;
use energy::{Deviation, Links, Priced};
use family::Measures;
use labelling::{Labelling, Scene};
use propose::{Proposal, Proposer};

/// Seeds of proposals at first, and again among badly explained points.
const SEEDS: [usize; 2] = [400, 150];
/// Times that surfaces are fitted, joined and labelled. With noise of 0.5 % three reach a mean DSC of 0.770 on forty training
/// models, five 0.779 and eight 0.783; below that five do as well as eight.
const ROUNDS: usize = 5;
/// Share of the time of each step after the first proposals have settled.
const STEP: f64 = 0.3 / (3 * ROUNDS - 1) as f64;
/// Standard deviation, in spacings, above which a cloud is the judge's. Of 38 training models with noise of 0.05 % of
/// the diagonal, some 0.07 spacings, HT alone reaches a mean DSC of 0.961 and the judge 0.979, from the prediction's side 0.914
/// and 0.980; with 0.03 % 0.968 and 0.978; below that they are level, and the ten test models are better off without.
const SWITCH: f64 = 0.04;
/// Share of the points on surfaces found, up to which a cloud taken for exact may be a mixture. Of one a third of whose
/// points is exact, that third at most is on any.
const FOUND: f64 = 0.35;
/// Points of a cloud whose noise can be told.
const ENOUGH: usize = 100;
/// Points that a face of a noisy cloud has at least.
const SMALLEST: usize = 12;

/// Whether a cloud of so many points is the judge's: where the points are so far off their surfaces that it
/// finds more than the methods that look for exact ones, and are enough for the noise to be told. Rounded
/// points are off all faces by steps, which these take for faces. Where no noise is told and the tolerance is wide
/// all the same, it was asked for, or a far point hides how small the part is.
pub fn is_for(scale: &Scale, points: usize) -> bool {
    let is_noisy = if scale.has_noise() {
        scale.step > 0.0 || scale.noise > SWITCH * scale.spacing
    } else {
        !scale.is_clean()
    };
    is_noisy && points >= ENOUGH
}

/// The noise of a cloud that was taken for exact, and of which so little was found on surfaces that it seems to be
/// a mixture: some of its points are exact, the others are not, and there are too few of the former to go by.
pub fn noise_of_mixture(search: &Search<'_>) -> Option<f64> {
    let points = search.cloud.points();
    let explained = (0u32..)
        .take(points.len())
        .filter(|&index| search.is_explained(index));
    if points.len() < ENOUGH || explained.count() as f64 > FOUND * points.len() as f64 {
        return None;
    }
    measure_plateau(points, &search.tree).filter(|noise| *noise > SWITCH * search.scale.spacing)
}

/// Finds the faces of a cloud whose noise is known.
///
/// # Errors
/// If the observer stops the fit.
pub fn judge(
    search: &Search<'_>,
    seed: u64,
    observer: &mut dyn Observer,
) -> Result<Vec<Face>, Cancelled> {
    let points = search.cloud.points();
    let graph = &search.graph;
    let links = Links::of(graph, points.len());
    let scene = Scene {
        points,
        tree: &search.tree,
        links: &links,
    };
    let measures = Measures {
        deviation: Deviation {
            noise: search.scale.noise,
            step: search.scale.step,
        },
        diameter: search.scale.diameter,
        weighs_families: true,
    };
    let alike = Measures {
        weighs_families: false,
        ..measures
    };
    let mut random = Random::new(seed, 1);
    let mut proposer = Proposer::new(points, &search.tree, graph, alike);
    let mut labelling = Labelling::empty(points.len(), measures.deviation);
    let mut usable = vec![true; points.len()];
    let mut progress = Progress {
        observer,
        done: 0.0,
        share: 0.4,
    };
    for (round, seeds) in std::iter::once(SEEDS[0])
        .chain(std::iter::repeat(SEEDS[1]))
        .take(ROUNDS)
        .enumerate()
    {
        let tell = &mut |share| progress.tell(share);
        let proposals = proposer.propose(&usable, seeds, &mut random, tell)?;
        progress.next(if round == 0 { 0.3 } else { STEP });
        settle(&mut labelling, &scene, proposals, &mut progress)?;
        progress.next(STEP);
        rounds::refit(&mut labelling, &scene, graph, &measures);
        rounds::join(&mut labelling, &scene, &measures);
        progress.tell(0.5)?;
        rounds::sweep(&mut labelling, &scene);
        usable = rounds::badly_explained(&labelling, graph);
        progress.next(STEP);
    }
    rounds::refit(&mut labelling, &scene, graph, &measures);
    rounds::share(&mut labelling, &scene, graph, &measures);
    let smallest = SMALLEST.max(Parameters::count(search.parameters.smallest));
    Ok(faces::faces(
        &labelling,
        points,
        graph,
        search.scale.spacing,
        smallest,
    ))
}

/// Lets the surfaces of proposals take points, the widest first.
fn settle(
    labelling: &mut Labelling,
    scene: &Scene<'_>,
    mut proposals: Vec<Proposal>,
    progress: &mut Progress<'_>,
) -> Result<(), Cancelled> {
    proposals.sort_by_key(|it| std::cmp::Reverse(it.support.len()));
    let count = proposals.len() as f64;
    for (place, proposal) in proposals.into_iter().enumerate() {
        progress.tell(place as f64 / count)?;
        let label = labelling.add(Priced::of(proposal.surface, proposal.support.len()));
        labelling.expand(scene, label);
    }
    Ok(())
}

/// How far the judge is.
struct Progress<'o> {
    observer: &'o mut dyn Observer,
    /// What is done of the whole.
    done: f64,
    /// What the present step is of the whole.
    share: f64,
}

impl Progress<'_> {
    /// Tells how much of the present step is done.
    fn tell(&mut self, fraction: f64) -> Result<(), Cancelled> {
        let done = (self.done + self.share * fraction).min(1.0);
        self.observer.progress(Stage::Find, done)
    }

    /// Begins the next step, of a share of the whole.
    fn next(&mut self, share: f64) {
        self.done += self.share;
        self.share = share;
    }
}

#[cfg(test)]
mod tests;
