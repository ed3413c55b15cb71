//! Segments that come without surfaces, as labels do, get them from the engine.

use std::collections::BTreeSet;

use fit4cad::format::{Reading, Source};

/// Whose surfaces are the engine's: names of methods, `None` for the truth.
pub(crate) type Fitted = BTreeSet<Option<String>>;

/// Fits a surface to each segment of the segmentations that have none, and says so among the
/// diagnostics.
#[cfg(feature = "workshop")]
pub(crate) fn give_surfaces<S: Source>(reading: &mut Reading, files: &[S]) -> Fitted {
    use fit4cad::diagnostics::{Diagnostic, Severity, Subject};
    use fit4cad::fit::single::fit_segments;
    use fit4cad::format::Role;

    for owner in &reading.bare {
        let model = &mut reading.model;
        let segmentation = match owner {
            None => model.truth.as_mut(),
            Some(method) => {
                let mut submissions = model.submissions.iter_mut();
                let own = submissions.find(|submission| submission.method == *method);
                own.map(|submission| &mut submission.segmentation)
            }
        };
        let Some(segmentation) = segmentation else {
            continue;
        };
        let count = fit_segments(&model.cloud, segmentation);
        let of_role = |role| {
            let mut files = files.iter();
            files.find(|file| file.role() == role && file.method() == owner.as_deref())
        };
        let file = of_role(Role::Primitives).or(of_role(Role::Cloud));
        reading.diagnostics.push(Diagnostic {
            severity: Severity::Note,
            subject: Subject::Vector,
            primitive: None,
            file: file.map_or_else(String::new, |file| file.path().to_owned()),
            position: None,
            message:
                "The file says which points belong together and not on what surfaces: they were \
                      fitted here"
                    .to_owned(),
            found: format!("{count} segments"),
            expected: String::new(),
            hint: "Types, MFE, dHaus and distances of parameters are of these surfaces".to_owned(),
        });
    }
    reading.bare.iter().cloned().collect()
}

/// Leaves that to the whole engine.
#[cfg(not(feature = "workshop"))]
pub(crate) fn give_surfaces<S: Source>(_: &mut Reading, _: &[S]) -> Fitted {
    Fitted::new()
}
