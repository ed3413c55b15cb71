//! What the engine declares, for every face to read: measures, protocols, types of surfaces, fitters,
//! parts and files. The page is built with it (`scripts/build.mjs` writes it out as modules), the
//! command line asks for it.

use fit4cad::export::Export;
use fit4cad::{fit, format, metrics, sample, surface};
use serde::Serialize;
use tsify::{Ts, Tsify};
use wasm_bindgen::JsError;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::export::ExportInfo;
use crate::field::FigureScale;
use crate::hand_over;
use crate::input::Role;
use crate::primitive::SurfaceType;
use crate::recognition::RecognitionInfo;
use crate::report::Protocol;
use crate::strata::StrataInfo;

/// A part of a formula.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Tsify)]
#[serde(tag = "kind", rename_all = "lowercase")]
#[allow(missing_docs, reason = "each is said in `fit4cad::metrics::Term`")]
pub enum Term {
    /// A name of several letters, upright.
    Word { text: String },
    /// A variable, in italics.
    Variable { text: &'static str },
    /// A number.
    Number { text: String },
    /// An operator, a bracket or a comma.
    Operator { text: &'static str },
    /// Terms after one another.
    Row { terms: Vec<Term> },
    /// One over another.
    Fraction { over: Box<Term>, under: Box<Term> },
    /// One with an index.
    Sub { base: Box<Term>, index: Box<Term> },
    /// An operator, and what it runs over below it.
    Under {
        operator: Box<Term>,
        range: Box<Term>,
    },
}

impl From<metrics::Term> for Term {
    fn from(term: metrics::Term) -> Self {
        let boxed = |term: Box<metrics::Term>| Box::new(Self::from(*term));
        match term {
            metrics::Term::Word(text) => Self::Word { text },
            metrics::Term::Variable(text) => Self::Variable { text },
            metrics::Term::Number(number) => Self::Number {
                text: number.to_string(),
            },
            metrics::Term::Operator(text) => Self::Operator { text },
            metrics::Term::Row(terms) => Self::Row {
                terms: terms.into_iter().map(Self::from).collect(),
            },
            metrics::Term::Fraction(over, under) => Self::Fraction {
                over: boxed(over),
                under: boxed(under),
            },
            metrics::Term::Sub(base, index) => Self::Sub {
                base: boxed(base),
                index: boxed(index),
            },
            metrics::Term::Under(operator, range) => Self::Under {
                operator: boxed(operator),
                range: boxed(range),
            },
        }
    }
}

/// Which values of a measure are good.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum Better {
    /// The higher the better.
    Higher,
    /// The lower the better.
    Lower,
}

/// What a measure looks at.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum Group {
    /// Which points a true primitive and its match have.
    Classification,
    /// How the surface of a predicted primitive fits.
    Accuracy,
}

/// What every face needs to show a measure.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[tsify(missing_as_null)]
pub struct MeasureInfo {
    /// The paper's abbreviation: head of columns and name in reports.
    #[tsify(type = "Measure")]
    pub key: &'static str,
    /// Its name in full.
    pub name: &'static str,
    /// What it looks at.
    pub group: Group,
    /// How it is written in formulas.
    pub symbol: Term,
    /// What it is equal to.
    pub formula: Term,
    /// What it tells.
    pub meaning: &'static str,
    /// The values it can have, in words.
    pub range: String,
    /// The largest of them; `null` where there is none. The smallest is 0.
    pub most: Option<f64>,
    /// Which values are good.
    pub better: Better,
    /// Whether its values lie orders of magnitude apart.
    pub logarithmic: bool,
    /// Digits after the point that tell something.
    pub decimals: u8,
    /// What its mean runs over.
    pub mean: &'static str,
    /// Where the paper defines it.
    pub section: &'static str,
    /// What the published protocol changes about it; empty where nothing.
    pub published: String,
}

