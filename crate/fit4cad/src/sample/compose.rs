//! Parts composed of shapes that a few numbers describe, as a form can ask for them.

use super::SampleError;
use super::blocks::{Feature, Frame, Loop, Operation, Outline, Part, Solid};
use super::shapes::Shape;
use crate::cloud::Vector;

/// Most blocks of a part: sampling asks every block about the points of the others.
pub const MAX_BLOCKS: usize = 64;

/// Largest size or coordinate.
const LARGEST: f64 = 1e6;
/// Smallest size: what is smaller beside what is large has no digits left.
const SMALLEST: f64 = 1e-6;

/// A shape in its place, and what it does to the part so far.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Whether it is added or cut away.
    pub operation: Operation,
    /// The shape.
    pub shape: Shape,
    /// Its sizes, in the order of [`ShapeInfo::sizes`](super::ShapeInfo::sizes).
    pub sizes: Vec<f64>,
    /// Where its centre is.
    pub position: [f64; 3],
    /// Degrees by which it is turned about the axes through its centre: about x, then y, then z.
    pub rotation: [f64; 3],
}

/// The part that blocks make, first to last.
///
/// # Errors
/// [`SampleError::InvalidBlock`] names the first block that makes no solid and says why;
/// [`SampleError::TooManyBlocks`] if there are more than [`MAX_BLOCKS`].
pub fn compose(blocks: &[Block]) -> Result<Part, SampleError> {
    if blocks.len() > MAX_BLOCKS {
        return Err(SampleError::TooManyBlocks { limit: MAX_BLOCKS });
    }
    let feature = |(place, block): (usize, &Block)| {
        let solid = block.solid().map_err(|reason| SampleError::InvalidBlock {
            block: place + 1,
            shape: block.shape.info().title,
            reason,
        })?;
        Ok(Feature {
            operation: block.operation,
            solid,
        })
    };
    let features = blocks.iter().enumerate().map(feature);
    Ok(Part {
        features: features.collect::<Result<_, _>>()?,
    })
}

impl Block {
    fn solid(&self) -> Result<Solid, String> {
        let coordinates = self.position.iter().chain(&self.rotation);
        if !coordinates.clone().all(|x| x.abs() <= LARGEST) {
            return Err(format!(
                "position and rotation must be numbers up to {LARGEST}"
            ));
        }
        let (solid, middle) = self.upright()?;
        let axes = axes(self.rotation);
        let origin = Vector::from(self.position) - axes[2] * middle;
        Ok(Solid {
            frame: Frame {
                origin: origin.into(),
                z: axes[2].into(),
                x: axes[0].into(),
            },
            ..solid
        })
    }

