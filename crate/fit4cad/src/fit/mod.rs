//! Methods that make a submission from a bare cloud.
//!
//! A method differs from another only in how it **finds** surfaces. Everything around that is
//! shared: [`places`] leave out points that only repeat others and put the rest in an order of their
//! own; a [`Search`] holds the cloud with
//! its neighbours, scale and what is explained so far; a method hands it surfaces that might be
//! there ([`Search::grow`] polishes one by least squares and grows its patch into a [`Candidate`],
//! [`Search::best`] lets candidates compete, [`Search::accept`] keeps the winner); [`thin`] proposes
//! surfaces for faces that only their neighbours tell, and [`contest`] says what shows that a
//! candidate is there; then [`stages`] prune, label and split into patches.
//!
//! ```text
//! cloud → Places → Search → hough::find or growing::find → specks → prune → label → patches → Segmentation
//!                           local::starts → grow → best → accept
//! ```
//!
//! What they find is at last fitted to the points it has, surface by surface ([`mod@refit`]).
//!
//! In a cloud whose noise is no small part of the spacing, a handful of points on a surface says nothing.
//! There both methods leave the cloud to the same [`mod@judge`], and find the same.

pub mod axes;
pub mod contest;
pub mod detect;
pub mod given;
pub mod growing;
pub mod holders;
pub mod hough;
pub mod judge;
pub mod least_squares;
pub mod local;
pub mod noise;
pub mod parameters;
pub mod places;
pub mod profile;
pub mod progress;
pub mod pure;
pub mod quadric;
mod quantile;
pub mod refit;
pub mod relations;
pub mod scale;
pub mod search;
pub mod single;
pub mod specks;
pub mod stages;
pub mod thin;
pub mod trace;

pub use noise::Noise;
pub use parameters::Parameters;
pub use progress::{Cancelled, Observer, Stage};
pub use scale::Scale;
pub use search::Search;

use crate::cloud::Cloud;
use crate::model::{Primitive, Segmentation};
use crate::surface::Surface;
use noise::Kind;
use parameters::ParameterError;
use places::{Places, Unfolded};
use thiserror::Error;
use trace::Event;

/// How surfaces are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Method {
    /// HT: votes in parameter space (paper, section "HT").
    Hough,
    /// PG: primitive growing from neighbourhoods (paper, section "PG").
    Growing,
}

impl Method {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Hough, Self::Growing];

    /// Name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Hough => "ht",
            Self::Growing => "pg",
        }
    }

    /// The paper's abbreviation: what submissions made by it are called.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Hough => "HT",
            Self::Growing => "PG",
        }
    }

    /// Its name in full.
    pub const fn full_name(self) -> &'static str {
        match self {
            Self::Hough => "Hough transform",
            Self::Growing => "primitive growing",
        }
    }

    /// How it finds surfaces, in a sentence.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Hough => {
                "Points vote for surfaces in the space of their parameters; persistent peaks \
                 become primitives."
            }
            Self::Growing => {
                "Smooth regions grow from neighbourhoods, and slippage tells what surface each \
                 lies on."
            }
        }
    }
}

/// A surface that may be one of the cloud's primitives, with the points that speak for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The surface, fitted to its support.
    pub surface: Surface,
    /// Indices of the points on it, connected, ascending.
    pub support: Vec<u32>,
    /// Root mean square distance of the support to the surface, in the units of the cloud.
    pub error: f64,
}

/// What a fit gives.
#[derive(Debug, Clone, PartialEq)]
pub struct Fit {
    /// The primitives found, largest first: a submission like any other.
    pub segmentation: Segmentation,
    /// The scale the cloud was taken to have.
    pub scale: Scale,
    /// How many places were fitted, where they are not all: the [subsample](Parameters::subsample) asked for.
    pub thinned: Option<usize>,
    /// The noise it went by.
    pub noise: Noise,
}

impl Fit {
    /// What a submission by a method is called, so that it says where only some of the points were fitted:
    /// `HT`, `HT on 50000 points`.
    pub fn title(&self, method: Method) -> String {
        match self.thinned {
            None => method.title().to_owned(),
            Some(count) => format!("{} on {count} points", method.title()),
        }
    }
}

/// Why there is no fit.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum FitError {
    /// Its observer stopped it.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
    /// A parameter cannot be meant for the cloud.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
}

