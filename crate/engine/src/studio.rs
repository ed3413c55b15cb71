//! Making a case: parts composed of blocks, and regions cut out of clouds.

use fit4cad::sample::{self, Lasso, Region, SHAPES, blocks};
use js_sys::Uint32Array;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::model::Model;
use crate::part::{SampleOptions, Wear};

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

/// What a model has lost by cutting.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct Losses {
    /// How many points.
    pub points: u32,
    /// Numbers of the true primitives that lost their last point.
    pub vanished: Vec<u32>,
}

/// Primitives with so few points that they are none to speak of.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
pub struct Thin {
    /// Their numbers.
    pub primitives: Vec<u32>,
    /// They have fewer points than these.
    pub fewest: u32,
    /// How far neighbouring points lie apart, in the units of the file.
    pub distance: f64,
}

#[wasm_bindgen]
impl Model {
    /// Makes a part of the generator's catalogue, named after it, with its truth.
    ///
    /// # Errors
    /// If there is no such part, or an option is out of its range.
    pub fn generate(part: &str, options: Ts<SampleOptions>) -> Result<Model, JsError> {
        let options = sample::Options::from(options.to_rust()?);
        Ok(Self::of(sample::generate(part, &options)?))
    }

    /// The model as a worse scan would show it, with its truth and without its submissions.
    ///
    /// # Errors
    /// If an option is out of its range.
    pub fn degraded(&self, wear: Ts<Wear>) -> Result<Model, JsError> {
        let wear: Wear = wear.to_rust()?;
        let seed = wear.seed.unwrap_or(sample::Options::default().seed);
        Ok(self.remade(sample::degraded(&self.model, &wear.into(), seed)?))
    }

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

    /// What was lost between this model and what is left of it.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn losses(&self, rest: &Model) -> Result<Ts<Losses>, JsError> {
        let losses = sample::Losses::between(&self.model, &rest.model);
        hand_over(&Losses {
            points: losses.points as u32,
            vanished: losses.vanished,
        })
    }

    /// Which true primitives have too few points to tell their surface, where points were made at
    /// this spacing, a share of the diagonal.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn thin(&self, spacing: f64) -> Result<Ts<Thin>, JsError> {
        hand_over(&Thin {
            primitives: sample::thin(&self.model),
            fewest: sample::FEWEST_POINTS as u32,
            distance: spacing * self.model.cloud.bounds().diagonal(),
        })
    }

    /// Indices, ascending, of the points that [`Model::without_ball`] would cut away.
    ///
    /// # Errors
    /// If the numbers describe no ball.
    #[wasm_bindgen(js_name = pointsInBall)]
    pub fn points_in_ball(&self, centre: &[f64], radius: f64) -> Result<Uint32Array, JsError> {
        let ball = Region::ball(numbers("centre", centre)?, radius)?;
        let inside = sample::points_in(&self.model, &ball);
        Ok(Uint32Array::from(inside.as_slice()))
    }

    /// The model without the points in a ball, and without its submissions. Primitives that lose
    /// every point are gone; the others keep their numbers.
    ///
    /// # Errors
    /// If the numbers describe no ball.
    #[wasm_bindgen(js_name = withoutBall)]
    pub fn without_ball(&self, centre: &[f64], radius: f64) -> Result<Model, JsError> {
        let ball = Region::ball(numbers("centre", centre)?, radius)?;
        Ok(self.without(&ball))
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
