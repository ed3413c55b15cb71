//! What reading a long file holds at its peak. One test alone: the count is of all threads.

#[cfg(target_arch = "wasm32")]
#[macro_use]
extern crate fit4cad_testing;

use std::borrow::Cow;

use fit4cad::format::{Readers, Role, Source, read_files};

mod counting;

const POINTS: usize = 1_000_000;
/// Bytes of a point.
const POINT: usize = 24;
/// Pieces that come and go.
const PIECES: usize = 16 << 20;

/// A file of a head and rows of one length, made as it is read.
struct Made {
    path: &'static str,
    head: Vec<u8>,
    row_size: usize,
    row: fn(usize) -> Vec<u8>,
    rows: usize,
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
        (self.head.len() + self.rows * self.row_size) as u64
    }
    fn content(&self) -> Result<Cow<'_, [u8]>, String> {
        Err("it is asked for whole".to_owned())
    }
    fn part(&self, from: u64, to: u64) -> Option<Result<Cow<'_, [u8]>, String>> {
        let (from, to) = (from as usize, to as usize);
        let mut bytes = Vec::with_capacity(to - from + 2 * self.row_size);
        bytes.extend(self.head.get(from..).unwrap_or_default());
        let begun = from.saturating_sub(self.head.len());
        let mut at = begun / self.row_size;
        let skipped = if bytes.is_empty() {
            begun % self.row_size
        } else {
            0
        };
        while bytes.len() < to - from + skipped && at < self.rows {
            bytes.extend((self.row)(at));
            at += 1;
        }
        bytes.drain(..skipped);
        bytes.truncate(to - from);
        Some(Ok(Cow::Owned(bytes)))
    }
}

fn place(at: usize) -> [f32; 3] {
    [(at % 1000) as f32, (at / 1000) as f32, 0.5]
}

fn floats(at: usize) -> Vec<u8> {
    place(at).into_iter().flat_map(f32::to_le_bytes).collect()
}

fn text(at: usize) -> Vec<u8> {
    let [x, y, z] = place(at);
    format!("{x:>10.3} {y:>10.3} {z:>6.3}\n").into_bytes()
}

/// Triangles of which each brings a point of its own, with its next two.
fn triangle(at: usize) -> Vec<u8> {
    let corners = (0..3).flat_map(|next| floats((at + next) % POINTS));
    [0; 12].into_iter().chain(corners).chain([0, 0]).collect()
}

fn files() -> Vec<Made> {
    let pcd = |data: &str| {
        format!(
            "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {POINTS}\nHEIGHT 1\n\
             POINTS {POINTS}\nDATA {data}\n"
        )
    };
    let npy = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': ({POINTS}, 3), }}\n");
    let length = (npy.len() as u16).to_le_bytes();
    let npy = [b"\x93NUMPY\x01\x00", &length[..], npy.as_bytes()].concat();
    let ply = |format: &str| {
        format!(
            "ply\nformat {format} 1.0\nelement vertex {POINTS}\nproperty float x\nproperty float y\n\
             property float z\nend_header\n"
        )
    };
    let stl = [&[b' '; 80][..], &(POINTS as u32).to_le_bytes()].concat();
    let made = |path, head: Vec<u8>, row: fn(usize) -> Vec<u8>| Made {
        path,
        head,
        row_size: row(0).len(),
        row,
        rows: POINTS,
    };
    vec![
        made("a.xyz", Vec::new(), text),
        made("a.ply", ply("ascii").into_bytes(), text),
        made("a.ply", ply("binary_little_endian").into_bytes(), floats),
        made("a.pcd", pcd("ascii").into_bytes(), text),
        made("a.pcd", pcd("binary").into_bytes(), floats),
        made("a.npy", npy, floats),
        made("a.obj", b"# points\n".to_vec(), |at| {
            [b"v ", &text(at)[..]].concat()
        }),
        made("a.stl", stl, triangle),
    ]
}

#[test]
fn a_long_file_of_any_kind_takes_no_more_memory_than_its_points_twice() {
    for file in files() {
        let (reading, bytes) =
            counting::peak(|| read_files("a", std::slice::from_ref(&file), &Readers::ALL));
        assert_eq!(
            reading.model.cloud.len(),
            POINTS,
            "{:?}",
            reading.diagnostics
        );
        let most = 2 * POINT * POINTS + PIECES;
        println!(
            "{}: {:.2} times",
            file.path,
            bytes as f64 / (POINT * POINTS) as f64
        );
        assert!(
            bytes <= most,
            "{} holds {bytes} bytes for {POINTS} points",
            file.path
        );
    }
}
