//! The equations between the start system (`t` = 1) and the given one (`t` = 0).

use super::evaluation::Evaluation;
use super::polynomial::Polynomial;
use super::projective::ProjectivePoint;
use super::quadratic::Quadratics;
use super::start_system::{self, Univariate};
use super::system::HIGHEST_DEGREE;
use crate::numeric::complex::{Complex, ONE, ZERO};
use crate::numeric::complex_matrix::{Matrix, Vector};
use alloc::vec::Vec;

/// `(1 - t) * target + t * start`, in coordinates of which each is a variable or its inverse.
///
/// In general the equations are lists of terms, of which few have all variables.
pub(super) struct Homotopy<const N: usize> {
    equations: [Equation<N>; N],
    factors: [[Univariate; N]; N],
    constants: Vector<N>,
    /// Coordinates that are inverses of their variables.
    flipped: [bool; N],
    /// Highest degree of every variable.
    highest: [usize; N],
    powers: [Powers; N],
    /// Used in place of the terms and factors where the equations have this form.
    quadratics: Option<Quadratics>,
}

struct Equation<const N: usize> {
    terms: Vec<Term<N>>,
    degrees: [u8; N],
}

#[derive(Clone, Copy)]
struct Term<const N: usize> {
    factor: Complex,
    exponents: [u8; N],
}

/// Powers of a coordinate and their derivatives.
#[derive(Clone, Copy)]
struct Powers {
    values: [Complex; HIGHEST_DEGREE + 1],
    slopes: [Complex; HIGHEST_DEGREE + 1],
}

impl<const N: usize> Homotopy<N> {
    pub(super) fn new(target: &[Polynomial], attempt: usize) -> Self {
        let narrow = |wide: &[u8]| core::array::from_fn(|j| wide[j]);
        let equations = core::array::from_fn(|i| Equation {
            terms: target[i]
                .terms
                .iter()
                .map(|term| Term {
                    factor: term.factor,
                    exponents: narrow(&term.exponents),
                })
                .collect(),
            degrees: narrow(&target[i].degrees),
        });
        let highest = |j: usize| target.iter().map(|p| p.degrees[j]).max();
        let mut powers = Powers {
            values: [ZERO; HIGHEST_DEGREE + 1],
            slopes: [ZERO; HIGHEST_DEGREE + 1],
        };
        powers.values[0] = ONE;
        powers.slopes[1] = ONE;
        let factors = start_system::factors(target, attempt);
        let constants = start_system::constants(attempt);
        let quadratics = Quadratics::new(target, &factors, &constants);
        Self {
            quadratics,
            equations,
            factors,
            constants,
            flipped: [false; N],
            highest: core::array::from_fn(|j| highest(j).unwrap_or(0).into()),
            powers: [powers; N],
        }
    }

    /// The solutions at `t` = 1; no coordinate is an inverse there.
    pub(super) fn starts(&mut self) -> Vec<Vector<N>> {
        self.turn([false; N]);
        start_system::solutions(&self.factors)
    }

    pub(super) fn projective_point(&self, x: Vector<N>) -> ProjectivePoint<N> {
        let flipped = self.flipped;
        ProjectivePoint { x, flipped }
    }

    /// Changes to other coordinates.
    pub(super) fn turn(&mut self, flipped: [bool; N]) {
        for (j, &flipped) in flipped.iter().enumerate() {
            if self.flipped[j] != flipped {
                self.flip(j);
            }
        }
    }

    /// Takes the inverse of a coordinate as a coordinate.
    pub(super) fn flip(&mut self, j: usize) {
        self.flipped[j] = !self.flipped[j];
        if let Some(quadratics) = &mut self.quadratics {
            quadratics.flip(j);
            return;
        }
        for equation in &mut self.equations {
            for term in &mut equation.terms {
                term.exponents[j] = equation.degrees[j] - term.exponents[j];
            }
        }
        for row in &mut self.factors {
            let degree = row[j].degree as usize;
            row[j].coefficients[..=degree].reverse();
        }
    }

    /// The given equations and their derivatives.
    #[inline(always)]
    pub(super) fn target(&mut self, x: &Vector<N>) -> (Vector<N>, Matrix<N>) {
        match &self.quadratics {
            Some(quadratics) => quadratics.target(x),
            None => self.sparse_target(x),
        }
    }

