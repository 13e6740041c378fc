//! Conditions as shifts and turns against the first of them, of size about 1, with the bounds of
//! their rounding.

use super::ball::Ball;
use super::dyad::Pair;
use linkage_core::numeric::complex::Complex;
use linkage_core::numeric::double_double::DoubleDouble;

/// A shift with all digits that the points have.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shift([DoubleDouble; 2]);

impl Shift {
    pub(super) fn between(from: [f64; 2], to: [f64; 2]) -> Self {
        Self([0, 1].map(|i| DoubleDouble::difference(to[i], from[i])))
    }

    /// Times a power of two, which is exact.
    pub(super) fn scaled(self, factor: f64) -> Self {
        Self(self.0.map(|part| part * factor.into()))
    }

    pub(super) fn narrow(self) -> Complex {
        self.wide()[0].narrow()
    }

    /// With its conjugate.
    pub(super) fn wide(self) -> Pair<Complex<DoubleDouble>> {
        let [x, y] = self.0;
        [Complex::new(x, y), Complex::new(x, -y)]
    }

    /// With its conjugate, and the digits that a plain number does not hold.
    pub(super) fn discs(self) -> Pair<Ball> {
        let middle = self.narrow();
        let radius = f64::EPSILON * middle.size();
        [middle, middle.conjugate()].map(|middle| Ball::new(middle, radius))
    }
}

/// A power of two near the size of the shifts: with it as the unit of length they are about 1, and
/// nothing is rounded.
pub(super) fn unit(shifts: impl Iterator<Item = Complex>) -> f64 {
    let largest = shifts.map(Complex::size).fold(0.0, f64::max);
    largest.log2().round().exp2()
}

/// A unit vector and its inverse; elementary functions give it to some units of the last digit.
pub(super) fn turn_discs(turn: Complex) -> Pair<Ball> {
    const WRONG: f64 = 4.0 * f64::EPSILON;
    [turn, turn.conjugate()].map(|middle| Ball::new(middle, WRONG))
}