impl From<metrics::Measure> for MeasureInfo {
    fn from(measure: metrics::Measure) -> Self {
        let info = measure.info();
        Self {
            key: info.key,
            name: info.name,
            group: match info.group {
                metrics::Group::Classification => Group::Classification,
                metrics::Group::Accuracy => Group::Accuracy,
            },
            symbol: info.symbol.into(),
            formula: info.formula.into(),
            meaning: info.meaning,
            range: info.range,
            most: info.most,
            better: info.better.into(),
            logarithmic: info.logarithmic,
            decimals: info.decimals,
            mean: info.mean,
            section: info.section,
            published: info.published,
        }
    }
}

/// What a figure of the field is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "lowercase")]
pub enum FigureGroup {
    /// Which points belong together: a score of the segmentation by a protocol.
    Segmentation,
    /// How the predicted surfaces reproduce the true ones.
    Fit,
}

/// What is to be known about a figure that the field reports.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
#[tsify(missing_as_null)]
pub struct FigureInfo {
    /// Name by which it is asked for.
    #[tsify(type = "Figure")]
    pub key: &'static str,
    /// Head of its column.
    pub title: &'static str,
    /// What it is about.
    pub group: FigureGroup,
    /// What is computed.
    pub definition: &'static str,
    /// In one sentence, what kind of answer it rewards.
    pub rewards: &'static str,
    /// What one has to know before comparing.
    pub trap: &'static str,
    /// Where the rules are read off.
    pub source: &'static str,
    /// What it takes for the label of a point.
    pub labels: &'static str,
    /// The largest value; `null` where there is none. The smallest is 0.
    pub most: Option<f64>,
    /// Which values are good.
    pub better: Better,
    /// Digits after the point that tell something.
    pub decimals: u8,
    /// Unit of its values: empty of shares, `°` of angles.
    pub unit: &'static str,
    /// Whether its values, or its ε, are lengths in units of the normalisation.
    pub is_normalised: bool,
}

impl From<metrics::Better> for Better {
    fn from(better: metrics::Better) -> Self {
        match better {
            metrics::Better::Higher => Self::Higher,
            metrics::Better::Lower => Self::Lower,
        }
    }
}

impl From<metrics::Figure> for FigureInfo {
    fn from(figure: metrics::Figure) -> Self {
        let info = figure.info();
        Self {
            key: info.key,
            title: info.title,
            group: match info.group {
                metrics::FigureGroup::Segmentation => FigureGroup::Segmentation,
                metrics::FigureGroup::Fit => FigureGroup::Fit,
            },
            definition: info.definition,
            rewards: info.rewards,
            trap: info.trap,
            source: info.source,
            labels: info.labels,
            most: info.most,
            better: info.better.into(),
            decimals: info.decimals,
            unit: info.unit,
            is_normalised: info.is_normalised,
        }
    }
}

/// What lengths can be divided by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
pub struct NormalisationInfo {
    /// Name by which it is asked for.
    pub name: &'static str,
    /// What a length is given in, for the head of a column.
    pub unit: &'static str,
    /// What it divides by and who does so.
    pub meaning: &'static str,
}

/// A protocol in words.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
pub struct ProtocolInfo {
    /// Name by which it is asked for.
    pub name: Protocol,
    /// How scores by it come about, to go on a sentence.
    pub rules: &'static str,
    /// What it does and what it is for.
    pub meaning: &'static str,
}

/// A point in which the protocols differ, or are held to differ.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
pub struct ProtocolDifference {
    /// What it is about.
    pub what: &'static str,
    /// How it is by definition.
    pub definition: &'static str,
    /// How it is as published.
    pub published: &'static str,
}

/// A type of surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
pub struct SurfaceTypeInfo {
    /// The name used in the files.
    pub name: SurfaceType,
    /// Place of its colour among those of segments, from 0.
    pub colour: u8,
}

/// What is to be known about one number that can be set.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct ParameterInfo {
    /// Name by which it is set.
    pub name: &'static str,
    /// Unit; empty for a plain number.
    pub unit: &'static str,
    /// Smallest value allowed.
    pub minimum: f64,
    /// Largest value allowed.
    pub maximum: f64,
    /// Value when nothing is said.
    pub default: f64,
    /// Whether only whole numbers make sense.
    pub whole: bool,
    /// What it does.
    pub explanation: &'static str,
}

