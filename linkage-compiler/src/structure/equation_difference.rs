//! Multiples of equations: the factor by which terms cancel, and the difference.

use linkage_symbolic::{Ex, Monomial, Vector};

use crate::algebra::names::Names;
use crate::structure::equations::Coordinate;
use crate::structure::polynomials::Polynomials;
use crate::structure::{cancellation, equations, polynomials};

/// Returns the positions of a coordinate's symbols among those of polynomials.
pub(crate) fn symbol_range(
    names: &Names<'_>,
    coordinates: &[Coordinate],
    index: usize,
) -> std::ops::Range<usize> {
    let first = polynomials::first_symbol(names, coordinates, index);
    first..first + equations::symbols(names, &coordinates[index]).len()
}

/// Returns the multiple of the second equation with the same first term in the symbols of `range`:
/// 1, -1, or a quotient that is known before a call. That of two rows is a complex number.
pub(crate) fn ratio<'m>(
    minuend: &Polynomials<'m>,
    subtrahend: &Polynomials<'m>,
    range: std::ops::Range<usize>,
) -> Option<Vec<Ex<'m>>> {
    let mut monomials = minuend.rows.iter().flat_map(|row| row.keys());
    let first = monomials.find(|monomial| mentions(monomial, range.clone()))?;
    let (a, b) = (column(minuend, first)?, column(subtrahend, first)?);
    let number = |x: f64| a[0].number(x);
    let alike = |sign: f64| {
        let pairs = a.iter().zip(&b);
        pairs
            .into_iter()
            .all(|(&a, &b)| cancellation::equal(a, number(sign) * b))
    };
    let zero = || vec![number(0.0); a.len() - 1];
    for sign in [1.0, -1.0] {
        if alike(sign) {
            return Some([vec![number(sign)], zero()].concat());
        }
    }
    let is_fixed = a.iter().chain(&b).all(|x| x.is_fixed());
    if !is_fixed {
        let mut pairs = a.iter().zip(&b);
        let factor = pairs.find_map(|(&a, &b)| cancellation::ratio_of_terms(a, b))?;
        return Some([vec![factor], zero()].concat());
    }
    match (&a[..], &b[..]) {
        (&[a], &[b]) => Some(vec![a / b]),
        (&[x, y], &[u, v]) => Some(Vector([x, y]).turned_back(Vector([u, v])).0.to_vec()),
        _ => None,
    }
}

/// True if all terms in the symbols of `range` cancel.
pub(crate) fn cancels<'m>(
    minuend: &Polynomials<'m>,
    subtrahend: &Polynomials<'m>,
    ratio: &[Ex<'m>],
    range: std::ops::Range<usize>,
) -> bool {
    let rows = minuend.rows.iter().chain(&subtrahend.rows);
    let mut monomials = rows.flat_map(|row| row.keys());
    monomials.all(|monomial| {
        !mentions(monomial, range.clone())
            || difference_of_columns(minuend, subtrahend, ratio, monomial)
                .iter()
                .all(|x| x.is_zero())
    })
}

pub(crate) fn subtracted<'m>(
    minuend: &Polynomials<'m>,
    subtrahend: &Polynomials<'m>,
    ratio: &[Ex<'m>],
) -> Polynomials<'m> {
    let mut result = minuend.clone();
    let rows = minuend.rows.iter().chain(&subtrahend.rows);
    let mut monomials: Vec<&Monomial> = rows.flat_map(|row| row.keys()).collect();
    monomials.sort();
    monomials.dedup();
    for monomial in monomials {
        let column = difference_of_columns(minuend, subtrahend, ratio, monomial);
        for (row, coefficient) in result.rows.iter_mut().zip(column) {
            row.insert(monomial.clone(), coefficient);
        }
    }
    result
}

fn mentions(monomial: &Monomial, mut range: std::ops::Range<usize>) -> bool {
    range.any(|symbol| monomial[symbol] > 0)
}

/// Returns the coefficients of a monomial, one for each row.
fn column<'m>(polynomials: &Polynomials<'m>, monomial: &Monomial) -> Option<Vec<Ex<'m>>> {
    let found: Vec<Option<Ex<'m>>> = polynomials
        .rows
        .iter()
        .map(|row| row.get(monomial).copied())
        .collect();
    let zero = found.iter().flatten().next()?.number(0.0);
    Some(found.into_iter().map(|x| x.unwrap_or(zero)).collect())
}

/// Returns the coefficients of a monomial in a multiple of an equation.
fn multiple<'m>(coefficients: &[Ex<'m>], ratio: &[Ex<'m>]) -> Vec<Ex<'m>> {
    match (coefficients, ratio) {
        (&[x, y], &[u, v]) => Vector([x, y]).turned(Vector([u, v])).0.to_vec(),
        _ => coefficients.iter().map(|&x| ratio[0] * x).collect(),
    }
}

/// Returns the coefficients of a monomial in the difference, 0 where they cancel.
fn difference_of_columns<'m>(
    minuend: &Polynomials<'m>,
    subtrahend: &Polynomials<'m>,
    ratio: &[Ex<'m>],
    monomial: &Monomial,
) -> Vec<Ex<'m>> {
    let Some(b) = column(subtrahend, monomial) else {
        return column(minuend, monomial).unwrap_or_default();
    };
    let b = multiple(&b, ratio);
    let Some(a) = column(minuend, monomial) else {
        return b.into_iter().map(|x| -x).collect();
    };
    a.into_iter()
        .zip(b)
        .map(|(a, b)| cancellation::difference(a, b))
        .collect()
}
