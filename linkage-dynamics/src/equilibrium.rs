//! Static equilibria of one input, and natural frequencies of several.

use crate::sign_changes::{change_of_sign, samples};
use nalgebra::DMatrix;

/// Steps of differences, as parts of the range or of 1: errors of order four and of rounding are
/// then alike.
const DIFFERENCE: f64 = 1e-3;

/// A position at which the generalised force is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    /// The input, rad or the length unit.
    pub input: f64,
    /// Stiffness about the position: the force that falls with the input, per unit of it.
    pub stiffness: f64,
}

impl Equilibrium {
    /// Returns true if the mechanism returns to the position after a small displacement.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        self.stiffness > 0.0
    }
}

/// Finds the equilibria over a range of the input: zeros of the generalised force (springs, weights
/// and loads at rest).
///
/// The range is divided into `parts`; each change of the sign between neighbours is located to the
/// last digit by bracketing. Two equilibria within one part are not found, nor one at which the
/// force only touches zero. Positions without a force (NaN) are left out.
///
/// ```
/// use linkage_dynamics::equilibria;
///
/// // A pendulum of 1 kg and 1 m, on a spring of 4 N*m/rad that is free at 90 degrees.
/// let force = |phi: f64| 4.0 * (std::f64::consts::FRAC_PI_2 - phi) - 9.81 * phi.sin();
/// let found = equilibria(force, [-3.2, 3.2], 100);
/// assert_eq!(found.len(), 1);
/// assert!(found[0].is_stable() && (found[0].input - 0.4669).abs() < 1e-4);
/// ```
#[must_use]
pub fn equilibria(
    force: impl Fn(f64) -> f64,
    [low, high]: [f64; 2],
    parts: usize,
) -> Vec<Equilibrium> {
    let samples = samples(&force, [low, high], parts);
    let mut inputs: Vec<f64> = Vec::new();
    for (index, &(input, value)) in samples.iter().enumerate() {
        if value == 0.0 {
            inputs.push(input);
        }
        if let Some(&next) = samples.get(index + 1) {
            inputs.extend(change_of_sign(&force, (input, value), next));
        }
    }
    let equilibrium = |input: f64| {
        let step = DIFFERENCE * (high - low) / parts.max(1) as f64;
        Equilibrium {
            input,
            stiffness: -slope(step, |offset| [force(input + offset)])[0],
        }
    };
    inputs.into_iter().map(equilibrium).collect()
}

/// Returns derivatives at zero, by differences of order four.
fn slope<const N: usize>(step: f64, function: impl Fn(f64) -> [f64; N]) -> [f64; N] {
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|part| function(part * step));
    std::array::from_fn(|i| (8.0 * (c[i] - b[i]) - (d[i] - a[i])) / (12.0 * step))
}

/// A natural motion about an equilibrium: `exp(-decay t) cos(omega t)`, or `exp(-decay t)` alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NaturalMode {
    /// Angular frequency, rad/s; zero for a motion without oscillation.
    pub angular_frequency: f64,
    /// Rate of decay, 1/s; negative for a motion that grows.
    pub decay: f64,
}

impl NaturalMode {
    /// Returns the frequency in Hz.
    #[must_use]
    pub fn frequency(&self) -> f64 {
        self.angular_frequency / std::f64::consts::TAU
    }

    /// Returns the damping ratio: 0 without damping, 1 and more without oscillation.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        self.decay / self.angular_frequency.hypot(self.decay)
    }
}

