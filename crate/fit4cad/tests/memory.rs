//! What a fit holds at its peak. One test alone: the count is of all threads.

#[cfg(target_arch = "wasm32")]
#[macro_use]
extern crate fit4cad_testing;

use fit4cad::fit::{Method, Parameters, fit};
use fit4cad::sample::{self, Options};

mod counting;

/// Bytes a point beyond the cloud, of which the tree and the graph of the neighbours take 105.
const MOST: usize = 190;

#[test]
fn a_fit_holds_few_bytes_a_point_beyond_a_small_cloud() {
    let options = Options {
        spacing: 0.0095,
        ..Options::default()
    };
    let cloud = sample::generate("housing", &options).unwrap().cloud;
    assert!((9_000..11_000).contains(&cloud.len()), "{}", cloud.len());
    for method in [Method::Hough, Method::Growing] {
        let parameters = Parameters::default();
        let (found, bytes) =
            counting::peak(|| fit(&cloud, method, &parameters, 1, &mut ()).unwrap());
        assert!(found.segmentation.primitives.len() > 20);
        let share = bytes / cloud.len();
        assert!(share <= MOST, "{method:?} holds {share} bytes a point");
    }
}
