//! Errors made on purpose are found, and nothing else is.

use super::*;
use crate::diagnostics::Severity;
use crate::format::{Role, SourceFile, read_model, write_cloud, write_primitives, write_surfaces};
use crate::model::{Coefficients, Primitive, Segmentation};
use crate::sample::{self, Options, generate};
use crate::surface::{Form, Surface, SurfaceType};

fn part(name: &str) -> Model {
    let options = Options {
        spacing: 0.02,
        ..Options::default()
    };
    generate(name, &options).unwrap()
}

fn primitives(model: &mut Model) -> &mut Vec<Primitive> {
    &mut model.truth.as_mut().unwrap().primitives
}

/// The first two primitives of a type, as positions.
fn two_of(model: &Model, kind: SurfaceType) -> [usize; 2] {
    let all = model.truth.as_ref().unwrap().primitives.iter().enumerate();
    let of_kind: Vec<usize> = all
        .filter(|(_, primitive)| primitive.kind == Some(kind))
        .map(|(at, _)| at)
        .collect();
    [of_kind[0], of_kind[1]]
}

fn found(model: &Model) -> Vec<(Option<u32>, Check)> {
    let findings = audit(model, &[]).findings;
    findings.iter().map(|f| (f.primitive, f.check)).collect()
}

/// Writes the truth with one of its texts changed and reads it again.
fn reread(model: &Model, change: impl Fn(Role, String) -> String) -> (Model, Vec<Diagnostic>) {
    let truth = model.truth.as_ref().unwrap();
    let texts = [
        (Role::Cloud, write_cloud(&model.cloud)),
        (
            Role::Primitives,
            write_primitives(truth, model.cloud.numbering()),
        ),
        (Role::Parametric, write_surfaces(truth, Form::Parametric)),
        (Role::Implicit, write_surfaces(truth, Form::Implicit)),
    ]
    .map(|(role, text)| (role, change(role, text)));
    let files: Vec<SourceFile<'_>> = texts
        .iter()
        .map(|(role, text)| SourceFile {
            path: "part.txt",
            role: *role,
            method: None,
            bytes: text.as_bytes(),
        })
        .collect();
    read_model("part", &files)
}

fn found_in_files(
    model: &Model,
    change: impl Fn(Role, String) -> String,
) -> Vec<(Option<u32>, Check)> {
    let (model, diagnostics) = reread(model, change);
    let findings = audit(&model, &diagnostics).findings;
    findings.iter().map(|f| (f.primitive, f.check)).collect()
}

#[test]
fn no_part_of_the_generator_has_a_finding() {
    for info in sample::parts() {
        let model = part(info.name);
        let audit = audit(&model, &[]);
        assert_eq!(audit.findings, [], "{}", info.name);
        for primitive in &audit.primitives {
            let parametric = primitive.parametric.unwrap().accuracy.unwrap();
            let label = format!("{} {}", info.name, primitive.number);
            assert!(parametric.d_haus < 1e-9, "{label}: {parametric:?}");
            assert!(primitive.agreement.unwrap() < 1e-7, "{label}");
        }
    }
}

#[test]
fn nor_has_a_part_that_was_written_and_read() {
    let model = part("bracket");
    assert_eq!(found_in_files(&model, |_, text| text), []);
}

#[test]
fn a_wrong_implicit_form_is_found_and_corrected() {
    let mut model = part("bracket");
    let [first, _] = two_of(&model, SurfaceType::Cylinder);
    let number = primitives(&mut model)[first].number;
    let right = primitives(&mut model)[first].implicit.clone();
    let mut wrong = right.values().unwrap().to_vec();
    wrong[9] *= 1.02;
    primitives(&mut model)[first].implicit = Coefficients::Given(wrong);
    assert_eq!(found(&model), [(Some(number), Check::ImplicitDistance)]);
    let finding = &audit(&model, &[]).findings[0];
    assert!(finding.value > finding.limit, "{finding:?}");
    assert!(
        finding.hint.contains("The parametric form fits"),
        "{finding:?}"
    );

    let (truth, corrections) = correct(&model).unwrap();
    let expected = Correction {
        primitive: number,
        form: Form::Implicit,
        from: Form::Parametric,
    };
    assert_eq!(corrections, [expected]);
    let corrected = Model {
        truth: Some(truth),
        ..model
    };
    assert_eq!(audit(&corrected, &[]).findings, []);
}

