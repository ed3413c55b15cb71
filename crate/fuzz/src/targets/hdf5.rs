//! HDF5 files: opened, and what is in them read.

use fit4cad::format::foreign::{Purpose, read_foreign};
use fit4cad_hdf5::Opened;

use super::MIB;
use crate::Target;

/// Entries that are read of each file: one says as much as a thousand.
const ENTRIES: usize = 4;

pub const OPEN: Target = Target {
    name: "hdf5",
    run: |input| {
        let bytes = input.to_vec();
        let opened = Opened::open("a.h5", bytes.len() as u64, move |from, length| {
            let from = usize::try_from(from).unwrap_or(usize::MAX);
            let part = bytes.get(from..from.saturating_add(length));
            let part = part.map(<[u8]>::to_vec);
            part.ok_or_else(|| "it is shorter".to_owned())
        });
        let Ok(opened) = opened else { return };
        for entry in opened.entries().iter().take(ENTRIES) {
            if let Ok(content) = opened.read(entry) {
                assert!(read_foreign("a.h5", &content, Purpose::Truth).is_some());
            }
        }
    },
    seeds: || {
        let files: [&[u8]; 4] = [
            include_bytes!("../../../hdf5/fixtures/train_data.h5"),
            include_bytes!("../../../hdf5/fixtures/predictions.h5"),
            include_bytes!("../../../hdf5/fixtures/shape.h5"),
            include_bytes!("../../../hdf5/fixtures/latest.h5"),
        ];
        files.map(<[u8]>::to_vec).to_vec()
    },
    words: &[
        "\u{89}HDF",
        "OHDR",
        "TREE",
        "SNOD",
        "HEAP",
        "FRHP",
        "points",
        "labels",
        "seg_id",
        "prim",
        "type_per_point",
    ],
    longest: LONGEST,
    // What the reader keeps of the blocks that it had, and a chunk.
    floor: 64 * MIB,
    quick: 150,
};

const LONGEST: usize = 32 << 10;
