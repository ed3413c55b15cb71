//! Contents of the files of a model, had one at a time and within the limits: whole, or of long texts piece by piece.

use std::borrow::Cow;

use super::cloud::{self, CloudFile, RowForm, read_own};
use super::encoding;
use super::foreign::{is_gzip, may_be_foreign, read_by_pieces as read_foreign_by_pieces};
use super::limits::{MAX_FILE_BYTES, MAX_MODEL_BYTES};
use super::pieces::Union;
use super::readers::{ByPieces, Pieced, Readers, Taken};
use super::source::Source;
use super::window::{PIECE, Text, Window};
use crate::cloud::Cloud;
use crate::diagnostics::{Diagnostic, Severity, Subject};

/// The cloud of a file, and whether it was left for later.
fn cloud_of(path: &str, bytes: &[u8], readers: &Readers) -> ((CloudFile, bool), Vec<Diagnostic>) {
    match (readers.cloud)(path, bytes) {
        Taken::Own => {
            let (file, findings) = read_own(path, bytes);
            ((file, false), findings)
        }
        Taken::Later => ((CloudFile::default(), true), Vec::new()),
        Taken::Read(file, findings) => ((file, false), findings),
    }
}

/// The same of a file that is too long to be held, piece by piece; `None` where it is to be read whole: it is short, or
/// no text.
///
/// # Errors
/// Why the file cannot be had to its end.
fn by_pieces<S: Source>(file: &S, readers: &Readers) -> Result<Option<Pieced>, String> {
    const GONE: &str = "it cannot be read in pieces any more";
    let (path, size) = (file.path(), file.size());
    let is_long = size > 2 * PIECE as u64;
    // Of what is short as it is, only what is called so is looked at twice.
    if !is_long && !path.ends_with(".gz") || file.part(0, 0).is_none() {
        return Ok(None);
    }
    let part = |from, to| file.part(from, to).unwrap_or_else(|| Err(GONE.to_owned()));
    if let Some(ByPieces { unpacked, .. }) = readers.by_pieces
        && is_gzip(&part(0, size.min(2))?)
    {
        let name = path.strip_suffix(".gz").unwrap_or(path);
        return unpacked(size, &part, &|text| long(name, text, readers));
    }
    if !is_long {
        return Ok(None);
    }
    long(path, Text { size, part: &part }, readers)
}

/// The same of a long text.
///
/// # Errors
/// Why it cannot be had to its end.
fn long(path: &str, text: Text<'_>, readers: &Readers) -> Result<Option<Pieced>, String> {
    let mut window = Window::open(text, PIECE)?;
    // Whoever reads other kinds of files begins anew.
    let later = Ok(Some(((CloudFile::default(), true), Vec::new())));
    if !is_in_pieces(path, &window) {
        return match readers.by_pieces {
            None => later,
            Some(ByPieces { foreign, .. }) => {
                let found = foreign(path, &mut window)?;
                Ok(found.map(|(file, findings)| ((file, false), findings)))
            }
        };
    }
    let (file, findings) = match (cloud::begin(path, &mut window)?, readers.by_pieces) {
        (Err(_), _) => return Ok(None),
        (Ok((at, RowForm::Paper)), _) => cloud::read_papers_form(path, &mut window, at)?,
        (Ok((at, RowForm::Table)), Some(ByPieces { table, .. })) => {
            table(path, &mut window, at, cloud::is_labelled(path))?
        }
        (Ok((_, RowForm::Table)), None) => return later,
    };
    Ok(Some(((file, false), findings)))
}

/// Whether a text can be read in pieces, by how it begins: it is of one byte a character, and no file of another
/// program.
fn is_in_pieces(file: &str, window: &Window<'_>) -> bool {
    let head = window.bytes();
    matches!(encoding::utf8(head), Cow::Borrowed(_)) && !may_be_foreign(file, head, window.size())
}

/// As [`super::read_cloud`], by pieces of so many bytes, as long texts are read; the same whatever they are. Text of two
/// bytes a character is read whole.
pub fn read_cloud_by_pieces(
    file: &str,
    bytes: &[u8],
    piece: usize,
) -> (CloudFile, Vec<Diagnostic>) {
    if matches!(encoding::utf8(bytes), Cow::Owned(_)) {
        return cloud::read_cloud(file, bytes);
    }
    let labelled = cloud::is_labelled(file);
    let read = in_pieces(bytes, piece, |window| {
        cloud::read_window(file, window, labelled)
    });
    // What is in memory can be had.
    read.unwrap_or_default()
}

/// The cloud of a file of another program, by pieces of so many bytes; `None` where it is of a kind that is read whole, or
/// of no other program.
pub fn read_foreign_cloud_by_pieces(
    file: &str,
    bytes: &[u8],
    piece: usize,
) -> Option<(CloudFile, Vec<Diagnostic>)> {
    let read = in_pieces(bytes, piece, |window| read_foreign_by_pieces(file, window));
    read.unwrap_or_default()
}

