//! What the columns of a cloud hold, told by their names or, where they have none, by their values.

use std::fmt::Write;

use crate::cloud::Point;
use crate::format::labels::is_label_value;

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::format) enum Meaning {
    /// A coordinate: 0, 1 or 2.
    Coordinate(usize),
    /// A component of the normal.
    Normal,
    /// A component of the colour.
    Colour,
    /// How strongly the scanner was answered.
    Intensity,
    /// The segment the point belongs to.
    Label,
    /// Something else.
    Other,
}

/// Names of columns in lower case, without what stands around letters and digits.
const NAMES: [(Meaning, &[&str]); 8] = [
    (
        Meaning::Coordinate(0),
        &[
            "x",
            "px",
            "coordx",
            "xcoord",
            "xcoordinate",
            "pointx",
            "posx",
            "points0",
            "easting",
        ],
    ),
    (
        Meaning::Coordinate(1),
        &[
            "y",
            "py",
            "coordy",
            "ycoord",
            "ycoordinate",
            "pointy",
            "posy",
            "points1",
            "northing",
        ],
    ),
    (
        Meaning::Coordinate(2),
        &[
            "z",
            "pz",
            "coordz",
            "zcoord",
            "zcoordinate",
            "pointz",
            "posz",
            "points2",
            "elevation",
            "height",
        ],
    ),
    (
        Meaning::Normal,
        &[
            "nx",
            "ny",
            "nz",
            "normalx",
            "normaly",
            "normalz",
            "normals0",
            "normals1",
            "normals2",
            "normal0",
            "normal1",
            "normal2",
            "curvature",
        ],
    ),
    (
        Meaning::Colour,
        &[
            "r",
            "g",
            "b",
            "a",
            "red",
            "green",
            "blue",
            "alpha",
            "rgb",
            "rgba",
            "rf",
            "gf",
            "bf",
            "diffusered",
            "diffusegreen",
            "diffuseblue",
            "color",
            "colour",
        ],
    ),
    (
        Meaning::Intensity,
        &[
            "i",
            "intensity",
            "reflectance",
            "remission",
            "scalarintensity",
            "amplitude",
        ],
    ),
    (Meaning::Label, &LABEL_NAMES),
    (
        Meaning::Other,
        &["id", "index", "row", "type", "time", "gpstime"],
    ),
];

/// What a column of labels is called, those that tell more first.
const LABEL_NAMES: [&str; 30] = [
    "primitiveindex",
    "vprimitiveindex",
    "primitive",
    "primitiveid",
    "instance",
    "instanceid",
    "instanceperpoint",
    "inst",
    "segmentindex",
    "segment",
    "segmentid",
    "segid",
    "seg",
    "patch",
    "patchid",
    "cluster",
    "clusterid",
    "region",
    "regionid",
    "group",
    "groupid",
    "face",
    "faceid",
    "faceindex",
    "labels",
    "label",
    "scalarlabel",
    "class",
    "classification",
    "originalcloudindex",
];

/// The meaning of a column's name, whatever its case and whatever joins its words (`Scalar field #2`,
/// `v:primitive_index`, `Points:0`, `X [m]`).
pub(in crate::format) fn meaning_of(name: &str) -> Meaning {
    known(name).unwrap_or(Meaning::Other)
}

/// The meaning of a name that tells one.
fn known(name: &str) -> Option<Meaning> {
    let bare = name.split('[').next().unwrap_or(name);
    let mut word: String = bare
        .chars()
        .filter(|character| character.is_ascii_alphanumeric())
        .take(32)
        .collect();
    word.make_ascii_lowercase();
    let plain = word.strip_prefix("scalar").unwrap_or(&word);
    NAMES
        .into_iter()
        .find(|(_, names)| names.contains(&word.as_str()) || names.contains(&plain))
        .map(|(meaning, _)| meaning)
}

