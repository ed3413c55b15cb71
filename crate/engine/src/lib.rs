//! The engine as JavaScript sees it: a thin wasm-bindgen boundary over [`fit4cad`].
