//! The arrays of one group: which are points, labels and types, of one model or of many.

use fit4cad::export::Arrays;
use fit4cad::format::foreign::Purpose;
use fit4cad::format::types::{self, Told};
use hdf5_reader::error::Error;
use hdf5_reader::{Dataset, SliceInfo, SliceInfoElem};

use crate::names::{is_found, rank_of_labels, rank_of_points};
use crate::number::{Number, is_numeric, is_single, is_whole};

/// Most numbers to a point: coordinates, normals, colours and the like.
const MOST_COLUMNS: u64 = 16;

/// Most segments that each point may have a share of.
const MOST_SHARES: u64 = 4096;

/// Largest label: there are at most as many as points.
const LARGEST_LABEL: f64 = fit4cad::format::limits::MAX_POINTS as f64;

/// The arrays of a group that mean something, all of the same models and rows.
pub(crate) struct Contents {
    points: Option<Dataset>,
    truth: Option<Labels>,
    prediction: Option<Labels>,
    /// How many models the arrays are of, along their first axis; `None` where they have no such axis.
    pub(crate) models: Option<u64>,
    /// Rows of each model.
    pub(crate) rows: u64,
    /// Whether there are points with noise beside those that are read.
    pub(crate) has_noisy: bool,
}

/// Labels, and the types that go with them.
struct Labels {
    values: Dataset,
    types: Option<(Dataset, types::Named)>,
}

/// One thing that a model has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    /// Its points, with the labels of the truth where there are some.
    Cloud,
    /// Labels alone: of a prediction where there are some, else of the truth.
    Labels,
}

impl Contents {
    /// Looks through arrays; `None` where there are neither points nor labels.
    pub(crate) fn of(arrays: Vec<Dataset>) -> Option<Self> {
        let arrays: Vec<Dataset> = arrays
            .into_iter()
            .filter(|array| is_numeric(array.dtype()))
            .collect();
        let best = |rank: &dyn Fn(&Dataset) -> Option<usize>| {
            let ranked = arrays
                .iter()
                .filter_map(|array| Some((rank(array)?, array)));
            ranked
                .min_by_key(|(rank, _)| *rank)
                .map(|(_, array)| array.clone())
        };
        let points = best(&|array| {
            shape_of_points(array.shape())?;
            rank_of_points(array.name())
        });
        let labels = |whose: Purpose| {
            best(&|array| {
                let name = array.name();
                let (of, rank) = rank_of_labels(name, points.is_some())?;
                (of == whose).then_some(rank)
            })
        };
        let (mut truth, mut prediction) = (labels(Purpose::Truth), labels(Purpose::Submission));
        // Of labels that may be either, those beside others of the truth are predicted.
        if points.is_some()
            && prediction.is_none()
            && truth.as_ref().is_some_and(|it| !is_found(it.name()))
        {
            prediction = best(&|array| is_found(array.name()).then_some(0));
        }
        let first = points.as_ref().map(|it| shape_of_points(it.shape()));
        let (models, rows) = match first {
            Some(shape) => shape?,
            None => shape_of_labels(truth.as_ref().or(prediction.as_ref())?)?,
        };
        let fits = |array: &Dataset| column_of(array.shape(), models, rows).is_some();
        truth = truth.filter(fits);
        prediction = prediction.filter(fits);
        let types = |whose: Purpose| {
            let named = arrays.iter().filter_map(|array| {
                let named = types::named(array.name())?;
                (named.whose == whose).then_some((named, array))
            });
            let first = named.min_by_key(|(named, _)| named.rank);
            first.map(|(named, array)| (array.clone(), named))
        };
        let is_only = prediction.is_none();
        let with_types = |values: Dataset, whose: Purpose| {
            // What is named as a prediction's goes with the only labels that there are.
            let other = || types(Purpose::Submission).filter(|_| is_only);
            let types = types(whose).or_else(other);
            Labels { values, types }
        };
        let truth = truth.map(|values| with_types(values, Purpose::Truth));
        let prediction = prediction.map(|values| with_types(values, Purpose::Submission));
        let has_noisy = points.as_ref().is_some_and(|points| {
            let noisy = |array: &Dataset| array.name().eq_ignore_ascii_case("noisy_points");
            !noisy(points) && arrays.iter().any(noisy)
        });
        (points.is_some() || truth.is_some() || prediction.is_some()).then_some(Self {
            points,
            truth,
            prediction,
            models,
            rows,
            has_noisy,
        })
    }

    /// What each model has.
    pub(crate) fn parts(&self) -> Vec<Part> {
        let has_cloud = self.points.is_some();
        let has_labels = self.prediction.is_some() || !has_cloud;
        let parts = [(Part::Cloud, has_cloud), (Part::Labels, has_labels)];
        parts.into_iter().filter(|it| it.1).map(|it| it.0).collect()
    }

    /// Bytes that a part takes as it is written, but for what does not grow with the points.
    pub(crate) fn size(&self, part: Part) -> u64 {
        let single = self.points.as_ref().is_some_and(|it| is_single(it.dtype()));
        let point = if single { 12 } else { 24 };
        let row = match part {
            Part::Cloud => point + if self.truth.is_some() { 4 } else { 0 },
            Part::Labels => 4,
        };
        self.rows.saturating_mul(row)
    }

