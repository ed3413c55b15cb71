//! What happens if the engine meets a bug of its own.

use std::panic;

use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::throw_str;

/// Without this, a panic would reach JavaScript as the bare word `unreachable`. No input is meant
/// to cause one; should it happen all the same, the caller gets an error that says where. The
/// instance is not to be used afterwards: its stack was left as it was.
#[wasm_bindgen(start)]
fn report_panics() {
    panic::set_hook(Box::new(|panic| {
        throw_str(&format!("the engine has a bug: {panic}"));
    }));
}
