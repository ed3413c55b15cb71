//! Who reads what. The benchmark's own files are read by whoever reads a model; those of other programs,
//! rows of any kind and labels by functions handed to it, so that a build which leaves them to another
//! carries none of their readers.

use std::borrow::Cow;
use std::cell::RefCell;

use super::cloud::kinds::ONE_A_ROW;
use super::cloud::{self, CloudFile, read_cloud};
use super::findings::Findings;
use super::foreign::{
    Content, Packed, Purpose, Unpacking, is_foreign, read_by_pieces as read_foreign_by_pieces,
    read_foreign,
};
use super::labels::Segment;
use super::limits::MAX_FILE_BYTES;
use super::pieces::{self, Piece};
use super::segments::{is_of_labels, read_segments};
use super::typed::read_types;
use super::types::Told;
use super::window::{PIECE, Text, Window};
use crate::cloud::Cloud;
use crate::diagnostics::Diagnostic;

/// What came of a file.
#[derive(Debug, Clone, PartialEq)]
pub enum Taken<T> {
    /// It is the benchmark's own, or as good as that.
    Own,
    /// It is not, and nobody here reads it.
    Later,
    /// It was read.
    Read(T, Vec<Diagnostic>),
}

/// Readers of files that are not the benchmark's own.
#[derive(Debug, Clone, Copy)]
pub struct Readers {
    /// Of clouds, by path and content.
    pub(super) cloud: fn(&str, &[u8]) -> Taken<CloudFile>,
    /// Of rows of any kind and of other programs' clouds, piece by piece; none where they are left for later.
    pub(super) by_pieces: Option<ByPieces>,
    /// Of segments of a cloud; none where the file cannot be used.
    pub(super) segments: ReadSegments,
    /// Of the types of a cloud's points; none where they are left for later.
    pub(super) types: Option<ReadTypes>,
    /// Of segments that come as a cloud each; none where they are left for later.
    pub(super) pieces: Option<ReadPieces>,
}

/// Readers of long files.
#[derive(Debug, Clone, Copy)]
pub(super) struct ByPieces {
    /// Of rows from an offset on; whether their last column is of labels.
    pub(super) table: fn(&str, &mut Window<'_>, usize, bool) -> Result<Found, String>,
    /// Of other programs' files; none where they are read whole.
    pub(super) foreign: fn(&str, &mut Window<'_>) -> Result<Option<Found>, String>,
    /// What reading a file of so many bytes comes to that is packed by gzip: what is handed over makes it of the text
    /// that is unpacked; none where that is short, or cannot be unpacked.
    pub(super) unpacked:
        for<'s> fn(u64, &'s Packed<'s>, OfText<'_>) -> Result<Option<Pieced>, String>,
}

/// What becomes of a text.
pub(super) type OfText<'a> = &'a dyn Fn(Text<'_>) -> Result<Option<Pieced>, String>;

/// A cloud, whether it was left for later, and what is wrong with it.
pub(super) type Pieced = ((CloudFile, bool), Vec<Diagnostic>);

/// A cloud, and what is wrong with it.
type Found = (CloudFile, Vec<Diagnostic>);

type ReadPieces = fn(&[Piece<'_>], &Cloud) -> (Option<Vec<Segment>>, Vec<Diagnostic>);

type ReadTypes = fn(&str, &[u8], &Cloud) -> (Option<Vec<Told>>, Vec<Diagnostic>);

type ReadSegments = fn(&str, &[u8], &Cloud, Purpose) -> Taken<Option<Vec<Segment>>>;

impl Readers {
    /// Those of every file.
    pub const ALL: Self = Self {
        cloud: read_any_cloud,
        by_pieces: Some(ByPieces {
            table: cloud::read_table,
            foreign: read_foreign_by_pieces,
            unpacked,
        }),
        segments: read_any_segments,
        types: Some(read_types),
        pieces: Some(pieces::onto),
    };

    /// Those that leave all but the benchmark's own files for later.
    pub const OWN: Self = Self {
        cloud: |file, bytes| taken(!is_foreign(file, bytes) && cloud::is_own(file, bytes)),
        by_pieces: None,
        segments: |file, bytes, _, _| taken(!is_foreign(file, bytes) && !is_of_labels(bytes)),
        types: None,
        pieces: None,
    };
}

/// Unpacks a long file as far as it is read. What is damaged is read whole, and that says so.
fn unpacked<'s>(
    size: u64,
    packed: &'s Packed<'s>,
    read: OfText<'_>,
) -> Result<Option<Pieced>, String> {
    let mut unpacking = Unpacking::new(size, packed);
    let length = unpacking.length().unwrap_or(0);
    if !(2 * PIECE as u64..=MAX_FILE_BYTES).contains(&length) {
        return Ok(None);
    }
    let unpacking = RefCell::new(unpacking);
    read(Text {
        size: length,
        part: &|from, to| Ok(Cow::Owned(unpacking.borrow_mut().read(from, to)?)),
    })
}

fn taken<T>(own: bool) -> Taken<T> {
    if own { Taken::Own } else { Taken::Later }
}

fn read_any_cloud(file: &str, bytes: &[u8]) -> Taken<CloudFile> {
    match read_foreign(file, bytes, Purpose::Truth) {
        Some((Content::Cloud(cloud), findings)) => Taken::Read(cloud, findings),
        Some((Content::Labels(labels, _), _)) => {
            let mut findings = Findings::new(file, &[]);
            findings.add_whole(&ONE_A_ROW, format!("{} of them", labels.len()));
            Taken::Read(CloudFile::default(), findings.finish())
        }
        Some((Content::Text(text), _)) => {
            let (cloud, findings) = read_cloud(file, &text);
            Taken::Read(cloud, findings)
        }
        None if cloud::is_own(file, bytes) => Taken::Own,
        None => {
            let (cloud, findings) = read_cloud(file, bytes);
            Taken::Read(cloud, findings)
        }
    }
}

fn read_any_segments(
    file: &str,
    bytes: &[u8],
    cloud: &Cloud,
    purpose: Purpose,
) -> Taken<Option<Vec<Segment>>> {
    match read_segments(file, bytes, cloud, purpose) {
        Some((segments, findings)) => Taken::Read(segments, findings),
        None => Taken::Own,
    }
}
