//! Both fitters on tiny clouds, whatever their points.

use fit4cad::fit::parameters::TABLE;
use fit4cad::fit::single::fit_single;
use fit4cad::fit::{Method, Parameters, fit};

use super::MIB;
use crate::{Bytes, Target, shapes};

pub const HOUGH: Target = Target {
    name: "fit-ht",
    run: |input| fitted(input, Method::Hough),
    seeds: super::none,
    words: &[],
    longest: 768,
    floor: 48 * MIB,
    quick: 200,
};

pub const GROWING: Target = Target {
    name: "fit-pg",
    run: |input| fitted(input, Method::Growing),
    seeds: super::none,
    words: &[],
    longest: 768,
    floor: 16 * MIB,
    quick: 300,
};

pub const SINGLE: Target = Target {
    name: "fit-single",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let kinds = bytes.list(5, shapes::kind);
        let cloud = shapes::cloud(&mut bytes);
        let single = fit_single(cloud.points(), &kinds);
        assert!(single.margin >= 1.0, "{single:?}");
        assert!(kinds.is_empty() || kinds.contains(&single.best.surface.kind()));
    },
    seeds: super::none,
    words: &[],
    longest: 1024,
    floor: 4 * MIB,
    quick: 60,
};

pub const PARAMETERS: Target = Target {
    name: "parameters",
    run: |input| {
        let mut bytes = Bytes::new(input);
        while !bytes.is_empty() {
            let mut parameters = Parameters::default();
            let (name, value) = (bytes.text(), bytes.number());
            match parameters.set(&name, value) {
                Ok(()) => assert_eq!(parameters.get(&name), Some(value)),
                Err(error) => assert!(error.to_string().contains(&name)),
            }
        }
    },
    seeds: || {
        TABLE
            .iter()
            .map(|info| [info.name.as_bytes(), &[0, 180]].concat())
            .collect()
    },
    words: &[
        "tolerance",
        "noise",
        "smallest",
        "neighbours",
        "persistence",
        "sharp_quantile",
        "\0",
    ],
    longest: 256,
    floor: MIB / 16,
    quick: 60_000,
};

/// Largest value from which on a range is of lengths in the units of the cloud.
const WIDE: f64 = 1e6;

fn fitted(input: &[u8], method: Method) {
    let mut bytes = Bytes::new(input);
    let mut parameters = Parameters::default();
    for (place, share) in bytes.list(4, |bytes| (bytes.below(TABLE.len()), bytes.byte())) {
        let info = TABLE[place];
        let share = f64::from(share) / 255.0;
        let value = if info.maximum > WIDE {
            // Of lengths in any unit: from a millionth to a million.
            10f64.powf(12.0 * share - 6.0)
        } else {
            info.minimum + (info.maximum - info.minimum) * share
        };
        let value = if info.whole { value.round() } else { value };
        assert!(parameters.set(info.name, value).is_ok());
    }
    let seed = bytes.seed();
    let cloud = shapes::cloud(&mut bytes);
    let Ok(found) = fit(&cloud, method, &parameters, seed, &mut ()) else {
        return;
    };
    for primitive in &found.segmentation.primitives {
        assert!(!primitive.points.is_empty() && primitive.points.is_sorted_by(|a, b| a < b));
        assert!(
            primitive
                .points
                .last()
                .is_none_or(|&last| (last as usize) < cloud.len())
        );
    }
}
