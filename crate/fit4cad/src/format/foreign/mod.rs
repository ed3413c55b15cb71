//! Reading what other programs write: PLY, PCD, LAS, OBJ, STL, NumPy's arrays, vertex groups, and any of
//! them packed by gzip. What a file is, is told by how it begins.

mod distinct;
mod gather;
mod gzip;
mod kinds;
mod las;
mod lzf;
mod mesh;
mod npy;
mod numpy;
mod pcd;
mod ply;
mod scalar;
mod vg;
mod zip;

#[cfg(test)]
mod streaming;
#[cfg(test)]
mod tests;

pub use super::purpose::Purpose;
pub(super) use gzip::{Packed, Unpacking};
pub use gzip::{is_gzip, unpack_gzip};
pub use lzf::unpack as unpack_lzf;
pub use scalar::{Kind as ScalarKind, Scalar};
pub use vg::TYPES as VERTEX_GROUP_TYPES;

use std::collections::BTreeMap;

use super::cloud::CloudFile;
use super::findings::Findings;
use super::window::Window;
use crate::diagnostics::Diagnostic;
use crate::surface::SurfaceType;

/// What a file of another program holds.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// Points, perhaps with segments.
    Cloud(CloudFile),
    /// A label for each row of a cloud, and the types of the segments that have one.
    Labels(Vec<i32>, BTreeMap<u32, SurfaceType>),
    /// Text of one of the kinds that are read anyway, unpacked.
    Text(Vec<u8>),
}

/// Reads a file of another program, whatever it is packed in; `None` where it is none. Linear in its length, but for the
/// distinct vertices of STL.
pub fn read_foreign(
    file: &str,
    bytes: &[u8],
    purpose: Purpose,
) -> Option<(Content, Vec<Diagnostic>)> {
    let kind = kind_of(file, bytes)?;
    if kind != Kind::Gzip {
        return read_kind(kind, file, bytes, purpose);
    }
    let Some(unpacked) = unpack_gzip(bytes) else {
        let mut findings = Findings::new(file, &[]);
        findings.add_whole(&kinds::PACKED_BADLY, String::new());
        return Some((Content::Cloud(CloudFile::default()), findings.finish()));
    };
    let name = file.strip_suffix(".gz").unwrap_or(file);
    match kind_of(name, &unpacked) {
        // Twice packed is as good as broken.
        None | Some(Kind::Gzip) => Some((Content::Text(unpacked), Vec::new())),
        Some(kind) => read_kind(kind, name, &unpacked, purpose),
    }
}

/// Whether a file is of another program.
pub fn is_foreign(file: &str, bytes: &[u8]) -> bool {
    kind_of(file, bytes).is_some()
}

/// Whether a file of so many bytes is of another program, or may be, by how it begins.
pub(super) fn may_be_foreign(file: &str, head: &[u8], size: u64) -> bool {
    head.starts_with(b"PK\x03\x04") || mesh::is_binary_stl(head, size) || is_foreign(file, head)
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    Gzip,
    Array,
    Archive,
    Hdf5,
    Ply,
    Pcd,
    Las,
    Stl,
    Groups,
    Obj,
}

fn kind_of(file: &str, bytes: &[u8]) -> Option<Kind> {
    let named = |ending: &str| {
        file.rsplit_once('.')
            .is_some_and(|(_, own)| own.eq_ignore_ascii_case(ending))
    };
    Some(match bytes {
        _ if is_gzip(bytes) => Kind::Gzip,
        [0x93, b'N', b'U', b'M', b'P', b'Y', ..] => Kind::Array,
        [b'P', b'K', 3, 4, ..] if zip::holds_arrays(bytes) => Kind::Archive,
        _ if bytes.starts_with(HDF5) => Kind::Hdf5,
        [b'p', b'l', b'y', b'\n' | b'\r', ..] => Kind::Ply,
        _ if bytes.starts_with(las::MAGIC) => Kind::Las,
        _ if is_pcd(bytes) => Kind::Pcd,
        _ if mesh::is_stl(bytes, named("stl")) => Kind::Stl,
        _ if vg::is_vg(bytes) => Kind::Groups,
        _ if mesh::is_obj(bytes) => Kind::Obj,
        _ => return None,
    })
}

