//! Proof that a system of equations has one solution near a point, and that it is real or is not.
//!
//! Krawczyk's operator on discs: with `A` about the inverse of the Jacobian at the point, `x - A
//! f(x)` takes the product of the discs into itself and contracts it, rounding included. Then
//! (Banach) it has one fixed point there, a solution of `f`. Data that are not exact are discs,
//! too: the proof then holds for all of them.
//!
//! A real solution is its own mirror image: a variable is the conjugate of its partner, which is
//! itself if it stands for a real number.

mod long;

use super::ball::Ball;
use super::long::Long;
use super::real::Real;
use linkage_core::numeric::complex::{Complex, Ring};
use linkage_core::numeric::complex_matrix;
use linkage_core::numeric::double_double::DoubleDouble;
pub(super) use long::certify_long;

/// A system of as many equations as unknowns.
pub(super) trait System<const N: usize> {
    /// The variable that is the conjugate of this one in a real solution: they come in pairs, if
    /// nothing else is said.
    fn partner(i: usize) -> usize {
        i ^ 1
    }

    /// The values at a point, with all that rounding and the data leave open.
    fn values(&self, point: &Point<N>) -> [Ball; N];

    /// The Jacobian at all points of the discs.
    fn matrix(&self, discs: &[Ball; N]) -> [[Ball; N]; N];

    /// Values and Jacobian with 77 digits, of equations whose data are exact: others are not known
    /// any better.
    fn long(&self, _discs: &[Ball<Long>; N]) -> Option<Evaluated<N>> {
        None
    }
}

/// Values and, by rows, derivatives.
pub(super) type Evaluated<const N: usize> = ([Ball<Long>; N], [[Ball<Long>; N]; N]);

/// A point with more digits than the solutions have: next to singular points the values need them.
pub(super) type Point<const N: usize> = [Complex<DoubleDouble>; N];

/// Discs around a solution; it is the only one in them, or in smaller ones that plain numbers do
/// not tell from a point.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Certificate<const N: usize> {
    pub(super) discs: [Ball; N],
    /// True for a real solution, false for a complex one; nothing if undecided.
    pub(super) real: Option<bool>,
}

impl<const N: usize> Certificate<N> {
    /// Returns whether the solutions of both are two.
    pub(super) fn is_apart_from(&self, other: &Self) -> bool {
        let mut pairs = self.discs.iter().zip(&other.discs);
        pairs.any(|(a, b)| a.is_apart_from(*b))
    }
}

/// The number of times that discs are widened; a solution without a proof by then is too close to a
/// singular point.
const ATTEMPTS: usize = 4;

/// Looks for discs around `point` in which `system` has one solution.
pub(super) fn certify<const N: usize, S: System<N>>(
    point: &Point<N>,
    system: &S,
) -> Option<Certificate<N>> {
    let half = Complex::from(0.5).wide();
    let apart = |disc: Ball, image| disc.is_apart_from(image);
    let (discs, real) =
        decided::<N, S, _, _>(point, half, apart, |point| one_solution(point, system))?;
    Some(Certificate { discs, real })
}

/// Discs around a solution, and whether it is real; nothing if undecided.
type Decided<const N: usize, R> = ([Ball<R>; N], Option<bool>);

/// Decides whether the solution near `point` is real. `apart` tests that two discs are, and
/// `one_solution` gives discs with one solution.
fn decided<const N: usize, S: System<N>, P: Ring, R: Real>(
    point: &[Complex<P>; N],
    half: Complex<P>,
    apart: impl Fn(Ball<R>, Ball<R>) -> bool,
    one_solution: impl Fn(&[Complex<P>; N]) -> Option<[Ball<R>; N]>,
) -> Option<Decided<N, R>> {
    let discs = one_solution(point)?;
    let images = core::array::from_fn::<_, N, _>(|i| discs[S::partner(i)].conjugate());
    if discs
        .iter()
        .zip(images)
        .any(|(&disc, image)| apart(disc, image))
    {
        return Some((discs, Some(false)));
    }
    // Discs that are their own mirror image hold the mirror image of their only solution.
    let middle = core::array::from_fn(|i| (point[i] + point[S::partner(i)].conjugate()) * half);
    Some(match one_solution(&middle) {
        Some(discs) => (discs, Some(true)),
        None => (discs, None),
    })
}

