//! The keys of the measures and figures as types of TypeScript, put together from their declarations at compile
//! time.
#![allow(dead_code, reason = "what only wasm-bindgen reads counts as unused")]

use fit4cad::metrics::{Figure, Group, Measure};
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = match std::str::from_utf8(&KEYS.bytes) {
    Ok(text) => text,
    Err(_) => unreachable!(),
};

const LENGTH: usize = keys::<0>().length;
const KEYS: Text<LENGTH> = keys();

const fn keys<const N: usize>() -> Text<N> {
    Text::new()
        .line("/** Name of a measure in reports. */")
        .keys("Measure", false)
        .line("/** Name of a measure of predicted surfaces. */")
        .keys("AccuracyMeasure", true)
        .line("/** Name of a figure that the field reports. */")
        .figures("Figure")
}

/// A text of which no more than `N` bytes are kept; all are counted.
struct Text<const N: usize> {
    bytes: [u8; N],
    length: usize,
}

impl<const N: usize> Text<N> {
    const fn new() -> Self {
        Self {
            bytes: [0; N],
            length: 0,
        }
    }

    const fn add(mut self, text: &str) -> Self {
        let mut at = 0;
        while at < text.len() {
            if self.length < N {
                self.bytes[self.length] = text.as_bytes()[at];
            }
            self.length += 1;
            at += 1;
        }
        self
    }

    const fn line(self, text: &str) -> Self {
        self.add(text).add("\n")
    }

    /// A type with the names of the measures, or of those of surfaces alone.
    const fn keys(mut self, name: &str, of_surfaces: bool) -> Self {
        self = self.add("export type ").add(name).add(" =");
        let mut at = 0;
        while at < Measure::COUNT {
            let measure = Measure::ALL[at];
            if !of_surfaces || matches!(measure.group(), Group::Accuracy) {
                self = self.add(" | \"").add(measure.name()).add("\"");
            }
            at += 1;
        }
        self.line(";")
    }

    /// A type with the names of the figures.
    const fn figures(mut self, name: &str) -> Self {
        self = self.add("export type ").add(name).add(" =");
        let mut at = 0;
        while at < Figure::COUNT {
            self = self.add(" | \"").add(Figure::ALL[at].name()).add("\"");
            at += 1;
        }
        self.line(";")
    }
}
