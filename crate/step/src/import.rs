//! From a document to a model of the benchmark.

use std::collections::BTreeSet;

use fit4cad::cloud::{Cloud, Point};
use fit4cad::model::{Model, Primitive, Segmentation};
use fit4cad::random::Random;
use fit4cad::sample::MAX_POINTS;
use fit4cad::surface::Surface;

use crate::document::{BodyFace, Document, Progress, Ready};
use crate::error::StepError;
use crate::join::join;
use crate::options::{Amount, Options, SHARES, Spread};
use crate::placement::Motion;
use crate::report::{BodyReport, FaceReport, LEFT_OUT, Report};
use crate::sampling::{FILLING, Patch, spread};
use crate::sight::Sight;

/// Edges farther from their surface than this share of the diagonal are worth a word.
const FAR_OFF: f64 = 1e-4;

/// A part as a model, and what became of its faces.
#[derive(Debug, Clone, PartialEq)]
pub struct Import {
    /// Cloud and truth.
    pub model: Model,
    /// What became of each face.
    pub report: Report,
}

/// A face of an instance.
struct Item<'a> {
    face: &'a BodyFace,
    body: &'a str,
    instance: usize,
    motion: Motion,
    /// Whether it is left out because nothing outside sees it.
    inner: bool,
}

/// The faces that can be used, with what that needs.
fn usable<'a>(items: &'a [Item<'a>]) -> Vec<(&'a Item<'a>, &'a Ready)> {
    let outer = items.iter().filter(|item| !item.inner);
    outer
        .filter_map(|item| Some((item, item.face.ready.as_ref().ok()?)))
        .collect()
}

fn patches<'a>(usable: &[(&'a Item<'a>, &'a Ready)]) -> Vec<Patch<'a>> {
    let patch = |(item, ready): &(&'a Item<'a>, &'a Ready)| Patch {
        face: &ready.trimmed,
        motion: item.motion,
    };
    usable.iter().map(patch).collect()
}

