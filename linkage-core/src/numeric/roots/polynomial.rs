//! The given equations as polynomials with exponents from zero up.

use super::rough_root::rough_root;
use super::system::{HIGHEST_DEGREE, MOST_VARIABLES, System, Unlisted, Variable};
use crate::numeric::complex::Complex;
use alloc::vec::Vec;

/// Terms smaller than this, compared with the largest of their equation, are rounding errors of
/// terms that vanish; a degree must not hang on them.
const NOTHING: f64 = 1e-15;

/// A polynomial in several variables; the terms have different exponents.
pub(super) struct Polynomial {
    pub(super) terms: Vec<Monomial>,
    /// Degree in every variable.
    pub(super) degrees: [u8; MOST_VARIABLES],
}

#[derive(Clone, Copy)]
pub(super) struct Monomial {
    pub(super) factor: Complex,
    pub(super) exponents: [u8; MOST_VARIABLES],
}

/// The polynomials of a system, scaled so that the squares of the coefficients of each add up to
/// about 1.
pub(super) fn collect(
    system: &System<'_>,
    coefficients: &[[f64; 2]],
) -> Result<Vec<Polynomial>, Unlisted> {
    let variables = system.variables;
    if variables.is_empty() {
        return Err(Unlisted::Degenerate);
    }
    if coefficients.iter().flatten().any(|part| !part.is_finite()) {
        return Err(Unlisted::NotFinite);
    }
    if variables.len() > MOST_VARIABLES {
        let degree = 0;
        return Err(too_large(variables, degree));
    }
    (0..variables.len())
        .map(|equation| {
            let terms = merged(system, coefficients, equation);
            let terms = scaled(terms).ok_or(Unlisted::Degenerate)?;
            from_laurent(variables, &terms)
        })
        .collect()
}

type Laurent<'a> = Vec<(&'a [i8], Complex)>;

/// The terms of one equation, those of equal exponents added up.
fn merged<'a>(system: &System<'a>, coefficients: &[[f64; 2]], equation: usize) -> Laurent<'a> {
    let mut terms: Laurent<'a> = Vec::new();
    for (term, &[re, im]) in system.terms.iter().zip(coefficients) {
        if term.equation != equation {
            continue;
        }
        let factor = Complex::new(re, im);
        match terms.iter_mut().find(|(e, _)| *e == term.exponents) {
            Some((_, known)) => *known += factor,
            None => terms.push((term.exponents, factor)),
        }
    }
    terms
}

/// The terms scaled; `None` if there is nothing.
fn scaled(mut terms: Laurent<'_>) -> Option<Laurent<'_>> {
    let largest = |terms: &Laurent<'_>| {
        let parts = terms.iter().map(|(_, c)| c.re.abs().max(c.im.abs()));
        parts.fold(0.0, f64::max)
    };
    let unit = largest(&terms);
    if !(unit > 0.0 && unit.is_finite()) {
        return None;
    }
    // Two divisions by numbers that cannot overflow, for units near the ends of the range too.
    for (_, factor) in &mut terms {
        *factor = Complex::new(factor.re / unit, factor.im / unit);
    }
    terms.retain(|(_, c)| c.square() > NOTHING * NOTHING);
    let norm = rough_root(terms.iter().map(|(_, c)| c.square()).sum());
    for (_, factor) in &mut terms {
        *factor = factor.scaled(1.0 / norm);
    }
    Some(terms)
}

/// Multiplies by powers of the variables: a unit vector is never zero, so that common factors of
/// unit vectors go; other variables may be zero, and only negative exponents are lifted.
fn from_laurent(variables: &[Variable], terms: &Laurent<'_>) -> Result<Polynomial, Unlisted> {
    let mut polynomial = Polynomial {
        terms: Vec::with_capacity(terms.len()),
        degrees: [0; MOST_VARIABLES],
    };
    let mut lowest = [0; MOST_VARIABLES];
    for (j, &variable) in variables.iter().enumerate() {
        let exponents = || terms.iter().map(|(e, _)| i32::from(e[j]));
        let (low, high) = (exponents().min(), exponents().max());
        let (low, high) = (low.unwrap_or(0), high.unwrap_or(0));
        lowest[j] = if variable == Variable::Unit {
            low
        } else {
            low.min(0)
        };
        let degree = high.max(lowest[j]) - lowest[j];
        if degree as usize > HIGHEST_DEGREE {
            return Err(too_large(variables, degree as usize));
        }
        polynomial.degrees[j] = degree as u8;
    }
    for (given, factor) in terms {
        let mut exponents = [0; MOST_VARIABLES];
        for (j, &exponent) in given.iter().enumerate() {
            exponents[j] = (i32::from(exponent) - lowest[j]) as u8;
        }
        let factor = *factor;
        polynomial.terms.push(Monomial { factor, exponents });
    }
    Ok(polynomial)
}

/// Adds variables that are 1 until there are `variables` of them.
pub(super) fn fill(target: &mut Vec<Polynomial>, variables: usize) {
    for j in target.len()..variables {
        let mut polynomial = Polynomial {
            terms: Vec::new(),
            degrees: [0; MOST_VARIABLES],
        };
        polynomial.degrees[j] = 1;
        for (exponent, factor) in [(0, -0.5), (1, 0.5)] {
            let mut exponents = [0; MOST_VARIABLES];
            exponents[j] = exponent;
            let factor = Complex::new(factor, 0.0);
            polynomial.terms.push(Monomial { factor, exponents });
        }
        target.push(polynomial);
    }
}

fn too_large(variables: &[Variable], degree: usize) -> Unlisted {
    Unlisted::TooLarge {
        variables: variables.len(),
        degree,
    }
}