#[test]
fn a_wrong_parametric_form_is_converted_from_the_implicit_one() {
    let mut model = part("bracket");
    let [first, _] = two_of(&model, SurfaceType::Cylinder);
    let number = primitives(&mut model)[first].number;
    let mut wrong = primitives(&mut model)[first]
        .parametric
        .values()
        .unwrap()
        .to_vec();
    for value in &mut wrong[..6] {
        *value *= 1.1;
    }
    primitives(&mut model)[first].parametric = Coefficients::Given(wrong);
    assert_eq!(found(&model), [(Some(number), Check::ParametricDistance)]);
    let (truth, corrections) = correct(&model).unwrap();
    assert_eq!(
        (corrections[0].form, corrections[0].from),
        (Form::Parametric, Form::Implicit)
    );
    model.truth = Some(truth);
    assert_eq!(found(&model), []);
}

#[test]
fn swapped_implicit_entries_are_traced_to_their_owners() {
    let mut model = part("bracket");
    let right = model.truth.clone().unwrap().primitives;
    let [first, second] = two_of(&model, SurfaceType::Cylinder);
    let all = primitives(&mut model);
    all[first].implicit = right[second].implicit.clone();
    all[second].implicit = right[first].implicit.clone();
    let findings = audit(&model, &[]).findings;
    assert_eq!(findings.len(), 2, "{findings:#?}");
    for (finding, (own, other)) in findings.iter().zip([(first, second), (second, first)]) {
        let place = (Some(right[own].number), Check::ImplicitDistance);
        assert_eq!((finding.primitive, finding.check), place);
        // Several patches may lie on the same cylinder; the first of them is named.
        let owners = right
            .iter()
            .filter(|it| it.implicit == right[other].implicit);
        let named =
            owners.map(|it| format!("The vector fits the points of Primitive{}.", it.number));
        assert!(
            named
                .into_iter()
                .any(|hint| finding.hint.starts_with(&hint)),
            "{finding:?}"
        );
    }
}

#[test]
fn surfaces_swapped_in_both_files_are_one_finding_each_and_not_corrected() {
    let mut model = part("bracket");
    let [first, second] = two_of(&model, SurfaceType::Plane);
    let all = primitives(&mut model);
    let (a, b) = (all[first].clone(), all[second].clone());
    let give = |to: &mut Primitive, from: &Primitive| {
        to.surface = from.surface;
        to.parametric = from.parametric.clone();
        to.implicit = from.implicit.clone();
    };
    give(&mut all[first], &b);
    give(&mut all[second], &a);
    let expected = [&a, &b].map(|it| (Some(it.number), Check::SurfaceDistance));
    assert_eq!(found(&model), expected);
    assert_eq!(correct(&model).unwrap().1, []);
}

#[test]
fn a_stray_point_is_named_and_does_not_put_the_forms_in_doubt() {
    let mut model = part("bracket");
    let cloud = model.cloud.clone();
    let all = primitives(&mut model);
    let surface = all[0].surface.unwrap();
    let away = |index: &u32| surface.distance(&cloud.points()[*index as usize]);
    let stray = (0..cloud.len() as u32)
        .max_by(|a, b| away(a).total_cmp(&away(b)))
        .unwrap();
    all[0].points.push(stray);
    all[0].points.sort_unstable();
    let findings = audit(&model, &[]).findings;
    assert_eq!(findings.len(), 1, "{findings:#?}");
    assert_eq!(findings[0].check, Check::StrayPoint);
    let named = format!("Point {} is", stray + 1);
    assert!(findings[0].message.starts_with(&named), "{findings:?}");
    assert_eq!(findings[0].severity, Severity::Error);
}

#[test]
fn an_empty_parametric_file_is_the_only_finding_where_the_implicit_one_is_right() {
    let found = found_in_files(&part("bracket"), |role, text| match role {
        Role::Parametric => String::new(),
        _ => text,
    });
    assert_eq!(found, [(None, Check::File)]);
}

