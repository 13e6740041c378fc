//! Values of expressions: scalars that may be angles, vectors and arrays.

use linkage_symbolic::{Ex, Vn};

/// An angle that a direction can be built from without knowing its value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Atom {
    Input(usize),
    /// Index of an unknown angle of the algebra.
    Angle(usize),
}

/// `sum of coefficient * atom + rest`; atoms in order, coefficients never 0. Anything that is no
/// angle has no atoms.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Scalar<'m> {
    pub(crate) terms: Vec<(Atom, f64)>,
    pub(crate) rest: Ex<'m>,
}

impl<'m> From<Ex<'m>> for Scalar<'m> {
    fn from(rest: Ex<'m>) -> Self {
        Self {
            terms: Vec::new(),
            rest,
        }
    }
}

impl Scalar<'_> {
    pub(crate) fn coefficient(&self, atom: Atom) -> f64 {
        self.terms
            .iter()
            .find(|(a, _)| *a == atom)
            .map_or(0.0, |(_, k)| *k)
    }

    /// `self + sign other`
    #[must_use]
    pub(crate) fn combined(&self, other: &Self, sign: f64) -> Self {
        let mut terms = self.terms.clone();
        for &(atom, k) in &other.terms {
            match terms.iter_mut().find(|(other, _)| *other == atom) {
                Some((_, old)) => *old += sign * k,
                None => terms.push((atom, sign * k)),
            }
        }
        terms.retain(|(_, k)| *k != 0.0);
        terms.sort_by_key(|(atom, _)| *atom);
        let rest = if sign > 0.0 {
            self.rest + other.rest
        } else {
            self.rest - other.rest
        };
        Self { terms, rest }
    }

    /// `factor self`
    #[must_use]
    pub(crate) fn scaled(&self, factor: f64) -> Self {
        let terms = self.terms.iter();
        let terms = terms.map(|&(atom, k)| (atom, factor * k));
        Self {
            terms: terms.filter(|(_, k)| *k != 0.0).collect(),
            rest: factor * self.rest,
        }
    }
}

/// The value of an expression.
#[derive(Clone, Debug)]
pub(crate) enum Value<'m> {
    Scalar(Scalar<'m>),
    Vector(Vn<'m>),
    /// A frame has four entries: its origin and its axes.
    Array(Vec<Value<'m>>),
}

impl<'m> From<Ex<'m>> for Value<'m> {
    fn from(x: Ex<'m>) -> Self {
        Self::Scalar(x.into())
    }
}

impl<'m> From<Vn<'m>> for Value<'m> {
    fn from(v: Vn<'m>) -> Self {
        Self::Vector(v)
    }
}

impl<'m> Value<'m> {
    pub(crate) fn negative(self) -> Self {
        match self {
            Self::Scalar(scalar) => Self::Scalar(scalar.scaled(-1.0)),
            Self::Vector(vector) => Self::Vector(-vector),
            Self::Array(entries) => Self::Array(entries.into_iter().map(Self::negative).collect()),
        }
    }
}