fn read_kind(
    kind: Kind,
    file: &str,
    bytes: &[u8],
    purpose: Purpose,
) -> Option<(Content, Vec<Diagnostic>)> {
    let findings = Findings::new(file, &[]);
    let of_cloud = |(file, findings)| (Content::Cloud(file), findings);
    Some(match kind {
        Kind::Gzip => return None,
        Kind::Array => numpy::read_array(findings, bytes),
        Kind::Archive => numpy::read_archive(findings, bytes, purpose),
        Kind::Hdf5 => {
            let mut findings = findings;
            findings.add_whole(&kinds::NOT_OPENED, String::new());
            of_cloud((CloudFile::default(), findings.finish()))
        }
        Kind::Ply => of_cloud(in_memory(ply::read(findings, &mut Window::whole(bytes)))),
        Kind::Pcd => of_cloud(in_memory(pcd::read(findings, &mut Window::whole(bytes)))),
        Kind::Las => of_cloud(in_memory(las::read(findings, &mut Window::whole(bytes)))),
        Kind::Stl => of_cloud(in_memory(mesh::read_stl(
            findings,
            &mut Window::whole(bytes),
        ))),
        Kind::Groups => of_cloud(vg::read(findings, bytes)),
        Kind::Obj => of_cloud(in_memory(mesh::read_obj(
            findings,
            &mut Window::whole(bytes),
        ))),
    })
}

/// What was read of a file that is in memory, and so can be had.
fn in_memory(read: Result<(CloudFile, Vec<Diagnostic>), String>) -> (CloudFile, Vec<Diagnostic>) {
    read.unwrap_or_default()
}

/// The cloud of a long file of another program, piece by piece; `None` where it is of a kind that is read whole.
///
/// # Errors
/// Why the file cannot be had to its end.
pub(super) fn read_by_pieces(
    file: &str,
    window: &mut Window<'_>,
) -> Result<Option<(CloudFile, Vec<Diagnostic>)>, String> {
    let findings = Findings::new(file, &[]);
    let mut kind = kind_of(file, window.bytes());
    if !matches!(kind, Some(Kind::Ply | Kind::Las)) {
        window.reach(LONGEST_HEAD)?;
        kind = kind_of(file, window.bytes());
    }
    let head = window.bytes();
    if mesh::is_binary_stl(head, window.size()) {
        kind = Some(Kind::Stl);
    }
    Ok(match kind {
        Some(Kind::Ply) => Some(ply::read(findings, window)?),
        Some(Kind::Pcd) if !pcd::is_compressed(head) => Some(pcd::read(findings, window)?),
        Some(Kind::Las) => Some(las::read(findings, window)?),
        Some(Kind::Array) => numpy::read_rows(findings, window)?,
        Some(Kind::Stl) => Some(mesh::read_stl(findings, window)?),
        Some(Kind::Obj) => Some(mesh::read_obj(findings, window)?),
        // Archives and groups refer to places all over themselves.
        _ => None,
    })
}

/// Most bytes by which a kind of file is told.
const LONGEST_HEAD: usize = 1 << 16;

/// What HDF5 begins with.
const HDF5: &[u8] = b"\x89HDF\r\n\x1a\n";

/// Whether bytes begin as PCD files do: remarks, then the version or the fields.
fn is_pcd(bytes: &[u8]) -> bool {
    let window = bytes.get(..4096).unwrap_or(bytes);
    let lines = window.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let first = lines
        .into_iter()
        .find(|line| !line.is_empty() && !line.starts_with(b"#"));
    first.is_some_and(|line| {
        [&b"VERSION "[..], b"FIELDS ", b"COLUMNS "]
            .iter()
            .any(|word| line.starts_with(word))
    })
}
