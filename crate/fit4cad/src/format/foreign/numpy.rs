//! What arrays of NumPy mean: points, or a label for each point.

use std::collections::BTreeMap;

use super::gather::Gather;
use super::kinds::{BAD_HEADER, CUT_OFF, NO_COORDINATES, PACKED_BADLY, PICKLED};
use super::npy::{Array, LONGEST_HEAD, Unread};
use super::zip;
use super::{Content, Purpose};
use crate::diagnostics::Diagnostic;
use crate::format::cloud::{CloudFile, Columns};
use crate::format::findings::Findings;
use crate::format::labels::NO_LABEL;
use crate::format::labels::is_label_value;
use crate::format::types;
use crate::format::window::Window;
use crate::surface::SurfaceType;

/// Rows by which columns are told.
const SAMPLES: usize = 1024;

/// Columns that are looked at, where they have no names.
const MOST_COLUMNS: usize = 32;

/// Reads one array.
pub(super) fn read_array(mut findings: Findings<'_>, bytes: &[u8]) -> (Content, Vec<Diagnostic>) {
    match Array::read(bytes) {
        Ok(array) => {
            if let Some(labels) = labels_of(&array) {
                return (Content::Labels(labels, BTreeMap::new()), findings.finish());
            }
            let (file, findings) = cloud(findings, &array, None);
            (Content::Cloud(file), findings)
        }
        Err(unread) => {
            refuse(&mut findings, "", unread);
            (Content::Cloud(CloudFile::default()), findings.finish())
        }
    }
}

/// Reads the arrays of an archive that are called like points and labels, or look like them. Of labels
/// called so and so and so and so `_gt`, the latter are the truth's.
pub(super) fn read_archive(
    mut findings: Findings<'_>,
    bytes: &[u8],
    purpose: Purpose,
) -> (Content, Vec<Diagnostic>) {
    let Some(entries) = zip::entries(bytes) else {
        findings.add_whole(&PACKED_BADLY, String::new());
        return (Content::Cloud(CloudFile::default()), findings.finish());
    };
    let unpacked: Vec<(String, Vec<u8>)> = entries
        .iter()
        .filter(|entry| entry.name.ends_with(".npy"))
        .filter_map(|entry| {
            let name = entry.name.trim_end_matches(".npy").to_lowercase();
            Some((name, entry.unpack(bytes)?.into_owned()))
        })
        .collect();
    let mut arrays = Vec::new();
    for (name, bytes) in &unpacked {
        match Array::read(bytes) {
            Ok(array) => arrays.push((name.as_str(), array)),
            // What else such archives hold need not concern anybody.
            Err(Unread::Head(_)) => {}
            Err(unread) => refuse(&mut findings, name, unread),
        }
    }
    const POINTS: [&str; 9] = [
        "points", "point", "xyz", "pos", "v", "pc", "coords", "vertices", "data",
    ];
    let points = arrays
        .iter()
        .filter(|(_, array)| shape(array).is_some_and(|(_, columns, _)| columns >= 3))
        .min_by_key(|(name, _)| POINTS.iter().position(|known| known == name).unwrap_or(99));
    let rows = points
        .and_then(|(_, array)| shape(array))
        .map(|(rows, ..)| rows);
    let fits = |labels: &Vec<i32>| rows.is_none_or(|rows| labels.len() == rows);
    let named = arrays.iter().filter_map(|(name, array)| {
        let rank = rank(name, purpose)?;
        Some((rank, *name, labels_of(array).filter(fits)?))
    });
    let named = named.min_by_key(|(rank, ..)| *rank);
    // Where nobody gave names, the first whole numbers that are one a row are labels.
    let nameless = || {
        let mut nameless = arrays.iter().filter(|(name, _)| name.starts_with("arr_"));
        nameless.find_map(|(name, array)| {
            let labels = labels_of(array).filter(|_| array.is_whole());
            Some((*name, labels.filter(fits)?))
        })
    };
    let labels = named
        .map(|(_, name, labels)| (name, labels))
        .or_else(nameless);
    let mut kinds = kinds_of(&arrays);
    if let (Some((_, labels)), true) = (&labels, kinds.is_empty()) {
        kinds = kinds_of_points(&arrays, labels, purpose);
    }
    match (points, labels) {
        (Some((_, array)), labels) => {
            let labels = labels.map(|(_, labels)| labels);
            let (mut file, findings) = cloud(findings, array, labels);
            for segment in file.segments.iter_mut().flatten() {
                segment.kind = kinds.get(&segment.number).copied();
            }
            (Content::Cloud(file), findings)
        }
        (None, Some((_, labels))) => (Content::Labels(labels, kinds), findings.finish()),
        (None, None) => {
            let names: Vec<&str> = unpacked.iter().map(|(name, _)| name.as_str()).collect();
            findings.add_whole(&NO_COORDINATES, names.join(", "));
            (Content::Cloud(CloudFile::default()), findings.finish())
        }
    }
}

