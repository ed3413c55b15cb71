//! A model that lives in wasm memory and is asked about from JavaScript.

use std::collections::BTreeMap;

use fit4cad::cloud::Point;
use fit4cad::diagnostics::Diagnostic;
use fit4cad::format::{self, model_number, write_cloud, write_primitives, write_surfaces};
use fit4cad::metrics;
use fit4cad::model::{self, Segmentation};
use fit4cad::sample;
use fit4cad::surface::Form;
use js_sys::{Float32Array, Float64Array, Uint32Array};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::diagnostic::DiagnosticInfo;
use crate::fitted::{Fitted, give_surfaces};
use crate::hand_over;
use crate::input::InputFile;
use crate::lists::PointLists;
use crate::primitive::PrimitiveInfo;
use crate::report::{Protocol, Report};

/// The axis-aligned box of a cloud, in the coordinates of its file.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct BoundsInfo {
    /// Smallest coordinates.
    pub min: [f64; 3],
    /// Largest coordinates.
    pub max: [f64; 3],
    /// Length of its diagonal.
    pub diagonal: f64,
}

/// What a model holds.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct ModelInfo {
    /// Its name, e.g. `PC14`.
    pub name: String,
    /// The number its name ends with.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub number: Option<u32>,
    /// Number of points.
    pub points: u32,
    /// The box of the points; absent without points.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub bounds: Option<BoundsInfo>,
    /// Whether the ground truth is there.
    pub has_truth: bool,
    /// The methods that have a submission.
    pub methods: Vec<String>,
    /// Those of them whose surfaces the engine fitted to given segments.
    pub fitted: Vec<String>,
    /// Whether it did so for the truth.
    pub truth_fitted: bool,
    /// What is wrong with its files.
    pub diagnostics: Vec<DiagnosticInfo>,
}

/// The texts of a model's files, in the paper's form.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct Texts {
    /// `PCi.txt`; only with the truth, as submissions refer to the cloud they were made for.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub cloud: Option<String>,
    /// `PCi_primitives.txt`.
    pub primitives: String,
    /// `PCi_parametric.txt`.
    pub parametric: String,
    /// `PCi_implicit.txt`.
    pub implicit: String,
}

/// One point cloud with its truth and its submissions. Release it with `free()`.
#[derive(Debug)]
#[wasm_bindgen]
pub struct Model {
    pub(crate) model: model::Model,
    diagnostics: Vec<Diagnostic>,
    /// The method each submitted file belongs to, by path.
    method_of_file: BTreeMap<String, String>,
    /// Whether something was left to the whole engine.
    wants_whole: bool,
    /// Whose surfaces were fitted here.
    pub(crate) fitted: Fitted,
    /// The noise that fits made here went by.
    #[cfg(feature = "workshop")]
    pub(crate) noise: BTreeMap<String, fit4cad::fit::Noise>,
}

/// Who reads files that are not the benchmark's own: the scorer leaves them to the whole engine.
const READERS: format::Readers = if cfg!(feature = "workshop") {
    format::Readers::ALL
} else {
    format::Readers::OWN
};

#[wasm_bindgen]
impl Model {
    /// Reads a model from its files, one content at a time, while they are within the limits. Whatever
    /// is wrong with them is among the diagnostics.
    ///
    /// # Errors
    /// Only if the arguments are not of the declared types.
    pub fn read(name: &str, files: Vec<Ts<InputFile>>) -> Result<Model, JsError> {
        let files = files
            .iter()
            .map(Ts::to_rust)
            .collect::<Result<Vec<InputFile>, _>>()?;
        let mut reading = format::read_files(name, &files, &READERS);
        let fitted = give_surfaces(&mut reading, &files);
        let wants_whole = reading.unread || reading.bare.len() > fitted.len();
        // One by one: to be collected they would be sorted, by code of their own.
        let mut method_of_file = BTreeMap::new();
        for file in files {
            if let Some(method) = file.method {
                method_of_file.insert(file.path, method);
            }
        }
        Ok(Self {
            model: reading.model,
            diagnostics: reading.diagnostics,
            method_of_file,
            wants_whole,
            fitted,
            #[cfg(feature = "workshop")]
            noise: BTreeMap::new(),
        })
    }