/// Refines a solution by Newton's steps with residuals of twice the digits. The error is the last
/// point, where the matrix is singular.
pub(super) fn refined<const N: usize>(
    start: &[Complex; N],
    steps: usize,
    values: impl Fn(&Point<N>) -> [Complex; N],
    matrix: impl Fn(&[Complex; N]) -> complex_matrix::Matrix<N>,
) -> Result<Point<N>, Point<N>> {
    let mut point = start.map(Complex::wide);
    for _ in 0..steps {
        let mut right = [values(&point).map(|value| -value)];
        let mut matrix = matrix(&point.map(Complex::narrow));
        if complex_matrix::solve_scaled(&mut matrix, &mut right) == 0.0 {
            return Err(point);
        }
        point = core::array::from_fn(|i| point[i] + right[0][i].wide());
    }
    Ok(point)
}

fn one_solution<const N: usize, S: System<N>>(point: &Point<N>, system: &S) -> Option<[Ball; N]> {
    let there = point.map(Ball::from_wide);
    let matrix = system.matrix(&there);
    let inverse = complex_matrix::inverse(&matrix.map(|row| row.map(|element| element.middle)))?;
    let shift = times(&inverse, &system.values(point)).map(Ball::size);
    contracted::<N, S, f64>(&there, &inverse, &shift, |discs| Some(system.matrix(discs)))
}

/// Discs around `there` that the map `x - inverse f(x)` takes into themselves; `shift` bounds
/// `inverse f` at their middle.
fn contracted<const N: usize, S: System<N>, R: Real>(
    there: &[Ball<R>; N],
    inverse: &[[Complex<R>; N]],
    shift: &[f64; N],
    matrix: impl Fn(&[Ball<R>; N]) -> Option<[[Ball<R>; N]; N]>,
) -> Option<[Ball<R>; N]> {
    // Twice the Newton step, so that there is room for the other terms.
    let mut radii = pairs::<N, S>(|i| 2.0 * shift[i] + f64::MIN_POSITIVE);
    for _ in 0..ATTEMPTS {
        let discs = core::array::from_fn(|i| there[i].widened(radii[i]));
        let spread = spread(inverse, &matrix(&discs)?, &radii);
        let image: [f64; N] =
            core::array::from_fn(|i| (shift[i] + spread[i]) * (1.0 + 4.0 * f64::EPSILON));
        let inside = image
            .iter()
            .zip(&radii)
            .all(|(image, radius)| image < radius);
        if inside {
            return Some(discs);
        }
        radii = pairs::<N, S>(|i| 2.0 * image[i]);
    }
    None
}

/// The larger one for both of a pair.
fn pairs<const N: usize, S: System<N>>(radius: impl Fn(usize) -> f64) -> [f64; N] {
    core::array::from_fn(|i| radius(i).max(radius(S::partner(i))))
}

fn times<const N: usize, R: Real>(
    matrix: &[[Complex<R>; N]],
    vector: &[Ball<R>; N],
) -> [Ball<R>; N] {
    core::array::from_fn(|i| {
        let terms = matrix[i].iter().zip(vector);
        terms.fold(0.0.into(), |sum: Ball<R>, (&a, &b)| {
            sum + Ball::exact(a) * b
        })
    })
}

/// `|1 - A J|` times the radii.
fn spread<const N: usize, R: Real>(
    inverse: &[[Complex<R>; N]],
    matrix: &[[Ball<R>; N]; N],
    radii: &[f64; N],
) -> [f64; N] {
    core::array::from_fn(|i| {
        let mut row: [Ball<R>; N] = [0.0.into(); N];
        row[i] = (-1.0).into();
        for (&a, elements) in inverse[i].iter().zip(matrix) {
            for (sum, &element) in row.iter_mut().zip(elements) {
                if !element.is_zero() {
                    *sum = *sum + Ball::exact(a) * element;
                }
            }
        }
        let terms = row
            .iter()
            .zip(radii)
            .map(|(element, radius)| element.size() * radius);
        // Rounding of a sum of N products, amply.
        terms.sum::<f64>() * (1.0 + 4.0 * N as f64 * f64::EPSILON)
    })
}
