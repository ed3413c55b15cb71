//! Writing the four files in the paper's form.
//!
//! Numbers are written with as few digits as read back to the same double, so that what is
//! written and read again is the same, bit for bit.

use std::fmt::Write;

use crate::cloud::{Cloud, Numbering};
use crate::model::{Coefficients, Segmentation};
use crate::surface::{Form, OTHER};

/// What stands for a row that could not be read: again nothing that could be.
const BROKEN_ROW: [f64; 3] = [f64::NAN; 3];

/// The text of `PCi.txt`. Linear in the number of rows, of which those that could not be read keep
/// their places, and with them the points their numbers.
pub fn write_cloud(cloud: &Cloud) -> String {
    let mut text = String::with_capacity(16 + cloud.len() * 64);
    text.push_str("Points:=[\n");
    let mut points = (0..).zip(cloud.points()).peekable();
    for number in 1..=cloud.numbering().rows() as u64 {
        let here = points.next_if(|&(index, _)| cloud.numbering().number(index) == number);
        text.push_str(if number == 1 { "[" } else { ", \n[" });
        let row = here.map_or(BROKEN_ROW, |(_, point)| point.coords.into());
        push_numbers(&mut text, &row, ", ");
        text.push(']');
    }
    text.push_str(" \n ];\n");
    text
}

/// The text of `PCi_primitives.txt`: lists of points by their numbers in the cloud's file. Linear in
/// the points listed.
///
/// ```
/// use fit4cad::format::write_primitives;
/// use fit4cad::cloud::Numbering;
/// use fit4cad::model::{Primitive, Segmentation};
/// let primitives = vec![Primitive { number: 1, points: vec![0, 1], ..Primitive::default() }];
/// let text = write_primitives(&Segmentation { primitives }, &Numbering::of(2));
/// assert!(text.starts_with("Primitive1:=[1"));
/// ```
pub fn write_primitives(segmentation: &Segmentation, numbering: &Numbering) -> String {
    let listed: usize = segmentation
        .primitives
        .iter()
        .map(|primitive| primitive.points.len())
        .sum();
    let mut text = String::with_capacity(listed * 6 + segmentation.primitives.len() * 24);
    for primitive in &segmentation.primitives {
        let _ = write!(text, "Primitive{}:=[", primitive.number);
        for (at, &index) in primitive.points.iter().enumerate() {
            if at > 0 {
                text.push(' ');
            }
            let _ = write!(text, "{}", numbering.number(index));
        }
        text.push_str("];\n");
    }
    text
}

/// The text of `PCi_parametric.txt` or `PCi_implicit.txt`.
///
/// A primitive without an entry in that form has none in the text; an entry that could not be read
/// is written with its type and no numbers, so that it cannot be read again either. Empty where no
/// primitive has an entry: readers then convert the other form.
///
/// ```
/// use fit4cad::cloud::{Point, Vector};
/// use fit4cad::format::write_surfaces;
/// use fit4cad::model::{Primitive, Segmentation};
/// use fit4cad::surface::{Form, Plane, Surface};
/// let floor = Surface::Plane(Plane::new(Point::origin(), Vector::z()));
/// let primitives = vec![Primitive::on(floor, 1, vec![0])];
/// let text = write_surfaces(&Segmentation { primitives }, Form::Implicit);
/// assert!(text.contains("Plane"));
/// ```
pub fn write_surfaces(segmentation: &Segmentation, form: Form) -> String {
    let mut text = String::new();
    for primitive in &segmentation.primitives {
        let values = match primitive.coefficients(form) {
            Coefficients::Missing => continue,
            Coefficients::Malformed => &[],
            Coefficients::Given(values) => &values[..],
        };
        let kind = primitive.kind.map_or(OTHER, |kind| kind.name());
        let _ = write!(text, "Primitive{}:=[{kind}, [", primitive.number);
        push_numbers(&mut text, values, " ");
        text.push_str("]];\n");
    }
    text
}