    /// The solid before it is placed, and the height of its centre.
    fn upright(&self) -> Result<(Solid, f64), String> {
        let sizes = self.shape.info().sizes;
        if self.sizes.len() != sizes.len() {
            return Err(format!(
                "it has {} sizes, not {}",
                sizes.len(),
                self.sizes.len()
            ));
        }
        for (&size, (name, _)) in self.sizes.iter().zip(sizes) {
            let pointed = self.shape == Shape::Cone && size == 0.0 && *name != "height";
            if !((SMALLEST..=LARGEST).contains(&size) || pointed) {
                return Err(format!(
                    "its {name} must be positive, from {SMALLEST} to {LARGEST}, not {size}"
                ));
            }
        }
        let turned = |corners: &[[f64; 2]]| Solid::revolve(Outline::new(Loop::polygon(corners)));
        Ok(match (self.shape, self.sizes.as_slice()) {
            (Shape::Cuboid, &[length, width, height]) => {
                let (x, y) = (length / 2.0, width / 2.0);
                let outline = Outline::rectangle([-x, -y], [x, y]);
                (Solid::extrude(outline, height), height / 2.0)
            }
            (Shape::RoundedCuboid, &[length, width, height, radius]) => {
                let (x, y) = (length / 2.0, width / 2.0);
                if radius > x.min(y) {
                    return Err("its radius must be at most half its length and width".to_owned());
                }
                let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
                let outline = Loop::rounded(&corners.map(|[x, y]| [x, y, radius]));
                (Solid::extrude(Outline::new(outline), height), height / 2.0)
            }
            (Shape::Prism, &[sides, radius, height]) => {
                if sides.fract() != 0.0 || !(3.0..=24.0).contains(&sides) {
                    return Err(format!("it must have 3 to 24 sides, not {sides}"));
                }
                let corner = |k: u32| {
                    let (sin, cos) = sincos_degrees(360.0 * f64::from(k) / sides);
                    [radius * cos, radius * sin]
                };
                let corners: Vec<[f64; 2]> = (0..sides as u32).map(corner).collect();
                let outline = Outline::new(Loop::polygon(&corners));
                (Solid::extrude(outline, height), height / 2.0)
            }
            (Shape::Cylinder, &[radius, height]) => {
                let outline = Outline::disc([0.0, 0.0], radius);
                (Solid::extrude(outline, height), height / 2.0)
            }
            (Shape::Tube, &[outer, inner, height]) => {
                if inner >= outer {
                    return Err("its inner radius must be less than the outer one".to_owned());
                }
                let hole = Loop::circle([0.0, 0.0], inner);
                let outline = Outline::disc([0.0, 0.0], outer).hole(hole);
                (Solid::extrude(outline, height), height / 2.0)
            }
            (Shape::Cone, &[lower, upper, height]) => {
                if lower == upper {
                    return Err("its radii must differ; a cylinder has equal ones".to_owned());
                }
                let profile = [[0.0, 0.0], [lower, 0.0], [upper, height], [0.0, height]];
                (turned(&profile), height / 2.0)
            }
            (Shape::Sphere, &[radius]) => {
                let half = Loop::path([0.0, -radius]).arc([0.0, radius], 1.0);
                (Solid::revolve(Outline::new(half)), 0.0)
            }
            (Shape::Torus, &[major, minor]) => {
                if minor >= major {
                    return Err("its minor radius must be less than the major one".to_owned());
                }
                let outline = Outline::disc([major, 0.0], minor);
                (Solid::revolve(outline), 0.0)
            }
            _ => return Err("its sizes are not those of its shape".to_owned()),
        })
    }
}

/// The axes of the world turned by degrees about x, then y, then z.
fn axes(rotation: [f64; 3]) -> [Vector; 3] {
    let [about_x, about_y, about_z] = rotation.map(sincos_degrees);
    [Vector::x(), Vector::y(), Vector::z()].map(|axis| {
        let (sin, cos) = about_x;
        let axis = Vector::new(
            axis.x,
            cos * axis.y - sin * axis.z,
            sin * axis.y + cos * axis.z,
        );
        let (sin, cos) = about_y;
        let axis = Vector::new(
            cos * axis.x + sin * axis.z,
            axis.y,
            cos * axis.z - sin * axis.x,
        );
        let (sin, cos) = about_z;
        Vector::new(
            cos * axis.x - sin * axis.y,
            sin * axis.x + cos * axis.y,
            axis.z,
        )
    })
}

