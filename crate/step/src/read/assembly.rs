//! What of a file is a body, and where each stands: an assembly places its parts, once or many times.

use std::collections::{BTreeMap, BTreeSet};

use super::Reader;
use super::bodies::{BODIES, is_body, why_no_body};
use super::relation::relates;
use crate::error::{Got, StepError, Trouble};
use crate::file::File;
use crate::placement::Motion;
use crate::units::{Units, context_of, items_of};

/// Most bodies placed, instances counted each.
const MOST_PLACED: usize = 100_000;
/// Most steps from assembly to part: those of assemblies of assemblies of … grow without a body among
/// them, too.
const MOST_STEPS: usize = 1_000_000;
/// How deep assemblies may be nested.
const DEEPEST: usize = 64;

/// A body in coordinates of its own.
pub(crate) struct Body {
    /// What the file calls it, or its product.
    pub name: String,
    /// Numbers of its faces.
    pub faces: Vec<u64>,
    /// Units of its representation.
    pub units: Units,
}

/// All bodies and where they stand.
#[derive(Default)]
pub(crate) struct Assembly {
    /// Each body once.
    pub bodies: Vec<Body>,
    /// Places in `bodies`, with the motion from the body's coordinates to the file's, in millimetres.
    pub placed: Vec<(usize, Motion)>,
    /// What has a shape but could not be used, and why.
    pub left_out: Vec<Trouble>,
    /// What else is to be known.
    pub notes: Vec<String>,
}

/// Representations that share coordinates, as one.
#[derive(Default)]
pub(super) struct Node {
    bodies: Vec<usize>,
    pub children: Vec<(u64, Motion)>,
    pub has_parent: bool,
}

pub(super) struct Assembler<'a> {
    pub file: &'a File,
    usual: Units,
    /// The representation that stands for all that share its coordinates.
    one: BTreeMap<u64, u64>,
    pub nodes: BTreeMap<u64, Node>,
    products: BTreeMap<u64, String>,
    steps: usize,
    pub result: Assembly,
}

/// Finds all bodies of a file and where they stand. O(n log n).
pub(crate) fn assemble(file: &File) -> Result<Assembly, StepError> {
    let mut assembler = Assembler {
        file,
        usual: Units::usual(file),
        one: BTreeMap::new(),
        nodes: BTreeMap::new(),
        products: BTreeMap::new(),
        steps: 0,
        result: Assembly::default(),
    };
    let representations: Vec<u64> = file.numbers().filter(|&id| is_shape(file, id)).collect();
    assembler.join(&representations);
    assembler.name_products();
    assembler.find_bodies(&representations);
    assembler.place_mapped(&representations);
    assembler.place_occurrences();
    assembler.walk()?;
    assembler.add_strays();
    Ok(assembler.result)
}

/// Whether an entity is a representation of a shape.
fn is_shape(file: &File, id: u64) -> bool {
    let named = |name: &str| {
        (name.ends_with("SHAPE_REPRESENTATION") && name != "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION")
            || name == "SHAPE_REPRESENTATION_WITH_PARAMETERS"
            || name == "REPRESENTATION"
    };
    file.types(id).any(named) && file.fields(id).is_ok_and(|it| it.list(1).is_ok())
}