/// Returns the natural motions about an equilibrium of the inputs, the slowest first, from the
/// accelerations as a function of inputs and speeds.
///
/// The accelerations are linearised by differences of order four, and the motions are eigenvalues
/// of the matrix of the first order, so that dampers and gyroscopic terms are in it. A pair of
/// conjugate eigenvalues is one motion. `None` if accelerations around the equilibrium are NaN, or
/// the eigenvalues are not found.
///
/// ```
/// use linkage_dynamics::natural_modes;
///
/// // Two masses of 1 kg between three springs of 1 N/m: 1 rad/s and the root of 3 rad/s.
/// let accelerations = |[x, y]: [f64; 2], _| [y - 2.0 * x, x - 2.0 * y];
/// let modes = natural_modes(accelerations, [0.0, 0.0]).expect("two modes");
/// assert!((modes[0].angular_frequency - 1.0).abs() < 1e-9);
/// assert!((modes[1].angular_frequency - 3.0_f64.sqrt()).abs() < 1e-9);
/// ```
pub fn natural_modes<const N: usize>(
    accelerations: impl Fn([f64; N], [f64; N]) -> [f64; N],
    equilibrium: [f64; N],
) -> Option<Vec<NaturalMode>> {
    let mut matrix = DMatrix::zeros(2 * N, 2 * N);
    for column in 0..N {
        let moved = |mut values: [f64; N], offset: f64| {
            values[column] += offset;
            values
        };
        let rest = [0.0; N];
        let step = DIFFERENCE * equilibrium[column].abs().max(1.0);
        let stiffness = slope(step, |x| accelerations(moved(equilibrium, x), rest));
        let damping = slope(DIFFERENCE, |x| accelerations(equilibrium, moved(rest, x)));
        matrix[(column, N + column)] = 1.0;
        for row in 0..N {
            matrix[(N + row, column)] = stiffness[row];
            matrix[(N + row, N + column)] = damping[row];
        }
    }
    if !matrix.iter().all(|entry: &f64| entry.is_finite()) {
        return None;
    }
    let size = matrix.amax().sqrt();
    let eigenvalues = matrix.complex_eigenvalues();
    let noise = f64::EPSILON.sqrt() * size;
    let upper = eigenvalues.iter().filter(|value| value.im > -noise);
    let modes = upper.map(|value| NaturalMode {
        angular_frequency: if value.im < noise { 0.0 } else { value.im },
        decay: -value.re,
    });
    let mut modes: Vec<NaturalMode> = modes.collect();
    modes.sort_by(|a, b| a.angular_frequency.total_cmp(&b.angular_frequency));
    Some(modes)
}

#[cfg(test)]
mod tests {
    use super::{Equilibrium, equilibria, natural_modes};
    use std::f64::consts::PI;

    /// A pendulum over a turn and a half: stable below, unstable above.
    #[test]
    fn equilibria_have_their_stability() {
        let found = equilibria(|phi: f64| -2.0 * phi.sin(), [-1.0, 8.0], 64);
        let expected = [0.0, PI, 2.0 * PI];
        assert_eq!(found.len(), 3);
        for (Equilibrium { input, stiffness }, exact) in found.iter().zip(expected) {
            assert!((input - exact).abs() < 1e-15, "{input}");
            assert!((stiffness - 2.0 * exact.cos()).abs() < 1e-9, "{stiffness}");
        }
        assert!(!found[1].is_stable() && found[2].is_stable());
        // No force beyond 3: the zero before is found.
        let force = |x: f64| if x < 3.0 { 1.0 - x } else { f64::NAN };
        assert_eq!(equilibria(force, [0.0, 4.0], 7).len(), 1);
        // On a sample.
        let found = equilibria(|x| 1.0 - x, [0.0, 4.0], 4);
        assert!(found.len() == 1 && found[0].input == 1.0 && found[0].is_stable());
    }

    /// One input with a damper: `a = -100 q - 2 v`.
    #[test]
    fn damped_oscillation() {
        let modes = natural_modes(|[q], [v]| [-100.0 * q - 2.0 * v], [0.0]).expect("a mode");
        assert_eq!(modes.len(), 1);
        assert!((modes[0].angular_frequency - 99.0_f64.sqrt()).abs() < 1e-9);
        assert!((modes[0].decay - 1.0).abs() < 1e-9);
        assert!((modes[0].damping_ratio() - 0.1).abs() < 1e-10);
        // Upside down it falls.
        let falling = natural_modes(|[q], [_]: [f64; 1]| [4.0 * q], [0.0]).expect("modes");
        assert!(falling.iter().any(|mode| (mode.decay + 2.0).abs() < 1e-9));
        assert!(natural_modes(|[_], [_]: [f64; 1]| [f64::NAN], [0.0]).is_none());
    }
}
