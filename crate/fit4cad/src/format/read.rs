//! Reading all files of one model.

use std::collections::BTreeMap;

use super::assemble::{Named, assemble};
use super::contents::{Reader, whole_file};
use super::counting;
use super::foreign::Purpose;
use super::labels::Segment;
use super::pieces::{self, Piece};
use super::primitives::{PointList, read_counted};
use super::readers::{Readers, Taken};
use super::source::{Role, Source};
use super::surfaces::{SurfaceFile, read_surfaces};
use super::types::{self, Told};
use crate::cloud::Cloud;
use crate::diagnostics::Diagnostic;
use crate::model::{Model, Segmentation};
use crate::surface::Form;

/// What reading the files of a model gave.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Reading {
    /// The model.
    pub model: Model,
    /// Whatever is wrong with its files.
    pub diagnostics: Vec<Diagnostic>,
    /// Whose segmentations say which points belong together and not on what surfaces, as labels do:
    /// names of methods, `None` for the truth.
    pub bare: Vec<Option<String>>,
    /// Whether there is a file that the reader of other programs' files left for later.
    pub unread: bool,
}

/// Reads a model from its files, those of other programs among them: see [`read_files`].
///
/// ```
/// use fit4cad::format::{Role, SourceFile, read_model};
/// let file = |path, role, text: &'static str| SourceFile { path, role, method: None, bytes: text.as_bytes() };
/// let files = [
///     file("PC1.txt", Role::Cloud, "0 0 0\n1 0 0\n0 1 0\nnan 1 0\n"),
///     file("PC1_primitives.txt", Role::Primitives, "Primitive1:=[1 2 3 9];"),
/// ];
/// let (model, findings) = read_model("PC1", &files);
/// assert_eq!(model.truth.map(|truth| truth.primitives[0].points.clone()), Some(vec![0, 1, 2]));
/// // What is wrong is said with file, line and column: a row that is no point, an index of no row.
/// assert!(findings.iter().any(|finding| finding.file == "PC1.txt"));
/// assert!(findings.iter().any(|finding| finding.to_string().starts_with("PC1_primitives.txt:1:20:")));
/// ```
pub fn read_model<S: Source>(name: &str, files: &[S]) -> (Model, Vec<Diagnostic>) {
    let Reading {
        model, diagnostics, ..
    } = read_files(name, files, &Readers::ALL);
    (model, diagnostics)
}

/// Reads a model from its files, in whatever order they come: the cloud, the truth, then the methods
/// by name. Linear in their length; one content at a time is held.
///
/// What a file holds is told by its content: a cloud may come with the segments of the truth; those of
/// a truth or a method may be the benchmark's lists, a label a row, or the same points with labels
/// or groups. Files that are not the benchmark's own are left to `readers`.
///
/// Whatever is wrong is among the diagnostics and the rest is used; without points there is
/// nothing to refer to, and no other file is read. Nor is one larger than
/// [`MAX_FILE_BYTES`](super::limits::MAX_FILE_BYTES), or with which the model came to more than
/// [`MAX_MODEL_BYTES`](super::limits::MAX_MODEL_BYTES).
pub fn read_files<S: Source>(name: &str, files: &[S], readers: &Readers) -> Reading {
    let mut reader = Reader::default();
    let mut model = Model {
        name: name.to_owned(),
        ..Model::default()
    };
    let mut clouds = files.iter().filter(|file| file.role() == Role::Cloud);
    let Some(cloud) = clouds.next() else {
        let file = files.first().map_or(name, Source::path);
        reader.diagnostics.push(whole_file(
            file,
            "There is no file of points for this model",
            "",
            &format!("{name}.txt"),
            "Add the cloud the primitives were found in",
        ));
        return reader.finish(model);
    };
    let mut of_pieces = vec![cloud];
    for other in clouds {
        if is_piece(cloud) && is_piece(other) {
            of_pieces.push(other);
        } else {
            reader.diagnostics.push(second(other.path(), cloud.path()));
        }
    }
    let file = if of_pieces.len() == 1 {
        reader.cloud(cloud, readers)
    } else {
        reader.union(&of_pieces, readers)
    };
    model.cloud = file.cloud;

    // Truth (no method) sorts first.
    let mut methods: BTreeMap<Option<&str>, Files<'_, S>> = BTreeMap::new();
    for file in files {
        let of_method = methods.entry(file.method()).or_default();
        let slot = match file.role() {
            Role::Cloud => continue,
            Role::Primitives => &mut of_method.primitives,
            Role::Parametric => &mut of_method.parametric,
            Role::Implicit => &mut of_method.implicit,
            Role::Types => &mut of_method.types,
        };
        match slot {
            Some(first)
                if file.role() == Role::Primitives && is_piece(*first) && is_piece(file) =>
            {
                of_method.pieces.push(file);
            }
            Some(first) => reader.diagnostics.push(second(file.path(), first.path())),
            None => *slot = Some(file),
        }
    }
    if model.cloud.is_empty() {
        return reader.finish(model);
    }
    // The cloud's own segments are the truth, where no file of the truth's says otherwise.
    if let Some(segments) = file.segments {
        let of_truth = methods.entry(None).or_default();
        if of_truth.primitives.is_none() {
            of_truth.own = Some((cloud.path(), segments));
        }
    }
    for (method, files) in methods {
        let Some(segmentation) = files.read(&model.cloud, method, readers, &mut reader) else {
            continue;
        };
        match method {
            None => model.truth = Some(segmentation),
            Some(method) => model.submit(method, segmentation),
        }
    }
    reader.finish(model)
}

