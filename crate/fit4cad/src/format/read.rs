//! Reading all files of one model.

use std::collections::BTreeMap;

use super::assemble::{Named, assemble};
use super::cloud::{CloudText, read_cloud};
use super::numbering::Numbering;
use super::primitives::read_primitives;
use super::surfaces::{SurfaceFile, read_surfaces};
use crate::diagnostics::{Diagnostic, Severity, Subject};
use crate::model::{Model, Segmentation};
use crate::surface::Form;

/// What a file holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// `PCi.txt`: the points.
    Cloud,
    /// `PCi_primitives.txt`: which points belong together.
    Primitives,
    /// `PCi_parametric.txt`: their surfaces in parametric form.
    Parametric,
    /// `PCi_implicit.txt`: their surfaces in implicit form.
    Implicit,
}

/// One file of a model.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SourceFile<'a> {
    /// Path, for the diagnostics.
    pub path: &'a str,
    /// What it holds.
    pub role: Role,
    /// The method whose result it is; `None` for the cloud and the ground truth.
    pub method: Option<&'a str>,
    /// The content.
    pub bytes: &'a [u8],
}

/// Reads a model from its files, in whatever order they come. Linear in their length.
///
/// Whatever is wrong is among the diagnostics and the rest is used; without points there is
/// nothing to refer to, and no other file is read.
pub fn read_model(name: &str, files: &[SourceFile<'_>]) -> (Model, Vec<Diagnostic>) {
    let mut diagnostics = Vec::new();
    let mut clouds = files.iter().filter(|file| file.role == Role::Cloud);
    let mut model = Model {
        name: name.to_owned(),
        ..Model::default()
    };
    let Some(cloud) = clouds.next() else {
        let file = files.first().map_or(name, |file| file.path);
        diagnostics.push(whole_file(
            file,
            "There is no file of points for this model",
            &format!("{name}.txt"),
            "Add the cloud the primitives were found in",
        ));
        return (model, diagnostics);
    };
    for other in clouds {
        diagnostics.push(second(other.path, cloud.path));
    }
    let (CloudText { cloud, numbering }, findings) = read_cloud(cloud.path, cloud.bytes);
    diagnostics.extend(findings);
    model.cloud = cloud;

    // Truth (no method) sorts first.
    let mut methods: BTreeMap<Option<&str>, Files<'_>> = BTreeMap::new();
    for file in files {
        let of_method = methods.entry(file.method).or_default();
        let slot = match file.role {
            Role::Cloud => continue,
            Role::Primitives => &mut of_method.primitives,
            Role::Parametric => &mut of_method.parametric,
            Role::Implicit => &mut of_method.implicit,
        };
        match slot {
            Some(first) => diagnostics.push(second(file.path, first.path)),
            None => *slot = Some(*file),
        }
    }
    if model.cloud.is_empty() {
        return (model, diagnostics);
    }
    for (method, files) in methods {
        let Some(segmentation) = files.read(&numbering, &mut diagnostics) else {
            continue;
        };
        match method {
            None => model.truth = Some(segmentation),
            Some(method) => model.submit(method, segmentation),
        }
    }
    (model, diagnostics)
}

/// The files of one method, or of the truth.
#[derive(Default)]
struct Files<'a> {
    primitives: Option<SourceFile<'a>>,
    parametric: Option<SourceFile<'a>>,
    implicit: Option<SourceFile<'a>>,
}

impl Files<'_> {
    fn read(
        &self,
        numbering: &Numbering,
        diagnostics: &mut Vec<Diagnostic>,
    ) -> Option<Segmentation> {
        let Some(file) = self.primitives else {
            if let Some(surfaces) = self.parametric.or(self.implicit) {
                diagnostics.push(whole_file(
                    surfaces.path,
                    "There are surfaces but no file of primitives for them",
                    "a file ending in _primitives.txt that lists their points",
                    "Add it",
                ));
            }
            return None;
        };
        let (lists, findings) = read_primitives(file.path, file.bytes, numbering);
        diagnostics.extend(findings);
        let lists = Named {
            file: file.path,
            content: lists,
        };
        let parametric = surfaces(self.parametric, Form::Parametric, diagnostics);
        let implicit = surfaces(self.implicit, Form::Implicit, diagnostics);
        let (segmentation, findings) = assemble(lists, parametric, implicit);
        diagnostics.extend(findings);
        Some(segmentation)
    }
}

fn surfaces<'a>(
    file: Option<SourceFile<'a>>,
    form: Form,
    diagnostics: &mut Vec<Diagnostic>,
) -> Named<'a, SurfaceFile> {
    let Some(SourceFile { path, bytes, .. }) = file else {
        return Named::default();
    };
    let (content, findings) = read_surfaces(path, bytes, form);
    diagnostics.extend(findings);
    Named {
        file: path,
        content,
    }
}

fn second(path: &str, first: &str) -> Diagnostic {
    whole_file(
        path,
        "A second file of the same kind is not read",
        "one file of a kind for each method",
        &format!("{first} is used; give them different methods"),
    )
}

fn whole_file(file: &str, message: &str, expected: &str, hint: &str) -> Diagnostic {
    Diagnostic {
        severity: Severity::Error,
        subject: Subject::File,
        primitive: None,
        file: file.to_owned(),
        position: None,
        message: message.to_owned(),
        found: String::new(),
        expected: expected.to_owned(),
        hint: hint.to_owned(),
    }
}
