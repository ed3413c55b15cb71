//! What can be wrong with files of other programs.

use crate::diagnostics::{Severity, Subject};
use crate::format::findings::Kind;

pub(super) const COLUMNS: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Note,
    message: "There are more columns than coordinates",
    expected: "",
    hint: "",
};
pub(super) const BROKEN_ROWS: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Error,
    message: "Points could not be read",
    expected: "three finite numbers up to 1e30",
    hint: "They keep their numbers and are left out",
};
pub(super) const BAD_LABELS: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Warning,
    message: "Points have no label that could be read",
    expected: "a whole number, -1 for none",
    hint: "They belong to no segment",
};
pub(super) const NO_POINTS: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file holds no point that could be read",
    expected: "",
    hint: "",
};
pub(super) const CUT_OFF: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file is shorter than it says",
    expected: "",
    hint: "What is there is read; fetch the file again",
};
pub(super) const BAD_HEADER: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The head of the file could not be read",
    expected: "",
    hint: "Save it again, as text where nothing else helps",
};
pub(super) const NO_COORDINATES: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file has no columns x, y and z",
    expected: "",
    hint: "",
};
pub(super) const PICKLED: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The array holds Python objects, which are never opened",
    expected: "an array of numbers",
    hint: "Save it with np.save(…, allow_pickle=False)",
};
pub(super) const PACKED_BADLY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file could not be unpacked",
    expected: "",
    hint: "Fetch it again, or unpack it first",
};
pub(super) const NOT_OPENED: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "This is an HDF5 file that was not opened",
    expected: "a name ending in .h5 or .hdf5",
    hint: "Unpack it, and give it such a name",
};
pub(super) const LAZ: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The points are packed as LAZ, which is not read",
    expected: "LAS",
    hint: "Save it as LAS; laszip, PDAL and CloudCompare do",
};
