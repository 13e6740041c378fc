//! True velocity, acceleration and jerk from the derivatives with respect to the input.

use core::ops::{Add, Mul};

/// True velocity `v = omega v1` of a quantity.
///
/// `v1` is its first derivative with respect to the input, as `velocity(q)` gives it, and `omega`
/// the speed of the input (rad/s for an angle). Works for numbers and vectors; the unit of the
/// result is the unit of the quantity per second.
///
/// ```
/// use linkage_runtime::{Vector2, true_velocity};
///
/// assert_eq!(true_velocity(0.5, 10.0), 5.0);
/// assert_eq!(true_velocity(Vector2::new(3.0, -1.0), 10.0), Vector2::new(30.0, -10.0));
/// ```
#[inline(always)]
#[must_use]
pub fn true_velocity<V, T>(v1: V, omega: T) -> V
where
    V: Mul<T, Output = V>,
{
    v1 * omega
}

/// True acceleration `a = omega^2 a1 + epsilon v1` of a quantity.
///
/// `v1` and `a1` are its first and second derivative with respect to the input, as `velocity(q)`
/// and `acceleration(q)` give them; `omega` and `epsilon` are the speed and the acceleration of the
/// input (rad/s and rad/s^2 for an angle).
///
/// ```
/// use linkage_runtime::true_acceleration;
///
/// let (v1, a1) = (0.5, -0.2);
/// assert_eq!(true_acceleration(v1, a1, 10.0, 4.0), 10.0 * 10.0 * a1 + 4.0 * v1);
/// ```
#[inline(always)]
#[must_use]
pub fn true_acceleration<V, T>(v1: V, a1: V, omega: T, epsilon: T) -> V
where
    V: Mul<T, Output = V> + Add<Output = V>,
    T: Copy + Mul<Output = T>,
{
    a1 * (omega * omega) + v1 * epsilon
}

/// True jerk `j = omega^3 j1 + 3 omega epsilon a1 + zeta v1` of a quantity: how fast its true
/// acceleration changes.
///
/// `v1`, `a1` and `j1` are its first three derivatives with respect to the input, as `velocity(q)`,
/// `acceleration(q)` and `jerk(q)` give them; `omega`, `epsilon` and `zeta` are the first three
/// derivatives of the input by time, its speed, its acceleration and its jerk (rad/s, rad/s^2 and
/// rad/s^3 for an angle).
///
/// ```
/// use linkage_runtime::true_jerk;
///
/// // q = x^3, x = t^2 at t = 1: the third derivative of t^6.
/// assert_eq!(true_jerk(3.0, 6.0, 6.0, 2.0, 2.0, 0.0), 120.0);
/// ```
#[inline(always)]
#[must_use]
pub fn true_jerk<V, T>(v1: V, a1: V, j1: V, omega: T, epsilon: T, zeta: T) -> V
where
    V: Mul<T, Output = V> + Add<Output = V>,
    T: Copy + Mul<Output = T> + Add<Output = T>,
{
    let mixed = omega * epsilon;
    j1 * (omega * omega * omega) + a1 * (mixed + mixed + mixed) + v1 * zeta
}
