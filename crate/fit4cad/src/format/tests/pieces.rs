//! Texts read in pieces: the same as read whole, to the last line number.

use std::borrow::Cow;
use std::cell::Cell;

use proptest::prelude::*;

use crate::format::limits::MAX_FILE_BYTES;
use crate::format::{Readers, Role, Source, read_cloud, read_cloud_by_pieces, read_files};

/// What files of points are made of, well and badly.
const FRAGMENTS: &[&str] = &[
    "[1, 2, 3], ",
    "[4.5, -2e3, 7],",
    "[1 2 3];",
    "[1, 2\n, 3],",
    "[1, 2",
    "1, 2, 3]",
    "[nan, 1, 2],",
    "[1e40, 0, 0]",
    "1 2 3",
    "1.5 2.5 3.5 7",
    "4 5 6 -1",
    "1;2;3",
    "1,2,3",
    "1,5 2,5 3,5",
    "1\t2\t\t3",
    "1 2",
    "1 x 3",
    "nan 1 2",
    "x y z",
    "x y z label",
    "# a remark",
    "% another",
    "// a third",
    "1 2 3 # behind",
    "words of no meaning",
    "Primitive1:=[1 2];",
    "Points:=[",
    "Points=[",
    "Points",
    "[",
    "];",
    "]",
    ";",
    "1205",
    "3",
    "",
    " ",
    "\u{e9}",
    "\"1\" \"2\" \"3\"",
    "0 0 0 0.25 1 9",
];

fn text() -> impl Strategy<Value = String> {
    let end = prop::sample::select(vec!["\n", "\n", "\n", "\r\n", "\r", " ", ""]);
    let fragment = prop::sample::select(FRAGMENTS.to_vec());
    let usual = prop::sample::select(FRAGMENTS.to_vec());
    // Most of a file is rows of one kind.
    (
        usual,
        prop::collection::vec((fragment, end, 0usize..4), 0..60),
        any::<bool>(),
    )
        .prop_map(|(usual, lines, mark)| {
            let mut text = String::from(if mark { "\u{feff}" } else { "" });
            for (fragment, end, more) in lines {
                text.push_str(fragment);
                text.push_str(end);
                for _ in 0..more {
                    text.push_str(usual);
                    text.push('\n');
                }
            }
            text
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn a_text_in_pieces_reads_as_the_whole(text in text(), piece in 1usize..120, labelled: bool) {
        let (name, text) = (if labelled { "PC1.xyzc" } else { "PC1.txt" }, text.as_bytes());
        prop_assert_eq!(read_cloud_by_pieces(name, text, piece), read_cloud(name, text));
    }

    #[test]
    fn so_do_bytes_of_any_kind(bytes in prop::collection::vec(any::<u8>(), 0..200), piece in 1usize..50) {
        prop_assert_eq!(read_cloud_by_pieces("PC1.txt", &bytes, piece), read_cloud("PC1.txt", &bytes));
    }
}

#[test]
fn a_row_that_is_a_lone_quote_is_told_of_by_its_own_line() {
    let text = b"\"\n\0\0\0\0\0\0\0";
    let (_, findings) = read_cloud("PC1.txt", text);
    assert_eq!(findings[0].found, "the end of the line");
    assert_eq!(read_cloud_by_pieces("PC1.txt", text, 1).1, findings);
}

/// A text that is made when it is asked for, and counts how much of it is.
struct Made {
    path: &'static str,
    row: &'static [u8],
    rows: u64,
    largest: Cell<u64>,
}

impl Source for Made {
    fn path(&self) -> &str {
        self.path
    }

    fn role(&self) -> Role {
        Role::Cloud
    }

    fn method(&self) -> Option<&str> {
        None
    }

    fn size(&self) -> u64 {
        self.rows * self.row.len() as u64
    }

    fn content(&self) -> Result<Cow<'_, [u8]>, String> {
        Err("it is read in pieces".to_owned())
    }

    fn part(&self, from: u64, to: u64) -> Option<Result<Cow<'_, [u8]>, String>> {
        self.largest.set(self.largest.get().max(to - from));
        let length = self.row.len() as u64;
        let byte = |at: u64| self.row.get((at % length) as usize).copied();
        Some(Ok(Cow::Owned((from..to).filter_map(byte).collect())))
    }
}