/// How well a name says that its column is of labels: the less the better; none where it does not.
fn label_rank(name: &str) -> Option<usize> {
    let mut word: String = name
        .chars()
        .filter(|character| character.is_ascii_alphanumeric())
        .collect();
    word.make_ascii_lowercase();
    let plain = word.strip_prefix("scalar").unwrap_or(&word);
    LABEL_NAMES
        .iter()
        .position(|known| *known == word || *known == plain)
}

/// Which columns are read, and what the others are taken for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::format) struct Columns {
    /// Those of x, y and z.
    pub(in crate::format) coordinates: [usize; 3],
    /// That of the labels.
    pub(in crate::format) label: Option<usize>,
    /// Of all.
    meanings: Vec<Meaning>,
}

impl Columns {
    /// By names. Where they name no x, y and z, the first three are.
    pub(in crate::format) fn named<N: AsRef<str>>(names: &[N]) -> Option<Self> {
        if names.len() < 3 {
            return None;
        }
        let mut meanings: Vec<Meaning> =
            names.iter().map(|name| meaning_of(name.as_ref())).collect();
        let place = |k: usize| meanings.iter().position(|it| *it == Meaning::Coordinate(k));
        let coordinates = match (place(0), place(1), place(2)) {
            (Some(x), Some(y), Some(z)) => [x, y, z],
            _ => [0, 1, 2],
        };
        for (k, &column) in coordinates.iter().enumerate() {
            if let Some(meaning) = meanings.get_mut(column) {
                *meaning = Meaning::Coordinate(k);
            }
        }
        let ranked = names.iter().enumerate().filter_map(|(column, name)| {
            let is_label = meanings.get(column) == Some(&Meaning::Label);
            Some((label_rank(name.as_ref()).filter(|_| is_label)?, column))
        });
        let label = ranked.min().map(|(_, column)| column);
        Some(Self {
            coordinates,
            label,
            meanings,
        })
    }

    /// Where names tell of no labels: looks for some in columns whose names tell nothing (`Scalar field`), by the values of
    /// some rows.
    pub(in crate::format) fn look_for_labels<N: AsRef<str>>(
        &mut self,
        names: &[N],
        rows: &[Vec<f64>],
    ) {
        if self.label.is_some() {
            return;
        }
        let tells_nothing = |name: &N| known(name.as_ref()).is_none();
        let open = names.iter().enumerate();
        let open = open.filter(|(_, name)| tells_nothing(name));
        let open: Vec<usize> = open
            .map(|(column, _)| column)
            .filter(|&column| self.meanings.get(column) == Some(&Meaning::Other))
            .take(MOST_GUESSED)
            .collect();
        self.label = label_among(&open, self.coordinates, rows);
        if let Some(meaning) = self.label.and_then(|at| self.meanings.get_mut(at)) {
            *meaning = Meaning::Label;
        }
    }

    /// By the values of some rows, of which all have as many: coordinates come first. `labelled` where
    /// the kind of file says that its last column is of labels.
    pub(in crate::format) fn guessed(rows: &[Vec<f64>], labelled: bool) -> Self {
        let count = rows.iter().map(Vec::len).min().unwrap_or(3);
        let count = count.clamp(3, MOST_GUESSED);
        let mut meanings = vec![Meaning::Other; count];
        for (k, meaning) in meanings.iter_mut().take(3).enumerate() {
            *meaning = Meaning::Coordinate(k);
        }
        let column = |at: usize| rows.iter().filter_map(move |row| row.get(at).copied());
        let mut at = 3;
        while at < count {
            let triple = [column(at), column(at + 1), column(at + 2)];
            let has_triple = at + 3 <= count;
            let meaning = if has_triple && are_normals(rows, at) {
                Meaning::Normal
            } else if has_triple && triple.into_iter().all(is_of_bytes) {
                Meaning::Colour
            } else {
                at += 1;
                continue;
            };
            for each in meanings.iter_mut().skip(at).take(3) {
                *each = meaning;
            }
            at += 3;
        }
        let single = (3..count).filter(|&at| meanings.get(at) == Some(&Meaning::Other));
        let label = label_among(&single.collect::<Vec<_>>(), [0, 1, 2], rows);
        let label = match label {
            None if labelled && count > 3 && column(count - 1).all(is_label_value) => {
                Some(count - 1)
            }
            found => found,
        };
        if let Some(meaning) = label.and_then(|at| meanings.get_mut(at)) {
            *meaning = Meaning::Label;
        }
        Self {
            coordinates: [0, 1, 2],
            label,
            meanings,
        }
    }