    /// The equations at a point of a path.
    #[inline(always)]
    pub(super) fn evaluate(&mut self, x: &Vector<N>, t: f64) -> Evaluation<N> {
        match &self.quadratics {
            Some(quadratics) => quadratics.evaluate(x, t),
            None => self.sparse_evaluate(x, t),
        }
    }

    /// The same for a `t` that is not real.
    pub(super) fn evaluate_beside(&mut self, x: &Vector<N>, t: Complex) -> Evaluation<N> {
        let (target, mut matrix) = self.target(x);
        // There is nothing but the start system at 1.
        let start = self.evaluate(x, 1.0);
        for (row, start) in matrix.iter_mut().zip(&start.matrix) {
            for (slope, start) in row.iter_mut().zip(start) {
                *slope += (*start - *slope) * t;
            }
        }
        let drift: Vector<N> = core::array::from_fn(|i| start.values[i] - target[i]);
        Evaluation {
            values: core::array::from_fn(|i| target[i] + drift[i] * t),
            matrix,
            drift,
        }
    }

    #[inline(never)]
    fn sparse_target(&mut self, x: &Vector<N>) -> (Vector<N>, Matrix<N>) {
        for (powers, (&x, &highest)) in self.powers.iter_mut().zip(x.iter().zip(&self.highest)) {
            powers.fill(x, highest);
        }
        let mut values = [ZERO; N];
        let mut matrix = [[ZERO; N]; N];
        for ((equation, value), row) in self.equations.iter().zip(&mut values).zip(&mut matrix) {
            for term in &equation.terms {
                let power = |j: usize| self.powers[j].evaluate(term.exponents[j]);
                *value += product(term.factor, &term.exponents, power, ONE, row);
            }
        }
        (values, matrix)
    }

    #[inline(never)]
    fn sparse_evaluate(&mut self, x: &Vector<N>, t: f64) -> Evaluation<N> {
        let (mut values, mut matrix) = self.sparse_target(x);
        let mut drift = [ZERO; N];
        for i in 0..N {
            let row = &mut matrix[i];
            *row = row.map(|slope| slope.scaled(1.0 - t));
            let degrees = &self.equations[i].degrees;
            let factor = |j: usize| self.factors[i][j].evaluate(x[j]);
            let start = product(self.constants[i], degrees, factor, ONE.scaled(t), row);
            drift[i] = start - values[i];
            values[i] += drift[i].scaled(t);
        }
        Evaluation {
            values,
            matrix,
            drift,
        }
    }
}

/// The product of a constant and of one factor for every variable, given by value and derivative;
/// a factor of degree zero is 1. The derivatives times `weight` are added to `slopes`.
#[inline(always)]
fn product<const N: usize>(
    constant: Complex,
    degrees: &[u8; N],
    factor: impl Fn(usize) -> (Complex, Complex),
    weight: Complex,
    slopes: &mut Vector<N>,
) -> Complex {
    let mut heads = [constant; N];
    let mut factors = [(ONE, ZERO); N];
    let mut product = constant;
    for j in 0..N {
        heads[j] = product;
        if degrees[j] > 0 {
            factors[j] = factor(j);
            product = product * factors[j].0;
        }
    }
    let mut tail = weight;
    for j in (0..N).rev() {
        if degrees[j] > 0 {
            let (value, slope) = factors[j];
            slopes[j] += heads[j] * slope * tail;
            tail = tail * value;
        }
    }
    product
}

impl Powers {
    /// A power and its derivative.
    #[inline(always)]
    fn evaluate(&self, exponent: u8) -> (Complex, Complex) {
        let exponent = (exponent as usize).min(HIGHEST_DEGREE);
        (self.values[exponent], self.slopes[exponent])
    }

    #[inline(always)]
    fn fill(&mut self, x: Complex, highest: usize) {
        let mut power = ONE;
        for k in 1..=highest {
            self.slopes[k] = power.scaled(k as f64);
            power = power * x;
            self.values[k] = power;
        }
    }
}

impl Univariate {
    /// Value and derivative.
    #[inline(always)]
    fn evaluate(&self, x: Complex) -> (Complex, Complex) {
        let degree = self.degree as usize;
        let (mut value, mut slope) = (ZERO, ZERO);
        for &coefficient in self.coefficients.iter().take(degree + 1).rev() {
            slope = slope * x + value;
            value = value * x + coefficient;
        }
        (value, slope)
    }
}