/// A long file that gzip packed, of which nothing but pieces are to be had.
struct Packed {
    bytes: Vec<u8>,
    largest: Cell<u64>,
}

impl Source for Packed {
    fn path(&self) -> &'static str {
        "PC1.xyz.gz"
    }

    fn role(&self) -> Role {
        Role::Cloud
    }

    fn method(&self) -> Option<&str> {
        None
    }

    fn size(&self) -> u64 {
        self.bytes.len() as u64
    }

    fn content(&self) -> Result<Cow<'_, [u8]>, String> {
        Err("it is read in pieces".to_owned())
    }

    fn part(&self, from: u64, to: u64) -> Option<Result<Cow<'_, [u8]>, String>> {
        self.largest.set(self.largest.get().max(to - from));
        Some(Ok(Cow::Borrowed(&self.bytes[from as usize..to as usize])))
    }
}

#[test]
fn a_long_text_that_is_packed_is_read_as_it_is_unpacked() {
    let rows: String = (0..600_000)
        .map(|at| match at {
            500_000 => "1 x 2\n".to_owned(),
            at => format!("{}.25 {} {}.5\n", at % 977, at % 101, at),
        })
        .collect();
    let mut bytes = vec![0x1F, 0x8B, 8, 0, 0, 0, 0, 0, 0, 3];
    bytes.extend(miniz_oxide::deflate::compress_to_vec(rows.as_bytes(), 1));
    bytes.extend([0; 8]);
    let (whole, _) = read_cloud("PC1.xyz.gz", rows.as_bytes());
    let packed = Packed {
        bytes,
        largest: Cell::new(0),
    };
    let reading = read_files("PC1", std::slice::from_ref(&packed), &Readers::ALL);
    assert_eq!(reading.model.cloud, whole.cloud);
    let told: Vec<_> = reading
        .diagnostics
        .iter()
        .filter_map(|it| it.position)
        .collect();
    assert_eq!((told.len(), told[0].line), (1, 500_001));
    assert!(packed.largest.get() < packed.size());
}

#[test]
fn a_long_text_is_never_asked_for_whole() {
    for row in [&b"[0.125, -3.5, 17.25], \n"[..], b"0.125 -3.5 17.25\n"] {
        let rows = 1_000_000;
        let made = Made {
            path: "PC1.txt",
            row,
            rows,
            largest: Cell::new(0),
        };
        let reading = read_files("PC1", &[made], &Readers::ALL);
        assert_eq!(
            reading.model.cloud.len() as u64,
            rows,
            "{:?}",
            reading.diagnostics
        );
        let spare = reading.model.cloud.points().first().map(|point| point.x);
        assert_eq!(spare, Some(0.125));
    }
    // The scorer leaves rows to the whole engine after the first piece of them.
    let made = Made {
        path: "PC1.txt",
        row: b"0.125 -3.5 17.25\n",
        rows: 1_000_000,
        largest: Cell::new(0),
    };
    let files = [made];
    let reading = read_files("PC1", &files, &Readers::OWN);
    assert!(reading.unread && reading.model.cloud.is_empty());
    assert!(files[0].largest.get() < files[0].size() / 3);
    // What cannot be had is told, and what is too long is not asked for.
    let endless = Made {
        path: "PC1.txt",
        row: b"1 2 3\n",
        rows: MAX_FILE_BYTES,
        largest: Cell::new(0),
    };
    let files = [endless];
    let reading = read_files("PC1", &files, &Readers::ALL);
    assert!(reading.diagnostics[0].message.contains("too large"));
    assert_eq!(files[0].largest.get(), 0);
}
