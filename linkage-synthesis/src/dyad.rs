//! The equation of a link between two revolute joints, in isotropic coordinates.
//!
//! A point of the plane is a complex number and its conjugate, which are variables of their own (a
//! hat says conjugate). In pose `j` the body is shifted by `d` and turned by the unit vector `t`,
//! `u` for its hat, against pose 0. The joint of the body at `x` in pose 0 then is at `d + t x`; it
//! stays at the distance from the fixed joint `a` that it has in pose 0 (Wampler, Morgan and
//! Sommese, Journal of Mechanical Design 114, 1992):
//!
//! `(d + t x - a) (d^ + u x^ - a^) = (x - a) (x^ - a^)`

use linkage_core::numeric::complex::Ring;

/// `x`, `x^`, `a`, `a^`.
pub(super) type Dyad<T> = [T; 4];
/// A number and its hat.
pub(super) type Pair<T> = [T; 2];

/// Value of the equation and its derivatives.
pub(super) struct Link<T> {
    pub(super) value: T,
    pub(super) by_dyad: [T; 4],
    /// Derivatives with respect to `t` and `u`.
    pub(super) by_turn: Pair<T>,
    /// Derivatives with respect to `d` and `d^`.
    pub(super) by_shift: Pair<T>,
}

/// The difference of both sides, multiplied out: with `t u = 1` the squares of `x` and `a` cancel.
#[inline(always)]
pub(super) fn value<T: Ring>(
    &[x, x_hat, a, a_hat]: &Dyad<T>,
    [d, d_hat]: Pair<T>,
    [t, u]: Pair<T>,
) -> T {
    let far = d - a;
    let far_hat = d_hat - a_hat;
    t * x * far_hat + u * x_hat * far + d * far_hat - a * d_hat + x * a_hat + x_hat * a
}

#[inline(always)]
pub(super) fn link<T: Ring>(dyad: &Dyad<T>, shift: Pair<T>, turn: Pair<T>) -> Link<T> {
    let ([x, x_hat, a, a_hat], [d, d_hat], [t, u]) = (*dyad, shift, turn);
    let (far, far_hat) = (d - a, d_hat - a_hat);
    let (turned, turned_hat) = (t * x, u * x_hat);
    Link {
        value: turned * far_hat + turned_hat * far + d * far_hat - a * d_hat
            + x * a_hat
            + x_hat * a,
        by_dyad: [
            t * far_hat + a_hat,
            u * far + a,
            x_hat - turned_hat - d_hat,
            x - turned - d,
        ],
        by_turn: [x * far_hat, x_hat * far],
        by_shift: [turned_hat + far_hat, turned + far],
    }
}
