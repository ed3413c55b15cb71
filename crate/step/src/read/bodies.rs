//! Bodies: solids, shells and faces that stand for themselves.

use super::Reader;
use crate::file::File;

/// What a representation may list that has faces.
pub(super) const BODIES: [&str; 13] = [
    "MANIFOLD_SOLID_BREP",
    "BREP_WITH_VOIDS",
    "FACETED_BREP",
    "SHELL_BASED_SURFACE_MODEL",
    "FACE_BASED_SURFACE_MODEL",
    "CLOSED_SHELL",
    "OPEN_SHELL",
    "CONNECTED_FACE_SET",
    "ORIENTED_CLOSED_SHELL",
    "ORIENTED_OPEN_SHELL",
    "ADVANCED_FACE",
    "FACE_SURFACE",
    "ORIENTED_FACE",
];

/// What a representation may list that has a shape, but no faces of a boundary.
const OTHERS: [&str; 12] = [
    "TESSELLATED_SOLID",
    "TESSELLATED_SHELL",
    "TRIANGULATED_SURFACE_SET",
    "COMPLEX_TRIANGULATED_SURFACE_SET",
    "GEOMETRIC_CURVE_SET",
    "GEOMETRIC_SET",
    "CSG_SOLID",
    "EXTRUDED_AREA_SOLID",
    "REVOLVED_AREA_SOLID",
    "SWEPT_DISK_SOLID",
    "HALF_SPACE_SOLID",
    "EDGE_BASED_WIREFRAME_MODEL",
];

/// Whether an entity is a body with faces.
pub(crate) fn is_body(file: &File, id: u64) -> bool {
    BODIES.iter().any(|name| file.is(id, name))
}

/// Why an entity with a shape gives no faces; `None` of all others.
pub(crate) fn why_no_body(file: &File, id: u64) -> Option<String> {
    let name = OTHERS.iter().find(|name| file.is(id, name))?;
    Some(
        if name.contains("TESSELLATED") || name.contains("TRIANGULATED") {
            format!("{name}: triangles for display, not the faces themselves")
        } else {
            format!("{name}: no faces of a boundary")
        },
    )
}

impl Reader<'_> {
    /// The faces of a body, those around its voids included.
    pub fn faces_of(&self, body: u64) -> Vec<u64> {
        let mut faces = Vec::new();
        self.collect(body, 0, &mut faces);
        faces
    }

    fn collect(&self, id: u64, depth: usize, faces: &mut Vec<u64>) {
        let file = self.file;
        let is = |name| file.is(id, name);
        let Ok(fields) = file.fields(id) else {
            return;
        };
        if depth > 6 {
            return;
        }
        if is("ADVANCED_FACE") || is("FACE_SURFACE") || is("ORIENTED_FACE") {
            faces.push(id);
            return;
        }
        let inner: Vec<u64> = if is("ORIENTED_CLOSED_SHELL") || is("ORIENTED_OPEN_SHELL") {
            fields.reference(2).into_iter().collect()
        } else if is("BREP_WITH_VOIDS") {
            // Written part by part, the shells of the voids come after the outer one all the same.
            let outer = fields.reference(1).into_iter();
            outer
                .chain(fields.references(2).unwrap_or_default())
                .collect()
        } else if is("MANIFOLD_SOLID_BREP") || is("FACETED_BREP") {
            fields.reference(1).into_iter().collect()
        } else {
            fields.references(1).unwrap_or_default()
        };
        for each in inner {
            self.collect(each, depth + 1, faces);
        }
    }
}
