//! Laurent polynomials in unit vectors, lengths and points, with which the tests write their
//! equations as they would be written by hand.

use linkage_core::numeric::roots::{Listing, System, Term, Unlisted, Variable, solve};
use std::collections::BTreeMap;

pub(crate) use linkage_core::numeric::complex::Complex;

pub(crate) const fn complex(re: f64, im: f64) -> Complex {
    Complex::new(re, im)
}

pub(crate) fn unit(angle: f64) -> Complex {
    Complex::polar(angle)
}

/// A sum of products of powers of the variables.
#[derive(Clone, Debug)]
pub(crate) struct Laurent {
    terms: BTreeMap<Vec<i8>, Complex>,
}

impl Laurent {
    pub(crate) fn constant(value: Complex, variables: usize) -> Self {
        Self {
            terms: BTreeMap::from([(vec![0; variables], value)]),
        }
    }

    pub(crate) fn variable(index: usize, variables: usize) -> Self {
        let mut exponents = vec![0; variables];
        exponents[index] = 1;
        Self {
            terms: BTreeMap::from([(exponents, complex(1.0, 0.0))]),
        }
    }

    pub(crate) fn plus(&self, other: &Self) -> Self {
        let mut sum = self.clone();
        for (exponents, value) in &other.terms {
            let known = sum
                .terms
                .entry(exponents.clone())
                .or_insert(complex(0.0, 0.0));
            *known += *value;
        }
        sum
    }

    pub(crate) fn scaled(&self, factor: Complex) -> Self {
        let mut product = self.clone();
        for value in product.terms.values_mut() {
            *value = *value * factor;
        }
        product
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(complex(-1.0, 0.0)))
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = Self {
            terms: BTreeMap::new(),
        };
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                let exponents = a.iter().zip(b).map(|(a, b)| a + b).collect();
                let terms = BTreeMap::from([(exponents, *x * *y)]);
                product = product.plus(&Self { terms });
            }
        }
        product
    }

    /// The conjugate at real values of the variables.
    pub(crate) fn conjugate(&self, variables: &[Variable]) -> Self {
        let mut terms = BTreeMap::new();
        for (exponents, value) in &self.terms {
            let exponents = (0..variables.len()).map(|j| match variables[j] {
                Variable::Unit => -exponents[j],
                Variable::Length | Variable::Number => exponents[j],
                Variable::Point => exponents[j + 1],
                Variable::Conjugate => exponents[j - 1],
            });
            terms.insert(exponents.collect(), value.conjugate());
        }
        Self { terms }
    }

    /// Square of the absolute value.
    pub(crate) fn square(&self, variables: &[Variable]) -> Self {
        self.times(&self.conjugate(variables))
    }

    /// Twice the imaginary part.
    pub(crate) fn imaginary(&self, variables: &[Variable]) -> Self {
        let difference = self.minus(&self.conjugate(variables));
        difference.scaled(complex(0.0, -1.0))
    }
}

/// A system ready to be solved.
pub(crate) struct Equations {
    pub(crate) variables: Vec<Variable>,
    pub(crate) exponents: Vec<(usize, Vec<i8>)>,
    pub(crate) coefficients: Vec<[f64; 2]>,
}

impl Equations {
    pub(crate) fn new(variables: &[Variable], equations: &[Laurent]) -> Self {
        let mut system = Self {
            variables: variables.to_vec(),
            exponents: Vec::new(),
            coefficients: Vec::new(),
        };
        for (index, equation) in equations.iter().enumerate() {
            for (exponents, value) in &equation.terms {
                system.exponents.push((index, exponents.clone()));
                system.coefficients.push([value.re, value.im]);
            }
        }
        system
    }

    pub(crate) fn solve(&self) -> Result<Listing, Unlisted> {
        let terms = self.terms();
        let system = System {
            variables: &self.variables,
            terms: &terms,
        };
        solve(&system, &self.coefficients)
    }

    pub(crate) fn terms(&self) -> Vec<Term<'_>> {
        let terms = self.exponents.iter().map(|(equation, exponents)| Term {
            equation: *equation,
            exponents,
        });
        terms.collect()
    }
}