impl Reader {
    fn finish(self, model: Model) -> Reading {
        Reading {
            model,
            diagnostics: self.diagnostics,
            bare: self.bare,
            unread: self.unread,
        }
    }
}

/// Whether a file is named as one that holds the points of a single primitive.
fn is_piece<S: Source>(file: &S) -> bool {
    pieces::of_path(file.path()).is_some()
}

/// What a file of segments holds.
enum Found {
    /// Lists in the benchmark's form.
    Lists(Vec<PointList>),
    /// Segments of another form, which no surface files go with.
    Segments(Vec<Segment>),
    /// Nothing that could be used; the findings say why.
    Nothing,
    /// Nothing yet.
    Later,
}

/// The files of one method, or of the truth.
struct Files<'a, S> {
    primitives: Option<&'a S>,
    /// Further files that hold the points of one primitive each, as the first does.
    pieces: Vec<&'a S>,
    parametric: Option<&'a S>,
    implicit: Option<&'a S>,
    types: Option<&'a S>,
    /// The segments that the cloud's file holds, and its path.
    own: Option<(&'a str, Vec<Segment>)>,
}

// Derived, it would ask for a default of `S`.
impl<S> Default for Files<'_, S> {
    fn default() -> Self {
        Self {
            primitives: None,
            pieces: Vec::new(),
            parametric: None,
            implicit: None,
            types: None,
            own: None,
        }
    }
}