    /// Whether the whole engine would make more of the files: the scorer leaves those of other programs,
    /// and segments without surfaces.
    #[wasm_bindgen(js_name = wantsWhole)]
    pub fn wants_whole(&self) -> bool {
        self.wants_whole
    }

    /// The part that the page opens with: the first of the catalogue, as it is made without options.
    ///
    /// # Errors
    /// None in practice: this part can be made.
    pub fn opening() -> Result<Model, JsError> {
        Ok(Self::of(sample::opening()?))
    }

    /// What the model holds.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn info(&self) -> Result<Ts<ModelInfo>, JsError> {
        let bounds = self.model.cloud.bounds();
        let corner = |point: Point| [point.x, point.y, point.z];
        hand_over(&ModelInfo {
            name: self.model.name.clone(),
            number: model_number(&self.model.name),
            points: self.model.cloud.len() as u32,
            bounds: (!bounds.is_empty()).then(|| BoundsInfo {
                min: corner(bounds.min),
                max: corner(bounds.max),
                diagonal: bounds.diagonal(),
            }),
            has_truth: self.model.truth.is_some(),
            methods: self.methods().map(str::to_owned).collect(),
            fitted: self.fitted.iter().flatten().cloned().collect(),
            truth_fitted: self.fitted.contains(&None),
            diagnostics: self.diagnostics.iter().map(DiagnosticInfo::from).collect(),
        })
    }

    /// The points relative to [`Model::centre`], x y z after one another.
    pub fn positions(&self) -> Float32Array {
        self.relative_to(self.model.cloud.bounds().centre())
    }

    /// The points relative to another place than their middle, so that what is cut away moves nothing.
    ///
    /// # Errors
    /// If the place is not three numbers.
    #[wasm_bindgen(js_name = positionsAround)]
    pub fn positions_around(&self, centre: &[f64]) -> Result<Float32Array, JsError> {
        let &[x, y, z] = centre else {
            return Err(JsError::new("the centre is made of 3 numbers"));
        };
        Ok(self.relative_to(Point::new(x, y, z)))
    }

    /// The middle of the cloud's box, in the coordinates of the file.
    pub fn centre(&self) -> Float64Array {
        let centre = self.model.cloud.bounds().centre();
        Float64Array::from([centre.x, centre.y, centre.z].as_slice())
    }

    /// The number of each point in the cloud's file, counted from 1; absent where that is its index
    /// and one, as in every file without rows that could not be read.
    pub fn numbers(&self) -> Option<Uint32Array> {
        let numbering = self.model.cloud.numbering();
        if numbering.is_plain() {
            return None;
        }
        let count = self.model.cloud.len() as u32;
        let numbers: Vec<u32> = (0..count)
            .map(|index| numbering.number(index) as u32)
            .collect();
        Some(Uint32Array::from(numbers.as_slice()))
    }

    /// The primitives of a method, or of the truth, in the order of their file.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn primitives(&self, method: Option<String>) -> Result<Vec<Ts<PrimitiveInfo>>, JsError> {
        let primitives = self.segmentation(method.as_deref())?.primitives.iter();
        primitives
            .map(|primitive| hand_over(&PrimitiveInfo::new(&self.model.cloud, primitive)))
            .collect()
    }

    /// The points that each primitive of a method, or of the truth, lists.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn members(&self, method: Option<String>) -> Result<Ts<PointLists>, JsError> {
        hand_over(&PointLists::from(self.segmentation(method.as_deref())?))
    }

    /// Distance of each listed point to its primitive's surface, in the order of
    /// [`PointLists::indices`]; NaN where the primitive has no surface.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn distances(&self, method: Option<String>) -> Result<Float32Array, JsError> {
        let points = self.model.cloud.points();
        let mut distances = Vec::new();
        for primitive in &self.segmentation(method.as_deref())?.primitives {
            distances.extend(primitive.points.iter().map(|&index| {
                let point = points.get(index as usize);
                let distance = primitive.surface.zip(point);
                distance.map_or(f32::NAN, |(surface, point)| surface.distance(point) as f32)
            }));
        }
        Ok(Float32Array::from(distances.as_slice()))
    }

    /// Writes `PCi.txt`, which needs no truth.
    pub fn cloud(&self) -> String {
        write_cloud(&self.model.cloud)
    }

    /// Writes the files of a method, or of the truth, so that reading them gives the same again.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn write(&self, method: Option<String>) -> Result<Ts<Texts>, JsError> {
        let segmentation = self.segmentation(method.as_deref())?;
        hand_over(&Texts {
            cloud: method.is_none().then(|| self.cloud()),
            primitives: write_primitives(segmentation, self.model.cloud.numbering()),
            parametric: write_surfaces(segmentation, Form::Parametric),
            implicit: write_surfaces(segmentation, Form::Implicit),
        })
    }

    /// Scores the submission of a method, or the truth against itself as method `truth`.
    ///
    /// # Errors
    /// If there is no such submission, or no truth.
    pub fn score(
        &self,
        method: Option<String>,
        protocol: Ts<Protocol>,
    ) -> Result<Ts<Report>, JsError> {
        let protocol = protocol.to_rust()?;
        let truth = self.segmentation(None)?;
        let prediction = self.segmentation(method.as_deref())?;
        let report = metrics::evaluate(&self.model.cloud, truth, prediction, protocol.into());
        hand_over(&Report::new(
            &self.model.name,
            method.as_deref().unwrap_or("truth"),
            protocol,
            &report,
            self.diagnostics_for(method.as_deref())
                .map(DiagnosticInfo::from)
                .collect(),
        ))
    }
}

