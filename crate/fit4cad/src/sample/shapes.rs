//! The shapes that blocks can have, and the sizes that each asks for.

/// A shape, centred on its block's position.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Six planes.
    Cuboid,
    /// A cuboid whose four edges along z are rounded.
    RoundedCuboid,
    /// A regular polygon along z.
    Prism,
    /// A round bar along z.
    Cylinder,
    /// A round bar along z with a round hole.
    Tube,
    /// A cone along z, whole or without its tip.
    Cone,
    /// A ball.
    Sphere,
    /// A ring about z.
    Torus,
}

/// What there is to know of a shape before a block is made of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapeInfo {
    /// The shape.
    pub shape: Shape,
    /// Name by which it is asked for.
    pub name: &'static str,
    /// Name to be shown.
    pub title: &'static str,
    /// Its sizes in order: name, and a value to begin with.
    pub sizes: &'static [(&'static str, f64)],
}

/// Every shape.
pub const SHAPES: [ShapeInfo; 8] = {
    const fn info(
        shape: Shape,
        name: &'static str,
        title: &'static str,
        sizes: &'static [(&'static str, f64)],
    ) -> ShapeInfo {
        ShapeInfo {
            shape,
            name,
            title,
            sizes,
        }
    }
    [
        info(
            Shape::Cuboid,
            "cuboid",
            "Box",
            &[("length", 60.0), ("width", 40.0), ("height", 20.0)],
        ),
        info(
            Shape::RoundedCuboid,
            "rounded",
            "Rounded box",
            &[
                ("length", 60.0),
                ("width", 40.0),
                ("height", 20.0),
                ("radius", 8.0),
            ],
        ),
        info(
            Shape::Prism,
            "prism",
            "Prism",
            &[("sides", 6.0), ("radius", 20.0), ("height", 20.0)],
        ),
        info(
            Shape::Cylinder,
            "cylinder",
            "Cylinder",
            &[("radius", 10.0), ("height", 40.0)],
        ),
        info(
            Shape::Tube,
            "tube",
            "Tube",
            &[
                ("outer radius", 15.0),
                ("inner radius", 10.0),
                ("height", 40.0),
            ],
        ),
        info(
            Shape::Cone,
            "cone",
            "Cone",
            &[
                ("lower radius", 20.0),
                ("upper radius", 10.0),
                ("height", 30.0),
            ],
        ),
        info(Shape::Sphere, "sphere", "Sphere", &[("radius", 20.0)]),
        info(
            Shape::Torus,
            "torus",
            "Torus",
            &[("major radius", 20.0), ("minor radius", 6.0)],
        ),
    ]
};

impl Shape {
    /// Its entry in [`SHAPES`].
    pub const fn info(self) -> &'static ShapeInfo {
        // The table is in the order of the enumeration, which a test holds it to.
        &SHAPES[self as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_is_in_the_order_of_the_shapes() {
        for info in &SHAPES {
            assert_eq!(info.shape.info(), info);
        }
    }
}
