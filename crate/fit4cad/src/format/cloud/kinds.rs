//! What can be wrong with a cloud file.

use crate::diagnostics::{Severity, Subject};
use crate::format::findings::Kind;

pub(super) const EMPTY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The cloud file is empty",
    expected: "a point a line, `[x, y, z],` or `x y z`",
    hint: "Fetch the file again",
};
pub(super) const NO_POINTS: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The cloud file holds no point that could be read",
    expected: "a point a line, `[x, y, z],` or `x y z`",
    hint: "If it is no cloud, set its role or leave it out",
};
pub(super) const OTHER_FILE: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "This is not a cloud but a file of primitives",
    expected: "`Points:=[`",
    hint: "Rename the file or set its role",
};
pub(super) const NO_HEADER: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Warning,
    message: "The cloud does not begin with its header",
    expected: "`Points:=[`",
    hint: "The rows are read all the same",
};
pub(super) const JUNK: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Warning,
    message: "A line is not a point and was skipped",
    expected: "a point, `[x, y, z],` or `x y z`",
    hint: "It takes no point number; begin remarks with # or %",
};
pub(super) const COUNT: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Note,
    message: "The cloud begins with a number of points",
    expected: "`Points:=[`",
    hint: "It takes no point number",
};
pub(super) const BROKEN_ROW: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Error,
    message: "A point could not be read",
    expected: "three finite numbers, `[x, y, z],` or `x y z`",
    hint: "It keeps its number and is left out; write decimals with a point",
};
pub(super) const TOO_FAR: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Error,
    message: "A point is too far away to compute with",
    expected: "coordinates up to 1e30",
    hint: "It keeps its number and is left out; choose another unit",
};
pub(super) const CUT_OFF: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The file ends within a point",
    expected: "`]`",
    hint: "The point is left out; fetch the file again",
};
pub(super) const NO_ROW_END: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Warning,
    message: "A point is not closed",
    expected: "`]` after the third number",
    hint: "",
};
pub(super) const NO_COMMAS: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Note,
    message: "Coordinates are not separated by commas",
    expected: "`[x, y, z],`",
    hint: "They are read all the same",
};
pub(super) const NO_BRACKETS: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Note,
    message: "Points stand without brackets",
    expected: "`[x, y, z],`",
    hint: "Each line is read as a point",
};
pub(super) const NOT_CLOSED: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Warning,
    message: "The list of points is not closed",
    expected: "`];`",
    hint: "If the file was cut off, fetch it again",
};
pub(super) const AFTER_END: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Warning,
    message: "What follows the end of the list was not read",
    expected: "nothing after `];`",
    hint: "",
};
pub(in crate::format) const TOO_MANY: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "The cloud has too many points; the rest was not read",
    expected: "at most 10,000,000 points",
    hint: "Thin the cloud",
};
pub(in crate::format) const ONE_A_ROW: Kind = Kind {
    subject: Subject::File,
    severity: Severity::Error,
    message: "This is not a cloud but a number, or a name, for each point of one",
    expected: "points",
    hint: "Put it beside its cloud PC1.txt and call it PC1_labels.txt, or PC1_type.txt where it tells types; or set \
           its model and its role, primitives or types",
};
pub(super) const COLUMNS: Kind = Kind {
    subject: Subject::Syntax,
    severity: Severity::Note,
    message: "There are more columns than coordinates",
    expected: "",
    hint: "Where that is wrong, name the columns in a first line: x y z nx ny nz label",
};
pub(super) const BAD_LABEL: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Warning,
    message: "A point has no label that could be read",
    expected: "a whole number, -1 for none",
    hint: "It belongs to no segment",
};
pub(super) const MISCOUNTED: Kind = Kind {
    subject: Subject::Point,
    severity: Severity::Warning,
    message: "The cloud has another number of points than it says",
    expected: "",
    hint: "If the file was cut off, fetch it again",
};
