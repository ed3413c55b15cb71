//! The stages after the search, run on the true surfaces: what they lose is their own loss.

use fit4cad::fit::{Cancelled, Candidate, Parameters, Search, stages};
use fit4cad::model::{Model, Segmentation};

/// A segmentation from the surfaces of the truth, each grown from its true points as a search would
/// have grown it.
pub fn fit(model: &Model, parameters: &Parameters) -> Result<Segmentation, Cancelled> {
    let mut search = Search::new(&model.cloud, parameters, 1);
    let truth = model.truth.iter().flat_map(|truth| &truth.primitives);
    for primitive in truth {
        let Some(surface) = primitive.surface else {
            continue;
        };
        let tolerance = search.scale.tolerance;
        let on = |&i: &u32| surface.distance(search.point(i)) <= tolerance;
        let mut support: Vec<u32> = primitive.points.iter().copied().filter(on).collect();
        support.sort_unstable();
        let listed = Candidate {
            surface,
            support,
            error: 0.0,
        };
        let candidate = search.grow(&surface, &primitive.points).unwrap_or(listed);
        if !candidate.support.is_empty() {
            search.accept(candidate);
        }
    }
    stages::finish(&search, &mut ())
}
