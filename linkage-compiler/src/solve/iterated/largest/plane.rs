//! Loops of the plane: links and guides are joints of one direction each, whatever turns with several is a body.
//!
//! A joint's direction is `(e^(i a) + e^(-i a))/2` of complex numbers, and the determinant is linear in it. So it is a sum over the choices of
//! one of both for each joint, with a factor that depends on the bodies alone; the sum of the sizes is the largest value. For a link with three
//! joints that is half of what it measures around them.

use crate::solve::iterated::largest;
use crate::solve::iterated::largest::parts;
use linkage_symbolic::{Ex, V2, Vector, numerically_equal};

use crate::solve::Solver;

use super::super::equations::Equations;
use super::parts::{Parts, Shares};

/// More bodies than this are measured by the lengths of their columns: a determinant of complex numbers has `n 2^n` products.
const MOST_BODIES: usize = 4;

/// Sums of loops in which joints are eliminated.
struct Eliminated<'m> {
    sums: Vec<Shares<'m>>,
    /// What the determinant is multiplied by.
    factor: Ex<'m>,
}

/// See [`Solver::largest_core_determinant`].
pub(super) fn largest_in_plane<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
) -> Ex<'m> {
    let blocks = &equations.form.blocks;
    let weights = blocks
        .iter()
        .map(|block| largest::weight(solver, equations, block));
    let across = weights.fold(solver.algebra.one(), |size, weight| size * weight);
    let parts = parts::parts(solver, equations);
    across * parts.size * sum_over_choices(solver, &parts, blocks.len())
}

fn sum_over_choices<'m>(solver: &Solver<'_, 'm>, parts: &Parts<'m>, loops: usize) -> Ex<'m> {
    let mut sum = solver.algebra.zero();
    // The opposite choice for all joints has the conjugate factor: one for the last joint stands for both.
    let choices = 1_u32 << parts.joints.len();
    let different = choices.div_ceil(2);
    for choice in 0..different {
        let halves = [0, 1].map(|side| {
            let joints = parts.joints.iter().enumerate();
            let own = joints.filter(|(k, _)| choice >> k & 1 == side);
            eliminated(solver, loops, own.map(|(_, shares)| shares))
        });
        let [Some(plain), Some(conjugate)] = halves else {
            continue;
        };
        let below = rows(solver, &conjugate, parts).into_iter();
        let below = below.map(|row| row.into_iter().map(V2::conjugate).collect());
        let rows: Vec<Vec<V2>> = rows(solver, &plain, parts)
            .into_iter()
            .chain(below)
            .collect();
        sum += plain.factor * conjugate.factor * size_of_determinant(solver, &rows);
    }
    // A row of complex numbers and its conjugate are twice the two rows of real numbers.
    let rows = 2.0_f64.powi(loops as i32);
    f64::from(choices / different) / rows * sum
}

/// Elimination of joints from the loops; none if their shares depend on each other.
fn eliminated<'m, 's>(
    solver: &Solver<'_, 'm>,
    loops: usize,
    joints: impl Iterator<Item = &'s Shares<'m>>,
) -> Option<Eliminated<'m>>
where
    'm: 's,
{
    let zero = solver.algebra.zero();
    let mut sums: Vec<Shares> = (0..loops)
        .map(|own| parts::unit(solver, own, loops))
        .collect();
    let mut factor = solver.algebra.one();
    for joint in joints {
        let shares = sums.iter().map(|sum| {
            let products = sum.iter().zip(joint).map(|(&a, &b)| a * b);
            let share = products.fold(zero, |sum, x| sum + x);
            if numerically_equal(share, zero) {
                zero
            } else {
                share
            }
        });
        let mut shares: Vec<Ex> = shares.collect();
        let pivot = shares.iter().position(|share| !share.is_zero())?;
        let (own, taken) = (shares.swap_remove(pivot), sums.swap_remove(pivot));
        factor = factor * own.abs();
        for (sum, share) in sums.iter_mut().zip(shares) {
            let ratio = share / own;
            for (x, &y) in sum.iter_mut().zip(&taken) {
                *x -= ratio * y;
            }
        }
    }
    Some(Eliminated { sums, factor })
}

/// The bodies' columns in sums of loops, as complex numbers.
fn rows<'m>(solver: &Solver<'_, 'm>, from: &Eliminated<'m>, parts: &Parts<'m>) -> Vec<Vec<V2<'m>>> {
    let zero = Vector([solver.algebra.zero(); 2]);
    let entry = |sum: &Shares<'m>, body: &[V2<'m>]| {
        let shares = sum.iter().zip(body);
        shares.fold(zero, |entry, (&share, &v)| entry + share * v)
    };
    let rows = from.sums.iter();
    rows.map(|sum| parts.bodies.iter().map(|body| entry(sum, body)).collect())
        .collect()
}

/// The size of a determinant of complex numbers.
fn size_of_determinant<'m>(solver: &Solver<'_, 'm>, rows: &[Vec<V2<'m>>]) -> Ex<'m> {
    let one = solver.algebra.one();
    if rows.len() > MOST_BODIES {
        let columns = (0..rows.len()).map(|k| {
            let squares = rows.iter().map(|row| row[k].square());
            squares.fold(solver.algebra.zero(), |sum, x| sum + x).sqrt()
        });
        return columns.fold(one, |product, length| product * length);
    }
    match rows {
        [] => one,
        rows => complex_minor(rows, (1 << rows.len()) - 1).length(),
    }
}

/// The determinant of the last rows, at least one, and the columns in a set.
fn complex_minor<'m>(rows: &[Vec<V2<'m>>], columns: u32) -> V2<'m> {
    let (first, below) = (&rows[0], &rows[1..]);
    let among = (0..first.len()).filter(|k| columns >> k & 1 == 1);
    let products = among.enumerate().map(|(place, column)| {
        let product = match below {
            [] => first[column],
            below => first[column].turned(complex_minor(below, columns & !(1 << column))),
        };
        if place % 2 == 0 { product } else { -product }
    });
    let sum = products.reduce(|sum, product| sum + product);
    sum.expect("as many columns as rows")
}