    /// How many there are.
    pub(in crate::format) fn len(&self) -> usize {
        self.meanings.len()
    }

    /// The last one that is read.
    pub(in crate::format) fn last(&self) -> usize {
        let [x, y, z] = self.coordinates;
        x.max(y).max(z).max(self.label.unwrap_or(0))
    }

    /// What the columns but the coordinates are taken for: `normals in 4 to 6, labels in 7`. Empty where
    /// there are no others.
    pub(in crate::format) fn besides(&self) -> String {
        let mut text = String::new();
        let mut at = 0;
        while let Some(&meaning) = self.meanings.get(at) {
            let same = self.meanings.iter().skip(at);
            let run = same.take_while(|other| **other == meaning).count().max(1);
            let word = match meaning {
                Meaning::Coordinate(_) => {
                    at += run;
                    continue;
                }
                Meaning::Normal => "normals",
                Meaning::Colour => "colours",
                Meaning::Intensity => "intensity",
                Meaning::Label if Some(at) == self.label || run > 1 => "labels",
                Meaning::Label | Meaning::Other => "something not used",
            };
            if !text.is_empty() {
                text.push_str(", ");
            }
            let _ = match run {
                1 => write!(text, "{word} in {}", at + 1),
                _ => write!(text, "{word} in {} to {}", at + 1, at + run),
            };
            at += run;
            if text.len() > 120 {
                text.push_str(", …");
                break;
            }
        }
        text
    }
}

/// Whether three columns are unit vectors, as far as programs write them, some of them perhaps zero.
fn are_normals(rows: &[Vec<f64>], at: usize) -> bool {
    let mut some = false;
    let all = rows.iter().all(|row| {
        let components = row.get(at..at + 3).unwrap_or_default();
        let square: f64 = components.iter().map(|value| value * value).sum();
        let unit = (square - 1.0).abs() < 0.02;
        some |= unit;
        unit || square == 0.0
    });
    all && some
}

/// Whether values are whole numbers of a byte.
fn is_of_bytes(mut values: impl Iterator<Item = f64>) -> bool {
    values.all(|value| (0.0..=255.0).contains(&value) && value.fract() == 0.0)
}

/// Columns whose values are looked at; programs write fewer, and further ones are not used.
const MOST_GUESSED: usize = 32;

/// Which of some columns is of labels, by the values of rows: of several the one of most segments.
fn label_among(columns: &[usize], coordinates: [usize; 3], rows: &[Vec<f64>]) -> Option<usize> {
    let value = |row: &Vec<f64>, at: usize| row.get(at).copied();
    let points = rows.iter().filter_map(|row| {
        let [x, y, z] = coordinates.map(|at| value(row, at));
        Some(Point::new(x?, y?, z?))
    });
    let points: Vec<Point> = points.collect();
    let likely = columns.iter().filter_map(|&at| {
        let values: Vec<f64> = rows.iter().filter_map(|row| value(row, at)).collect();
        Some((segments(&values, &points)?, at))
    });
    likely.max().map(|(_, at)| at)
}

