//! Inputs that are kept, in memory and on disk.

use std::fs;
use std::io;
use std::path::Path;

use crate::random::Random;

/// Most bytes of a target's file.
const MOST: usize = 32 << 10;

/// An input with what it costs.
struct Kept {
    bytes: Vec<u8>,
    /// Nanoseconds of its run.
    cost: u64,
}

/// Inputs that reached something new.
#[derive(Default)]
pub struct Corpus {
    kept: Vec<Kept>,
}

impl Corpus {
    /// Keeps an input.
    pub fn keep(&mut self, bytes: Vec<u8>, cost: u64) {
        self.kept.push(Kept { bytes, cost });
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.kept.len()
    }

    /// All of them, shortest first.
    pub fn by_length(&self) -> Vec<&[u8]> {
        let mut all: Vec<&[u8]> = self.kept.iter().map(|kept| kept.bytes.as_slice()).collect();
        all.sort_by_key(|bytes| bytes.len());
        all
    }

    /// One of them: of two at random, one among the last, the shorter more often than not. Which is
    /// quicker would say more, but not the same every time.
    pub fn pick(&self, random: &mut Random) -> &[u8] {
        let count = self.kept.len();
        let draw = |random: &mut Random| {
            let late = random.chance(2);
            let from = if late { count - count.div_ceil(4) } else { 0 };
            self.kept.get(from + random.below(count - from))
        };
        let (first, second) = (draw(random), draw(random));
        let length = |kept: Option<&Kept>| kept.map_or(0, |kept| kept.bytes.len());
        let shorter = if length(first) <= length(second) {
            first
        } else {
            second
        };
        let chosen = if random.chance(3) { first } else { shorter };
        chosen.map_or(&[], |kept| kept.bytes.as_slice())
    }

    /// Mean nanoseconds of a run.
    pub fn mean_cost(&self) -> u64 {
        let sum: u64 = self.kept.iter().map(|kept| kept.cost).sum();
        sum / self.kept.len().max(1) as u64
    }
}

/// A name for a content: FNV-1a (Fowler, Noll and Vo) in sixteen digits.
pub fn name_of(bytes: &[u8]) -> String {
    let mix = |hash: u64, byte: &u8| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3);
    format!("{:016x}", bytes.iter().fold(0xcbf2_9ce4_8422_2325, mix))
}

/// The inputs of a file of the corpus, none where there is no such file. Each stands behind its length in
/// four bytes, the lowest first: thousands of files of a few bytes each would be in the way.
///
/// # Errors
/// If it cannot be read, or is cut off.
pub fn read(file: &Path) -> io::Result<Vec<Vec<u8>>> {
    if !file.exists() {
        return Ok(Vec::new());
    }
    let bytes = fs::read(file)?;
    let mut rest = bytes.as_slice();
    let mut inputs = Vec::new();
    while let Some((length, after)) = rest.split_first_chunk::<4>() {
        let length = u32::from_le_bytes(*length) as usize;
        let input = after.get(..length);
        inputs.push(input.ok_or(io::ErrorKind::UnexpectedEof)?.to_vec());
        rest = &after[length..];
    }
    if rest.is_empty() {
        Ok(inputs)
    } else {
        Err(io::ErrorKind::UnexpectedEof.into())
    }
}

/// Makes a file of the corpus hold these inputs and no others, the first of them while they are few bytes;
/// gives how many.
///
/// # Errors
/// If it cannot be written.
pub fn write(file: &Path, inputs: &[&[u8]]) -> io::Result<usize> {
    let mut bytes = Vec::new();
    let mut count = 0;
    for input in inputs {
        let length = u32::try_from(input.len()).unwrap_or(u32::MAX);
        if bytes.len() + 4 + input.len() > MOST {
            break;
        }
        bytes.extend(length.to_le_bytes());
        bytes.extend_from_slice(input);
        count += 1;
    }
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    fs::write(file, bytes)?;
    Ok(count)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_again_and_what_is_cut_off_is_told() {
        let file = std::env::temp_dir().join(format!("corpus-{}", std::process::id()));
        let inputs: [&[u8]; 3] = [b"", b"a\r\n", &[0xFF; 300]];
        let read = write(&file, &inputs).and_then(|count| {
            assert_eq!(count, 3);
            read(&file)
        });
        assert_eq!(read.ok(), Some(inputs.map(<[u8]>::to_vec).to_vec()));
        let cut = fs::read(&file).and_then(|bytes| fs::write(&file, &bytes[..bytes.len() - 1]));
        assert!(cut.is_ok() && super::read(&file).is_err());
        assert!(fs::remove_file(&file).is_ok());
    }
}
