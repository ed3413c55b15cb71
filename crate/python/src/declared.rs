//! What the engine declares, as the wasm boundary hands it to page and command line.

use fit4cad::export::Export;
use fit4cad::metrics::field::By;
use fit4cad::metrics::geometry::{Normalisation, Scale};
use fit4cad::metrics::{
    Better, DIFFERENCES, Figure, FigureGroup, Group, Measure, Protocol, Term, recognition,
};
use fit4cad::surface::{OTHER, SurfaceType};
use fit4cad::{fit, format, sample};
use fit4cad_step::{OptionValue, import_options};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use crate::dict::dict;

/// A list of what a table declares.
macro_rules! list {
    ($py:expr; $all:expr, |$one:ident| $dict:expr) => {{
        let list = PyList::empty($py);
        for $one in $all {
            list.append($dict)?;
        }
        list
    }};
}

/// A number that may be given: its name, unit, range, default and what it does.
macro_rules! number {
    ($py:expr; $info:expr) => {
        dict!($py;
            "name" => $info.name,
            "unit" => $info.unit,
            "minimum" => $info.minimum,
            "maximum" => $info.maximum,
            "default" => $info.default,
            "whole" => $info.whole,
            "explanation" => $info.explanation,
        )
    };
}

const fn better(better: Better) -> &'static str {
    match better {
        Better::Higher => "higher",
        Better::Lower => "lower",
    }
}

/// Measures, protocols, figures, types of surfaces, fitters with their parameters, parts, options and kinds of
/// files: lists of dictionaries by name.
#[pyfunction]
pub(crate) fn declarations(py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
    let parameters = list!(py; fit::Method::ALL, |method| {
        let heeded = fit::parameters::TABLE.iter();
        let heeded = heeded.filter(|info| info.methods.contains(&method));
        dict!(py;
            "name" => method.name(),
            "title" => method.title(),
            "fullName" => method.full_name(),
            "meaning" => method.meaning(),
            "parameters" => list!(py; heeded, |info| number!(py; info)),
        )
    });
    let scale = Scale::default();
    Ok(dict!(py;
        "measures" => measures(py)?,
        "protocols" => list!(py; Protocol::ALL, |protocol| dict!(py;
            "name" => protocol.name(),
            "rules" => protocol.rules(),
            "meaning" => protocol.meaning(),
        )),
        "protocolDifferences" => list!(py; DIFFERENCES, |each| dict!(py;
            "what" => each.what,
            "definition" => each.definition,
            "published" => each.published,
        )),
        "figures" => figures(py)?,
        "normalisations" => list!(py; Normalisation::ALL, |each| dict!(py;
            "name" => each.name(),
            "unit" => each.unit(),
            "meaning" => each.meaning(),
        )),
        "figureScale" => dict!(py;
            "normalisation" => scale.normalisation.name(),
            "epsilon" => scale.epsilon,
        ),
        "strata" => list!(py; By::ALL, |by| dict!(py;
            "name" => by.name(),
            "title" => by.title(),
            "how" => by.how(),
            "isCondition" => by.is_condition(),
            "strata" => by.strata(),
        )),
        "recognition" => dict!(py;
            "key" => recognition::INFO.key,
            "title" => recognition::INFO.title,
            "definition" => recognition::INFO.definition,
            "rewards" => recognition::INFO.rewards,
            "trap" => recognition::INFO.trap,
            "source" => recognition::INFO.source,
        ),
        "surfaceTypes" => list!(py; SurfaceType::ALL, |kind| dict!(py;
            "name" => kind.name(),
            "colour" => kind.colour(),
        )),
        "otherType" => OTHER,
        "fitters" => parameters,
        "stages" => list!(py; fit::Stage::ALL, |stage| dict!(py;
            "name" => stage.name(),
            "share" => stage.share(),
        )),
        "parts" => list!(py; sample::parts(), |part| dict!(py;
            "name" => part.name,
            "title" => part.title,
            "description" => part.description,
        )),
        "sampleOptions" => list!(py; sample::OPTIONS, |option| number!(py; option)),
        "wear" => list!(py; sample::WEAR, |option| number!(py; option)),
        "roles" => list!(py; format::Role::ALL, |role| dict!(py;
            "name" => role.name(),
            "meaning" => role.meaning(),
            "written" => role.is_written(),
        )),
        "fileKinds" => list!(py; format::FILE_KINDS, |kind| dict!(py;
            "endings" => kind.endings,
            "title" => kind.title,
            "meaning" => kind.meaning,
            "openedApart" => kind.is_opened_apart,
        )),
        "exports" => list!(py; Export::ALL, |export| dict!(py;
            "name" => export.name(),
            "ending" => export.ending(),
            "title" => export.title(),
            "meaning" => export.meaning(),
            "ofSurfaces" => export.is_of_surfaces(),
        )),
        "importOptions" => list!(py; import_options(), |option| dict!(py;
            "name" => option.name,
            "value" => kind_of_value(py, option.value)?,
            "unit" => option.unit,
            "default" => option.default,
            "explanation" => option.explanation,
        )),
        "limits" => dict!(py;
            "fileBytes" => format::limits::MAX_FILE_BYTES,
            "points" => format::limits::MAX_POINTS,
        ),
    ))
}