/// How many segments the values make where they are labels: whole numbers that near points share far
/// more often than any two points do. Quadratic in the number of points.
fn segments(values: &[f64], points: &[Point]) -> Option<usize> {
    if !values.iter().all(|&value| is_label_value(value)) || values.len() < 8 {
        return None;
    }
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let runs = sorted.chunk_by(|a, b| a == b).map(<[f64]>::len);
    let count = values.len() as f64;
    let (mut different, mut chance) = (0, 0.0);
    for run in runs {
        different += 1;
        chance += (run as f64 / count).powi(2);
    }
    if different < 2 {
        return None;
    }
    let nearest = |at: usize| {
        let own = points.get(at)?;
        let others = points.iter().enumerate().filter(|(other, _)| *other != at);
        let squared = others.map(|(other, point)| ((point - own).norm_squared(), other));
        squared.min_by(|a, b| a.0.total_cmp(&b.0))
    };
    let agreeing = (0..points.len())
        .filter(|&at| nearest(at).is_some_and(|(_, other)| values.get(other) == values.get(at)));
    let agreement = agreeing.count() as f64 / count;
    // Of a segmentation, all but the points along borders agree; of few points those are many.
    let by_chance = 3.0 * (chance * (1.0 - chance) / count).sqrt();
    (agreement - chance > by_chance.max(0.25 * (1.0 - chance))).then_some(different)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A grid of 20 × 20 points with more numbers a row.
    fn grid(more: impl Fn(usize, usize) -> Vec<f64>) -> Vec<Vec<f64>> {
        (0..400)
            .map(|at| {
                let (i, j) = (at / 20, at % 20);
                let mut row = vec![i as f64, j as f64, 0.25];
                row.extend(more(i, j));
                row
            })
            .collect()
    }

    #[test]
    fn labels_are_told_from_intensities_by_what_neighbours_share() {
        let labels = grid(|i, j| vec![(i / 7 + 3 * (j / 7)) as f64]);
        assert_eq!(Columns::guessed(&labels, false).besides(), "labels in 4");
        let counting = grid(|i, j| vec![(i * 20 + j) as f64]);
        assert_eq!(Columns::guessed(&counting, false).label, None);
        let noise = grid(|i, j| vec![((i * 7 + j * 13) as u64 * 2_654_435_761 % 4) as f64]);
        assert_eq!(Columns::guessed(&noise, false).label, None);
        let all_one = grid(|_, _| vec![1.0]);
        assert_eq!(Columns::guessed(&all_one, false).label, None);
        assert_eq!(Columns::guessed(&all_one, true).label, Some(3));
    }

    #[test]
    fn normals_and_colours_are_told_by_their_values() {
        let all = grid(|i, j| vec![0.6, 0.0, -0.8, (i * 12) as f64, 0.0, 255.0, (j / 10) as f64]);
        let columns = Columns::guessed(&all, false);
        assert_eq!(
            columns.besides(),
            "normals in 4 to 6, colours in 7 to 9, labels in 10"
        );
        assert_eq!((columns.last(), columns.len()), (9, 10));
    }

    #[test]
    fn a_name_that_tells_nothing_leaves_it_to_the_values() {
        let rows = grid(|i, j| vec![(i / 7 + 3 * (j / 7)) as f64, (i * 20 + j) as f64]);
        let look = |names: [&str; 5]| {
            let mut columns = Columns::named(&names).unwrap();
            columns.look_for_labels(&names, &rows);
            columns.label
        };
        assert_eq!(
            look(["x", "y", "z", "Scalar field", "Scalar field #2"]),
            Some(3)
        );
        assert_eq!(look(["x", "y", "z", "intensity", "id"]), None);
        assert_eq!(look(["x", "y", "z", "Scalar field", "label"]), Some(4));
    }

    #[test]
    fn names_tell_wherever_the_columns_stand() {
        let names = [
            "id",
            "Label",
            "X [m]",
            "\"Y\"",
            "z",
            "nx",
            "ny",
            "nz",
            "Scalar_Intensity",
        ];
        let columns = Columns::named(&names).unwrap();
        assert_eq!(columns.coordinates, [2, 3, 4]);
        assert_eq!(columns.label, Some(1));
        assert_eq!(
            columns.besides(),
            "something not used in 1, labels in 2, normals in 6 to 8, intensity in 9"
        );
        // Of several columns of labels the one that tells primitives apart.
        let names = ["x", "y", "z", "class", "v:primitive_index"];
        assert_eq!(Columns::named(&names).unwrap().label, Some(4));
        assert_eq!(
            Columns::named(&["east", "north", "up"])
                .unwrap()
                .coordinates,
            [0, 1, 2]
        );
        assert_eq!(Columns::named(&["x", "y"]), None);
    }
}
