//! The equations of a path in numbers of about 32 digits.

use super::super::polynomial::Polynomial;
use super::super::start_system::{self, Univariate};
use crate::numeric::complex::{Complex, ONE, ZERO};
use crate::numeric::complex_matrix::Vector;
use crate::numeric::double_double::DoubleDouble;
use alloc::vec::Vec;

/// A point.
pub(super) type Point<const N: usize> = [Wide; N];

/// A complex number of about 32 digits.
type Wide = Complex<DoubleDouble>;

/// `(1 - t) * target + t * start`, of the same coefficients as the homotopy that has been followed
/// so far.
#[derive(Clone)]
pub(super) struct Equations<const N: usize> {
    equations: [Equation<N>; N],
    /// Coordinates that are inverses of their variables.
    pub(super) flipped: [bool; N],
}

#[derive(Clone)]
struct Equation<const N: usize> {
    terms: Vec<(Wide, [u8; N])>,
    degrees: [u8; N],
    factors: [Univariate; N],
    constant: Complex,
}

/// The rounding errors of a coefficient, amply, as a part of it.
const ROUNDING: f64 = 1e-15;
/// A unit number that is no root of 1.
const RADIAN: Complex = Complex::new(0.540_302_305_868_139_8, 0.841_470_984_807_896_5);

impl<const N: usize> Equations<N> {
    pub(super) fn new(target: &[Polynomial], attempt: usize) -> Self {
        let factors = start_system::factors::<N>(target, attempt);
        let constants = start_system::constants::<N>(attempt);
        let narrow = |wide: &[u8]| core::array::from_fn(|j| wide[j]);
        let terms = |i: usize| target[i].terms.iter();
        let equation = |i: usize| Equation {
            terms: terms(i)
                .map(|term| (term.factor.wide(), narrow(&term.exponents)))
                .collect(),
            degrees: narrow(&target[i].degrees),
            factors: factors[i],
            constant: constants[i],
        };
        Self {
            equations: core::array::from_fn(equation),
            flipped: [false; N],
        }
    }

    /// The same with every coefficient changed by a rounding, in directions that have nothing to do
    /// with each other or, with the other sign, against these.
    pub(super) fn changed(&self, sign: f64) -> Self {
        let mut changed = self.clone();
        let mut direction = ONE;
        let terms = changed
            .equations
            .iter_mut()
            .flat_map(|equation| &mut equation.terms);
        for (factor, _) in terms {
            direction = direction * RADIAN;
            *factor = *factor + *factor * direction.scaled(sign * ROUNDING).wide();
        }
        changed
    }

    /// Returns the errors of the equations at a point: little compared with their terms, so that 16
    /// digits are enough.
    pub(super) fn values(&self, x: &Point<N>, t: f64) -> Vector<N> {
        let powers: [Vec<Wide>; N] = core::array::from_fn(|j| self.powers(x, j));
        core::array::from_fn(|i| {
            let equation = &self.equations[i];
            let target = equation.target(&powers, &self.flipped);
            let start = equation.start(x, &self.flipped);
            (target + (start - target).scaled(t.into())).narrow()
        })
    }

    fn powers(&self, x: &Point<N>, j: usize) -> Vec<Wide> {
        let degrees = self.equations.iter().map(|equation| equation.degrees[j]);
        let highest = usize::from(degrees.max().unwrap_or(0));
        let next = |power: &Wide| Some(*power * x[j]);
        let all = core::iter::successors(Some(ONE.wide()), next);
        all.take(highest + 1).collect()
    }
}

impl<const N: usize> Equation<N> {
    fn target(&self, powers: &[Vec<Wide>; N], flipped: &[bool; N]) -> Wide {
        let mut sum = ZERO.wide();
        for (factor, exponents) in &self.terms {
            let mut product = *factor;
            for j in 0..N {
                let exponent = match flipped[j] {
                    true => self.degrees[j] - exponents[j],
                    false => exponents[j],
                };
                if exponent > 0 {
                    product = product * powers[j][usize::from(exponent)];
                }
            }
            sum += product;
        }
        sum
    }

    fn start(&self, x: &Point<N>, flipped: &[bool; N]) -> Wide {
        let mut product = self.constant.wide();
        for (factor, (x, flipped)) in self.factors.iter().zip(x.iter().zip(flipped)) {
            let mut coefficients = factor.coefficients;
            let coefficients = &mut coefficients[..=usize::from(factor.degree)];
            if *flipped {
                coefficients.reverse();
            }
            let from_highest = coefficients.iter().rev();
            let value = from_highest.fold(ZERO.wide(), |value, coefficient| {
                value * *x + coefficient.wide()
            });
            product = product * value;
        }
        product
    }
}
