//! Polynomials in complex variables and their inverses, with expressions as coefficients.

use std::collections::BTreeMap;
use std::ops::{Add, Mul, Sub};

use linkage_core::numeric::roots::Variable;
use linkage_symbolic::{Ex, V2, numerically_equal};

/// Complex coefficients by the exponents of all variables.
#[derive(Clone, Default)]
pub(super) struct Laurent<'m>(pub(super) BTreeMap<Vec<i8>, V2<'m>>);

impl<'m> Laurent<'m> {
    /// One term.
    pub(super) fn term(exponents: Vec<i8>, coefficient: V2<'m>) -> Self {
        Self(BTreeMap::from([(exponents, coefficient)]))
    }

    fn add_term(&mut self, exponents: Vec<i8>, coefficient: V2<'m>) {
        let sum = self.0.entry(exponents);
        sum.and_modify(|sum| *sum = *sum + coefficient)
            .or_insert(coefficient);
    }

    /// The same monomials with other coefficients.
    fn map(self, other: impl Fn(V2<'m>) -> V2<'m>) -> Self {
        let terms = self.0.into_iter();
        Self(
            terms
                .map(|(exponents, own)| (exponents, other(own)))
                .collect(),
        )
    }

    /// Times a real number.
    pub(super) fn scaled(self, factor: Ex<'m>) -> Self {
        self.map(|own| factor * own)
    }

    /// Times a complex number.
    pub(super) fn turned(self, factor: V2<'m>) -> Self {
        self.map(|own| own.turned(factor))
    }

    /// The conjugate of a unit vector is its inverse, the two variables of a point are each other's.
    pub(super) fn conjugate(&self, variables: &[Variable]) -> Self {
        let terms = self.0.iter().map(|(exponents, coefficient)| {
            let mut reflected = exponents.clone();
            for (place, variable) in variables.iter().enumerate() {
                match variable {
                    Variable::Unit => reflected[place] = -exponents[place],
                    Variable::Length | Variable::Number => {}
                    Variable::Point => reflected[place + 1] = exponents[place],
                    Variable::Conjugate => reflected[place - 1] = exponents[place],
                }
            }
            (reflected, coefficient.conjugate())
        });
        Self(terms.collect())
    }

    /// Without terms that cancel.
    pub(super) fn cleaned(self) -> Self {
        let mut cleaned = self.map(|own| {
            own.map(|x| {
                let zero = x.number(0.0);
                if numerically_equal(x, zero) { zero } else { x }
            })
        });
        cleaned.0.retain(|_, own| !own.is_zero());
        cleaned
    }
}

impl Add for Laurent<'_> {
    type Output = Self;

    fn add(mut self, other: Self) -> Self {
        for (exponents, coefficient) in other.0 {
            self.add_term(exponents, coefficient);
        }
        self
    }
}

impl Sub for Laurent<'_> {
    type Output = Self;

    fn sub(mut self, other: Self) -> Self {
        for (exponents, coefficient) in other.0 {
            self.add_term(exponents, -coefficient);
        }
        self
    }
}

impl<'m> Mul for &Laurent<'m> {
    type Output = Laurent<'m>;

    fn mul(self, other: Self) -> Laurent<'m> {
        let mut product = Laurent::default();
        for (m, &x) in &self.0 {
            for (n, &y) in &other.0 {
                let exponents = m.iter().zip(n).map(|(i, j)| i + j).collect();
                product.add_term(exponents, x.turned(y));
            }
        }
        product
    }
}
