//! Roberts' three four-bars of one coupler curve.
//!
//! With the coupler point at 0 in pose 0, the third joint of the frame is `c = a + k (b - a)`,
//! `k = -x / (y - x)`: the triangle of the frame is similar to that of the coupler. The links of a
//! cognate are parallel to sides of the first one.

use super::super::ball::Ball;
use super::equations::{Shifts, Unknowns};
use linkage_core::numeric::complex::{Complex, Ring};

/// The four-bar with the joints `a` and `c` of the frame, joint `a` first. Applied to the exchanged
/// links it gives the third one.
pub(super) fn cognate(of: &Unknowns<Complex>, shifts: &Shifts<Complex>) -> Unknowns<Complex> {
    let mut result = *of;
    for h in 0..2 {
        let [x, a, y, b] = [of[h], of[2 + h], of[4 + h], of[6 + h]];
        let k = -x * (y - x).inverse();
        let joint = a - x;
        [result[h], result[2 + h]] = [joint, a];
        [result[4 + h], result[6 + h]] = [joint + k * (x - a), a + k * (b - a)];
        let inverse = (x - a).inverse();
        // Its coupler is parallel to the link from `a`.
        for (j, shift) in shifts.iter().enumerate() {
            let i = 8 + 2 * j + h;
            result[i] = (shift[h] + of[i] * x - a) * inverse;
        }
    }
    result
}

/// The same four-bar with its links exchanged.
pub(super) fn exchanged<T: Copy>(of: &Unknowns<T>) -> Unknowns<T> {
    core::array::from_fn(|i| if i < 8 { of[i ^ 4] } else { of[i] })
}

/// Quantities that the three cognates have in common: sum of the joints of the frame and sum of
/// their products, both with hats.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Mark([Ball; 4]);

impl Mark {
    /// `None` if the joints of the coupler may be one point.
    pub(super) fn new(discs: &Unknowns<Ball>) -> Option<Self> {
        let [first, second] = [0, 1].map(|h| {
            let [x, a, y, b] = [discs[h], discs[2 + h], discs[4 + h], discs[6 + h]];
            let c = a - x * (b - a) * (y - x).inverse()?;
            Some(sums(a, b, c))
        });
        let ([p, q], [r, s]) = (first?, second?);
        Some(Self([p, q, r, s]))
    }

    /// That of the conjugate solution.
    #[cfg(test)]
    pub(super) fn mirrored(&self) -> Self {
        let conjugate = |i: usize| Ball::new(self.0[i].middle.conjugate(), self.0[i].radius);
        Self([2, 3, 0, 1].map(conjugate))
    }

    pub(super) fn is_apart_from(&self, other: &Self) -> bool {
        let mut pairs = self.0.iter().zip(&other.0);
        pairs.any(|(a, b)| a.is_apart_from(*b))
    }
}

fn sums<T: Ring>(a: T, b: T, c: T) -> [T; 2] {
    [a + b + c, a * b + b * c + c * a]
}
