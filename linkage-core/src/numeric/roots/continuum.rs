//! The test whether a multiple solution is one of a continuum.

use super::homotopy::Homotopy;
use super::projective::ProjectivePoint;
use super::rough_root::rough_root;
use crate::numeric::complex::{Complex, ZERO};
use crate::numeric::complex_matrix::{Matrix, Vector, solve};

/// Equations that some way off a solution are missed by less than this share of their terms hold
/// there too: some hundred roundings, since those of which six solutions meet are missed by no more
/// than `1e-11`.
const HOLDS: f64 = 1e-13;
/// Pivots below this are those of a singular matrix.
const SINGULAR: f64 = 1e-6;

/// Returns whether solutions go on beside a multiple one: along the direction in which the matrix
/// is singular, the equations hold to rounding errors not only here but also some way off.
pub(super) fn is_continuum<const N: usize>(
    homotopy: &mut Homotopy<N>,
    point: &ProjectivePoint<N>,
) -> bool {
    homotopy.turn(point.flipped);
    let Some(along) = weakest_component(homotopy, &point.x) else {
        return true;
    };
    [Complex::new(0.02, 0.01), Complex::new(-0.01, 0.02)]
        .into_iter()
        .all(|offset| slack(homotopy, &point.x, along, offset).is_none_or(|s| s < HOLDS))
}

/// The coordinate that changes most along the direction in which the matrix is singular; `None`
/// if there is no single one.
fn weakest_component<const N: usize>(homotopy: &mut Homotopy<N>, x: &Vector<N>) -> Option<usize> {
    let (_, matrix) = homotopy.target(x);
    let sizes = |j: usize| {
        let mut others = matrix;
        for (i, row) in others.iter_mut().enumerate() {
            row[j] = weight(i);
        }
        solve(&mut others, &mut [[ZERO; N]])
    };
    let best = (0..N).max_by(|&a, &b| sizes(a).total_cmp(&sizes(b)))?;
    (sizes(best) > SINGULAR * SINGULAR).then_some(best)
}

/// Returns the error of the equations, in a fixed combination of them and as a share of their
/// terms, at the nearest point with the coordinate `along` moved by `offset`. `None` if there is no
/// such point.
fn slack<const N: usize>(
    homotopy: &mut Homotopy<N>,
    x: &Vector<N>,
    along: usize,
    offset: Complex,
) -> Option<f64> {
    const STEPS: usize = 8;
    let mut x = *x;
    x[along] += offset;
    let mut slack = ZERO;
    let mut terms = 0.0;
    for _ in 0..STEPS {
        let (values, mut matrix) = homotopy.target(&x);
        terms = largest_term(&matrix, &x);
        let mut right = [core::array::from_fn(|i| -(values[i] + weight(i) * slack))];
        for (i, row) in matrix.iter_mut().enumerate() {
            row[along] = weight(i);
        }
        if solve(&mut matrix, &mut right) == 0.0 {
            return None;
        }
        for j in 0..N {
            if j == along {
                slack += right[0][j];
            } else {
                x[j] += right[0][j];
            }
        }
    }
    Some(rough_root(slack.square() / terms))
}

/// The square of the largest change of an equation with a coordinate as a whole: about that of its
/// terms. Where all coordinates are small, far out, equations are missed by little wherever that
/// is.
fn largest_term<const N: usize>(matrix: &Matrix<N>, x: &Vector<N>) -> f64 {
    let row = |row: &Vector<N>| {
        let terms = row.iter().zip(x).map(|(slope, x)| (*slope * *x).square());
        terms.fold(0.0, f64::max)
    };
    matrix.iter().map(row).fold(0.0, f64::max)
}

/// Some numbers that no combination of equations has by itself.
fn weight(row: usize) -> Complex {
    Complex::new(1.0 - 0.173 * row as f64, 0.317 + 0.211 * row as f64)
}
