//! The search of a cloud with noise.
//!
//! Within the noise a strip of a cylinder is a plane and a band of it a sphere, so no small
//! neighbourhood can be trusted to know its family. All families vote everywhere, every summit is
//! grown as far as it goes, and only then do the candidates compete: a face is told from its strips
//! by how much of the cloud it explains.

use super::pass::Pass;
use super::rounds::Work;
use super::solutions;
use crate::fit::{Cancelled, Search, Stage, detect};
use crate::surface::SurfaceType;

/// Radius of curvature, in diameters of the cloud, whose sagitta over a neighbourhood should stand out of noise.
const TYPICAL_RADIUS: f64 = 0.112;
/// By how many standard deviations it should.
const STAND_OUT: f64 = 2.6;
/// Smallest and largest neighbourhood.
const SIZES: [usize; 2] = [20, 160];

/// Finds the surfaces of a noisy cloud.
///
/// # Errors
/// If the observer stops the fit.
pub fn find(search: &mut Search<'_>, work: &mut Work<'_>) -> Result<(), Cancelled> {
    let size = neighbourhood(search);
    let passes = [
        (size, 160, &SurfaceType::ALL[..], [0.0, 0.7]),
        (size / 2, 100, &SurfaceType::ALL[..4], [0.7, 0.9]),
    ];
    for (size, batch, kinds, progress) in passes {
        let pass = Pass {
            failures: batch,
            batch,
            progress,
        };
        pass.run(search, work, &mut |search, seed, votes, blocked| {
            let patch = search.unexplained_near(seed, size);
            if 3 * patch.len() < 2 * size {
                return;
            }
            let before = votes.len();
            solutions::mixed_votes(search, seed, &patch, kinds, patch.len() / 4, votes);
            // The next seed should see another part of the cloud.
            let near = if votes.len() > before {
                size / 4
            } else {
                size / 2
            };
            for &index in patch.iter().take(near) {
                blocked[index as usize] = true;
            }
        })?;
    }
    remainder(search, work)?;
    work.recorder.progress(Stage::Find, 1.0)
}

/// What no peak stood out for: faces of few votes, sought one at a time around unexplained points.
fn remainder(search: &mut Search<'_>, work: &mut Work<'_>) -> Result<(), Cancelled> {
    let order = detect::shuffled(search);
    let mut blocked = vec![false; order.len()];
    let mut patience = PATIENCE;
    for seed in order {
        if search.is_explained(seed) || blocked[seed as usize] {
            continue;
        }
        if let Some(candidate) = detect::at(search, seed) {
            work.recorder.accepted(&candidate);
            search.accept(candidate);
            patience = PATIENCE;
            continue;
        }
        patience -= 1;
        if patience == 0 {
            break;
        }
        for index in search.unexplained_near(seed, SIZES[0]) {
            blocked[index as usize] = true;
        }
        work.recorder.progress(Stage::Find, 0.95)?;
    }
    Ok(())
}

/// Seeds in a row that may lead nowhere.
const PATIENCE: usize = 100;

/// Points of a neighbourhood wide enough for curvature to stand out of the noise: a sagitta
/// h²/2r of so many σ over its radius h.
fn neighbourhood(search: &Search<'_>) -> usize {
    let scale = &search.scale;
    let squared = 2.0 * TYPICAL_RADIUS * scale.diameter * STAND_OUT * scale.noise;
    let count = std::f64::consts::PI * squared / (scale.spacing * scale.spacing);
    (count as usize).clamp(SIZES[0], SIZES[1])
}