/// For each face whether nothing outside sees it. O(faces · viewpoints).
fn inner(items: &[Item<'_>], seed: u64) -> Vec<bool> {
    let usable = usable(items);
    let patches = patches(&usable);
    let mut random = Random::new(seed, 4);
    let sight = Sight::new(&patches, Options::MOST_VIEWS, &mut random);
    let mut hidden = sight.hidden(&mut random).into_iter();
    let of = |item: &Item<'_>| item.face.ready.is_ok() && hidden.next().unwrap_or(false);
    items.iter().map(of).collect()
}

impl Document {
    /// Makes a model of the part: points in millimetres that lie exactly on the faces, and the truth.
    /// One document and the same options give one model, everywhere.
    ///
    /// # Errors
    /// [`StepError`] where an option is out of its range, there would be too many points, or no face
    /// can be used.
    pub fn sample(
        &self,
        name: &str,
        options: &Options,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<Import, StepError> {
        options.check()?;
        let mut items = self.items();
        if !options.inner {
            progress(Progress {
                stage: "looking for inner faces",
                share: 0.0,
            });
            let inner = inner(&items, options.seed);
            for (item, inner) in items.iter_mut().zip(inner) {
                item.inner = inner;
            }
        }
        let usable = usable(&items);
        let patches = patches(&usable);
        let area: f64 = patches.iter().map(Patch::area).sum();
        if area <= 0.0 {
            return Err(StepError::NothingUsable {
                count: items.len(),
                reason: self.first_trouble(&items),
            });
        }
        let mut random = Random::new(options.seed, 3);
        let sight = (options.spread == Spread::Scan)
            .then(|| Sight::new(&patches, options.views, &mut random));
        let seen = sight.as_ref().map_or(1.0, |it| it.share(&mut random));
        let (count, spacing) = self.amount(options, if seen > 0.0 { seen * area } else { area })?;
        let mut spreading = |share| {
            progress(Progress {
                stage: "spreading points",
                share,
            });
        };
        spreading(0.0);
        let points = match sight {
            Some(_) if seen == 0.0 => Vec::new(),
            Some(sight) => sight.scan(count, &mut random, &mut spreading),
            None => spread(
                &patches,
                count,
                options.least,
                options.spread == Spread::Even,
                options.seed,
                &mut spreading,
            ),
        };
        if points.is_empty() {
            return Err(StepError::NothingUsable {
                count: items.len(),
                reason: "no place of it is seen or could be drawn".to_owned(),
            });
        }
        let groups = self.groups(&usable, options);
        let (model, numbers, counts) = model(name, &points, &groups);
        let report = self.report(&items, &groups, &numbers, &counts, area, spacing, options);
        progress(Progress {
            stage: "spreading points",
            share: 1.0,
        });
        Ok(Import { model, report })
    }

    fn items(&self) -> Vec<Item<'_>> {
        let instances = self.placed.iter().zip(1..);
        instances
            .flat_map(|((body, motion), instance)| {
                let body = &self.bodies[*body];
                body.faces.iter().map(move |face| Item {
                    face,
                    body: &body.name,
                    instance,
                    motion: *motion,
                    inner: false,
                })
            })
            .collect()
    }

    fn first_trouble(&self, items: &[Item<'_>]) -> String {
        let troubles = items
            .iter()
            .filter_map(|item| item.face.ready.as_ref().err());
        let mut texts = troubles.chain(&self.left_out).map(ToString::to_string);
        texts
            .next()
            .unwrap_or_else(|| "they have no area".to_owned())
    }

    /// How many points, and about how far apart.
    fn amount(&self, options: &Options, area: f64) -> Result<(usize, f64), StepError> {
        let spacing = match options.amount {
            Amount::Points(count) => return Ok((count, (FILLING * area / count as f64).sqrt())),
            Amount::Spacing(spacing) => spacing,
            Amount::Share(share) => share * self.diagonal,
        };
        let count = (FILLING * area / (spacing * spacing)).round();
        if count > MAX_POINTS as f64 || count < 10.0 {
            let [least, most] = SHARES.map(|share| share * self.diagonal);
            let finest = (FILLING * area / MAX_POINTS as f64).sqrt();
            return Err(StepError::OutOfRange {
                what: "spacing",
                expected: format!(
                    "about {:.3} to {most:.3} mm for this part",
                    least.max(finest)
                ),
                found: format!("{spacing} mm"),
            });
        }
        Ok((count as usize, spacing))
    }

    /// For each usable face the surface of its primitive, and which faces make one.
    fn groups(&self, usable: &[(&Item<'_>, &Ready)], options: &Options) -> Groups {
        let surfaces: Vec<Option<Surface>> = usable
            .iter()
            .map(|(item, ready)| {
                let shape = &ready.trimmed.chart.shape;
                let recognised = ready.recognised.as_ref().filter(|_| options.recognise);
                let own = is_named(&item.face.surface) || options.recognise;
                let own = own.then(|| shape.surface(&item.motion)).flatten();
                own.or_else(|| recognised?.surface(&item.motion))
                    .filter(Surface::is_in_range)
            })
            .collect();
        let edges: Vec<(usize, &[u64])> = usable
            .iter()
            .map(|(item, ready)| (item.instance, &ready.edges[..]))
            .collect();
        let group = if options.join {
            join(&surfaces, &edges, self.diagonal)
        } else {
            (0..usable.len()).collect()
        };
        Groups { surfaces, group }
    }

    #[expect(clippy::too_many_arguments, reason = "all that sampling has found out")]
    fn report(
        &self,
        items: &[Item<'_>],
        groups: &Groups,
        numbers: &[Option<u32>],
        counts: &[usize],
        area: f64,
        spacing: f64,
        options: &Options,
    ) -> Report {
        let mut faces = Vec::with_capacity(items.len());
        let mut usable = 0;
        let (mut thin, mut hidden) = (0, 0);
        for item in items {
            let mut report = FaceReport {
                face: item.face.id,
                body: item.body.to_owned(),
                instance: item.instance,
                surface: item.face.surface.clone(),
                ..FaceReport::default()
            };
            match &item.face.ready {
                Err(trouble) => report.remark = format!("{LEFT_OUT}{trouble}"),
                Ok(_) if item.inner => {
                    report.remark = "no points: nothing outside sees it".to_owned();
                }
                Ok(ready) => {
                    let scale = item.motion.scale();
                    report.area = ready.trimmed.area * scale * scale;
                    report.points = counts[usable];
                    report.kind = groups.surfaces[usable].map(|surface| surface.kind());
                    report.recognised = report.kind.is_some() && !is_named(&item.face.surface);
                    report.primitive = numbers[groups.group[usable]];
                    report.remark = self.remark(ready, report.points, options.spread);
                    hidden += usize::from(report.points == 0);
                    let expected = report.area * FILLING / (spacing * spacing);
                    thin += usize::from(expected < options.least.max(1) as f64);
                    usable += 1;
                }
            }
            faces.push(report);
        }
        let mut warnings = self.notes.clone();
        if options.spread == Spread::Scan {
            if hidden > 0 {
                warnings.push(format!(
                    "{hidden} of {} faces have no points: they are hidden from every viewpoint, or too small to be met",
                    items.len()
                ));
            }
        } else if thin > 0 {
            warnings.push(format!(
                "{thin} of {} faces are smaller than the spacing has points for: they have {} each, nearer to one another. A finer spacing shows them",
                items.len(),
                options.least
            ));
        }
        let placed: BTreeSet<usize> = self.placed.iter().map(|(body, _)| *body).collect();
        Report {
            system: self.system.clone(),
            schema: self.schema.clone(),
            bodies: placed.len(),
            choice: self.choice(&placed),
            instances: self.placed.len(),
            diagonal: self.diagonal,
            area,
            spacing,
            faces,
            left_out: self.left_out.iter().map(ToString::to_string).collect(),
            warnings,
        }
    }

    fn choice(&self, placed: &BTreeSet<usize>) -> Vec<BodyReport> {
        let bodies = self.bodies.iter().enumerate();
        let choice = bodies.map(|(at, body)| BodyReport {
            name: body.name.clone(),
            faces: body.faces.len(),
            kept: placed.contains(&at),
        });
        choice.collect()
    }

    fn remark(&self, ready: &Ready, points: usize, spread: Spread) -> String {
        let face = &ready.trimmed;
        let far = FAR_OFF * self.diagonal;
        if points == 0 && spread == Spread::Scan {
            "no points: no viewpoint sees it".to_owned()
        } else if points == 0 {
            "no points: its area is next to nothing".to_owned()
        } else if face.gap > far {
            format!("its edges leave a gap of {:.4} mm", face.gap)
        } else if face.off_surface > far {
            format!(
                "its edges lie up to {:.4} mm off its surface",
                face.off_surface
            )
        } else if face.agreement < 0.9 {
            "its bounds contradict one another on which side is inside".to_owned()
        } else {
            String::new()
        }
    }
}

/// Whether a type of surface is one of the five families by its name.
fn is_named(surface: &str) -> bool {
    const NAMES: [&str; 6] = [
        "PLANE",
        "CYLINDRICAL_SURFACE",
        "CONICAL_SURFACE",
        "SPHERICAL_SURFACE",
        "TOROIDAL_SURFACE",
        "DEGENERATE_TOROIDAL_SURFACE",
    ];
    surface.split('+').any(|part| NAMES.contains(&part))
}

/// What primitives there are to be.
struct Groups {
    /// The surface of each usable face.
    surfaces: Vec<Option<Surface>>,
    /// The first face of the primitive that each is of.
    group: Vec<usize>,
}

/// The model, the number of the primitive of each group, and the number of points of each face.
fn model(
    name: &str,
    points: &[(u32, Point)],
    groups: &Groups,
) -> (Model, Vec<Option<u32>>, Vec<usize>) {
    let count = groups.group.len();
    let mut lists: Vec<Vec<u32>> = vec![Vec::new(); count];
    let mut counts = vec![0; count];
    for (index, (patch, _)) in (0_u32..).zip(points) {
        counts[*patch as usize] += 1;
        lists[groups.group[*patch as usize]].push(index);
    }
    let mut numbers = vec![None; count];
    let mut primitives = Vec::new();
    for (group, list) in lists.into_iter().enumerate() {
        if let (Some(surface), false) = (groups.surfaces[group], list.is_empty()) {
            let number = primitives.len() as u32 + 1;
            numbers[group] = Some(number);
            primitives.push(Primitive::on(surface, number, list));
        }
    }
    let model = Model {
        name: name.to_owned(),
        cloud: Cloud::new(points.iter().map(|(_, point)| *point).collect()),
        truth: Some(Segmentation { primitives }),
        submissions: Vec::new(),
    };
    (model, numbers, counts)
}
