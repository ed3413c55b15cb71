//! Sorting paths into models.

use std::collections::BTreeMap;

use fit4cad::format;
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hand_over;
use crate::input::Role;

/// What the caller knows better about one file.
#[derive(Debug, Clone, Default, Deserialize, Tsify)]
pub struct Override {
    /// What it holds.
    #[serde(default)]
    #[tsify(optional)]
    pub role: Option<Role>,
    /// Name of the model it belongs to.
    #[serde(default)]
    #[tsify(optional)]
    pub model: Option<String>,
    /// The method whose result it is; empty for the ground truth.
    #[serde(default)]
    #[tsify(optional)]
    pub method: Option<String>,
    /// What its indices of points count from: 0, or 1 as the benchmark's do.
    #[serde(default)]
    #[tsify(optional)]
    pub first: Option<u8>,
}

/// What the caller knows better, by path.
#[derive(Debug, Clone, Default, Deserialize, Tsify)]
#[serde(transparent)]
pub struct Overrides(#[tsify(type = "Record<string, Override>")] pub BTreeMap<String, Override>);

/// A file and what it is for its model.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct PlacedFile {
    /// The path as it was given.
    pub path: String,
    /// What it holds.
    pub role: Role,
    /// The method whose result it is; absent for the cloud and the ground truth.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub method: Option<String>,
    /// What its indices of points count from, where the caller says so.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub first: Option<u8>,
}

/// The files of one model.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct ModelFiles {
    /// Unique among the models: `PC1`, or `training_set/PC1` where two sets have one.
    pub name: String,
    /// The number its name ends with.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub number: Option<u32>,
    /// The cloud, then the ground truth, then the methods' files in the order of their names.
    pub files: Vec<PlacedFile>,
}

/// A file without a place.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct Unplaced {
    /// The path as it was given.
    pub path: String,
    /// Why it has none, and what would give it one.
    pub reason: String,
    /// What its name and folder say it is, where they say that it holds segments or surfaces.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[tsify(optional)]
    pub recognised: Option<Recognised>,
}

/// What a file that has no place was taken for.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct Recognised {
    /// What it holds.
    pub role: Role,
    /// The name of the cloud it asks for.
    pub model: String,
    /// Whose result it would be.
    pub method: String,
}

/// Files sorted into models.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
pub struct Grouping {
    /// The models in the order people count: PC2 before PC10.
    pub models: Vec<ModelFiles>,
    /// Files that belong to no model as far as can be told.
    pub unplaced: Vec<Unplaced>,
    /// How many files were passed over as litter.
    pub ignored: u32,
}

/// Sorts files into models by their paths alone.
///
/// # Errors
/// Only if the overrides are not of the declared type.
#[wasm_bindgen]
pub fn group(
    paths: Vec<String>,
    overrides: Option<Ts<Overrides>>,
) -> Result<Ts<Grouping>, JsError> {
    let overrides = overrides.map(|overrides| overrides.to_rust()).transpose()?;
    // One by one: to be collected they would be sorted, by code of their own.
    let mut known = BTreeMap::new();
    for (path, said) in overrides.unwrap_or_default().0 {
        let said = format::Override {
            role: said.role.map(format::Role::from),
            model: said.model,
            method: said.method,
            first: said.first,
        };
        known.insert(path, said);
    }
    let grouping = format::group(&paths, &known);
    hand_over(&Grouping {
        models: grouping.models.into_iter().map(ModelFiles::from).collect(),
        unplaced: grouping.unplaced.into_iter().map(Unplaced::from).collect(),
        ignored: grouping.ignored as u32,
    })
}

impl From<format::ModelFiles> for ModelFiles {
    fn from(model: format::ModelFiles) -> Self {
        Self {
            name: model.name,
            number: model.number,
            files: model.files.into_iter().map(PlacedFile::from).collect(),
        }
    }
}

impl From<format::PlacedFile> for PlacedFile {
    fn from(file: format::PlacedFile) -> Self {
        Self {
            path: file.path,
            role: file.role.into(),
            method: file.method,
            first: file.first,
        }
    }
}

impl From<format::Unplaced> for Unplaced {
    fn from(file: format::Unplaced) -> Self {
        Self {
            path: file.path,
            reason: file.reason,
            recognised: file.recognised.map(Recognised::from),
        }
    }
}

impl From<format::Recognised> for Recognised {
    fn from(recognised: format::Recognised) -> Self {
        Self {
            role: recognised.role.into(),
            model: recognised.model,
            method: recognised.method,
        }
    }
}
