//! Says what becomes of HDF5 files: `cargo run -p fit4cad-hdf5 --example arrays -- FILE…`.

use std::io::Write as _;

use fit4cad_hdf5::Opened;

fn main() -> std::io::Result<()> {
    let mut out = std::io::stdout();
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path)?;
        let size = bytes.len() as u64;
        let opened = Opened::open(&path, size, move |from, length| {
            let from = usize::try_from(from).unwrap_or(usize::MAX);
            let part = bytes.get(from..from.saturating_add(length));
            part.map(<[u8]>::to_vec)
                .ok_or_else(|| "it is shorter".to_owned())
        });
        match opened {
            Err(error) => writeln!(out, "{path}: {error}")?,
            Ok(opened) => {
                for note in opened.notes() {
                    writeln!(out, "{path}: {note}")?;
                }
                for entry in opened.entries() {
                    let read = opened.read(entry).map(|bytes| bytes.len());
                    writeln!(out, "{path}: {} {read:?}", entry.path)?;
                }
            }
        }
    }
    Ok(())
}