/// The types of segments, where arrays `numbers` and `types` say so as in the project's own files: places in the order of
/// [`SurfaceType::ALL`].
fn kinds_of(arrays: &[(&str, Array<'_>)]) -> BTreeMap<u32, SurfaceType> {
    let named = |wanted: &str| {
        let found = arrays.iter().find(|(name, _)| *name == wanted);
        found
            .map(|(_, array)| array)
            .filter(|array| array.is_whole())
    };
    let (Some(numbers), Some(types)) = (named("numbers"), named("types")) else {
        return BTreeMap::new();
    };
    let both = numbers.count().min(types.count()).unwrap_or(0);
    let kinds = (0..both).filter_map(|row| {
        let (number, place) = (numbers.at(row, 0), types.at(row, 0));
        let known = is_label_value(number) && number >= 0.0 && place >= 0.0;
        let kind = SurfaceType::ALL.get(place as usize).filter(|_| known)?;
        Some((number as u32, *kind))
    });
    kinds.collect()
}

/// The types of segments, where an array of a network's tells the type of each point.
fn kinds_of_points(
    arrays: &[(&str, Array<'_>)],
    labels: &[i32],
    purpose: Purpose,
) -> BTreeMap<u32, SurfaceType> {
    let named = arrays.iter().filter_map(|(name, array)| {
        let is_one_a_row = array.squeezed() == [labels.len()] && array.names.len() == 1;
        let named = types::named(name).filter(|_| is_one_a_row)?;
        Some((named, array))
    });
    let best = named.min_by_key(|(named, _)| (named.whose != purpose, named.rank));
    let Some((named, array)) = best else {
        return BTreeMap::new();
    };
    let numbers: Vec<f64> = (0..labels.len()).map(|row| array.at(row, 0)).collect();
    let Some(coding) = named.coding_of(numbers.iter().copied()) else {
        return BTreeMap::new();
    };
    let types = types::of_labels(labels, &numbers, coding).into_iter();
    let known = types.filter_map(|(label, kind)| Some((u32::try_from(label).ok()?, kind?)));
    known.collect()
}

/// How well a name says that an array is of the labels wanted; the less the better.
fn rank(name: &str, purpose: Purpose) -> Option<usize> {
    const LABELS: [&str; 11] = [
        "labels",
        "label",
        "instances",
        "instance",
        "inst",
        "segments",
        "segment",
        "seg",
        "l",
        "i",
        "ids",
    ];
    let of_truth = name.ends_with("_gt") || name.starts_with("gt_") || name.ends_with("_true");
    let bare = name
        .trim_end_matches("_gt")
        .trim_end_matches("_true")
        .trim_end_matches("_pred")
        .trim_start_matches("gt_")
        .trim_start_matches("pred_");
    let place = LABELS.iter().position(|known| *known == bare)?;
    let wanted = of_truth == (purpose == Purpose::Truth);
    Some(place + if wanted { 0 } else { LABELS.len() })
}

fn refuse(findings: &mut Findings<'_>, name: &str, unread: Unread) {
    let of = |text: String| {
        if name.is_empty() {
            text
        } else {
            format!("{name}: {text}")
        }
    };
    match unread {
        Unread::Pickled => findings.add_whole(&PICKLED, name.to_owned()),
        Unread::Head(head) => findings.add_whole(&BAD_HEADER, of(head)),
        Unread::CutOff(what) => findings.add_whole(&CUT_OFF, of(what)),
    }
}

/// Rows and columns of an array that may hold points, and whether it lies on its side.
fn shape(array: &Array<'_>) -> Option<(usize, usize, bool)> {
    if array.names.len() > 1 {
        return Some((array.count()?, array.names.len(), false));
    }
    match array.squeezed()[..] {
        [columns @ 3..=16, rows] if rows > 16 => Some((rows, columns, true)),
        [rows, columns] => Some((rows, columns, false)),
        [columns] if columns >= 3 && array.shape.len() == 2 => Some((1, columns, false)),
        _ => None,
    }
}

fn cloud(
    mut findings: Findings<'_>,
    array: &Array<'_>,
    labels: Option<Vec<i32>>,
) -> (CloudFile, Vec<Diagnostic>) {
    let Some((rows, count, lying)) = shape(array).filter(|&(_, columns, _)| columns >= 3) else {
        findings.add_whole(
            &NO_COORDINATES,
            format!("an array of shape {:?}", array.shape),
        );
        return (CloudFile::default(), findings.finish());
    };
    let value = |row: usize, column: usize| {
        if lying {
            array.at(column, row)
        } else {
            array.at(row, column)
        }
    };
    let samples = rows.min(SAMPLES);
    let samples = (0..samples).map(|k| k * rows / samples);
    let samples = samples.map(|row| {
        (0..count.min(MOST_COLUMNS))
            .map(|at| value(row, at))
            .collect()
    });
    let Some(columns) = columns_of(array, samples.collect()) else {
        findings.add_whole(&NO_COORDINATES, String::new());
        return (CloudFile::default(), findings.finish());
    };
    let labelled = labels.is_some() || columns.label.is_some();
    let mut gather = Gather::new(findings, rows, labelled);
    gather.tell_columns(&columns);
    for row in 0..rows {
        if !gather.has_room() {
            break;
        }
        let label = match &labels {
            Some(labels) => labels.get(row).map(|&label| f64::from(label)),
            None => columns.label.map(|column| value(row, column)),
        };
        gather.push(columns.coordinates.map(|column| value(row, column)), label);
    }
    gather.finish()
}

/// What the columns of an array hold, by their names or by some of its rows.
fn columns_of(array: &Array<'_>, samples: Vec<Vec<f64>>) -> Option<Columns> {
    if array.names.len() > 1 {
        Columns::named(&array.names)
    } else {
        Some(Columns::guessed(&samples, false))
    }
}

/// Reads a long array of points, piece by piece; `None` where it is none whose rows lie one after another. Columns one
/// after another are held, and so are archives, whose arrays lie packed.
///
/// # Errors
/// Why the file cannot be had to its end.
pub(super) fn read_rows(
    findings: Findings<'_>,
    window: &mut Window<'_>,
) -> Result<Option<(CloudFile, Vec<Diagnostic>)>, String> {
    window.reach(LONGEST_HEAD)?;
    let Ok(array) = Array::head(window.bytes(), window.size()) else {
        return Ok(None);
    };
    let (Some((rows, count @ 3.., false)), Some(size)) = (shape(&array), array.row_size()) else {
        return Ok(None);
    };
    let many = rows.min(SAMPLES);
    let mut samples = Vec::with_capacity(many);
    for row in (0..many).map(|k| k * rows / many) {
        let place = (array.start() + row * size) as u64;
        let sample = window.look_at(place, |bytes, all| {
            let row = bytes.get(..size);
            let numbers = row.map(|row| {
                let columns = 0..count.min(MOST_COLUMNS);
                columns.map(|column| array.in_row(row, column)).collect()
            });
            numbers.or(all.then(Vec::new))
        })?;
        samples.extend(sample);
    }
    let Some(columns) = columns_of(&array, samples) else {
        return Ok(None);
    };
    let mut gather = Gather::new(findings, rows, columns.label.is_some());
    gather.tell_columns(&columns);
    let mut at = array.start();
    while gather.rows() < rows && gather.has_room() {
        let Some(row) = window.row(&mut at, size)? else {
            break;
        };
        let value = |column: usize| array.in_row(row, column);
        gather.push(columns.coordinates.map(value), columns.label.map(value));
    }
    Ok(Some(gather.finish()))
}

/// The labels that an array of one number a point is.
fn labels_of(array: &Array<'_>) -> Option<Vec<i32>> {
    let count = match array.squeezed()[..] {
        [count] if array.names.len() == 1 => count,
        _ => return None,
    };
    let values = (0..count).map(|row| array.at(row, 0));
    if !array.is_whole() && !values.clone().all(is_label_value) {
        return None;
    }
    let label = |value: f64| {
        if is_label_value(value) {
            value as i32
        } else {
            NO_LABEL
        }
    };
    Some(values.map(label).collect())
}
