//! A STEP file read: its bodies with their faces trimmed, and where they stand.

use std::collections::BTreeMap;

use fit4cad::cloud::{Bounds, Point};
use fit4cad::format::foreign::{is_gzip, unpack_gzip};
use fit4cad::random::Random;

use crate::error::{Got, StepError, Trouble};
use crate::face::Trimmed;
use crate::file::File;
use crate::geometry::shape::Shape;
use crate::placement::Motion;
use crate::read::Reader;
use crate::read::assembly::{Assembly, assemble};
use crate::read::topology::{Edges, Face};
use crate::recognise::recognise;

/// How exactly bounds are laid out, over the size of the body: a fifth of what points may be off.
const TOLERANCE: f64 = 2e-6;
/// The same over the size of the face, for the areas of small ones.
const TOLERANCE_OF_FACE: f64 = 1e-4;
/// How near to one of the five families a free-form face must be to be of it, over the size of the body.
const RECOGNISED: f64 = 1e-6;
/// Most faces of a document, instances counted each.
const MOST_FACES: usize = 500_000;

/// A STEP file read.
pub struct Document {
    /// The system that wrote it, as its header says; empty where it does not.
    pub system: String,
    /// The schemas its header names.
    pub schema: String,
    pub(crate) bodies: Vec<Body>,
    /// Indices of bodies, with the motion of each instance.
    pub(crate) placed: Vec<(usize, Motion)>,
    pub(crate) left_out: Vec<Trouble>,
    pub(crate) notes: Vec<String>,
    /// Diagonal of the box about all instances, in millimetres.
    pub diagonal: f64,
}

/// A body in coordinates of its own, in millimetres.
pub(crate) struct Body {
    pub name: String,
    pub faces: Vec<BodyFace>,
}

/// A face of a body.
pub(crate) struct BodyFace {
    /// Number of the entity.
    pub id: u64,
    /// Name of the type of its surface.
    pub surface: String,
    /// The face, or why it is left out.
    pub ready: Got<Ready>,
}

/// A face that can be used.
pub(crate) struct Ready {
    pub trimmed: Trimmed,
    /// What a free-form face turns out to be.
    pub recognised: Option<Shape>,
    /// What its edges are told by.
    pub edges: Vec<u64>,
}

/// How far reading or sampling has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// What is being done.
    pub stage: &'static str,
    /// How much of it is done, 0 to 1.
    pub share: f64,
}

impl Document {
    /// Reads a file, plain or packed by gzip. O(n) for n bytes, but for free-form faces, whose edges are searched for.
    ///
    /// # Errors
    /// [`StepError`] where the bytes are no STEP file, are broken, or hold no face at all. What is wrong
    /// with single faces is in the report of [`Document::sample`](crate::Document::sample).
    pub fn read(bytes: &[u8], progress: &mut dyn FnMut(Progress)) -> Result<Self, StepError> {
        progress(Progress {
            stage: "reading",
            share: 0.0,
        });
        let unpacked = is_gzip(bytes).then(|| unpack_gzip(bytes).ok_or(StepError::Packed));
        let unpacked = unpacked.transpose()?;
        let file = File::parse(unpacked.as_deref().unwrap_or(bytes))?;
        let assembly = assemble(&file)?;
        let total: usize = assembly.bodies.iter().map(|body| body.faces.len()).sum();
        if total == 0 {
            return Err(no_faces(&assembly));
        }
        let instances = assembly.placed.iter();
        let placed: usize = instances
            .map(|(body, _)| assembly.bodies[*body].faces.len())
            .sum();
        if placed > MOST_FACES {
            return Err(StepError::TooManyFaces { limit: MOST_FACES });
        }
        let mut done = 0;
        let mut bodies = Vec::with_capacity(assembly.bodies.len());
        for body in &assembly.bodies {
            let reader = Reader {
                file: &file,
                units: body.units,
            };
            let faces = prepare(&reader, &body.faces, &mut || {
                done += 1;
                progress(Progress {
                    stage: "trimming faces",
                    share: done as f64 / total as f64,
                });
            });
            bodies.push(Body {
                name: body.name.clone(),
                faces,
            });
        }
        let mut document = Self {
            system: file.header("FILE_NAME", 5).unwrap_or_default(),
            schema: file.header("FILE_SCHEMA", 0).unwrap_or_default(),
            bodies,
            placed: assembly.placed,
            left_out: assembly.left_out,
            notes: assembly.notes,
            diagonal: 0.0,
        };
        document.drop_copies();
        document.diagonal = document.bounds().diagonal();
        Ok(document)
    }

