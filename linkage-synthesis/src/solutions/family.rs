//! The equations among others: with other constants, and one of them with a linear form.

use super::super::ball::{Ball, Bound};
use super::super::certificate::{self, Certificate, Evaluated, Point, System};
use super::super::long::Long;
use super::super::path::{Moving, Step};
use super::number::{Number, Slopes};
use super::polynomial_equations::Equations;
use linkage_core::numeric::complex::{Complex, ONE, ZERO};
use linkage_core::numeric::complex_matrix;

/// Equations `f(x) + form . x = constants`, the form in one of them only.
pub(super) struct Member<'a, E, const N: usize> {
    pub(super) equations: &'a E,
    pub(super) row: usize,
    pub(super) form: [Complex; N],
    pub(super) constants: [Complex; N],
}

// A derived `Clone` would require that the equations can be copied.
impl<E, const N: usize> Clone for Member<'_, E, N> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<E, const N: usize> Copy for Member<'_, E, N> {}

/// A number of roundings of numbers of 32 digits that exceeds those of all equations that somebody
/// can write.
const WRONG: f64 = 1.0 / (1_u128 << 84) as f64;
/// Newton steps with residuals of 32 digits: two of them are enough where the test can succeed.
const STEPS: usize = 4;

impl<'a, E: Equations<N>, const N: usize> Member<'a, E, N> {
    /// The equations as they are.
    pub(super) fn given(equations: &'a E) -> Self {
        Self {
            equations,
            row: 0,
            form: [ZERO; N],
            constants: [ZERO; N],
        }
    }

    /// That of these constants.
    pub(super) fn with_constants(&self, constants: [Complex; N]) -> Self {
        Self { constants, ..*self }
    }

    /// That which has `point` among its solutions.
    pub(super) fn through(&self, point: &[Complex; N]) -> Self {
        let values = self.with_constants([ZERO; N]).evaluated(point);
        self.with_constants(values)
    }

    fn evaluated<T: Number + From<Complex>>(&self, x: &[T; N]) -> [T; N] {
        let mut values = self.equations.values(x);
        for (value, constant) in values.iter_mut().zip(self.constants) {
            *value = *value - constant.into();
        }
        let terms = self.form.iter().zip(x);
        values[self.row] = terms.fold(values[self.row], |sum, (&factor, &x)| {
            if factor == ZERO {
                sum
            } else {
                sum + T::from(factor) * x
            }
        });
        values
    }

    /// Values and, by rows, derivatives.
    fn differentiated<T: Number + From<Complex>>(&self, x: &[T; N]) -> ([T; N], [[T; N]; N]) {
        let unknowns = core::array::from_fn(|i| Slopes::unknown(x[i], i));
        let slopes = self.equations.values(&unknowns);
        let mut values = slopes.map(|slopes| slopes.value);
        let mut matrix = slopes.map(|slopes| slopes.by);
        for (value, constant) in values.iter_mut().zip(self.constants) {
            *value = *value - constant.into();
        }
        for (i, &factor) in self.form.iter().enumerate() {
            if factor != ZERO {
                values[self.row] = values[self.row] + T::from(factor) * x[i];
                matrix[self.row][i] = matrix[self.row][i] + factor.into();
            }
        }
        (values, matrix)
    }

    /// A certificate near this place.
    pub(super) fn shown(&self, point: &[Complex; N]) -> Option<Certificate<N>> {
        self.shown_soon(point)
            .or_else(|| certificate::certify_long(point, self))
    }

    /// One for which residuals of 32 digits are enough.
    pub(super) fn shown_soon(&self, start: &[Complex; N]) -> Option<Certificate<N>> {
        let values = |point: &Point<N>| self.evaluated(point).map(Complex::narrow);
        let matrix = |point: &_| self.differentiated(point).1;
        let point = certificate::refined(start, STEPS, values, matrix).ok()?;
        certificate::certify(&point, self)
    }
}

impl<E: Equations<N>, const N: usize> System<N> for Member<'_, E, N> {
    fn partner(i: usize) -> usize {
        i
    }

    fn values(&self, point: &Point<N>) -> [Ball; N] {
        let values = self.evaluated(point);
        let sizes = self.evaluated(&point.map(Bound::from_wide));
        core::array::from_fn(|i| Ball::from_wide(values[i]).widened(sizes[i].0 * WRONG))
    }

    fn matrix(&self, discs: &[Ball; N]) -> [[Ball; N]; N] {
        self.differentiated(discs).1
    }

    fn long(&self, discs: &[Ball<Long>; N]) -> Option<Evaluated<N>> {
        Some(self.differentiated(discs))
    }
}

/// The path from one member to another one: not straight, but along an arc of complex numbers,
/// which for almost every `arc` keeps away from members with double solutions.
pub(super) struct ParameterPath<'a, 'e, E, const N: usize> {
    pub(super) from: &'a Member<'e, E, N>,
    pub(super) to: &'a Member<'e, E, N>,
    pub(super) arc: Complex,
}

impl<'e, E: Equations<N>, const N: usize> Moving<N> for ParameterPath<'_, 'e, E, N> {
    /// The member, and how its form and its constants change.
    type Data = (Member<'e, E, N>, [Complex; N], [Complex; N]);

    fn evaluate(&self, t: f64) -> Self::Data {
        let rest = (ONE + (self.arc - ONE).scaled(t)).inverse();
        let part = self.arc.scaled(t) * rest;
        let slope = self.arc * rest * rest;
        let (from, to) = (self.from, self.to);
        let between = |from: &[Complex; N], to: &[Complex; N]| {
            core::array::from_fn(|i| to[i] + part * (from[i] - to[i]))
        };
        let change = |from: &[Complex; N], to: &[Complex; N]| {
            core::array::from_fn(|i| slope * (from[i] - to[i]))
        };
        let member = Member {
            form: between(&from.form, &to.form),
            constants: between(&from.constants, &to.constants),
            ..*from
        };
        (
            member,
            change(&from.form, &to.form),
            change(&from.constants, &to.constants),
        )
    }

    fn newton(&self, point: &[Complex; N], (member, form, constants): &Self::Data) -> Step<N> {
        let (values, mut matrix) = member.differentiated(point);
        let mut drift = *constants;
        let terms = form.iter().zip(point);
        drift[member.row] = terms.fold(drift[member.row], |sum, (&by, &x)| sum - by * x);
        let mut right = [values.map(|value| -value), drift];
        let singular = complex_matrix::solve_scaled(&mut matrix, &mut right) == 0.0;
        let [step, tangent] = right;
        Step {
            to: core::array::from_fn(|i| point[i] + step[i]),
            tangent,
            singular,
        }
    }
}
