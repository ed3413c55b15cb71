//! What a run must not do, and how it is told.

use std::fmt;
use std::path::PathBuf;

use crate::corpus;

/// What a run did that it must not do.
pub enum Fault {
    /// It panicked: where, and with which words.
    Panic(String, String),
    /// It took too long.
    Hang,
    /// It held so many bytes.
    Memory(usize),
}

impl Fault {
    /// What tells it from another of the target's.
    pub fn place(&self) -> &str {
        match self {
            Self::Panic(place, _) => place,
            Self::Hang => "hang",
            Self::Memory(_) => "memory",
        }
    }

    fn word(&self) -> &'static str {
        match self {
            Self::Panic(..) => "panic",
            Self::Hang => "hang",
            Self::Memory(_) => "memory",
        }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Panic(place, words) => write!(f, "a panic at {place}: {words}"),
            Self::Hang => f.write_str("a hang: more than two seconds of work"),
            Self::Memory(bytes) => write!(f, "too much memory: {bytes} bytes"),
        }
    }
}

/// Where faults are told of.
#[derive(Clone)]
pub struct Report {
    /// Name of the target.
    pub target: &'static str,
    /// Folder for their inputs.
    pub folder: PathBuf,
}

impl Report {
    /// Writes the input down and says how to run it again.
    pub fn tell(&self, fault: &Fault, input: &[u8]) {
        let name = format!(
            "{}-{}-{}",
            self.target,
            fault.word(),
            corpus::name_of(input)
        );
        let path = self.folder.join(name);
        let written =
            std::fs::create_dir_all(&self.folder).and_then(|()| std::fs::write(&path, input));
        println!("{}: {fault}", self.target);
        match written {
            Ok(()) => {
                let path = path.display();
                println!("  input of {} bytes: {path}", input.len());
                println!(
                    "  again with: npm run fuzz -- {} --replay {path}",
                    self.target
                );
            }
            Err(error) => println!(
                "  {} could not be written ({error}): {input:?}",
                path.display()
            ),
        }
    }
}
