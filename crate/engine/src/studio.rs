//! Making a case: parts composed of blocks, and regions cut out of clouds.

use fit4cad::sample::{self, Lasso, Region, SHAPES, blocks};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::model::Model;
use crate::{SampleOptions, hand_over};

/// A shape that blocks can have.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
pub struct ShapeInfo {
    /// Name by which it is asked for.
    pub name: &'static str,
    /// Name to be shown.
    pub title: &'static str,
    /// Names of its sizes in order.
    pub sizes: Vec<&'static str>,
    /// A value to begin with for each size.
    pub defaults: Vec<f64>,
}

/// What a block does to the part so far.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum Operation {
    /// It is added.
    Add,
    /// It is cut away.
    Cut,
}

/// A shape in its place, and what it does to the part so far.
#[derive(Debug, Clone, PartialEq, Deserialize, Tsify)]
pub struct Block {
    /// Whether it is added or cut away.
    pub operation: Operation,
    /// Name of its shape.
    pub shape: String,
    /// Its sizes, in the order of the shape's.
    pub sizes: Vec<f64>,
    /// Where its centre is.
    #[tsify(type = "[number, number, number]")]
    pub position: Vec<f64>,
    /// Degrees by which it is turned about its centre: about x, then y, then z.
    #[tsify(type = "[number, number, number]")]
    pub rotation: Vec<f64>,
}

/// The shapes that blocks can have.
///
/// # Errors
/// None in practice: plain values always cross.
#[wasm_bindgen]
pub fn shapes() -> Result<Vec<Ts<ShapeInfo>>, JsError> {
    let info = |shape: &sample::ShapeInfo| {
        let (sizes, defaults) = shape.sizes.iter().copied().unzip();
        hand_over(&ShapeInfo {
            name: shape.name,
            title: shape.title,
            sizes,
            defaults,
        })
    };
    SHAPES.iter().map(info).collect()
}

#[wasm_bindgen]
impl Model {
    /// Makes a part of blocks, first to last, with its truth.
    ///
    /// # Errors
    /// Names the first block that makes no solid and says why; if nothing is left of the part, or
    /// an option is out of its range.
    pub fn compose(
        name: &str,
        blocks: Vec<Ts<Block>>,
        options: Ts<SampleOptions>,
    ) -> Result<Model, JsError> {
        let options = sample::Options::from(options.to_rust()?);
        let blocks = blocks
            .iter()
            .map(|block| sample::Block::try_from(block.to_rust()?))
            .collect::<Result<Vec<_>, JsError>>()?;
        let part = sample::compose(&blocks)?;
        Ok(Self::of(sample::build(name, &part, &options)?))
    }

    /// The model without the points in a ball, and without its submissions. Primitives that lose
    /// every point are gone; the others keep their numbers.
    ///
    /// # Errors
    /// If the centre is not three numbers.
    #[wasm_bindgen(js_name = withoutBall)]
    pub fn without_ball(&self, centre: &[f64], radius: f64) -> Result<Model, JsError> {
        let [x, y, z] = numbers("centre", centre)?;
        let centre = [x, y, z].into();
        Ok(self.without(&Region::Ball { centre, radius }))
    }

    /// The model without the points in a lasso: a polygon (x y per corner) in the plane through a
    /// camera's target, swept along the lines of sight. The camera is its target x y z, its
    /// rotation x y z w, the distance of its eye from the target (infinite where it is
    /// orthographic), and how far beyond the target points are still cut away.
    ///
    /// # Errors
    /// If the numbers describe no camera, or the corners no polygon.
    #[wasm_bindgen(js_name = withoutLasso)]
    pub fn without_lasso(&self, camera: &[f64], corners: &[f64]) -> Result<Model, JsError> {
        let [x, y, z, i, j, k, w, eye, depth] = numbers("camera", camera)?;
        let (corners, []) = corners.as_chunks::<2>() else {
            return Err(JsError::new("every corner is made of 2 numbers"));
        };
        let lasso = Lasso::new([x, y, z], [i, j, k, w], eye, depth, corners)?;
        Ok(self.without(&Region::Lasso(lasso)))
    }
}

impl Model {
    fn without(&self, region: &Region) -> Self {
        Self::of(sample::without(&self.model, region))
    }
}

impl TryFrom<Block> for sample::Block {
    type Error = JsError;

    fn try_from(block: Block) -> Result<Self, JsError> {
        let shape = SHAPES.iter().find(|info| info.name == block.shape);
        let shape = shape.ok_or_else(|| {
            let known = SHAPES.map(|info| info.name).join(", ");
            let name = &block.shape;
            JsError::new(&format!(
                "there is no shape `{name}`; choose one of {known}"
            ))
        })?;
        Ok(Self {
            operation: match block.operation {
                Operation::Add => blocks::Operation::Add,
                Operation::Cut => blocks::Operation::Cut,
            },
            shape: shape.shape,
            sizes: block.sizes,
            position: numbers("position", &block.position)?,
            rotation: numbers("rotation", &block.rotation)?,
        })
    }
}

fn numbers<const N: usize>(what: &str, given: &[f64]) -> Result<[f64; N], JsError> {
    given.try_into().map_err(|_| miscounted(what, N))
}

fn miscounted(what: &str, wanted: usize) -> JsError {
    JsError::new(&format!("the {what} is made of {wanted} numbers"))
}
