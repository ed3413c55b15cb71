//! Formulas as data, so that every face writes them in its own way: MathML, LaTeX, plain text.

/// A part of a formula.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Term {
    /// A name of several letters, upright: TP.
    Word(String),
    /// A variable, in italics.
    Variable(&'static str),
    /// A number.
    Number(u32),
    /// An operator, a bracket or a comma.
    Operator(&'static str),
    /// Terms after one another.
    Row(Vec<Term>),
    /// One over another.
    Fraction(Box<Term>, Box<Term>),
    /// One with an index.
    Sub(Box<Term>, Box<Term>),
    /// An operator, and what it runs over below it.
    Under(Box<Term>, Box<Term>),
}

impl Term {
    /// A name of several letters.
    pub(super) fn word(text: impl Into<String>) -> Self {
        Self::Word(text.into())
    }

    /// Terms after one another.
    pub(super) fn row(terms: impl Into<Vec<Self>>) -> Self {
        Self::Row(terms.into())
    }

    /// A quotient.
    pub(super) fn fraction(over: Self, under: Self) -> Self {
        Self::Fraction(Box::new(over), Box::new(under))
    }

    /// A term with an index.
    pub(super) fn sub(base: Self, index: Self) -> Self {
        Self::Sub(Box::new(base), Box::new(index))
    }

    /// An operator over a range.
    pub(super) fn under(operator: Self, range: Self) -> Self {
        Self::Under(Box::new(operator), Box::new(range))
    }
}
