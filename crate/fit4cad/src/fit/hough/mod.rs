//! HT: the Hough-transform fitter (paper, section "HT: Simple primitive fitting based on Hough
//! transform").
//!
//! Every surface of a family is a point of a parameter space, and every point P of the cloud a
//! hypersurface Γ_P there: the surfaces through P. Where many Γ_P meet, a surface holds many points.
//!
//! The paper's method votes with single points, which light a hypersurface of cells each. This one
//! votes with small neighbourhoods, whose Γ_P have already been intersected by a closed-form solution
//! (a randomised Hough transform): one vote is one cell, so that accumulators can be sparse and fine.
//!
//! ```text
//! solutions                     neighbourhoods → votes, besides those of thin faces (`fit::thin`)
//! family, vote                  votes → ladder of small spaces → consensus of each peak's voters
//!   directions, grid              the spaces: half the Gauss sphere; boxes of up to three axes
//!   accumulator, persistence      𝓗 and its maxima above 10 % of the highest
//! rounds                        summits → grown and polished → compete (`fit::contest`) → accepted
//! recurring                     directions that the accepted surfaces have in common
//! pass                          rounds of votes by one kind of neighbourhood
//! find, noisy                   passes until nothing is left, without and with noise
//! gamma, trace, recorder        Γ_P of single points and everything above as data, for lessons
//! ```
//!
//! Clouds with much noise do not come here (see [`judge`](super::judge)). On clouds without the search goes from neighbourhoods that cannot be wrong (all points on
//! one plane, on one quadric, on one curve turned about a known axis) to those that may be mixed, to
//! the profiles of narrow extruded faces as wholes ([`profile`](super::profile)), and last to rings
//! and chamfers with no interior points, which only the open borders of their neighbours show.

pub mod accumulator;
pub mod directions;
pub mod family;
mod find;
pub mod gamma;
pub mod grid;
mod noisy;
mod pass;
pub mod persistence;
pub mod recorder;
mod recurring;
mod rounds;
mod solutions;
pub mod space;
pub mod trace;
pub mod vote;

pub use find::find;