fn kind_of_value(py: Python<'_>, value: OptionValue) -> PyResult<Bound<'_, PyDict>> {
    Ok(match value {
        OptionValue::Number {
            minimum,
            maximum,
            whole,
        } => dict!(py;
            "kind" => "number",
            "minimum" => minimum,
            "maximum" => maximum,
            "whole" => whole,
        ),
        OptionValue::Choice { words } => dict!(py; "kind" => "choice", "words" => words),
        OptionValue::Flag => dict!(py; "kind" => "flag"),
    })
}

/// A part of a formula, as the wasm boundary hands it over.
fn term(py: Python<'_>, said: Term) -> PyResult<Bound<'_, PyDict>> {
    Ok(match said {
        Term::Word(text) => dict!(py; "kind" => "word", "text" => text),
        Term::Variable(text) => dict!(py; "kind" => "variable", "text" => text),
        Term::Number(number) => dict!(py; "kind" => "number", "text" => number.to_string()),
        Term::Operator(text) => dict!(py; "kind" => "operator", "text" => text),
        Term::Row(terms) => {
            dict!(py; "kind" => "row", "terms" => list!(py; terms, |each| term(py, each)?))
        }
        Term::Fraction(over, under) => {
            dict!(py; "kind" => "fraction", "over" => term(py, *over)?, "under" => term(py, *under)?)
        }
        Term::Sub(base, index) => {
            dict!(py; "kind" => "sub", "base" => term(py, *base)?, "index" => term(py, *index)?)
        }
        Term::Under(operator, range) => {
            dict!(py; "kind" => "under", "operator" => term(py, *operator)?, "range" => term(py, *range)?)
        }
    })
}

fn measures(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    Ok(list!(py; Measure::ALL, |measure| {
        let info = measure.info();
        dict!(py;
            "key" => info.key,
            "name" => info.name,
            "group" => match info.group {
                Group::Classification => "classification",
                Group::Accuracy => "accuracy",
            },
            "symbol" => term(py, info.symbol)?,
            "formula" => term(py, info.formula)?,
            "meaning" => info.meaning,
            "range" => info.range,
            "most" => info.most,
            "better" => better(info.better),
            "logarithmic" => info.logarithmic,
            "decimals" => info.decimals,
            "mean" => info.mean,
            "section" => info.section,
            "published" => info.published,
        )
    }))
}

fn figures(py: Python<'_>) -> PyResult<Bound<'_, PyList>> {
    Ok(list!(py; Figure::ALL, |figure| {
        let info = figure.info();
        dict!(py;
            "key" => info.key,
            "title" => info.title,
            "group" => match info.group {
                FigureGroup::Segmentation => "segmentation",
                FigureGroup::Fit => "fit",
            },
            "definition" => info.definition,
            "rewards" => info.rewards,
            "trap" => info.trap,
            "source" => info.source,
            "labels" => info.labels,
            "most" => info.most,
            "better" => better(info.better),
            "decimals" => info.decimals,
            "unit" => info.unit,
            "isNormalised" => info.is_normalised,
        )
    }))
}
