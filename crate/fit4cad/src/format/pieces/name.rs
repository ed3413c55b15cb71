//! Names of clouds that hold the points of one primitive.

use crate::format::files::kind_of;
use crate::surface::SurfaceType;

/// What the name of such a cloud says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::format) struct PieceName<'a> {
    /// Name of the model; empty where it is not told.
    pub(in crate::format) model: &'a str,
    /// Type of the primitive; `None` for the points of none.
    pub(in crate::format) kind: Option<SurfaceType>,
}

/// Digits of the number: CloudCompare fills it up with zeros, by which its files are told from models that
/// somebody calls `plane_1`.
const DIGITS: usize = 4;

impl<'a> PieceName<'a> {
    /// Reads a name without its ending: `Cylinder_0001`, `part_CYLINDER_0001_cloud`, `Leftovers`. `None` where
    /// it is another kind of name.
    pub(in crate::format) fn read(stem: &'a str) -> Option<Self> {
        let stem = without(stem, "_cloud").unwrap_or(stem);
        if let Some(model) = without(stem, "leftovers") {
            return (model.is_empty() || ends_apart(model)).then(|| Self {
                model: trimmed(model),
                kind: None,
            });
        }
        let head = stem.trim_end_matches(|it: char| it.is_ascii_digit());
        if stem.len() - head.len() < DIGITS {
            return None;
        }
        let head = head.strip_suffix('_')?;
        SurfaceType::ALL.into_iter().find_map(|kind| {
            let name = kind.name();
            let shouted = name.to_ascii_uppercase();
            let model = head
                .strip_suffix(name)
                .or_else(|| head.strip_suffix(shouted.as_str()))?;
            (model.is_empty() || ends_apart(model)).then(|| Self {
                model: trimmed(model),
                kind: Some(kind),
            })
        })
    }
}

/// What the name of a file says, by its path.
pub(in crate::format) fn of_path(path: &str) -> Option<PieceName<'_>> {
    let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
    PieceName::read(kind_of(name)?.1)
}

/// A name without its last word, whatever case that is written in.
fn without<'a>(name: &'a str, word: &str) -> Option<&'a str> {
    let at = name.len().checked_sub(word.len())?;
    let end = name.get(at..)?;
    end.eq_ignore_ascii_case(word).then(|| name.get(..at))?
}

const SEPARATORS: [char; 4] = ['_', '-', '.', ' '];

fn ends_apart(model: &str) -> bool {
    model.ends_with(SEPARATORS)
}

fn trimmed(model: &str) -> &str {
    model.trim_end_matches(SEPARATORS)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_names_that_cloudcompare_gives_tell_model_and_type() {
        let known = [
            ("Plane_0001", "", Some(SurfaceType::Plane)),
            ("Cylinder_0012", "", Some(SurfaceType::Cylinder)),
            ("CONE_0003_cloud", "", Some(SurfaceType::Cone)),
            (
                "scan 1_SPHERE_0001_cloud",
                "scan 1",
                Some(SurfaceType::Sphere),
            ),
            ("a_b - Torus_10000", "a_b", Some(SurfaceType::Torus)),
            ("Leftovers", "", None),
            ("scan_LEFTOVERS_cloud", "scan", None),
        ];
        for (stem, model, kind) in known {
            assert_eq!(
                PieceName::read(stem),
                Some(PieceName { model, kind }),
                "{stem}"
            );
        }
        let others = [
            "",
            "_cloud",
            "plane_0001",
            "Plane_1",
            "Plane0001",
            "Airplane_0001",
            "Plane_0001_x",
            "PC1",
            "0001",
        ];
        for stem in others {
            assert_eq!(PieceName::read(stem), None, "{stem}");
        }
        assert_eq!(
            of_path("a/Plane_0001.ply.gz").map(|it| it.kind),
            Some(Some(SurfaceType::Plane))
        );
        assert_eq!(of_path("Plane_0001"), None);
    }
}
