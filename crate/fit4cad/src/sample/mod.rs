//! CAD-like parts with known truth, made by a deterministic generator.
