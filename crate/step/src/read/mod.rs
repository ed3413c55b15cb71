//! From entities to geometry.

pub(crate) mod assembly;
pub(crate) mod bodies;
mod curves;
mod placing;
mod relation;
mod surfaces;
pub(crate) mod topology;

use fit4cad::cloud::{Point, Vector};

use crate::error::{Got, Trouble};
use crate::file::File;
use crate::placement::{self, Frame};
use crate::units::Units;

/// How deep curves and surfaces may be made of others; what goes deeper goes in circles.
const DEEPEST: usize = 16;

/// Reads entities in the units of one context.
#[derive(Clone, Copy)]
pub(crate) struct Reader<'a> {
    /// The file.
    pub file: &'a File,
    /// Its units.
    pub units: Units,
}

impl Reader<'_> {
    fn point(&self, id: u64) -> Got<Point> {
        Ok(placement::point(self.file, id)? * self.units.length)
    }

    fn direction(&self, id: u64) -> Got<Vector> {
        let direction = placement::direction(self.file, id)?;
        let unit = direction.try_normalize(1e-300);
        unit.ok_or_else(|| Trouble::new(id, "has no direction"))
    }

    fn frame(&self, id: u64) -> Got<Frame> {
        Ok(Frame::read(self.file, id)?.scaled(self.units.length))
    }

    fn points(&self, ids: &[u64]) -> Got<Vec<Point>> {
        ids.iter().map(|&id| self.point(id)).collect()
    }
}

fn too_deep(id: u64) -> Trouble {
    Trouble::new(
        id,
        format!("is made of others more than {DEEPEST} deep, or of itself"),
    )
}
