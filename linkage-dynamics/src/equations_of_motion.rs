//! Equations of motion: accelerations of the inputs, from closures or from reduced parts.

use crate::phase::{Phase, Rates};
use linkage_core::numeric::cholesky;
use std::cell::Cell;

/// The reduced equation of motion `inertia * acceleration = force` at one position and speed.
///
/// `inertia` is the reduced inertia: twice the kinetic energy at unit speed, and with several
/// inputs the symmetric mass matrix. `force` is the generalised force of all loads, weights,
/// springs and drives, less the terms of velocity: with one input `Q - J' omega^2 / 2`. Units: a
/// generalised force of an angle is a moment, `N*mm` with `unit mm`; an inertia is a moment times
/// s^2. The equation is Lagrange's equation of the second kind for the inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduced<const N: usize = 1> {
    /// Reduced inertia, or the mass matrix.
    pub inertia: [[f64; N]; N],
    /// Generalised forces less the terms of velocity.
    pub force: [f64; N],
}

impl Reduced<1> {
    /// The equation of one input: its reduced inertia, and its force less the terms of velocity.
    #[must_use]
    pub const fn one(inertia: f64, force: f64) -> Self {
        Self {
            inertia: [[inertia]],
            force: [force],
        }
    }
}

impl<const N: usize> Reduced<N> {
    /// The equation from quantities of a mechanism: `inertia(phi)` in kg times the square of the
    /// length unit, `bias(phi)` and `generalised_force(phi)` in N times the length unit. The unit is
    /// given in metres: 1e-3 for `unit mm`.
    #[must_use]
    pub fn from_parts(
        unit: f64,
        inertia: [[f64; N]; N],
        bias: [f64; N],
        generalised_force: [f64; N],
    ) -> Self {
        Self {
            // 1 kg*mm^2 is 0.001 N*mm*s^2.
            inertia: inertia.map(|row| row.map(|entry| unit * entry)),
            force: std::array::from_fn(|i| generalised_force[i] - bias[i]),
        }
    }

    /// Returns the accelerations, by Cholesky's factorisation; NaN if the mass matrix is not
    /// positive definite.
    #[must_use]
    #[inline]
    pub fn accelerations(&self) -> [f64; N] {
        if N == 1 {
            let inertia = self.inertia[0][0];
            let inertia = if inertia > 0.0 { inertia } else { f64::NAN };
            return self.force.map(|force| force / inertia);
        }
        let mut lower = self.inertia;
        let positive = |_, rest: f64| (rest > 0.0).then_some(rest);
        if cholesky::factor(lower.as_flattened_mut(), N, positive).is_none() {
            return [f64::NAN; N];
        }
        let mut x = self.force;
        cholesky::forward(lower.as_flattened(), &mut x);
        for i in (0..N).rev() {
            let above: f64 = (i + 1..N).map(|j| lower[j][i] * x[j]).sum();
            x[i] = (x[i] - above) / lower[i][i];
        }
        x
    }

    /// Returns the fault of an equation that has no accelerations.
    fn fault(&self) -> Fault {
        let inertias = self.inertia.as_flattened();
        if !inertias.iter().copied().all(f64::is_finite) {
            return Fault::InertiaUndefined;
        }
        if !self.force.iter().copied().all(f64::is_finite) {
            return Fault::ForceUndefined;
        }
        let least = Cell::new(f64::INFINITY);
        let mut lower = self.inertia;
        let _positive = cholesky::factor(lower.as_flattened_mut(), N, |_, rest| {
            least.set(rest.min(least.get()));
            (rest > 0.0).then_some(rest)
        });
        Fault::InertiaNotPositive(least.get())
    }
}

/// The reason why there are no accelerations at a state.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Fault {
    /// The accelerations are NaN or infinite.
    Accelerations,
    /// The inertia is NaN or infinite: the mechanism has no position there.
    InertiaUndefined,
    /// The inertia is not positive: its value, or the least pivot of the mass matrix.
    InertiaNotPositive(f64),
    /// The generalised force is NaN or infinite.
    ForceUndefined,
}