fn in_pieces<T>(
    bytes: &[u8],
    piece: usize,
    read: impl FnOnce(&mut Window<'_>) -> Result<T, String>,
) -> Result<T, String> {
    let part = |from: u64, to: u64| {
        let [from, to] = [from, to].map(|at| usize::try_from(at).unwrap_or(usize::MAX));
        Ok(Cow::Borrowed(bytes.get(from..to).unwrap_or_default()))
    };
    let text = Text {
        size: bytes.len() as u64,
        part: &part,
    };
    let mut window = Window::open(text, piece)?;
    window.reach(cloud::MARK)?;
    read(&mut window)
}

/// Reads files of one model while they are within the limits, and keeps what is wrong.
#[derive(Default)]
pub(super) struct Reader {
    bytes: u64,
    pub(super) diagnostics: Vec<Diagnostic>,
    pub(super) bare: Vec<Option<String>>,
    pub(super) unread: bool,
}

impl Reader {
    /// What `parse` makes of a file's path and content, where it can be had.
    pub(super) fn read<'s, S: Source, T>(
        &mut self,
        file: &'s S,
        parse: impl FnOnce(&'s str, &[u8]) -> (T, Vec<Diagnostic>),
    ) -> Option<T> {
        self.parse(file, || Ok(parse(file.path(), &file.content()?)))
    }

    /// What `parse` makes of a file, where it is not too large and can be had.
    fn parse<S: Source, T>(
        &mut self,
        file: &S,
        parse: impl FnOnce() -> Result<(T, Vec<Diagnostic>), String>,
    ) -> Option<T> {
        let refused = match self.admit(file.size()) {
            Err((found, expected)) => Refusal::TooLarge(found, expected),
            Ok(()) => match parse() {
                Err(reason) => Refusal::Unreadable(reason),
                Ok((content, findings)) => {
                    self.diagnostics.extend(findings);
                    return Some(content);
                }
            },
        };
        self.diagnostics.push(refused.told_of(file.path()));
        None
    }

    /// The cloud of a file; empty where it cannot be had.
    pub(super) fn cloud<S: Source>(&mut self, file: &S, readers: &Readers) -> CloudFile {
        let content = self.parse(file, || match by_pieces(file, readers)? {
            Some(found) => Ok(found),
            None => Ok(cloud_of(file.path(), &file.content()?, readers)),
        });
        let (file, unread) = content.unwrap_or_default();
        self.unread |= unread;
        file
    }

    /// The cloud of a file that holds the points of one primitive: what else it says of them is left out,
    /// as it would be said of each.
    pub(super) fn piece<S: Source>(&mut self, file: &S, readers: &Readers) -> Cloud {
        let before = self.diagnostics.len();
        let CloudFile { cloud, .. } = self.cloud(file, readers);
        let own = self.diagnostics.split_off(before).into_iter();
        self.diagnostics
            .extend(own.filter(|finding| finding.severity > Severity::Note));
        cloud
    }

    /// The cloud that files make together, each with the points of one primitive.
    pub(super) fn union<S: Source>(&mut self, files: &[&S], readers: &Readers) -> CloudFile {
        let mut union = Union::default();
        for &file in files {
            let cloud = self.piece(file, readers);
            self.diagnostics.extend(union.add(file.path(), &cloud));
        }
        union.finish()
    }

    /// Counts a file of so many bytes in; says what is too much, and what would not be.
    fn admit(&mut self, size: u64) -> Result<(), (String, String)> {
        let mebibytes = |bytes: u64| format!("{} MiB", bytes.div_ceil(1 << 20));
        if size > MAX_FILE_BYTES {
            let most = mebibytes(MAX_FILE_BYTES);
            return Err((mebibytes(size), format!("at most {most}")));
        }
        let total = self.bytes + size;
        if total > MAX_MODEL_BYTES {
            let most = mebibytes(MAX_MODEL_BYTES);
            return Err((
                format!("{} with the model's files before it", mebibytes(total)),
                format!("at most {most} in all files of a model"),
            ));
        }
        self.bytes = total;
        Ok(())
    }
}

/// Why a file is not read.
enum Refusal {
    /// What was found and what would be read.
    TooLarge(String, String),
    /// Why its content could not be had.
    Unreadable(String),
}

impl Refusal {
    fn told_of(&self, path: &str) -> Diagnostic {
        match self {
            Self::TooLarge(found, expected) => whole_file(
                path,
                "The file is too large and was not read",
                found,
                expected,
                "Thin the cloud or split the file",
            ),
            Self::Unreadable(reason) => {
                let message = format!("The file could not be read: {reason}");
                whole_file(path, &message, "", "", "")
            }
        }
    }
}

/// A finding about a file as a whole, by which it is not used.
pub(super) fn whole_file(
    file: &str,
    message: &str,
    found: &str,
    expected: &str,
    hint: &str,
) -> Diagnostic {
    Diagnostic {
        severity: Severity::Error,
        subject: Subject::File,
        primitive: None,
        file: file.to_owned(),
        position: None,
        message: message.to_owned(),
        found: found.to_owned(),
        expected: expected.to_owned(),
        hint: hint.to_owned(),
    }
}
