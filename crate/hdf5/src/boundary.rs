//! HDF5 files as JavaScript sees them.

use std::cell::RefCell;
use std::collections::HashMap;

use js_sys::{Error as JsThrown, Function, Uint8Array};
use serde::{Deserialize, Serialize};
use tsify::{Ts, Tsify};
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsError, JsValue};

use crate::Opened;

thread_local! {
    /// What gives the bytes of each file that is open. The reader wants what could be sent to other threads, of which
    /// there are none here; a number can be.
    static SOURCES: RefCell<Sources> = RefCell::new(Sources::default());
}

#[derive(Default)]
struct Sources {
    next: u32,
    open: HashMap<u32, Function>,
}

/// A file that is open.
#[wasm_bindgen]
pub struct ArrayFile {
    source: u32,
    opened: Opened,
}

/// One file of a model in it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Tsify)]
pub struct ArrayFileEntry {
    /// The path under which it is sorted into models.
    pub path: String,
    /// Its bytes, about.
    pub size: f64,
}

#[wasm_bindgen]
impl ArrayFile {
    /// Opens a file by its path, its size in bytes, and what gives the bytes from one offset to before another:
    /// `(from: number, to: number) => Uint8Array`.
    ///
    /// # Errors
    /// If it is no HDF5, is damaged, or holds neither points nor labels.
    pub fn open(path: &str, size: f64, read: Function) -> Result<ArrayFile, JsError> {
        let source = SOURCES.with_borrow_mut(|sources| {
            sources.next += 1;
            sources.open.insert(sources.next, read);
            sources.next
        });
        let opened = Opened::open(path, size as u64, move |from, length| {
            bytes(source, from, length)
        });
        match opened {
            Ok(opened) => Ok(Self { source, opened }),
            Err(error) => {
                forget(source);
                Err(error.into())
            }
        }
    }

    /// The files of models in it.
    ///
    /// # Errors
    /// None in practice: plain values always cross.
    pub fn entries(&self) -> Result<Vec<Ts<ArrayFileEntry>>, JsError> {
        let entries = self.opened.entries().iter().map(|entry| ArrayFileEntry {
            path: entry.path.clone(),
            size: entry.size as f64,
        });
        entries
            .map(|entry| entry.into_ts().map_err(JsError::from))
            .collect()
    }

    /// What else there is to say of it, of "it".
    pub fn notes(&self) -> Vec<String> {
        self.opened.notes().to_vec()
    }

    /// The content of the entry at a place: arrays of NumPy in a zip.
    ///
    /// # Errors
    /// If there is none, or its arrays cannot be had.
    pub fn read(&self, place: usize) -> Result<Vec<u8>, JsError> {
        let entry = self.opened.entries().get(place);
        let entry = entry.ok_or_else(|| JsError::new("there is no such entry"))?;
        Ok(self.opened.read(entry)?)
    }
}

impl Drop for ArrayFile {
    fn drop(&mut self) {
        forget(self.source);
    }
}

fn forget(source: u32) {
    SOURCES.with_borrow_mut(|sources| sources.open.remove(&source));
}

fn bytes(source: u32, from: u64, length: usize) -> Result<Vec<u8>, String> {
    let read = SOURCES.with_borrow(|sources| sources.open.get(&source).cloned());
    let read = read.ok_or("it was closed")?;
    // Offsets are below 2⁵³ in all that JavaScript can hold.
    let to = from as f64 + length as f64;
    let given = read.call2(&JsValue::NULL, &(from as f64).into(), &to.into());
    let given: Uint8Array = given.and_then(JsCast::dyn_into).map_err(|thrown| {
        let error = thrown.dyn_ref::<JsThrown>();
        error.map_or_else(
            || "its bytes could not be had".to_owned(),
            |error| String::from(error.message()),
        )
    })?;
    Ok(given.to_vec())
}