/// Equations of motion of a mechanism with `N` inputs.
///
/// [`Problem::new`](crate::Problem::new) and [`Problem::reduced`](crate::Problem::reduced) take
/// closures instead. An implementation is for equations with data and a better explanation of
/// faults.
pub trait Equations<const N: usize> {
    /// Returns the accelerations of the inputs at a time (s) for inputs and their speeds. NaN means
    /// that there is no position or no load.
    fn accelerations(&self, time: f64, inputs: [f64; N], speeds: [f64; N]) -> [f64; N];

    /// Returns the reason of accelerations that are NaN or infinite.
    fn fault(&self, time: f64, inputs: [f64; N], speeds: [f64; N]) -> Fault {
        let _ = (time, inputs, speeds);
        Fault::Accelerations
    }
}

/// Equations from a closure that returns accelerations.
#[derive(Clone, Copy, Debug)]
pub struct FromAccelerations<F>(pub(crate) F);

impl<const N: usize, F: Fn(f64, [f64; N], [f64; N]) -> [f64; N]> Equations<N>
    for FromAccelerations<F>
{
    #[inline]
    fn accelerations(&self, time: f64, inputs: [f64; N], speeds: [f64; N]) -> [f64; N] {
        (self.0)(time, inputs, speeds)
    }
}

/// Equations from a closure that returns the reduced equation.
#[derive(Clone, Copy, Debug)]
pub struct FromReduced<F>(pub(crate) F);

impl<const N: usize, F: Fn(f64, [f64; N], [f64; N]) -> Reduced<N>> Equations<N> for FromReduced<F> {
    #[inline]
    fn accelerations(&self, time: f64, inputs: [f64; N], speeds: [f64; N]) -> [f64; N] {
        (self.0)(time, inputs, speeds).accelerations()
    }

    fn fault(&self, time: f64, inputs: [f64; N], speeds: [f64; N]) -> Fault {
        (self.0)(time, inputs, speeds).fault()
    }
}

/// Equations of motion over time.
pub(crate) struct OverTime<'e, E>(pub(crate) &'e E);

impl<E: Equations<N>, const N: usize> Rates<N> for OverTime<'_, E> {
    #[inline]
    fn rates(&self, time: f64, phase: &Phase<N>) -> Phase<N> {
        Phase {
            inputs: phase.speeds,
            speeds: self.0.accelerations(time, phase.inputs, phase.speeds),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Fault, Reduced};

    /// A full mass matrix: the accelerations times the matrix are the forces.
    #[test]
    fn accelerations_of_a_mass_matrix() {
        let inertia = [[4.0, 1.0, 0.5], [1.0, 3.0, -0.25], [0.5, -0.25, 2.0]];
        let force = [1.0, -2.0, 3.0];
        let accelerations = Reduced { inertia, force }.accelerations();
        for (row, force) in inertia.iter().zip(force) {
            let product: f64 = row.iter().zip(accelerations).map(|(m, a)| m * a).sum();
            assert!((product - force).abs() < 1e-14, "{product} {force}");
        }
        assert_eq!(Reduced::one(2.0, 3.0).accelerations(), [1.5]);
    }

    /// 3000 kg*mm^2 and 60 N*mm are 0.003 kg*m^2 and 0.06 N*m: 20 rad/s^2.
    #[test]
    fn parts_in_millimetres() {
        let equation = Reduced::from_parts(1e-3, [[3000.0]], [10.0], [70.0]);
        assert!((equation.accelerations()[0] - 20.0).abs() < 1e-13);
    }

    #[test]
    fn faults_have_their_numbers() {
        let indefinite = Reduced {
            inertia: [[1.0, 2.0], [2.0, 1.0]],
            force: [1.0, 1.0],
        };
        assert!(indefinite.accelerations().iter().all(|a| a.is_nan()));
        assert_eq!(indefinite.fault(), Fault::InertiaNotPositive(-3.0));
        assert!(Reduced::one(0.0, 1.0).accelerations()[0].is_nan());
        let cases = [
            (Reduced::one(0.0, 1.0), Fault::InertiaNotPositive(0.0)),
            (Reduced::one(f64::NAN, 1.0), Fault::InertiaUndefined),
            (Reduced::one(1.0, f64::NAN), Fault::ForceUndefined),
        ];
        for (equation, fault) in cases {
            assert_eq!(equation.fault(), fault);
        }
    }
}
