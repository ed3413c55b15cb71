//! The generator: options, parts of the catalogue, parts of blocks, and what is cut away.

use fit4cad::model::Model;
use fit4cad::sample::{
    self, Block, Degradation, Lasso, Losses, Options, Region, SHAPES, blocks::Operation,
};

use super::MIB;
use crate::{Bytes, Target, shapes};

/// Finer spacings make models of up to two million points, which take seconds as they should.
const FINEST: f64 = 0.03;

pub const GENERATE: Target = Target {
    name: "generate",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let parts = sample::parts();
        let known = parts[bytes.below(parts.len())].name;
        let options = options(&mut bytes);
        let name = if bytes.below(16) == 1 {
            bytes.text()
        } else {
            known.to_owned()
        };
        if coarse(&options)
            && let Ok(model) = sample::generate(&name, &options)
        {
            check(&model);
            if let Ok(worse) = sample::degraded(
                &model,
                &self::options(&mut bytes).degradation(),
                bytes.seed(),
            ) {
                check(&worse);
            }
        }
        let by = Degradation {
            noise: bytes.number(),
            outliers: bytes.number(),
            missing: bytes.number(),
            density: bytes.number(),
        };
        let cloud = shapes::model(&mut bytes);
        if let Ok(worse) = sample::degraded(&cloud, &by, bytes.seed()) {
            assert!(worse.cloud.len() <= 2 * cloud.cloud.len());
        }
        sample::imperfect(&cloud, bytes.seed());
    },
    seeds: || {
        (0..15)
            .map(|part| vec![part, 1, 1, 162, 0, 0, 0, 0, 0])
            .collect()
    },
    words: &[],
    longest: 512,
    floor: 8 * MIB,
    quick: 10,
};

pub const COMPOSE: Target = Target {
    name: "compose",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let options = options(&mut bytes);
        let blocks = bytes.list(sample::MAX_BLOCKS + 1, block);
        let Ok(part) = sample::compose(&blocks) else {
            return;
        };
        if !coarse(&options) {
            return;
        }
        match sample::build("part", &part, &options) {
            Ok(model) => {
                check(&model);
                sample::thin(&model);
            }
            Err(error) => assert!(error.to_string().len() < 1000),
        }
    },
    seeds: || {
        let places = 0..SHAPES.len() as u8;
        let alone = |shape: u8| vec![1, 1, 0, 1, 0, shape, 0];
        let cut = |shape: u8| {
            vec![
                1,
                1,
                0,
                2,
                0,
                shape,
                0,
                1,
                7 - shape,
                0,
                170,
                171,
                172,
                45,
                46,
                160,
            ]
        };
        places.clone().map(alone).chain(places.map(cut)).collect()
    },
    words: &[],
    longest: 512,
    floor: 24 * MIB,
    quick: 200,
};

pub const CUT: Target = Target {
    name: "cut",
    run: |input| {
        let mut bytes = Bytes::new(input);
        let region = if bytes.flag() {
            Region::ball(bytes.numbers(), bytes.number())
        } else {
            let (target, rotation) = (bytes.numbers(), bytes.numbers());
            let (eye, depth) = (bytes.number(), bytes.number());
            let corners = bytes.list(60, Bytes::numbers::<2>);
            Lasso::new(target, rotation, eye, depth, &corners).map(Region::Lasso)
        };
        let model = shapes::model(&mut bytes);
        let Ok(region) = region else {
            return;
        };
        let inside = sample::points_in(&model, &region);
        let rest = sample::without(&model, &region);
        assert_eq!(inside.len() + rest.cloud.len(), model.cloud.len());
        assert_eq!(Losses::between(&model, &rest).points, inside.len());
        sample::thin(&rest);
    },
    seeds: super::none,
    words: &[],
    longest: 1024,
    floor: MIB / 2,
    quick: 50_000,
};

/// Options that are in their ranges as a rule, and any numbers else.
fn options(bytes: &mut Bytes<'_>) -> Options {
    let seed = bytes.seed();
    if bytes.below(8) == 0 {
        return Options {
            seed,
            spacing: bytes.number(),
            noise: bytes.number(),
            outliers: bytes.number(),
            missing: bytes.number(),
        };
    }
    let share = |bytes: &mut Bytes<'_>, most: f64| most * f64::from(bytes.byte()) / 255.0;
    Options {
        seed,
        spacing: FINEST + share(bytes, 0.1 - FINEST),
        noise: share(bytes, 0.1),
        outliers: share(bytes, 1.0),
        missing: share(bytes, 0.95),
    }
}

fn coarse(options: &Options) -> bool {
    options.spacing >= FINEST || options.check().is_err()
}

/// A block: sizes of its shape's own as a rule, else any number of any.
fn block(bytes: &mut Bytes<'_>) -> Block {
    let info = SHAPES[bytes.below(SHAPES.len())];
    let operation = bytes.one([Operation::Add, Operation::Cut]);
    let (mut sizes, mut position, mut rotation) = (Vec::new(), [0.0; 3], [0.0; 3]);
    let said = bytes.byte();
    if said & 1 == 0 {
        sizes.extend(info.sizes.iter().map(|&(_, size)| size));
    } else if said & 2 == 0 {
        sizes.extend(info.sizes.iter().map(|_| bytes.number()));
    } else {
        sizes.extend(bytes.list(6, Bytes::number));
    }
    if said & 4 == 0 {
        position = bytes.numbers();
    }
    if said & 8 == 0 {
        rotation = bytes.numbers();
    }
    Block {
        operation,
        shape: info.shape,
        sizes,
        position,
        rotation,
    }
}

/// Every point is a number, and every list within the cloud and on its surface's own part.
fn check(model: &Model) {
    let points = model.cloud.points();
    assert!(
        points
            .iter()
            .all(|point| point.coords.iter().all(|x| x.is_finite()))
    );
    for primitive in model.truth.iter().flat_map(|truth| &truth.primitives) {
        assert!(!primitive.points.is_empty() && primitive.points.is_sorted_by(|a, b| a < b));
        assert!(
            primitive
                .points
                .last()
                .is_none_or(|&last| (last as usize) < points.len())
        );
    }
}
