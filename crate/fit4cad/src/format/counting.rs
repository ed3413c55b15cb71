//! Whether indices count from 0, told by the surfaces that the points would then lie on.

use super::findings::{Findings, Kind};
use crate::cloud::{Bounds, Cloud};
use crate::diagnostics::{Diagnostic, Severity, Subject};
use crate::model::Segmentation;

const FROM_0: Kind = Kind {
    subject: Subject::Index,
    severity: Severity::Error,
    message: "The indices seem to count from 0: read so, the points lie on their surfaces, and now they \
              do not",
    expected: "indices that count from 1",
    hint: "Say that they count from 0, on the page under Files, at the command line by --as first=0:FILE",
};

/// Distance of a point, as a share of the extent of its primitive, from which on it is off its surface.
const OFF: f64 = 1e-3;
/// Points off their surfaces that could be there by chance.
const BY_CHANCE: usize = 2;
/// How many times as many points must be off as they are read than would be read the other way.
const TIMES: usize = 10;

/// Looks whether points read as counted from 1 lie on the surfaces of their primitives, or the points
/// after them do; says so where the latter are hardly ever off. Linear in the points listed.
pub(super) fn check(file: &str, cloud: &Cloud, segmentation: &Segmentation) -> Vec<Diagnostic> {
    let (mut own, mut next, mut all) = (0, 0, 0);
    for primitive in &segmentation.primitives {
        let Some(surface) = &primitive.surface else {
            continue;
        };
        let listed = primitive.points.iter();
        let points = listed.filter_map(|&index| cloud.points().get(index as usize));
        let limit = OFF * cloud.length_of(&Bounds::of(points));
        for &index in &primitive.points {
            let is_off = |index: u32| {
                let point = cloud.points().get(index as usize);
                point.map(|point| surface.distance(point) > limit)
            };
            if let (Some(here), Some(after)) = (is_off(index), is_off(index.saturating_add(1))) {
                all += 1;
                own += usize::from(here);
                next += usize::from(after);
            }
        }
    }
    let mut findings = Findings::new(file, &[]);
    if own > BY_CHANCE && own >= TIMES * next {
        let found = format!("{own} of {all} points off their surfaces, {next} counted from 0");
        findings.add_whole(&FROM_0, found);
    }
    findings.finish()
}

#[cfg(test)]
mod tests {
    use super::Segmentation;
    use crate::format::{Readers, Role, SourceFile, read_files, write_primitives, write_surfaces};
    use crate::sample;
    use crate::surface::Form;

    /// A file whose indices count from something.
    struct Counted<'a>(SourceFile<'a>, u8);

    impl crate::format::Source for Counted<'_> {
        fn path(&self) -> &str {
            self.0.path
        }
        fn role(&self) -> Role {
            self.0.role
        }
        fn method(&self) -> Option<&str> {
            self.0.method
        }
        fn first(&self) -> u8 {
            self.1
        }
        fn size(&self) -> u64 {
            self.0.bytes.len() as u64
        }
        fn content(&self) -> Result<std::borrow::Cow<'_, [u8]>, String> {
            Ok(self.0.bytes.into())
        }
    }

    #[test]
    fn indices_that_count_from_0_are_told_by_the_surfaces_and_read_so_where_that_is_said() {
        let options = sample::Options {
            spacing: 0.05,
            ..sample::Options::default()
        };
        let model = sample::generate("flange", &options).unwrap();
        let truth = model.truth.unwrap();
        let cloud = crate::format::write_cloud(&model.cloud);
        let own = write_primitives(&truth, model.cloud.numbering());
        let mut from_0 = String::new();
        for primitive in &truth.primitives {
            let list: Vec<String> = primitive.points.iter().map(u32::to_string).collect();
            from_0 += &format!("Primitive{}:=[{}];\n", primitive.number, list.join(" "));
        }
        let surfaces = write_surfaces(&truth, Form::Parametric);
        for (text, first, told) in [(&own, 1, false), (&from_0, 1, true), (&from_0, 0, false)] {
            let file = |path, role, text: &'_ str, first| {
                let bytes = text.as_bytes().to_vec().leak();
                Counted(
                    SourceFile {
                        path,
                        role,
                        method: None,
                        bytes,
                    },
                    first,
                )
            };
            let files = [
                file("a.txt", Role::Cloud, &cloud, 1),
                file("a_primitives.txt", Role::Primitives, text, first),
                file("a_parametric.txt", Role::Parametric, &surfaces, 1),
            ];
            let reading = read_files("a", &files, &Readers::OWN);
            let findings = reading.diagnostics.iter();
            let from_0 = findings
                .filter(|it| it.message.contains("count from 0"))
                .count();
            assert_eq!(from_0, usize::from(told));
            if !told {
                let lists = |it: &Segmentation| -> Vec<Vec<u32>> {
                    it.primitives.iter().map(|it| it.points.clone()).collect()
                };
                assert_eq!(reading.model.truth.as_ref().map(lists), Some(lists(&truth)));
                assert!(reading.diagnostics.is_empty(), "{:?}", reading.diagnostics);
            }
        }
    }
}