/// A method that finds primitives.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct FitterInfo {
    /// Name by which it is asked for.
    #[tsify(type = "FitMethod")]
    pub name: &'static str,
    /// The paper's abbreviation: what its submissions are called.
    pub title: &'static str,
    /// Its name in full.
    pub full_name: &'static str,
    /// How it finds surfaces.
    pub meaning: &'static str,
    /// The parameters that it heeds, in the order to show them.
    pub parameters: Vec<ParameterInfo>,
}

impl From<fit::Method> for FitterInfo {
    fn from(method: fit::Method) -> Self {
        let table = fit::parameters::TABLE.iter();
        let heeded = table.filter(|info| info.methods.contains(&method));
        Self {
            name: method.name(),
            title: method.title(),
            full_name: method.full_name(),
            meaning: method.meaning(),
            parameters: heeded
                .map(|info| ParameterInfo {
                    name: info.name,
                    unit: info.unit,
                    minimum: info.minimum,
                    maximum: info.maximum,
                    default: info.default,
                    whole: info.whole,
                    explanation: info.explanation,
                })
                .collect(),
        }
    }
}

/// A stage of a fit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Tsify)]
pub struct StageInfo {
    /// The word by which progress names it.
    pub name: &'static str,
    /// What share of a fit's time it takes, roughly.
    pub share: f64,
}

/// A part that can be generated.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
pub struct PartInfo {
    /// Name by which it is asked for.
    pub name: &'static str,
    /// Name to be shown.
    pub title: &'static str,
    /// What it is and what is hard about it.
    pub description: &'static str,
}

/// A shape that blocks of a part can have.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
pub struct ShapeInfo {
    /// Name by which it is asked for.
    pub name: &'static str,
    /// Name to be shown.
    pub title: &'static str,
    /// Names of its sizes in order.
    pub sizes: Vec<&'static str>,
    /// A value to begin with for each size.
    pub defaults: Vec<f64>,
}

/// What a file of a model can hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
pub struct RoleInfo {
    /// The word for it in the names of files and folders; files of clouds go without.
    pub name: Role,
    /// What such a file holds.
    pub meaning: &'static str,
    /// Whether models are written in such files.
    pub written: bool,
}

/// A kind of file that can be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct FileKindInfo {
    /// Endings of its names, in lower case, without the dot.
    #[tsify(type = "readonly string[]")]
    pub endings: &'static [&'static str],
    /// What it is called.
    pub title: &'static str,
    /// What is read from it.
    pub meaning: &'static str,
    /// Whether a module of its own opens them, and hands on what is in them as files of other kinds.
    pub opened_apart: bool,
}

/// What the engine declares.
#[derive(Debug, Clone, PartialEq, Serialize, Tsify)]
#[serde(rename_all = "camelCase")]
pub struct Declarations {
    /// The measures, in the order of the paper's tables.
    pub measures: Vec<MeasureInfo>,
    /// The protocols, that of the definition first.
    pub protocols: Vec<ProtocolInfo>,
    /// How they differ.
    pub protocol_differences: Vec<ProtocolDifference>,
    /// The figures that the rest of the field reports, scores of the segmentation first.
    pub figures: Vec<FigureInfo>,
    /// What their lengths can be divided by.
    pub normalisations: Vec<NormalisationInfo>,
    /// What is taken for both where nothing is said.
    pub figure_scale: FigureScale,
    /// What true primitives are told apart by: first what a primitive has itself, then the conditions of
    /// its model.
    pub strata: Vec<StrataInfo>,
    /// SHREC 2022's tables of segments.
    pub recognition: RecognitionInfo,
    /// The types of surfaces, simplest first.
    pub surface_types: Vec<SurfaceTypeInfo>,
    /// What stands in the place of a type for a primitive of none of them.
    #[tsify(type = "Exclude<keyof Types, SurfaceType>")]
    pub other_type: &'static str,
    /// The methods that find primitives.
    pub fitters: Vec<FitterInfo>,
    /// The stages of a fit, in order.
    pub stages: Vec<StageInfo>,
    /// The parts that can be generated.
    pub parts: Vec<PartInfo>,
    /// How a part becomes a cloud.
    #[tsify(type = "(ParameterInfo & { name: keyof SampleOptions })[]")]
    pub sample_options: Vec<ParameterInfo>,
    /// What can be done to the points of any model, beside the seed.
    #[tsify(type = "(ParameterInfo & { name: Exclude<keyof Wear, \"seed\"> })[]")]
    pub wear: Vec<ParameterInfo>,
    /// The shapes that blocks of a part can have.
    pub shapes: Vec<ShapeInfo>,
    /// The files of a model.
    pub roles: Vec<RoleInfo>,
    /// The kinds of files that can be read.
    pub file_kinds: Vec<FileKindInfo>,
    /// The forms that a segmentation can be written in.
    pub exports: Vec<ExportInfo>,
}