impl<S: Source> Files<'_, S> {
    fn read(
        mut self,
        cloud: &Cloud,
        method: Option<&str>,
        readers: &Readers,
        reader: &mut Reader,
    ) -> Option<Segmentation> {
        let own = self.own.take();
        if own.is_none() && self.primitives.is_none() {
            self.tell_what_lacks(reader);
            return None;
        }
        let types = self.read_types(cloud, readers, reader);
        if let Some((path, segments)) = own {
            return Some(self.join(path, Found::Segments(segments), &types, method, reader));
        }
        let file = self.primitives?;
        if is_piece(file) {
            let found = self.read_pieces(file, cloud, readers, reader)?;
            return Some(self.join(file.path(), found, &types, method, reader));
        }
        let purpose = match method {
            None => Purpose::Truth,
            Some(_) => Purpose::Submission,
        };
        let found = reader.read(file, |path, bytes| {
            match (readers.segments)(path, bytes, cloud, purpose) {
                Taken::Own => {
                    let numbering = cloud.numbering();
                    let (lists, findings) = read_counted(path, bytes, numbering, file.first());
                    (Found::Lists(lists), findings)
                }
                Taken::Later => (Found::Later, Vec::new()),
                Taken::Read(Some(segments), findings) => (Found::Segments(segments), findings),
                Taken::Read(None, findings) => (Found::Nothing, findings),
            }
        })?;
        let counted_from_1 = file.first() == 1 && matches!(found, Found::Lists(_));
        match found {
            Found::Nothing => None,
            Found::Later => {
                reader.unread = true;
                None
            }
            found => {
                let segmentation = self.join(file.path(), found, &types, method, reader);
                if counted_from_1 {
                    let findings = counting::check(file.path(), cloud, &segmentation);
                    reader.diagnostics.extend(findings);
                }
                Some(segmentation)
            }
        }
    }

    /// Says of files that go with lists of points that there are none.
    fn tell_what_lacks(&self, reader: &mut Reader) {
        let mut tell = |file: &S, message: &str, expected: &str| {
            let finding = whole_file(file.path(), message, "", expected, "Add it");
            reader.diagnostics.push(finding);
        };
        if let Some(surfaces) = self.parametric.or(self.implicit) {
            tell(
                surfaces,
                "There are surfaces but no file of primitives for them",
                "a file ending in _primitives.txt that lists their points",
            );
        }
        if let Some(types) = self.types {
            tell(
                types,
                "There are types of points but no segments that they would be of",
                "a file ending in _labels.txt, with a whole number for each point",
            );
        }
    }

    /// The types of the points, where a file tells them and can be used.
    fn read_types(&self, cloud: &Cloud, readers: &Readers, reader: &mut Reader) -> Vec<Told> {
        let Some(file) = self.types else {
            return Vec::new();
        };
        let Some(read_types) = readers.types else {
            reader.unread = true;
            return Vec::new();
        };
        let types = reader.read(file, |path, bytes| read_types(path, bytes, cloud));
        types.flatten().unwrap_or_default()
    }

    /// The segments of files that hold the points of one primitive each.
    fn read_pieces(
        &self,
        first: &S,
        cloud: &Cloud,
        readers: &Readers,
        reader: &mut Reader,
    ) -> Option<Found> {
        let Some(onto) = readers.pieces else {
            reader.unread = true;
            return None;
        };
        let mut found = Vec::new();
        for file in std::iter::once(first).chain(self.pieces.iter().copied()) {
            // What was left over belongs to none.
            let Some(kind) = pieces::of_path(file.path()).and_then(|name| name.kind) else {
                continue;
            };
            let points = reader.piece(file, readers).into_points();
            found.push(Piece {
                path: file.path(),
                kind,
                points,
            });
        }
        let (segments, findings) = onto(&found, cloud);
        reader.diagnostics.extend(findings);
        segments.map(Found::Segments)
    }

    /// What was found in a file with the surfaces and types that go with it.
    fn join(
        self,
        file: &str,
        found: Found,
        types: &[Told],
        method: Option<&str>,
        reader: &mut Reader,
    ) -> Segmentation {
        let (content, kinds) = match found {
            Found::Lists(lists) => (lists, None),
            Found::Segments(segments) => {
                if self.parametric.or(self.implicit).is_none() {
                    reader.bare.push(method.map(str::to_owned));
                }
                let kinds: Vec<_> = segments.iter().map(|segment| segment.kind).collect();
                let lists = segments.into_iter().map(PointList::from).collect();
                (lists, Some(kinds))
            }
            Found::Nothing | Found::Later => (Vec::new(), None),
        };
        let lists = Named { file, content };
        let parametric = surfaces(self.parametric, Form::Parametric, reader);
        let implicit = surfaces(self.implicit, Form::Implicit, reader);
        let (mut segmentation, findings) = assemble(lists, parametric, implicit);
        for (primitive, kind) in segmentation
            .primitives
            .iter_mut()
            .zip(kinds.into_iter().flatten())
        {
            primitive.kind = primitive.kind.or(kind);
        }
        for primitive in &mut segmentation.primitives {
            let of_points = || types::of_points(&primitive.points, types);
            primitive.kind = primitive.kind.or_else(of_points);
        }
        reader.diagnostics.extend(findings);
        segmentation
    }
}

fn surfaces<'a, S: Source>(
    file: Option<&'a S>,
    form: Form,
    reader: &mut Reader,
) -> Named<'a, SurfaceFile> {
    let content = file.and_then(|file| {
        let content = reader.read(file, |path, bytes| read_surfaces(path, bytes, form))?;
        Some(Named {
            file: file.path(),
            content,
        })
    });
    content.unwrap_or_default()
}

fn second(path: &str, first: &str) -> Diagnostic {
    whole_file(
        path,
        "A second file of the same kind is not read",
        "",
        "one file of a kind for each method",
        &format!("{first} is used; give them different methods"),
    )
}