impl Model {
    /// A model that comes from no file.
    pub(crate) fn of(model: model::Model) -> Self {
        Self::with_findings(model, Vec::new())
    }

    /// A model made of one that comes from files with these findings.
    fn with_findings(model: model::Model, diagnostics: Vec<Diagnostic>) -> Self {
        Self {
            model,
            diagnostics,
            method_of_file: BTreeMap::new(),
            wants_whole: false,
            fitted: Fitted::new(),
            #[cfg(feature = "workshop")]
            noise: BTreeMap::new(),
        }
    }

    /// The points relative to a place, x y z after one another.
    fn relative_to(&self, centre: Point) -> Float32Array {
        let points = self.model.cloud.points().iter();
        let relative: Vec<f32> = points
            .flat_map(|point| {
                let offset = point - centre;
                [offset.x as f32, offset.y as f32, offset.z as f32]
            })
            .collect();
        Float32Array::from(relative.as_slice())
    }

    /// This model in another form, with what was found in its files.
    #[cfg(feature = "workshop")]
    pub(crate) fn remade(&self, model: model::Model) -> Self {
        Self::with_findings(model, self.diagnostics.clone())
    }

    pub(crate) fn methods(&self) -> impl Iterator<Item = &str> {
        let submissions = self.model.submissions.iter();
        submissions.map(|submission| submission.method.as_str())
    }

    pub(crate) fn segmentation(&self, method: Option<&str>) -> Result<&Segmentation, JsError> {
        let name = &self.model.name;
        let Some(method) = method else {
            let truth = self.model.truth.as_ref();
            return truth.ok_or_else(|| JsError::new(&format!("{name} has no ground truth")));
        };
        let mut submissions = self.model.submissions.iter();
        submissions
            .find(|submission| submission.method == method)
            .map(|submission| &submission.segmentation)
            .ok_or_else(|| {
                let there: Vec<&str> = self.methods().collect();
                JsError::new(&format!(
                    "{name} has no submission of `{method}`; there is {}",
                    if there.is_empty() {
                        "none at all".to_owned()
                    } else {
                        there.join(", ")
                    }
                ))
            })
    }

    /// The findings that bear on the score of one method, or of the truth itself: not those about
    /// files of other methods.
    pub(crate) fn diagnostics_for(
        &self,
        method: Option<&str>,
    ) -> impl Iterator<Item = &Diagnostic> {
        self.diagnostics.iter().filter(move |diagnostic| {
            let owner = self.method_of_file.get(&diagnostic.file);
            owner.is_none_or(|owner| method == Some(owner.as_str()))
        })
    }
}
