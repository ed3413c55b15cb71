//! Segments that come without surfaces, as labels do, get them from the engine.

#[cfg(feature = "workshop")]
pub(crate) use fit4cad::fit::given::{Fitted, give_surfaces};

/// Whose surfaces are the engine's: names of methods, `None` for the truth.
#[cfg(not(feature = "workshop"))]
pub(crate) type Fitted = std::collections::BTreeSet<Option<String>>;

/// Leaves that to the whole engine.
#[cfg(not(feature = "workshop"))]
pub(crate) fn give_surfaces<S: fit4cad::format::Source>(
    _: &mut fit4cad::format::Reading,
    _: &[S],
) -> Fitted {
    Fitted::new()
}
