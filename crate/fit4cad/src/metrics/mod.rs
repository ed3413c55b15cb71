//! How a submission is scored against the truth.
