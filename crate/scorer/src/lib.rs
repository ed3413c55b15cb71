//! The engine without its workshop: fitters, audit, lessons and all generated parts but the one that opens the page
//! come with the whole engine, which the page fetches when one of them is first asked for. A module of its own, so that both are built
//! side by side and neither build undoes the other.

pub use fit4cad_engine::*;