    /// Keeps some of the bodies, by their numbers from 1 in the order of the file, with all their instances.
    ///
    /// # Errors
    /// [`StepError::OutOfRange`] where there is no body of a number, with those there are.
    pub fn keep(&mut self, numbers: &[usize]) -> Result<(), StepError> {
        let unknown = numbers
            .iter()
            .find(|&&number| number == 0 || number > self.bodies.len());
        if unknown.is_some() || numbers.is_empty() {
            let found = unknown.map_or_else(|| "none".to_owned(), ToString::to_string);
            return Err(StepError::OutOfRange {
                what: "bodies",
                expected: format!("of {}", self.names()),
                found,
            });
        }
        self.placed
            .retain(|(body, _)| numbers.contains(&(body + 1)));
        self.diagonal = self.bounds().diagonal();
        Ok(())
    }

    /// The bodies with their numbers, as far as they fit into a message.
    fn names(&self) -> String {
        const MOST: usize = 12;
        let bodies = self.bodies.iter().zip(1..);
        let mut names: Vec<String> = bodies
            .take(MOST)
            .map(|(body, number)| format!("{number} ({}, {} faces)", body.name, body.faces.len()))
            .collect();
        if self.bodies.len() > MOST {
            names.push(format!("… {}", self.bodies.len()));
        }
        names.join(", ")
    }

    /// Leaves every instance once: some files list one both as part of an assembly and by itself.
    fn drop_copies(&mut self) {
        let mut kept: BTreeMap<usize, Vec<Motion>> = BTreeMap::new();
        // Where two motions are one: a billionth of a metre.
        let reach = 1e3;
        self.placed.retain(|(body, motion)| {
            let others = kept.entry(*body).or_default();
            // Screws by the thousand are compared with the last few hundred of their kind.
            let known = others
                .iter()
                .rev()
                .take(512)
                .any(|other| motion.is_like(other, reach));
            if !known {
                others.push(*motion);
            }
            !known
        });
    }

    fn bounds(&self) -> Bounds {
        let mut bounds = Bounds::EMPTY;
        let mut random = Random::new(0, 2);
        let mut looks: Vec<Vec<Point>> = Vec::new();
        for body in &self.bodies {
            let ready = body
                .faces
                .iter()
                .filter_map(|face| face.ready.as_ref().ok());
            let drawn = ready.flat_map(|face| {
                let edges = face.trimmed.corners.clone();
                let inner = (0..12).filter_map(|_| face.trimmed.draw(&mut random));
                edges
                    .into_iter()
                    .chain(inner.map(|(_, point)| point))
                    .collect::<Vec<_>>()
            });
            looks.push(drawn.collect());
        }
        for (body, motion) in &self.placed {
            for point in &looks[*body] {
                bounds.add(&motion.point(point));
            }
        }
        bounds
    }
}

fn no_faces(assembly: &Assembly) -> StepError {
    let mut reasons: Vec<String> = assembly.left_out.iter().map(ToString::to_string).collect();
    reasons.dedup();
    reasons.truncate(3);
    StepError::NoFaces {
        reason: if reasons.is_empty() {
            "there is neither a solid nor a shell in it. Export the part as solid or surface bodies"
                .to_owned()
        } else {
            reasons.join("; ")
        },
    }
}

/// Reads and trims the faces of a body.
fn prepare(reader: &Reader<'_>, ids: &[u64], step: &mut dyn FnMut()) -> Vec<BodyFace> {
    let mut edges = Edges::new();
    let faces: Vec<(u64, Got<Face>)> = ids
        .iter()
        .map(|&id| (id, reader.face(id, &mut edges)))
        .collect();
    let mut bounds = Bounds::EMPTY;
    for (edge, _) in edges.values().flatten() {
        for share in [0.0, 0.25, 0.5, 0.75] {
            bounds.add(&edge.at(share));
        }
    }
    let size = if bounds.is_empty() {
        1.0
    } else {
        bounds.diagonal()
    };
    let size = if size.is_finite() && size > 0.0 {
        size
    } else {
        1.0
    };
    let prepared = faces.into_iter().map(|(id, face)| {
        step();
        BodyFace {
            id,
            surface: reader.surface_name(id),
            ready: face.and_then(|face| {
                let own = face_size(&face).map_or(size, |own| own.min(size));
                let tolerance = f64::min(TOLERANCE * size, TOLERANCE_OF_FACE * own);
                let trimmed = Trimmed::new(id, &face, tolerance)?;
                let free = trimmed.chart.shape.surface(&Motion::identity()).is_none();
                let recognised = free
                    .then(|| recognise(&trimmed, RECOGNISED * size, id))
                    .flatten();
                Ok(Ready {
                    recognised,
                    edges: face.bounds.iter().flatten().map(|each| each.key).collect(),
                    trimmed,
                })
            }),
        }
    });
    prepared.collect()
}

/// Diagonal of the box about the edges of a face; `None` where there are none, or of no length.
fn face_size(face: &Face) -> Option<f64> {
    let edges = face.bounds.iter().flatten();
    let places: Vec<Point> = edges
        .flat_map(|each| [0.0, 0.25, 0.5, 0.75].map(|share| each.at(share)))
        .collect();
    let size = Bounds::of(&places).diagonal();
    (size > 0.0 && size.is_finite()).then_some(size)
}