/// Fits primitives to a bare cloud. The same points, parameters and seed give the same answer, in
/// whatever order the points are listed.
///
/// About O(n log n) for a given number of surfaces. Points whose coordinates are not finite stay
/// unsegmented. The observer may stop the fit; its trace costs nothing when not wanted.
///
/// # Errors
/// If the observer stops the fit, or the noise given is larger than the cloud.
///
/// ```
/// use fit4cad::cloud::{Cloud, Point};
/// use fit4cad::fit::{Method, Parameters, fit};
/// let grid = (0..400).map(|i| Point::new(f64::from(i % 20), f64::from(i / 20), 3.0));
/// let cloud = Cloud::new(grid.collect());
/// let fit = fit(&cloud, Method::Growing, &Parameters::default(), 1, &mut ())?;
/// assert_eq!(fit.segmentation.primitives[0].points.len(), 400);
/// # Ok::<(), fit4cad::fit::FitError>(())
/// ```
pub fn fit(
    cloud: &Cloud,
    method: Method,
    parameters: &Parameters,
    seed: u64,
    observer: &mut dyn Observer,
) -> Result<Fit, FitError> {
    observer.progress(Stage::Prepare, 0.0)?;
    parameters.suit(cloud)?;
    let (places, tree) = Places::of(cloud, parameters.most());
    let mut search = Search::over(places.cloud(), tree, parameters, seed);
    let observer = &mut Unfolded {
        observer,
        standing_for: places.standing_for(),
    };
    let is_noisy = judge::is_for(&search.scale, places.cloud().len());
    let is_told = parameters.noise > 0.0 && search.scale.has_noise();
    // Points that fill space do so whatever noise is told: within wide noise they would be on anything.
    let measured =
        is_noisy.then(|| judge::measure(places.cloud().points(), &search.tree, &search.scale));
    let told = search.scale.noise;
    let noise = measured.flatten();
    let noise = noise.map(|measured| if is_told { told } else { measured });
    if let Some(noise) = noise {
        search.scale = search
            .scale
            .with_noise(noise, parameters.tolerance, is_told);
    }
    if observer.wants_trace() {
        observer.trace(Event::Scale(search.scale));
    }
    let (found, kind) = if noise.is_some() {
        (judged(&search, seed, observer)?, Kind::Scattered)
    } else if is_noisy {
        // The points fill space.
        observer.progress(Stage::Patches, 1.0)?;
        (Segmentation::default(), Kind::Everywhere)
    } else {
        find(&mut search, method, observer)?;
        let mixture = (!is_told).then(|| judge::noise_of_mixture(&search));
        if let Some(noise) = mixture.flatten() {
            search.scale = search.scale.with_noise(noise, parameters.tolerance, false);
            (judged(&search, seed, &mut Late(observer))?, Kind::Mixed)
        } else {
            (stages::finish(&search, observer)?, Kind::Scattered)
        }
    };
    let refitted = refit::refit(&search, &found, observer)?;
    // Points that stand for others lend them their labels by the surfaces that those were given by.
    let mut segmentation = places.unfold(&search, found);
    refit::apply(&mut segmentation, &refitted);
    Ok(Fit {
        noise: Noise::of(&search, kind),
        segmentation,
        scale: search.scale,
        thinned: places.are_thinned().then(|| places.cloud().len()),
    })
}

/// An observer of a second search: of what it tells of its progress, the first has been at the end already.
struct Late<'o, 'p>(&'o mut Unfolded<'p>);

impl Observer for Late<'_, '_> {
    fn progress(&mut self, stage: Stage, fraction: f64) -> Result<(), Cancelled> {
        let fraction = if stage == Stage::Find { 1.0 } else { fraction };
        self.0.progress(stage, fraction)
    }

    fn wants_trace(&self) -> bool {
        self.0.wants_trace()
    }

    fn trace(&mut self, event: Event) {
        self.0.trace(event);
    }
}

/// The faces of a noisy cloud, as primitives.
fn judged(
    search: &Search<'_>,
    seed: u64,
    observer: &mut dyn Observer,
) -> Result<Segmentation, Cancelled> {
    let faces = judge::judge(search, seed, observer)?;
    if observer.wants_trace() {
        for face in &faces {
            observer.trace(Event::Accepted {
                surface: face.surface,
                support: face.points.clone(),
            });
        }
    }
    observer.progress(Stage::Patches, 1.0)?;
    let primitives = faces.into_iter();
    let primitives = primitives.map(|face| Primitive::on(face.surface, 0, face.points));
    Ok(stages::ranked(primitives.collect()))
}

/// Finds surfaces by a method: what [`fit`] does before the [`stages`] that all methods share. They
/// are the search's accepted candidates afterwards.
///
/// # Errors
/// If the observer stops the fit.
pub fn find(
    search: &mut Search<'_>,
    method: Method,
    observer: &mut dyn Observer,
) -> Result<(), Cancelled> {
    match method {
        Method::Hough => hough::find(search, observer)?,
        Method::Growing => growing::find(search, observer)?,
    }
    thin::scattered::scattered(search, observer)?;
    specks::specks(search, observer)
}

#[cfg(test)]
mod tests;
