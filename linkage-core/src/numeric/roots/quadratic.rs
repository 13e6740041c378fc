//! Two equations of at most the second degree in each of two variables, the form of triads. All
//! coefficients are kept, those of both equations side by side, so that evaluation is a fixed
//! sequence of operations on pairs of numbers.

use super::evaluation::Evaluation;
use super::polynomial::Polynomial;
use super::start_system::Univariate;
use crate::numeric::complex::Complex;
use core::ops::{Add, Mul};

/// A complex number for each of the two equations.
#[derive(Clone, Copy)]
struct Pair {
    re: [f64; 2],
    im: [f64; 2],
}

/// Coefficients of a polynomial in one variable, from the constant up.
type Quadratic = [Pair; 3];

pub(super) struct Quadratics {
    /// Coefficients by the exponents of the first and of the second variable.
    target: [Quadratic; 3],
    /// The factors of the start system, by variable.
    factors: [Quadratic; 2],
    constant: Pair,
    /// Degrees of the equations, by variable.
    degrees: [[u8; 2]; 2],
}

impl Quadratics {
    /// `None` if the equations are others.
    pub(super) fn new<const N: usize>(
        target: &[Polynomial],
        factors: &[[Univariate; N]; N],
        constants: &[Complex; N],
    ) -> Option<Self> {
        let low = |polynomial: &Polynomial| polynomial.degrees.iter().all(|&degree| degree <= 2);
        if N != 2 || !target.iter().all(low) {
            return None;
        }
        let mut table = [[Pair::ZERO; 3]; 3];
        for (equation, polynomial) in target.iter().enumerate() {
            for term in &polynomial.terms {
                let [a, b] = [term.exponents[0], term.exponents[1]];
                table[a as usize][b as usize].set(equation, term.factor);
            }
        }
        let pair = |of: &dyn Fn(usize) -> Complex| Pair::new([of(0), of(1)]);
        let factor = |j: usize, k: usize| pair(&|i| factors[i][j].coefficients[k]);
        Some(Self {
            target: table,
            factors: [0, 1].map(|j| [0, 1, 2].map(|k| factor(j, k))),
            constant: pair(&|i| constants[i]),
            degrees: [0, 1].map(|j| [0, 1].map(|i| target[i].degrees[j])),
        })
    }

    /// Takes the inverse of a coordinate as a coordinate.
    pub(super) fn flip(&mut self, j: usize) {
        for (equation, &degree) in self.degrees[j].iter().enumerate() {
            let reversed = |table: Quadratic| {
                let mut image = table;
                for k in 0..=degree as usize {
                    image[k].set(equation, table[degree as usize - k].get(equation));
                }
                image
            };
            self.factors[j] = reversed(self.factors[j]);
            for k in 0..3 {
                if j == 1 {
                    self.target[k] = reversed(self.target[k]);
                } else {
                    let column = reversed([0, 1, 2].map(|row| self.target[row][k]));
                    for (row, value) in self.target.iter_mut().zip(column) {
                        row[k] = value;
                    }
                }
            }
        }
    }

    /// The given equations, their derivatives by the first and by the second variable.
    #[inline(always)]
    fn values(&self, x: Complex, y: Complex) -> [Pair; 3] {
        let [low, middle, high] = &self.target;
        let (low, low_by_y) = value_and_slope(low, y);
        let (middle, middle_by_y) = value_and_slope(middle, y);
        let (high, high_by_y) = value_and_slope(high, y);
        let (value, by_x) = value_and_slope(&[low, middle, high], x);
        let by_y = (high_by_y * x + middle_by_y) * x + low_by_y;
        [value, by_x, by_y]
    }

    /// The given equations and their derivatives.
    #[inline(always)]
    pub(super) fn target<const N: usize>(
        &self,
        x: &[Complex; N],
    ) -> ([Complex; N], [[Complex; N]; N]) {
        let [values, by_x, by_y] = self.values(x[0], x[1]);
        (values.split(), columns([by_x, by_y]))
    }

    /// The equations at a point of a path.
    #[inline(always)]
    pub(super) fn evaluate<const N: usize>(&self, x: &[Complex; N], t: f64) -> Evaluation<N> {
        let [values, by_x, by_y] = self.values(x[0], x[1]);
        let (first, first_slope) = value_and_slope(&self.factors[0], x[0]);
        let (second, second_slope) = value_and_slope(&self.factors[1], x[1]);
        let first = self.constant.times(first);
        let start = first.times(second);
        let start_by_x = self.constant.times(first_slope).times(second);
        let start_by_y = first.times(second_slope);
        let drift = start + values.scaled(-1.0);
        let mixed = |target: Pair, start: Pair| target.scaled(1.0 - t) + start.scaled(t);
        Evaluation {
            values: mixed(values, start).split(),
            matrix: columns([mixed(by_x, start_by_x), mixed(by_y, start_by_y)]),
            drift: drift.split(),
        }
    }
}

/// Value and derivative.
#[inline(always)]
fn value_and_slope(&[low, middle, high]: &Quadratic, x: Complex) -> (Pair, Pair) {
    let slope = high * x + middle;
    (slope * x + low, high * x + slope)
}

/// The matrix with these columns.
#[inline(always)]
fn columns<const N: usize>(columns: [Pair; 2]) -> [[Complex; N]; N] {
    core::array::from_fn(|row| core::array::from_fn(|column| columns[column].get(row)))
}

impl Pair {
    const ZERO: Self = Self {
        re: [0.0; 2],
        im: [0.0; 2],
    };

    fn new(values: [Complex; 2]) -> Self {
        Self {
            re: values.map(|value| value.re),
            im: values.map(|value| value.im),
        }
    }

    #[inline(always)]
    fn get(self, equation: usize) -> Complex {
        Complex::new(self.re[equation], self.im[equation])
    }

    fn set(&mut self, equation: usize, value: Complex) {
        (self.re[equation], self.im[equation]) = (value.re, value.im);
    }

    #[inline(always)]
    fn split<const N: usize>(self) -> [Complex; N] {
        core::array::from_fn(|equation| self.get(equation))
    }

    #[inline(always)]
    fn scaled(self, factor: f64) -> Self {
        Self {
            re: [self.re[0] * factor, self.re[1] * factor],
            im: [self.im[0] * factor, self.im[1] * factor],
        }
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        let products = |a: [f64; 2], b: [f64; 2]| [a[0] * b[0], a[1] * b[1]];
        let (real, imaginary) = (products(self.re, other.re), products(self.im, other.im));
        let (mixed, crossed) = (products(self.re, other.im), products(self.im, other.re));
        Self {
            re: [real[0] - imaginary[0], real[1] - imaginary[1]],
            im: [mixed[0] + crossed[0], mixed[1] + crossed[1]],
        }
    }
}

impl Add for Pair {
    type Output = Self;

    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self {
            re: [self.re[0] + other.re[0], self.re[1] + other.re[1]],
            im: [self.im[0] + other.im[0], self.im[1] + other.im[1]],
        }
    }
}

impl Mul<Complex> for Pair {
    type Output = Self;

    #[inline(always)]
    fn mul(self, other: Complex) -> Self {
        self.times(Self {
            re: [other.re; 2],
            im: [other.im; 2],
        })
    }
}
