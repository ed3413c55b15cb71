//! From the surfaces a method found to a segmentation: prune, label, patches. Every fitter shares
//! these stages, so methods differ only in what they find.

mod contacts;
mod halves;
mod label;
mod links;
mod patches;
mod polygon;
mod prune;

pub use contacts::split_contacts;
pub use halves::join_halves;
pub use label::{Labels, label};
pub use links::{FOURTH, STEPS};
pub use patches::{Patch, patches};
pub use prune::{held, prune};

use super::Parameters;
use super::progress::{Cancelled, Observer, Stage};
use super::search::Search;
use crate::model::{Primitive, Segmentation};

/// Runs the three stages on what a search accepted.
///
/// # Errors
/// If the observer stops the fit.
pub fn finish(search: &Search<'_>, observer: &mut dyn Observer) -> Result<Segmentation, Cancelled> {
    observer.progress(Stage::Prune, 0.0)?;
    let kept = prune(search, search.accepted().to_vec());
    observer.progress(Stage::Label, 0.0)?;
    let labels = label(search, &kept);
    observer.progress(Stage::Patches, 0.0)?;
    let smallest = Parameters::count(search.parameters.smallest);
    // Splinters of a noisy face are no primitives.
    let smallest = if search.scale.shows_rows() {
        smallest
    } else {
        smallest.max(SPLINTER)
    };
    // Of a clean cloud small patches too may be halves of one that is not.
    let alone = if search.scale.is_clean() { 1 } else { smallest };
    let patches = patches(search, &kept, &labels, alone);
    let patches = split_contacts(search, &labels, patches);
    let mut primitives: Vec<Primitive> = Vec::new();
    for Patch { surface, points } in join_halves(search, patches) {
        if points.len() >= smallest {
            primitives.push(Primitive::on(surface, 0, points));
        }
    }
    observer.progress(Stage::Patches, 1.0)?;
    Ok(ranked(primitives))
}

/// Primitives numbered from the largest to the smallest.
pub fn ranked(mut primitives: Vec<Primitive>) -> Segmentation {
    primitives.sort_by_key(|primitive| std::cmp::Reverse(primitive.points.len()));
    for (number, primitive) in (1..).zip(&mut primitives) {
        primitive.number = number;
    }
    Segmentation { primitives }
}

/// Points that a patch of a noisy cloud needs.
const SPLINTER: usize = 20;

#[cfg(test)]
mod tests;
