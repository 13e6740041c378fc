//! Organs of several phases: points that move by two harmonics.

use std::f64::consts::{PI, TAU};

pub(crate) const CYCLE: (f64, f64) = (0.0, TAU);
/// Phases may be any.
pub(crate) const RANGE: (f64, f64) = (-PI, PI);
/// Of the coarse look.
pub(crate) const POSITIONS: usize = 91;

/// `mean + a cos(x + b) + c cos(2 x + d)`.
type Wave = [f64; 5];

pub(crate) const A: [Wave; 2] = [[0.0, 20.0, 0.0, 3.0, 0.4], [0.0, 12.0, 1.5, 2.0, 0.0]];
pub(crate) const B: [Wave; 2] = [[36.0, 14.0, 2.4, 2.0, 1.0], [6.0, 10.0, 0.7, 3.0, 2.0]];
pub(crate) const C: [Wave; 2] = [[16.0, 9.0, 1.0, 1.5, 0.2], [28.0, 13.0, 3.0, 2.0, 1.0]];
pub(crate) const D: [Wave; 2] = [[55.0, 12.0, 0.3, 2.5, 2.2], [20.0, 15.0, 0.0, 1.0, 0.1]];

/// A point with its first two derivatives.
pub(crate) fn member([along, up]: [Wave; 2]) -> impl Fn(f64) -> [[[f64; 2]; 3]; 1] + Copy {
    let wave = |[mean, a, b, c, d]: Wave, x: f64| {
        let ((s1, c1), (s2, c2)) = ((x + b).sin_cos(), (2.0 * x + d).sin_cos());
        [
            mean + a * c1 + c * c2,
            -a * s1 - 2.0 * c * s2,
            -a * c1 - 4.0 * c * c2,
        ]
    };
    move |x| {
        let (x, y) = (wave(along, x), wave(up, x));
        [[0, 1, 2].map(|k| [x[k], y[k]])]
    }
}
