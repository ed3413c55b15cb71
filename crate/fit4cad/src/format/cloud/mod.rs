//! Reading a cloud: the benchmark's `PCi.txt` (`Points:=[`, one `[x, y, z], ` per line, ` ];`), or a
//! table of any kind (`table`).

mod columns;
pub(super) mod kinds;
mod paper;
mod row;
mod table;

pub(super) use columns::Columns;
pub(super) use paper::read_papers_form;
pub(super) use table::read as read_table;

use super::encoding;
use super::findings::{is_blank, open};
use super::labels::Segment;
use super::scan::{Cursor, is_remark, is_whitespace};
use super::window::Window;
use crate::cloud::Cloud;
use crate::diagnostics::Diagnostic;

/// What a file of points holds.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CloudFile {
    /// The points.
    pub cloud: Cloud,
    /// Which of them belong together, where the file says so.
    pub segments: Option<Vec<Segment>>,
}

/// Reads a cloud file of text. Linear in its length, one pass.
///
/// The paper's form is read as far as its meaning is plain (MATLAB's `Points=[1 2 3; …]`, a missing
/// header or end, remarks) with a finding. Anything else is a table: a point a line, its numbers
/// separated by blanks, tabs, commas or semicolons, with decimal commas where they can be nothing
/// else; a line of names, a number of points and remarks may come first, other columns after the
/// coordinates. A row that is not three finite numbers keeps its number and has no point
/// ([`Cloud::numbering`]); what comes before the first row has no number.
pub fn read_cloud(file: &str, bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    read_cloud_with(file, bytes, is_labelled(file))
}

/// As [`read_cloud`], of a file that is known to have labels, or not.
pub(super) fn read_cloud_with(
    file: &str,
    bytes: &[u8],
    labelled: bool,
) -> (CloudFile, Vec<Diagnostic>) {
    let bytes = &*encoding::utf8(bytes);
    // What is in memory can be had.
    read_window(file, &mut Window::whole(bytes), labelled).unwrap_or_default()
}

/// As [`read_cloud`], of a text that is here, or comes piece by piece.
///
/// # Errors
/// Why it cannot be had to its end.
pub(super) fn read_window(
    file: &str,
    window: &mut Window<'_>,
    labelled: bool,
) -> Result<(CloudFile, Vec<Diagnostic>), String> {
    match begin(file, window)? {
        Ok((at, RowForm::Paper)) => read_papers_form(file, window, at),
        Ok((at, RowForm::Table)) => table::read(file, window, at, labelled),
        Err(diagnostics) => Ok((CloudFile::default(), diagnostics)),
    }
}

/// Whether a kind of file says that its last column is of labels, as Point2CAD's ending does.
pub(super) fn is_labelled(file: &str) -> bool {
    let ending = file.rsplit_once('.').map(|(_, ending)| ending);
    ending.is_some_and(|ending| ending.eq_ignore_ascii_case("xyzc"))
}

/// Reads a cloud in the paper's form alone.
pub(super) fn read_own(file: &str, bytes: &[u8]) -> (CloudFile, Vec<Diagnostic>) {
    let bytes = &*encoding::utf8(bytes);
    let mut window = Window::whole(bytes);
    match open(file, bytes) {
        Ok((_, cursor)) => read_papers_form(file, &mut window, cursor.at).unwrap_or_default(),
        Err(diagnostics) => (CloudFile::default(), diagnostics),
    }
}

/// Whether a text is in the paper's form, or is none that could be read in any.
pub(super) fn is_own(file: &str, bytes: &[u8]) -> bool {
    let bytes = &*encoding::utf8(bytes);
    let form = begin(file, &mut Window::whole(bytes));
    !matches!(form, Ok(Ok((_, RowForm::Table))))
}

/// Longer than any mark at the beginning of a file, in bytes.
pub(super) const MARK: usize = 8;

/// In what form the rows of a text are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RowForm {
    /// As the paper has them; also of what is blank.
    Paper,
    /// One a line.
    Table,
}

/// Where a text begins, in the offset of the window, and in what form it is; else what is wrong with it as a whole.
///
/// # Errors
/// Why the text cannot be had.
pub(super) fn begin(
    file: &str,
    window: &mut Window<'_>,
) -> Result<Result<(usize, RowForm), Vec<Diagnostic>>, String> {
    window.reach(MARK)?;
    loop {
        let bytes = window.bytes();
        let cursor = match open(file, bytes) {
            Ok((_, cursor)) => cursor,
            Err(diagnostics) => return Ok(Err(diagnostics)),
        };
        let (at, last) = (cursor.at, window.is_last());
        match form_of(cursor.clone(), last) {
            Some(form) => return Ok(Ok((at, form))),
            None if last && is_blank(cursor) => return Ok(Ok((at, RowForm::Paper))),
            None if last => return Ok(Ok((at, RowForm::Table))),
            None => window.read_on()?,
        }
    }
}

/// The form of a text by the first thing in it, remarks and a number of points aside: a bracket, or a word by which
/// one of the benchmark's files begins. `None` where there is nothing, and where `last` is false and what is here may
/// go on.
fn form_of(mut cursor: Cursor<'_>, last: bool) -> Option<RowForm> {
    let whole = |cursor: &Cursor<'_>| last || cursor.peek().is_some();
    loop {
        cursor.skip_whitespace();
        let is_papers = match cursor.peek()? {
            b'[' => true,
            byte if is_remark(byte) => {
                cursor.skip_line();
                continue;
            }
            b'0'..=b'9' => {
                if at_count(&cursor) {
                    cursor.skip_line();
                    continue;
                }
                cursor.skip_while(|byte| byte.is_ascii_digit() || matches!(byte, b' ' | b'\t'));
                if !whole(&cursor) {
                    return None;
                }
                false
            }
            byte if byte.is_ascii_alphabetic() => {
                let word = cursor.word();
                let keyword = word.get(..9).unwrap_or(word);
                cursor.skip_while(|byte| is_whitespace(byte) || matches!(byte, b':' | b'='));
                if !whole(&cursor) {
                    return None;
                }
                word.eq_ignore_ascii_case(b"points") && cursor.peek() == Some(b'[')
                    || keyword.eq_ignore_ascii_case(b"primitive")
            }
            _ => false,
        };
        return Some(if is_papers {
            RowForm::Paper
        } else {
            RowForm::Table
        });
    }
}

/// Whether a line begins here that holds one whole number and nothing else.
fn at_count(cursor: &Cursor<'_>) -> bool {
    let mut ahead = cursor.clone();
    ahead.skip_while(|byte| byte.is_ascii_digit());
    ahead.skip_while(|byte| matches!(byte, b' ' | b'\t'));
    matches!(ahead.peek(), Some(b'\n' | b'\r'))
}

/// Rows read before the length of the rest is estimated from them.
const ROWS_TO_JUDGE_BY: usize = 1024;
