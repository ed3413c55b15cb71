//! One name for a test on every target.
//!
//! Natively `#[test]` is the compiler's. Under wasm nothing runs such tests; a crate that imports the
//! macros of this one has them run by `wasm-bindgen-test`, those within `proptest!` too:
//!
//! ```text
//! #[cfg(all(test, target_arch = "wasm32"))]
//! #[macro_use]
//! extern crate fit4cad_testing;
//! ```

#[cfg(target_arch = "wasm32")]
pub use wasm_bindgen_test::wasm_bindgen_test as test;