impl Assembler<'_> {
    pub fn units_of(&self, representation: u64) -> Units {
        context_of(self.file, representation).map_or(self.usual, |context| {
            Units::of(self.file, context, self.usual)
        })
    }

    pub fn root(&self, representation: u64) -> u64 {
        let mut at = representation;
        while let Some(&up) = self.one.get(&at)
            && up != at
        {
            at = up;
        }
        at
    }

    /// Joins representations that a relationship without a transformation says to be of one thing.
    fn join(&mut self, representations: &[u64]) {
        for &id in representations {
            self.one.insert(id, id);
        }
        let file = self.file;
        for id in file.all("SHAPE_REPRESENTATION_RELATIONSHIP") {
            if file.is(id, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION") {
                continue;
            }
            if let Ok([a, b]) = relates(file, id)
                && self.one.contains_key(&a)
                && self.one.contains_key(&b)
            {
                let (a, b) = (self.root(a), self.root(b));
                self.one.insert(a.max(b), a.min(b));
            }
        }
    }

    /// The names of products by the representations of their shapes.
    fn name_products(&mut self) {
        let file = self.file;
        let name = |definition: u64| -> Got<(u64, String)> {
            let own = file.fields(definition)?;
            let (shape, representation) = (own.reference(0)?, own.reference(1)?);
            let of = file.fields(shape)?.reference(2)?;
            let formation = file.fields(of)?.reference(2)?;
            let product = file.fields(file.fields(formation)?.reference(2)?)?;
            let name = if product.text(1).is_empty() {
                product.text(0)
            } else {
                product.text(1)
            };
            Ok((representation, name.to_owned()))
        };
        for definition in file.all("SHAPE_DEFINITION_REPRESENTATION") {
            if let Ok((representation, name)) = name(definition) {
                let root = self.root(representation);
                self.products.entry(root).or_insert(name);
            }
        }
    }

    fn find_bodies(&mut self, representations: &[u64]) {
        let file = self.file;
        let mut found: Vec<(u64, u64)> = Vec::new();
        let mut seen = BTreeSet::new();
        for &representation in representations {
            for item in items_of(file, representation) {
                if is_body(file, item) {
                    if seen.insert((self.root(representation), item)) {
                        found.push((representation, item));
                    }
                } else if let Some(why) = why_no_body(file, item)
                    && seen.insert((0, item))
                {
                    self.result.left_out.push(Trouble::new(item, why));
                }
            }
        }
        // Faces and shells are listed by themselves too, to hang a tolerance on: those of a solid are it.
        let is_part = |item: u64| {
            let parts = [
                "ADVANCED_FACE",
                "FACE_SURFACE",
                "ORIENTED_FACE",
                "CLOSED_SHELL",
                "OPEN_SHELL",
            ];
            parts.iter().any(|name| file.is(item, name))
        };
        let mut owned: BTreeSet<u64> = BTreeSet::new();
        found.sort_by_key(|&(_, item)| is_part(item));
        let mut known: BTreeMap<u64, usize> = BTreeMap::new();
        for (representation, item) in found {
            let units = self.units_of(representation);
            let root = self.root(representation);
            let index = match known.get(&item) {
                Some(&index) => index,
                None => {
                    let faces = Reader { file, units }.faces_of(item);
                    if is_part(item) && faces.iter().all(|face| owned.contains(face)) {
                        continue;
                    }
                    owned.extend(&faces);
                    let own = file.fields(item).map_or("", |fields| fields.text(0));
                    let product = self.products.get(&root);
                    let name = match product {
                        Some(product) if own.trim().is_empty() || own == "NONE" => product.clone(),
                        _ => own.to_owned(),
                    };
                    self.result.bodies.push(Body { name, faces, units });
                    known.insert(item, self.result.bodies.len() - 1);
                    self.result.bodies.len() - 1
                }
            };
            self.nodes.entry(root).or_default().bodies.push(index);
        }
        for &representation in representations {
            self.nodes.entry(self.root(representation)).or_default();
        }
    }

    /// From what stands in nothing down to the bodies.
    fn walk(&mut self) -> Result<(), StepError> {
        let starts = self.nodes.iter().filter(|(_, node)| !node.has_parent);
        let mut starts: Vec<u64> = starts.map(|(&id, _)| id).collect();
        let mut reached = BTreeSet::new();
        if starts.is_empty() {
            starts.extend(self.nodes.keys().next());
        }
        for start in starts {
            self.descend(start, &Motion::identity(), &mut Vec::new(), &mut reached)?;
        }
        Ok(())
    }

    fn descend(
        &mut self,
        id: u64,
        motion: &Motion,
        path: &mut Vec<u64>,
        reached: &mut BTreeSet<u64>,
    ) -> Result<(), StepError> {
        if path.contains(&id) || path.len() >= DEEPEST {
            let reason = "an assembly that stands in itself, or is nested too deep";
            self.result.left_out.push(Trouble::new(id, reason));
            return Ok(());
        }
        let Some(node) = self.nodes.get(&id) else {
            return Ok(());
        };
        reached.insert(id);
        let (bodies, children) = (node.bodies.clone(), node.children.clone());
        for body in bodies {
            self.place(body, *motion)?;
        }
        path.push(id);
        self.steps += 1;
        if self.steps > MOST_STEPS {
            return Err(StepError::TooManyFaces { limit: MOST_PLACED });
        }
        for (child, inner) in children {
            self.descend(child, &motion.after(&inner), path, reached)?;
        }
        path.pop();
        Ok(())
    }

    fn place(&mut self, body: usize, motion: Motion) -> Result<(), StepError> {
        if self.result.placed.len() >= MOST_PLACED {
            return Err(StepError::TooManyFaces { limit: MOST_PLACED });
        }
        self.result.placed.push((body, motion));
        Ok(())
    }

    /// Bodies in no representation of a shape: where their coordinates say.
    fn add_strays(&mut self) {
        let file = self.file;
        let mut owned: BTreeSet<u64> = BTreeSet::new();
        owned.extend(self.result.bodies.iter().flat_map(|body| &body.faces));
        let reader = Reader {
            file,
            units: self.usual,
        };
        // What is oriented is so for the sake of a body that lists it.
        let order = BODIES.iter().filter(|name| !name.starts_with("ORIENTED_"));
        let mut strays = 0;
        for id in order.flat_map(|name| file.all(name)) {
            let mut faces = reader.faces_of(id);
            faces.retain(|face| owned.insert(*face));
            if !faces.is_empty() {
                strays += 1;
                let name = file
                    .fields(id)
                    .map_or("", |fields| fields.text(0))
                    .to_owned();
                self.result
                    .placed
                    .push((self.result.bodies.len(), Motion::identity()));
                self.result.bodies.push(Body {
                    name,
                    faces,
                    units: self.usual,
                });
            }
        }
        if strays > 0 {
            self.result.notes.push(format!(
                "{strays} bodies are listed by no representation of a shape: they stand where their own coordinates say"
            ));
        }
    }
}
