//! Segments that come without surfaces, as labels do, get them here.

use std::collections::BTreeSet;

use super::single::fit_segments;
use crate::diagnostics::{Diagnostic, Severity, Subject};
use crate::format::{Reading, Role, Source};

/// Whose surfaces are the engine's own: names of methods, `None` for the truth.
pub type Fitted = BTreeSet<Option<String>>;

/// Fits a surface to each segment of the segmentations that were read without any, and says so among the
/// diagnostics. `files` are those that were read.
pub fn give_surfaces<S: Source>(reading: &mut Reading, files: &[S]) -> Fitted {
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