fn push_numbers(text: &mut String, values: &[f64], separator: &str) {
    for (at, &value) in values.iter().enumerate() {
        if at > 0 {
            text.push_str(separator);
        }
        // Both forms are the shortest that read back; very large and small numbers would be
        // hundreds of digits long without an exponent.
        let _ = if value == 0.0 || (1e-5..1e16).contains(&value.abs()) {
            write!(text, "{value}")
        } else {
            write!(text, "{value:e}")
        };
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::cloud::{LARGEST, Point};
    use crate::format::{Role, SourceFile, read_model};
    use crate::model::{Model, Primitive, Submission};
    use crate::surface::{Surface, SurfaceType};

    #[test]
    fn a_segmentation_is_written_as_in_the_paper() {
        let plane = Primitive {
            number: 1,
            points: vec![0, 2],
            kind: Some(SurfaceType::Plane),
            implicit: Coefficients::Given(vec![0.0, 0.0, 1.0, -29.21]),
            ..Primitive::default()
        };
        let segmentation = Segmentation {
            primitives: vec![plane],
        };
        assert_eq!(
            write_primitives(&segmentation, &Numbering::of(3)),
            "Primitive1:=[1 3];\n"
        );
        assert_eq!(
            write_surfaces(&segmentation, Form::Implicit),
            "Primitive1:=[Plane, [0 0 1 -29.21]];\n"
        );
        assert_eq!(write_surfaces(&segmentation, Form::Parametric), "");
        let cloud = Cloud::new(vec![
            Point::new(1.0, -0.0, 1e-9),
            Point::new(2.5, 1e300, 3.0),
        ]);
        assert_eq!(
            write_cloud(&cloud),
            "Points:=[\n[1, -0, 1e-9], \n[2.5, 1e300, 3] \n ];\n"
        );
    }

    fn write_and_read(model: &Model) -> Model {
        let mut texts = vec![(Role::Cloud, None, write_cloud(&model.cloud))];
        let submissions = model
            .submissions
            .iter()
            .map(|submission| (Some(&submission.method[..]), &submission.segmentation));
        for (method, segmentation) in model
            .truth
            .iter()
            .map(|truth| (None, truth))
            .chain(submissions)
        {
            let primitives = write_primitives(segmentation, model.cloud.numbering());
            texts.push((Role::Primitives, method, primitives));
            texts.push((
                Role::Parametric,
                method,
                write_surfaces(segmentation, Form::Parametric),
            ));
            texts.push((
                Role::Implicit,
                method,
                write_surfaces(segmentation, Form::Implicit),
            ));
        }
        let files: Vec<SourceFile<'_>> = texts
            .iter()
            .map(|(role, method, text)| SourceFile {
                path: "written",
                role: *role,
                method: *method,
                bytes: text.as_bytes(),
            })
            .collect();
        read_model(&model.name, &files).0
    }

    /// Numbers that show rounding, signs and exponents.
    fn awkward() -> impl Strategy<Value = f64> {
        prop_oneof![
            any::<f64>().prop_filter("finite", |value| value.is_finite()),
            -1e3..1e3f64,
            prop::sample::select(vec![
                0.0,
                -0.0,
                1.73472e-15,
                577_350.0,
                5e-324,
                f64::MAX,
                f64::MIN_POSITIVE,
                0.1,
                1e16,
                1e-5,
                1e22,
            ]),
        ]
    }

    /// Such numbers as far as points are read: what is beyond comes round again.
    fn coordinate() -> impl Strategy<Value = f64> {
        awkward().prop_map(|value| {
            if value.abs() > LARGEST {
                value % LARGEST
            } else {
                value
            }
        })
    }

    fn coefficients(len: usize) -> impl Strategy<Value = Coefficients> {
        prop_oneof![
            1 => Just(Coefficients::Missing),
            1 => Just(Coefficients::Malformed),
            6 => prop::collection::vec(awkward(), len)
                .prop_filter("not all zero", |values| values.iter().any(|&value| value != 0.0))
                .prop_map(Coefficients::Given),
        ]
    }

    fn primitive(points: u32) -> impl Strategy<Value = Primitive> {
        let kind = prop::sample::select(SurfaceType::ALL.to_vec());
        (prop::collection::btree_set(0..points, 0..20), kind)
            .prop_flat_map(|(points, kind)| {
                (
                    Just(points),
                    Just(kind),
                    coefficients(kind.parametric_len()),
                    coefficients(kind.implicit_len()),
                )
            })
            .prop_map(|(points, kind, parametric, implicit)| {
                let given =
                    parametric != Coefficients::Missing || implicit != Coefficients::Missing;
                Primitive {
                    number: 0,
                    points: points.into_iter().collect(),
                    kind: given.then_some(kind),
                    surface: parametric
                        .values()
                        .and_then(|values| Surface::from_parametric(kind, values).ok())
                        .map(|converted| converted.surface),
                    parametric,
                    implicit,
                }
            })
    }

    /// A primitive with an entry in both files, so that neither is empty.
    fn whole_primitive() -> Primitive {
        let parametric = vec![1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.1];
        let kind = SurfaceType::Plane;
        Primitive {
            number: 1,
            points: vec![0],
            kind: Some(kind),
            surface: Surface::from_parametric(kind, &parametric)
                .ok()
                .map(|plane| plane.surface),
            parametric: Coefficients::Given(parametric),
            implicit: Coefficients::Given(vec![0.0, -0.0, 1.0, -0.1]),
        }
    }

    fn segmentation(points: u32) -> impl Strategy<Value = Segmentation> {
        prop::collection::vec(primitive(points), 0..8).prop_map(|others| {
            let mut primitives = vec![whole_primitive()];
            primitives.extend(others);
            for (number, primitive) in (1..).zip(&mut primitives) {
                primitive.number = number * 3;
            }
            Segmentation { primitives }
        })
    }

    fn model() -> impl Strategy<Value = Model> {
        let points = prop::collection::vec([coordinate(), coordinate(), coordinate()], 1..40);
        let rows = points.prop_flat_map(|points| {
            let most = points.len();
            (Just(points), prop::collection::vec(0..=most, 0..4))
        });
        rows.prop_flat_map(|(points, mut broken)| {
            // Rows before so many points, however many there are already.
            broken.sort_unstable();
            let broken: Vec<u32> = (0..).zip(broken).map(|(k, row)| row as u32 + k).collect();
            let numbering = Numbering::with_broken(points.len() + broken.len(), broken);
            let count = points.len() as u32;
            let points = points.into_iter().map(Point::from).collect();
            let cloud = Cloud::numbered(points, numbering);
            let submissions = (segmentation(count), segmentation(count)).prop_map(|(a, b)| {
                [("A", a), ("B", b)]
                    .map(|(method, segmentation)| Submission {
                        method: method.to_owned(),
                        segmentation,
                    })
                    .to_vec()
            });
            (
                Just(cloud),
                prop::option::of(segmentation(count)),
                submissions,
            )
                .prop_map(|(cloud, truth, submissions)| Model {
                    name: "PC1".to_owned(),
                    cloud,
                    truth,
                    submissions,
                })
        })
    }

    /// Debug text tells `-0` from `0`, which equality does not.
    fn bits(model: &Model) -> String {
        format!("{model:?}")
    }

    proptest! {
        #[test]
        fn what_is_written_reads_back_the_same(model in model()) {
            prop_assert_eq!(bits(&write_and_read(&model)), bits(&model));
        }
    }
}
