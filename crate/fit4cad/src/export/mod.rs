//! A segmentation in the forms of other programs: tables of its primitives, its points with a label
//! each, and the patches of its surfaces as a mesh.

mod archive;
mod groups;
mod mesh;
mod points;
mod table;

pub use archive::Arrays;
#[cfg(test)]
pub(crate) use archive::zip as zip_of;

use crate::cloud::Cloud;
use crate::model::Segmentation;

/// A form that a segmentation can be written in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Export {
    /// The primitives as a table for spreadsheets.
    Csv,
    /// The primitives for programs.
    Json,
    /// Points, colours and labels as PLY, binary.
    Ply,
    /// Points, colours and labels as PLY, text.
    PlyText,
    /// Rows `x y z label`.
    Xyzc,
    /// Arrays of NumPy.
    Npz,
    /// Vertex groups.
    Groups,
    /// The patches as Wavefront OBJ.
    Obj,
    /// The patches as STL, binary.
    Stl,
    /// The patches as a mesh in PLY, binary.
    Mesh,
    /// The patches as binary glTF.
    Glb,
}

impl Export {
    /// All, tables first.
    pub const ALL: [Self; 11] = [
        Self::Csv,
        Self::Json,
        Self::Ply,
        Self::PlyText,
        Self::Xyzc,
        Self::Npz,
        Self::Groups,
        Self::Obj,
        Self::Stl,
        Self::Mesh,
        Self::Glb,
    ];

    /// Name by which it is asked for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Csv => "csv",
            Self::Json => "json",
            Self::Ply => "ply",
            Self::PlyText => "ply-text",
            Self::Xyzc => "xyzc",
            Self::Npz => "npz",
            Self::Groups => "vg",
            Self::Obj => "obj",
            Self::Stl => "stl",
            Self::Mesh => "ply-mesh",
            Self::Glb => "glb",
        }
    }

    /// How names of its files end: a word of what is in them where several forms share an ending.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Csv => "_primitives.csv",
            Self::Json => "_primitives.json",
            Self::Ply | Self::PlyText => ".ply",
            Self::Xyzc => ".xyzc",
            Self::Npz => ".npz",
            Self::Groups => ".vg",
            Self::Obj => "_surfaces.obj",
            Self::Stl => "_surfaces.stl",
            Self::Mesh => "_surfaces.ply",
            Self::Glb => "_surfaces.glb",
        }
    }

    /// What it is called.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Csv => "Primitives, CSV",
            Self::Json => "Primitives, JSON",
            Self::Ply => "Points, PLY binary",
            Self::PlyText => "Points, PLY text",
            Self::Xyzc => "Points, .xyzc",
            Self::Npz => "Points, NumPy .npz",
            Self::Groups => "Points, .vg",
            Self::Obj => "Surfaces, OBJ",
            Self::Stl => "Surfaces, STL",
            Self::Mesh => "Surfaces, PLY mesh",
            Self::Glb => "Surfaces, GLB",
        }
    }

    /// What it holds, in a sentence.
    pub const fn meaning(self) -> &'static str {
        match self {
            Self::Csv => {
                "A row for each primitive: type, axis, position, radii, angle, points, MFE, dHaus, standard errors."
            }
            Self::Json => "The same for programs, with what made it.",
            Self::Ply => "Every point with the number of its primitive and its colour, exact.",
            Self::PlyText => "The same as text.",
            Self::Xyzc => "Rows x y z label, as Point2CAD reads them.",
            Self::Npz => "Arrays points, labels, numbers and types.",
            Self::Groups => {
                "Vertex groups of Easy3D, PolyFit, Mapple and CGAL, with planes and the like."
            }
            Self::Obj => "The covered part of each surface as an object of its own, named.",
            Self::Stl => "The same as one mesh of triangles.",
            Self::Mesh => "The same with colours.",
            Self::Glb => "The same with names and colours, for viewers.",
        }
    }

    /// Whether it is of surfaces rather than points: primitives without one leave no trace in it.
    pub const fn is_of_surfaces(self) -> bool {
        matches!(self, Self::Obj | Self::Stl | Self::Mesh | Self::Glb)
    }
}

/// What is known of where a segmentation comes from, for the forms that can say so.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct About {
    /// Name of the model.
    pub model: String,
    /// Name of the method; `truth` for the ground truth.
    pub method: String,
    /// Whether the surfaces were fitted to given segments by this engine.
    pub fitted: bool,
    /// Red, green and blue of points that belong to no primitive, then of the primitives in their order,
    /// from the beginning again after the last. Without any, all is grey.
    pub colours: Vec<[u8; 3]>,
}

impl About {
    /// The colour of the primitive at a place, or of points of none.
    fn colour(&self, place: Option<usize>) -> [u8; 3] {
        const GREY: [u8; 3] = [128; 3];
        let Some((none, colours)) = self.colours.split_first() else {
            return GREY;
        };
        match place {
            Some(place) if !colours.is_empty() => {
                colours.get(place % colours.len()).copied().unwrap_or(GREY)
            }
            _ => *none,
        }
    }
}

/// Writes a segmentation of a cloud. Linear in the points, but for patches.
///
/// ```
/// use fit4cad::export::{About, Export, write};
/// use fit4cad::sample::{Options, generate};
/// let options = Options { spacing: 0.02, ..Options::default() };
/// let model = generate("flange", &options)?;
/// let truth = model.truth.unwrap_or_default();
/// let table = write(Export::Csv, &model.cloud, &truth, &About::default());
/// assert_eq!(table.split(|byte| *byte == b'\n').count(), truth.primitives.len() + 2);
/// # Ok::<(), fit4cad::sample::SampleError>(())
/// ```
pub fn write(export: Export, cloud: &Cloud, segmentation: &Segmentation, about: &About) -> Vec<u8> {
    match export {
        Export::Csv => table::csv(cloud, segmentation).into_bytes(),
        Export::Json => table::json(cloud, segmentation, about).into_bytes(),
        Export::Ply => points::ply(cloud, segmentation, about, false),
        Export::PlyText => points::ply(cloud, segmentation, about, true),
        Export::Xyzc => points::xyzc(cloud, segmentation).into_bytes(),
        Export::Npz => archive::npz(cloud, segmentation),
        Export::Groups => groups::vg(cloud, segmentation, about).into_bytes(),
        Export::Obj => mesh::obj(cloud, segmentation, about).into_bytes(),
        Export::Stl => mesh::stl(cloud, segmentation),
        Export::Mesh => mesh::ply(cloud, segmentation, about),
        Export::Glb => mesh::glb(cloud, segmentation, about),
    }
}

#[cfg(test)]
mod tests;