/// What the engine declares.
///
/// # Errors
/// None in practice: plain values always cross.
#[wasm_bindgen]
pub fn declarations() -> Result<Ts<Declarations>, JsError> {
    let protocols = metrics::Protocol::ALL.map(|protocol| ProtocolInfo {
        name: protocol.into(),
        rules: protocol.rules(),
        meaning: protocol.meaning(),
    });
    let differences = metrics::DIFFERENCES.iter();
    let differences = differences.map(|difference| ProtocolDifference {
        what: difference.what,
        definition: difference.definition,
        published: difference.published,
    });
    let normalisations = metrics::geometry::Normalisation::ALL.map(|each| NormalisationInfo {
        name: each.name(),
        unit: each.unit(),
        meaning: each.meaning(),
    });
    let surface_types = surface::SurfaceType::ALL.map(|kind| SurfaceTypeInfo {
        name: kind.into(),
        colour: kind.colour(),
    });
    let stages = fit::Stage::ALL.map(|stage| StageInfo {
        name: stage.name(),
        share: stage.share(),
    });
    let parts = sample::parts().iter().map(|part| PartInfo {
        name: part.name,
        title: part.title,
        description: part.description,
    });
    let option = |option: &sample::OptionInfo| ParameterInfo {
        name: option.name,
        unit: option.unit,
        minimum: option.minimum,
        maximum: option.maximum,
        default: option.default,
        whole: option.whole,
        explanation: option.explanation,
    };
    let shapes = sample::SHAPES.map(|shape| {
        let (sizes, defaults) = shape.sizes.iter().copied().unzip();
        ShapeInfo {
            name: shape.name,
            title: shape.title,
            sizes,
            defaults,
        }
    });
    let roles = format::Role::ALL.map(|role| RoleInfo {
        name: role.into(),
        meaning: role.meaning(),
        written: role.is_written(),
    });
    let file_kinds = format::FILE_KINDS.map(|kind| FileKindInfo {
        endings: kind.endings,
        title: kind.title,
        meaning: kind.meaning,
        opened_apart: kind.is_opened_apart,
    });
    hand_over(&Declarations {
        measures: metrics::Measure::ALL.map(MeasureInfo::from).to_vec(),
        protocols: protocols.to_vec(),
        protocol_differences: differences.collect(),
        figures: metrics::Figure::ALL.map(FigureInfo::from).to_vec(),
        normalisations: normalisations.to_vec(),
        figure_scale: metrics::geometry::Scale::default().into(),
        strata: metrics::field::By::ALL.map(StrataInfo::from).to_vec(),
        recognition: metrics::recognition::INFO.into(),
        surface_types: surface_types.to_vec(),
        other_type: surface::OTHER,
        fitters: fit::Method::ALL.map(FitterInfo::from).to_vec(),
        stages: stages.to_vec(),
        parts: parts.collect(),
        sample_options: sample::OPTIONS.map(option).to_vec(),
        wear: sample::WEAR.map(option).to_vec(),
        shapes: shapes.to_vec(),
        roles: roles.to_vec(),
        file_kinds: file_kinds.to_vec(),
        exports: Export::ALL.map(ExportInfo::from).to_vec(),
    })
}
