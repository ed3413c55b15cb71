//! What a file that may hold both is read for.

/// What a file is read for: where it holds the segments of a truth and those of a result, the one or
/// the other is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// The cloud, or the truth.
    Truth,
    /// A method's result.
    Submission,
}
