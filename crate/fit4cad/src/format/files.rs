//! The kinds of files that can be read, by the endings of their names. What a file holds is told by its
//! content; its ending tells whether to look at all.

/// What files of a kind hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Holds {
    /// Points; if they come with segments, those are the truth's.
    Cloud,
    /// Points with or without segments: beside or below a cloud of their name, its segments.
    Either,
    /// Segments of a cloud that lies elsewhere.
    Segments,
}

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FileKind {
    /// Endings of its names, in lower case, without the dot.
    pub endings: &'static [&'static str],
    /// What it is called.
    pub title: &'static str,
    /// What is read from it.
    pub meaning: &'static str,
    /// What such files hold where their names do not say.
    pub holds: Holds,
    /// Whether a module of its own opens them, and hands on what is in them as files of other kinds.
    pub is_opened_apart: bool,
}

/// Every kind. Where two files of a folder could be the same cloud, the one of the first kind is.
pub const FILE_KINDS: [FileKind; 11] = [
    FileKind {
        endings: &["txt"],
        title: "Text",
        meaning: "the benchmark's files, and rows x y z of any kind",
        holds: Holds::Cloud,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["xyz", "xyzn", "xyzrgb", "csv", "tsv", "pts", "asc", "dat"],
        title: "Rows of points",
        meaning: "x y z and what follows, separated by blanks, tabs, commas or semicolons, with or \
                  without a first line of names or a number of points; a column of labels is the truth",
        holds: Holds::Cloud,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["xyzc"],
        title: "Labelled rows",
        meaning: "the same; the last column is of labels",
        holds: Holds::Either,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["ply"],
        title: "PLY",
        meaning: "vertices, text or binary; labels by the name of their property",
        holds: Holds::Either,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["pcd"],
        title: "PCD",
        meaning: "points, text, binary or compressed; labels by the name of their field",
        holds: Holds::Either,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["las"],
        title: "LAS",
        meaning: "points, not packed; labels by the name of what is added to each",
        holds: Holds::Either,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["npz", "npy"],
        title: "NumPy",
        meaning: "an array of points, of labels, or several in an archive, by their names",
        holds: Holds::Either,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["h5", "hdf5"],
        title: "HDF5",
        meaning: "points, labels and types of one model or of many, of SPFN, ParseNet and HPNet, by the names of \
                  their arrays; predictions are submissions",
        holds: Holds::Either,
        is_opened_apart: true,
    },
    FileKind {
        endings: &["vg"],
        title: "Vertex groups",
        meaning: "points, and the types and points of primitives, of Easy3D, PolyFit and CGAL",
        holds: Holds::Either,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["obj", "stl"],
        title: "Meshes",
        meaning: "the vertices of OBJ, the distinct ones of STL",
        holds: Holds::Cloud,
        is_opened_apart: false,
    },
    FileKind {
        endings: &["seg", "labels", "fidx"],
        title: "Labels",
        meaning: "a whole number a point in the order of the cloud, -1 for none; also PC14_labels.txt, \
                  PC14_inst.txt and the like, and beside them PC14_type.txt, the type of each point; and of any kind a cloud for each primitive, as CloudCompare's \
                  RANSAC saves them, beside their cloud or without: Plane_0001, PC14_CYLINDER_0002_cloud, Leftovers",
        holds: Holds::Segments,
        is_opened_apart: false,
    },
];

/// The kind of file that a name ends with, packed by gzip or not: its place in [`FILE_KINDS`], and the
/// name without its ending.
pub(super) fn kind_of(name: &str) -> Option<(usize, &str)> {
    let (stem, ending) = name.rsplit_once('.')?;
    let (stem, ending) = if ending.eq_ignore_ascii_case("gz") {
        stem.rsplit_once('.')?
    } else {
        (stem, ending)
    };
    let is_named = |kind: &FileKind| {
        kind.endings
            .iter()
            .any(|known| known.eq_ignore_ascii_case(ending))
    };
    Some((FILE_KINDS.iter().position(is_named)?, stem))
}

/// Endings of files that come with data sets and hold no points: pictures, programs, documents.
const OTHERS: [&str; 37] = [
    "png", "jpg", "jpeg", "gif", "svg", "bmp", "tif", "tiff", "webp", "eps", "fig", "pdf", "md",
    "rst", "tex", "bib", "cff", "html", "css", "doc", "docx", "xls", "xlsx", "pptx", "m", "mlx",
    "py", "ipynb", "js", "mjs", "c", "cpp", "h", "sh", "yml", "yaml", "log",
];

/// Whether a name is that of a picture, a program or a document.
pub(super) fn is_of_other_kind(name: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(_, ending)| {
        OTHERS
            .iter()
            .any(|known| known.eq_ignore_ascii_case(ending))
    })
}

/// The endings of all kinds, as `.txt, .xyz, …`.
pub(super) fn endings() -> String {
    let all = FILE_KINDS.iter().flat_map(|kind| kind.endings);
    let dotted: Vec<String> = all.map(|ending| format!(".{ending}")).collect();
    dotted.join(", ")
}