#[test]
fn indices_types_vectors_and_numbers_are_checked() {
    let model = part("bracket");
    let last = model.cloud.len() + 1;
    let found_with = |role_changed: Role, from: &str, to: &str| {
        found_in_files(&model, |role, text| {
            if role == role_changed {
                assert!(text.contains(from), "{from}");
                text.replacen(from, to, 1)
            } else {
                text
            }
        })
    };
    let first = model.truth.as_ref().unwrap().primitives[1].points[0] + 1;
    assert_eq!(
        found_with(
            Role::Primitives,
            "Primitive2:=[",
            &format!("Primitive2:=[{last} ")
        ),
        [(Some(2), Check::Index)]
    );
    assert_eq!(
        found_with(
            Role::Primitives,
            "Primitive2:=[",
            &format!("Primitive2:=[{first} ")
        ),
        [(Some(2), Check::Duplicate)]
    );
    assert_eq!(
        found_with(
            Role::Implicit,
            "Primitive2:=[Plane, [",
            "Primitive2:=[Plane, [1 "
        ),
        [(Some(2), Check::Vector)]
    );
    assert_eq!(
        found_with(
            Role::Implicit,
            "Primitive2:=[Plane, [",
            "Primitive2:=[Plane, [Plane, ["
        ),
        [(Some(2), Check::Syntax)]
    );
    assert_eq!(
        found_with(
            Role::Parametric,
            "Primitive2:=[Plane",
            "Primitive2:=[BSpline"
        ),
        [(Some(2), Check::Type)]
    );
    assert_eq!(
        found_with(Role::Implicit, "Primitive2:=[", "Primitive200:=["),
        [(None, Check::Numbering)]
    );
}

#[test]
fn an_elliptic_cylinder_is_no_member_of_its_family() {
    let mut model = part("bracket");
    let [first, _] = two_of(&model, SurfaceType::Cylinder);
    let number = primitives(&mut model)[first].number;
    let mut wrong = primitives(&mut model)[first]
        .parametric
        .values()
        .unwrap()
        .to_vec();
    for value in &mut wrong[..3] {
        *value *= 1.2;
    }
    primitives(&mut model)[first].parametric = Coefficients::Given(wrong);
    let expected = [Check::Family, Check::ParametricDistance];
    assert_eq!(found(&model), expected.map(|check| (Some(number), check)));
}

/// A cone whose constant lost its last digits is a hyperboloid that leaves it only at the apex.
#[test]
fn coarse_coefficients_at_an_apex_are_a_note_and_corrected() {
    use crate::cloud::{Cloud, Point, Vector};
    use crate::surface::Cone;
    let cone = Cone::new(Point::new(20.0, 0.0, 5.0), Vector::z(), 0.5);
    let surface = Surface::Cone(cone);
    let mut points = vec![Point::new(20.0, 1e-5, 5.0 + 1e-5)];
    points.extend((0..400).map(|i| {
        let (turn, height) = (f64::from(i) * 0.7, 0.05 + f64::from(i) / 400.0);
        let radius = height * 0.5f64.tan();
        Point::new(
            20.0 + radius * turn.cos(),
            radius * turn.sin(),
            5.0 + height,
        )
    }));
    let mut implicit = surface.to_implicit();
    implicit[9] += 1e-4;
    let primitive = Primitive {
        implicit: Coefficients::Given(implicit),
        ..Primitive::on(surface, 1, (0..401).collect())
    };
    let mut model = Model {
        cloud: Cloud::new(points),
        truth: Some(Segmentation {
            primitives: vec![primitive],
        }),
        ..Model::default()
    };
    let findings = audit(&model, &[]).findings;
    assert_eq!(findings.len(), 1, "{findings:#?}");
    assert_eq!(findings[0].check, Check::FirstOrderDistance);
    assert_eq!(findings[0].severity, Severity::Note);
    let (truth, corrections) = correct(&model).unwrap();
    assert_eq!(corrections.len(), 1);
    model.truth = Some(truth);
    assert_eq!(found(&model), []);
}

#[test]
fn a_model_without_truth_or_points_is_audited_without_harm() {
    assert_eq!(audit(&Model::default(), &[]), Audit::default());
    assert_eq!(correct(&Model::default()), None);
    let mut model = part("bracket");
    model.cloud = crate::cloud::Cloud::default();
    let audit = audit(&model, &[]);
    assert!(
        audit
            .primitives
            .iter()
            .all(|it| it.parametric.unwrap().accuracy.is_none())
    );
}
