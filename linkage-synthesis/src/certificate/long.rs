//! The test with 77 digits, for solutions next to others and far away ones, where Jacobians of
//! plain numbers are singular.

use super::{Certificate, Evaluated, System, contracted, decided, times};
use crate::ball::Ball;
use crate::dense;
use crate::long::Long;
use crate::real::Real;
use linkage_core::numeric::complex::Complex;
use std::vec::Vec;

type LongPoint<const N: usize> = [Complex<Long>; N];

/// Newton steps: six double 77 digits' worth, the others are for places that are further from the
/// solution than this is from another one. Near a double solution they only halve the distance.
const STEPS: usize = 16;
/// Newton steps below this part of the place, 2^-192, are rounding.
const SMALL: f64 = 1.0 / ((1_u128 << 96) as f64 * (1_u128 << 96) as f64);

/// Certifies as `certify` does, near `start`.
pub(in super::super) fn certify_long<const N: usize, S: System<N>>(
    start: &[Complex; N],
    system: &S,
) -> Option<Certificate<N>> {
    let finite = |number: &Complex| number.re.is_finite() && number.im.is_finite();
    if !start.iter().all(finite) {
        return None;
    }
    let point = refined(start, system)?;
    let half = Complex::from(0.5).map(Long::exact);
    let far = |disc: Ball<Long>, image| disc.is_far_from(image);
    let (discs, real) =
        decided::<N, S, _, _>(&point, half, far, |point| one_solution(point, system))?;
    Some(Certificate {
        discs: discs.map(Ball::narrow),
        real,
    })
}

/// Refines by Newton's method.
fn refined<const N: usize, S: System<N>>(start: &[Complex; N], system: &S) -> Option<LongPoint<N>> {
    let mut point = start.map(|number| number.map(Long::exact));
    for _ in 0..STEPS {
        let (values, matrix) = system.long(&point.map(Ball::exact))?;
        let right = values.iter().map(|value| [-value.middle]).collect();
        let step = dense::solve_long(middles(&matrix), right)?;
        let mut small = true;
        for (number, [step]) in point.iter_mut().zip(step) {
            *number += step;
            small &= step.map(Long::narrow).size() <= SMALL * number.map(Long::narrow).size();
        }
        if small {
            break;
        }
    }
    Some(point)
}

fn one_solution<const N: usize, S: System<N>>(
    point: &LongPoint<N>,
    system: &S,
) -> Option<[Ball<Long>; N]> {
    let there = point.map(Ball::exact);
    let (values, matrix): Evaluated<N> = system.long(&there)?;
    let unit = (0..N).map(|row| {
        core::array::from_fn(|column| {
            Complex::from(f64::from(u8::from(row == column))).map(Long::exact)
        })
    });
    let inverse = dense::solve_long(middles(&matrix), unit.collect())?;
    let shift = times(&inverse, &values).map(Ball::size);
    contracted::<N, S, Long>(&there, &inverse, &shift, |discs| {
        system.long(discs).map(|(_, matrix)| matrix)
    })
}

fn middles<const N: usize>(matrix: &[[Ball<Long>; N]; N]) -> Vec<LongPoint<N>> {
    matrix
        .iter()
        .map(|row| row.map(|element| element.middle))
        .collect()
}