/// Sine and cosine, exact at quarter turns: a part's faces stay parallel to the axes.
fn sincos_degrees(degrees: f64) -> (f64, f64) {
    let quarters = (degrees / 90.0).round();
    let (sin, cos) = libm::sincos((degrees - 90.0 * quarters).to_radians());
    match quarters.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Model;
    use crate::sample::{Options, SHAPES, build, farthest_off};
    use crate::surface::SurfaceType;
    use proptest::prelude::*;

    const COARSE: Options = Options {
        seed: 1,
        spacing: 0.03,
        noise: 0.0,
        outliers: 0.0,
        missing: 0.0,
    };

    fn block(shape: Shape) -> Block {
        let sizes = shape.info().sizes.iter().map(|(_, size)| *size);
        Block {
            operation: Operation::Add,
            shape,
            sizes: sizes.collect(),
            position: [0.0; 3],
            rotation: [0.0; 3],
        }
    }

    fn made(blocks: &[Block]) -> Model {
        build("composed", &compose(blocks).unwrap(), &COARSE).unwrap()
    }

    fn types(model: &Model) -> [usize; 5] {
        let truth = model.truth.as_ref().unwrap();
        SurfaceType::ALL.map(|kind| {
            let same = |each: &&crate::model::Primitive| each.kind == Some(kind);
            truth.primitives.iter().filter(same).count()
        })
    }

    fn reason(blocks: &[Block]) -> String {
        compose(blocks).unwrap_err().to_string()
    }

    #[test]
    fn every_shape_is_made_of_its_surfaces_about_its_centre() {
        // Planes, cylinders, cones, spheres, tori.
        let surfaces = [
            [6, 0, 0, 0, 0],
            [6, 4, 0, 0, 0],
            [8, 0, 0, 0, 0],
            [2, 1, 0, 0, 0],
            [2, 2, 0, 0, 0],
            [2, 0, 1, 0, 0],
            [0, 0, 0, 1, 0],
            [0, 0, 0, 0, 1],
        ];
        for (info, expected) in SHAPES.iter().zip(surfaces) {
            let model = made(&[block(info.shape)]);
            assert_eq!(types(&model), expected, "{}", info.name);
            let bounds = model.cloud.bounds();
            let centre = bounds.centre().coords.norm() / bounds.diagonal();
            assert!(centre < 0.02, "{}: {centre}", info.name);
        }
    }

    #[test]
    fn a_size_too_small_to_compute_with_is_refused() {
        for size in [1e-309, 1e-7, 0.0, -1.0, f64::NAN, f64::INFINITY] {
            let mut thin = block(Shape::RoundedCuboid);
            thin.sizes[3] = size;
            assert!(
                reason(&[thin]).contains("radius must be positive"),
                "{size}"
            );
        }
    }

    #[test]
    fn a_quarter_turn_keeps_faces_parallel_to_the_axes_exactly() {
        let mut cuboid = block(Shape::Cuboid);
        cuboid.rotation = [90.0, 180.0, -450.0];
        cuboid.position = [100.0, 0.0, 0.0];
        let bounds = made(&[cuboid]).cloud.bounds();
        assert_eq!(bounds.min, [90.0, -30.0, -20.0].into());
        assert_eq!(bounds.max, [110.0, 30.0, 20.0].into());
    }

    #[test]
    fn rotations_come_about_x_then_y_then_z() {
        let [x, y, z] = axes([90.0, 90.0, 0.0]);
        assert_eq!((x, y, z), (-Vector::z(), Vector::x(), -Vector::y()));
    }

    /// Else the time grows with the square of their number, and the choice of edges with the cube.
    #[test]
    fn of_equal_blocks_the_last_alone_counts() {
        let [cuboid, sphere] = [Shape::Cuboid, Shape::Sphere].map(block);
        let cut = Block {
            operation: Operation::Cut,
            ..block(Shape::Cylinder)
        };
        assert_eq!(
            made(&vec![cuboid.clone(); 17]),
            made(std::slice::from_ref(&cuboid))
        );
        let mut many = Vec::new();
        for _ in 0..8 {
            many.extend([cut.clone(), cuboid.clone(), sphere.clone()]);
        }
        many.push(cut.clone());
        assert_eq!(made(&many), made(&[cuboid.clone(), sphere, cut.clone()]));
        let gone = Block {
            operation: Operation::Cut,
            ..cuboid.clone()
        };
        let part = compose(&[cuboid, gone]).unwrap();
        assert!(build("gone", &part, &COARSE).is_err());
    }

    #[test]
    fn a_hole_through_a_box_is_a_cylinder() {
        let hole = Block {
            operation: Operation::Cut,
            ..block(Shape::Cylinder)
        };
        assert_eq!(types(&made(&[block(Shape::Cuboid), hole])), [6, 1, 0, 0, 0]);
    }

    #[test]
    fn a_block_far_larger_than_what_it_leaves_is_refused_at_once() {
        for size in [1e6, 1e5] {
            let mut half = block(Shape::Cuboid);
            half.operation = Operation::Cut;
            half.sizes = vec![size; 3];
            half.position = [size / 2.0, 0.0, 0.0];
            let mut small = block(Shape::Cuboid);
            small.sizes = vec![0.01; 3];
            let part = compose(&[small, half]).unwrap();
            let refused = build("part", &part, &Options::default());
            assert_eq!(refused, Err(SampleError::TooLarge));
        }
    }

    /// Each pair of their faces crosses in rounding alone, all over: to look into each crossing took minutes.
    #[test]
    fn blocks_that_nearly_coincide_are_sampled_like_others() {
        for shape in [Shape::Cuboid, Shape::Cylinder, Shape::Sphere] {
            let near = |k: u32| Block {
                position: [1e-9 * f64::from(k), 0.0, -2e-9 * f64::from(k)],
                rotation: [0.0, 1e-8 * f64::from(k), 0.0],
                ..block(shape)
            };
            let blocks: Vec<Block> = (0..12).map(near).collect();
            let model = build("near", &compose(&blocks).unwrap(), &COARSE).unwrap();
            assert!(model.cloud.len() > 100);
        }
    }

    /// Far from the origin the meeting of two of them never comes back to its start; followed to the length of the
    /// part, it had half a million points.
    #[test]
    fn small_blocks_that_nearly_coincide_in_a_large_part_are_sampled_like_others() {
        let far = |turn: f64| Block {
            position: [123_456.0; 3],
            rotation: [123_456.25 + turn, 123_456.25, 123_456.25],
            ..block(Shape::Tube)
        };
        let blocks = [block(Shape::Sphere), far(0.0), far(0.056)];
        let model = build("far", &compose(&blocks).unwrap(), &COARSE).unwrap();
        assert!(!model.cloud.is_empty());
    }

    #[test]
    fn what_is_wrong_with_a_block_is_said_with_its_number() {
        let good = block(Shape::Cuboid);
        let mut tube = block(Shape::Tube);
        tube.sizes = vec![5.0, 5.0, 10.0];
        assert_eq!(
            reason(&[good.clone(), tube]),
            "block 2 (Tube): its inner radius must be less than the outer one"
        );
        let mut flat = good.clone();
        flat.sizes[2] = 0.0;
        assert!(reason(&[flat]).contains("its height must be positive"));
        let mut nowhere = good.clone();
        nowhere.position[1] = f64::NAN;
        assert!(reason(&[nowhere]).contains("position"));
        let mut prism = block(Shape::Prism);
        prism.sizes[0] = 4.5;
        assert!(reason(&[prism]).contains("3 to 24 sides"));
        let mut short = good.clone();
        short.sizes.pop();
        assert!(reason(&[short]).contains("3 sizes, not 2"));
        assert!(reason(&vec![good; MAX_BLOCKS + 1]).contains("64 blocks"));
    }

    fn any_block() -> impl Strategy<Value = Block> {
        let shape = prop::sample::select(SHAPES.map(|info| info.shape).to_vec());
        let place = [-2i32..=2, -2i32..=2, -2i32..=2];
        let turn = [0i32..4, 0i32..4, 0i32..12];
        (shape, any::<bool>(), place, turn).prop_map(|(shape, add, place, turn)| Block {
            operation: if add { Operation::Add } else { Operation::Cut },
            // Steps of the sizes themselves: faces of blocks coincide and touch.
            position: place.map(|step| f64::from(step) * 10.0),
            rotation: [
                f64::from(turn[0]) * 90.0,
                f64::from(turn[1]) * 90.0,
                f64::from(turn[2]) * 30.0,
            ],
            ..block(shape)
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(48))]

        #[test]
        fn points_of_any_composition_lie_on_their_surfaces(
            blocks in prop::collection::vec(any_block(), 1..5),
        ) {
            let Ok(model) = build("composed", &compose(&blocks).unwrap(), &COARSE) else {
                return Ok(());
            };
            let farthest = farthest_off(&model);
            prop_assert!(farthest.is_none_or(|share| share <= 1e-8), "{farthest:?}");
        }
    }
}
