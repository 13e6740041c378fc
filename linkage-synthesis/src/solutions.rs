//! All solutions of polynomial equations, found from a single one.

mod family;
mod monodromy;
mod number;
mod polynomial_equations;
#[cfg(test)]
mod tests;
mod trace;

pub use number::Number;
pub use polynomial_equations::Equations;
pub use trace::Trace;

use super::ARCS;
use super::certificate::Certificate;
use super::error::Unsolved;
use family::Member;
use linkage_core::numeric::complex::Complex;
use monodromy::{Fibre, Random};
use std::vec::Vec;

/// The solutions of equations, and the evidence of their number.
#[derive(Clone, Debug, PartialEq)]
pub struct Solutions<const N: usize> {
    /// The real ones, in ascending order of the first unknown, then of the next ones.
    pub real: Vec<Solution<N>>,
    /// The number of complex ones.
    pub complex: usize,
    /// Solutions that almost all constants in place of the 0 give: each isolated solution is the
    /// end of one of their paths.
    pub general: usize,
    /// Paths without a certified end of their own, which end at infinity, in multiple solutions, or
    /// next to those.
    pub undecided: usize,
    /// Loops of the constants that have brought no further solution after the last one that did.
    pub idle: usize,
    /// The trace test, if it was asked for.
    pub trace: Option<Trace>,
}

/// A real solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution<const N: usize> {
    /// The unknowns.
    pub values: [f64; N],
    /// A bound of the error of each, rounding included: there is one solution so near.
    pub error: f64,
}

impl<const N: usize> Solutions<N> {
    /// Returns whether there are no others, as far as numbers can tell: each path has a certified
    /// end of its own, and the trace test was made and passed.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.undecided == 0 && self.trace.is_some_and(|trace| trace.passed())
    }
}

/// All solutions of polynomial equations: from a random complex place, which solves them with other
/// constants, by loops of the constants (monodromy), then along the way to the given ones. Each is
/// shown to be one, to differ from the others and to be real or not by Krawczyk's test. That none
/// is missing is not shown: see [`solutions_traced`].
///
/// The same equations always give the same listing, whatever the number of threads.
///
/// # Errors
///
/// `Singular` equations; `TooMany` solutions.
pub fn solutions<const N: usize>(equations: &impl Equations<N>) -> Result<Solutions<N>, Unsolved> {
    found(equations, None)
}

/// Solves as [`solutions`] does, with the trace test along equation `row`: its constant is the
/// coordinate of the curve that the test sums up. The degree of that curve, which takes most of the
/// time, may depend on the choice. Where the test leaves a point open along that equation, it is
/// made along the next ones, four at most: `trace` names the equation.
///
/// # Errors
///
/// As [`solutions`].
///
/// # Panics
///
/// If there is no equation `row`.
pub fn solutions_traced<const N: usize>(
    equations: &impl Equations<N>,
    row: usize,
) -> Result<Solutions<N>, Unsolved> {
    assert!(row < N, "no equation {row}: there are {N}");
    found(equations, Some(row))
}

fn found<E: Equations<N>, const N: usize>(
    equations: &E,
    row: Option<usize>,
) -> Result<Solutions<N>, Unsolved> {
    let given = Member::given(equations);
    let mut random = Random::new();
    let mut general = Fibre::find(&given, &mut random)?;
    let trace = row
        .map(|row| Trace::test_rows(&mut general, row, &mut random))
        .transpose()?;
    let found = ends(&general, given);
    let mut real: Vec<Solution<N>> = found
        .iter()
        .filter_map(Solution::from_certificate)
        .collect();
    real.sort_by(|a, b| {
        let order = a.values.partial_cmp(&b.values);
        order.unwrap_or(core::cmp::Ordering::Equal)
    });
    let is_complex = |certificate: &&Certificate<N>| certificate.real == Some(false);
    let complex = found.iter().filter(is_complex).count();
    let count = general.found.len();
    Ok(Solutions {
        undecided: count.saturating_sub(real.len() + complex),
        real,
        complex,
        general: count,
        idle: general.idle,
        trace,
    })
}

/// The solutions with the given constants.
fn ends<'a, E: Equations<N>, const N: usize>(
    general: &Fibre<'a, E, N>,
    given: Member<'a, E, N>,
) -> Vec<Certificate<N>> {
    let starts = general.places();
    let mut ends = Fibre::starting(given);
    for angle in ARCS {
        ends.follow(&general.member, &starts, Complex::polar(angle));
        if ends.found.len() >= starts.len() {
            break;
        }
    }
    ends.found
}

impl<const N: usize> Solution<N> {
    /// Returns a real solution.
    fn from_certificate(certificate: &Certificate<N>) -> Option<Self> {
        (certificate.real == Some(true)).then(|| Self {
            values: certificate.discs.map(|disc| disc.middle.re),
            error: certificate
                .discs
                .iter()
                .map(|disc| disc.radius)
                .fold(0.0, f64::max),
        })
    }
}
