//! Faults on purpose: a runner that misses one of these would miss others.

use std::hint::black_box;

use super::MIB;
use crate::Target;

const PLANTED: Target = Target {
    name: "",
    run: |_| (),
    seeds: || vec![b"6000".to_vec()],
    words: &[],
    longest: 64,
    floor: MIB,
    quick: 300_000,
};

/// One by one.
pub static ALL: &[Target] = &[
    // Four bytes right at once: one in four thousand million by chance alone. Coverage rewards each.
    Target {
        name: "planted-panic",
        run: |input| {
            let [b'F', rest @ ..] = input else { return };
            black_box(rest);
            let [b'4', rest @ ..] = rest else { return };
            black_box(rest);
            let [b'C', rest @ ..] = rest else { return };
            black_box(rest);
            let [b'!', ..] = rest else { return };
            assert!(black_box(rest).is_empty() && rest.len() > 64, "planted");
        },
        ..PLANTED
    },
    Target {
        name: "planted-assertion",
        run: |input| assert!(black_box(input).first() != Some(&b'7'), "planted"),
        ..PLANTED
    },
    Target {
        name: "planted-hang",
        run: |input| {
            while black_box(input).first() == Some(&b'7') {
                black_box(input);
            }
        },
        ..PLANTED
    },
    Target {
        name: "planted-allocation",
        run: |input| {
            if input.first() == Some(&b'7') {
                black_box(vec![1u8; 3 * MIB]);
            }
        },
        ..PLANTED
    },
    Target {
        name: "planted-exhaustion",
        run: |input| {
            if input.first() == Some(&b'7') {
                black_box(Vec::<u8>::with_capacity(1 << 40));
            }
        },
        ..PLANTED
    },
];
