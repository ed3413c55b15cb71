//! Where assemblies put their parts: copies that are listed, and occurrences.

use std::collections::BTreeMap;

use super::assembly::Assembler;
use super::relation::relates;
use crate::error::{Got, Trouble};
use crate::placement::{Frame, Motion};
use crate::units::items_of;

impl Assembler<'_> {
    fn add_child(&mut self, parent: u64, child: u64, motion: Motion) {
        let (parent, child) = (self.root(parent), self.root(child));
        if parent == child {
            return;
        }
        self.nodes
            .entry(parent)
            .or_default()
            .children
            .push((child, motion));
        self.nodes.entry(child).or_default().has_parent = true;
    }

    /// Parts that a representation lists as copies of others.
    pub fn place_mapped(&mut self, representations: &[u64]) {
        let file = self.file;
        for &parent in representations {
            for item in items_of(file, parent) {
                if !file.is(item, "MAPPED_ITEM") {
                    continue;
                }
                let read = || -> Got<(u64, Motion)> {
                    let own = file.fields(item)?;
                    let map = file.fields(own.reference(1)?)?;
                    let child = map.reference(1)?;
                    let from = self.frame(map.reference(0)?, child)?;
                    let target = own.reference(2)?;
                    let unit = self.units_of(parent).length;
                    let motion = if file
                        .types(target)
                        .any(|name| name.starts_with("CARTESIAN_TRANS"))
                    {
                        let back = Motion::between(&from, &standard());
                        Motion::read_operator(file, target, unit)?.after(&back)
                    } else {
                        Motion::between(&from, &self.frame(target, parent)?)
                    };
                    Ok((child, motion))
                };
                match read() {
                    Ok((child, motion)) => self.add_child(parent, child, motion),
                    Err(trouble) => self.lose(item, &trouble),
                }
            }
        }
    }

    /// Parts that stand in an assembly.
    pub fn place_occurrences(&mut self) {
        let file = self.file;
        let shapes = self.shapes_of_definitions();
        let context = |id: u64| -> Got<(u64, Option<u64>)> {
            let own = file.fields(id)?;
            let occurrence = file.fields(own.reference(1)?)?.reference(2)?;
            let related = file.fields(occurrence).and_then(|it| it.reference(4));
            Ok((own.reference(0)?, related.ok()))
        };
        let mut related: BTreeMap<u64, Option<u64>> = BTreeMap::new();
        for id in file.all("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION") {
            if let Ok((relation, part)) = context(id) {
                related.insert(relation, part);
            }
        }
        for id in file.all("REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION") {
            let part = related.get(&id).copied().flatten();
            let part = part
                .and_then(|part| shapes.get(&part))
                .map(|&shape| self.root(shape));
            let read = || -> Got<(u64, u64, Motion)> {
                let [first, second] = relates(file, id)?;
                // The component comes first, but where the occurrence says that it comes second.
                let turned = part == Some(self.root(second)) && part != Some(self.root(first));
                let own = file.part(id, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION", 4);
                let own = own.ok_or_else(|| Trouble::new(id, "has no transformation"))?;
                let motion = self.transformation(own.reference(0)?, first, second)?;
                Ok(if turned {
                    (first, second, motion.inverse())
                } else {
                    (second, first, motion)
                })
            };
            match read() {
                Ok((parent, child, motion)) => self.add_child(parent, child, motion),
                Err(trouble) => {
                    if let Ok([_, child]) = relates(file, id).map(|[first, second]| [second, first])
                    {
                        let root = self.root(child);
                        self.nodes.entry(root).or_default().has_parent = true;
                    }
                    self.lose(id, &trouble);
                }
            }
        }
    }

    fn lose(&mut self, id: u64, trouble: &Trouble) {
        let reason = format!("an instance cannot be placed: {trouble}");
        self.result.left_out.push(Trouble::new(id, reason));
    }

    /// The motion from the coordinates of one representation to those of another.
    fn transformation(&self, operator: u64, first: u64, second: u64) -> Got<Motion> {
        let file = self.file;
        if file
            .types(operator)
            .any(|name| name.starts_with("CARTESIAN_TRANS"))
        {
            return Motion::read_operator(file, operator, self.units_of(second).length);
        }
        let own = file.fields(operator)?;
        let (mut from, mut to) = (own.reference(2)?, own.reference(3)?);
        let lists = |representation: u64, item: u64| items_of(file, representation).contains(&item);
        // Some write the two placements in the other order; the lists of items tell.
        let right = lists(first, from) || lists(second, to);
        if !right && lists(first, to) && lists(second, from) {
            (from, to) = (to, from);
        }
        Ok(Motion::between(
            &self.frame(from, first)?,
            &self.frame(to, second)?,
        ))
    }

    fn frame(&self, id: u64, representation: u64) -> Got<Frame> {
        let file = self.file;
        if !file
            .types(id)
            .any(|name| name.starts_with("AXIS2_PLACEMENT"))
        {
            return Err(Trouble::new(
                id,
                format!("is {}, not a placement", file.name(id)),
            ));
        }
        let frame = Frame::read(file, id)?;
        Ok(frame.scaled(self.units_of(representation).length))
    }

    /// The representation of the shape of each product definition.
    fn shapes_of_definitions(&self) -> BTreeMap<u64, u64> {
        let file = self.file;
        let read = |id: u64| -> Got<(u64, u64)> {
            let own = file.fields(id)?;
            let definition = file.fields(own.reference(0)?)?.reference(2)?;
            Ok((definition, own.reference(1)?))
        };
        let all = file.all("SHAPE_DEFINITION_REPRESENTATION");
        all.filter_map(|id| read(id).ok()).collect()
    }
}

/// The frame of coordinates themselves.
fn standard() -> Frame {
    use fit4cad::cloud::{Point, Vector};
    Frame {
        origin: Point::origin(),
        x: Vector::x(),
        y: Vector::y(),
        z: Vector::z(),
    }
}