    /// A part of the model at a place.
    pub(crate) fn read(&self, part: Part, model: u64) -> Result<Arrays, Error> {
        let model = self.models.map(|_| model);
        let mut arrays = Arrays::default();
        let labels = match part {
            Part::Cloud => {
                if let Some(points) = &self.points {
                    let selection = selection(points.shape().len(), model, Some(3));
                    let values = points.read_slice::<Number>(&selection)?;
                    arrays.points = values.iter().map(|value| value.0).collect();
                    arrays.single = is_single(points.dtype());
                }
                self.truth.as_ref()
            }
            Part::Labels => self.prediction.as_ref().or(self.truth.as_ref()),
        };
        let Some(labels) = labels else {
            return Ok(arrays);
        };
        let rows = usize::try_from(self.rows).unwrap_or(usize::MAX);
        let values = column(&labels.values, model)?;
        arrays.labels = chosen(&values, rows).map(label).collect();
        arrays.types = match &labels.types {
            Some((types, named)) => typed(&arrays.labels, &column(types, model)?, named),
            None => Vec::new(),
        };
        Ok(arrays)
    }
}

/// Models and rows of an array of points.
fn shape_of_points(shape: &[u64]) -> Option<(Option<u64>, u64)> {
    match *shape {
        [rows, columns] if (3..=MOST_COLUMNS).contains(&columns) => Some((None, rows)),
        [models, rows, columns] if (3..=MOST_COLUMNS).contains(&columns) => {
            Some((Some(models), rows))
        }
        _ => None,
    }
}

/// Models and rows of labels without points.
fn shape_of_labels(array: &Dataset) -> Option<(Option<u64>, u64)> {
    match *array.shape() {
        [rows] | [rows, 1] => Some((None, rows)),
        // Shares of the segments in each point are fractions, and the segments fewer than the points.
        [rows, shares] if !is_whole(array.dtype()) && shares < rows => Some((None, rows)),
        [models, rows] | [models, rows, 1..=MOST_SHARES] => Some((Some(models), rows)),
        _ => None,
    }
}

/// Numbers to each row of an array of one number, or one share of each segment, a row; `None` where it is none.
fn column_of(shape: &[u64], models: Option<u64>, rows: u64) -> Option<u64> {
    let shape = match (models, shape) {
        (Some(models), [first, rest @ ..]) if *first == models => rest,
        (Some(_), _) => return None,
        (None, shape) => shape,
    };
    match *shape {
        [found] if found == rows => Some(1),
        [found, columns @ 1..=MOST_SHARES] if found == rows => Some(columns),
        _ => None,
    }
}

/// All of a model, or so many columns of it.
fn selection(axes: usize, model: Option<u64>, columns: Option<u64>) -> SliceInfo {
    let mut selection = SliceInfo::all(axes);
    if let (Some(model), Some(first)) = (model, selection.selections.first_mut()) {
        *first = SliceInfoElem::Index(model);
    }
    if let (Some(end), Some(last)) = (columns, selection.selections.last_mut()) {
        *last = SliceInfoElem::Slice {
            start: 0,
            end,
            step: 1,
        };
    }
    selection
}

fn column(array: &Dataset, model: Option<u64>) -> Result<Vec<f64>, Error> {
    let selection = selection(array.shape().len(), model, None);
    let values = array.read_slice::<Number>(&selection)?;
    Ok(values.iter().map(|value| value.0).collect())
}

/// The number of each row; of rows of shares the place of the largest.
fn chosen(values: &[f64], rows: usize) -> impl Iterator<Item = f64> + '_ {
    let shares = (values.len() / rows.max(1)).max(1);
    values.chunks_exact(shares).map(move |row| {
        let largest = row.iter().enumerate().max_by(|a, b| a.1.total_cmp(b.1));
        match (row, largest) {
            ([value], _) => *value,
            (_, Some((place, _))) => place as f64,
            (_, None) => -1.0,
        }
    })
}

fn label(value: f64) -> i32 {
    let is_label = value.fract() == 0.0 && (0.0..=LARGEST_LABEL).contains(&value);
    if is_label { value as i32 } else { -1 }
}

/// The type of each label: what most of its points are, or where there is one for each label, that.
fn typed(labels: &[i32], numbers: &[f64], named: &types::Named) -> Vec<(i32, Told)> {
    let rows = labels.len();
    let by_point: Vec<f64> = if numbers.len() >= rows && rows > 0 {
        chosen(numbers, rows).collect()
    } else {
        let of_label = |&label: &i32| {
            let place = usize::try_from(label).ok();
            place.and_then(|place| numbers.get(place).copied())
        };
        labels
            .iter()
            .map(|label| of_label(label).unwrap_or(-1.0))
            .collect()
    };
    let Some(coding) = named.coding_of(by_point.iter().copied()) else {
        return Vec::new();
    };
    types::of_labels(labels, &by_point, coding)
}
