//! Platforms on six legs as polynomial equations: the one that P. Dietmaier found in 1998, of whose 40 assemblies all are real, and any other.

use linkage::design::exact::{Equations, Number};

/// Six legs from a base to a platform, in whole numbers, so that the published digits are exact.
pub(crate) struct Platform {
    /// So many of them are the unit of the platform's place.
    pub(crate) unit: f64,
    pub(crate) base: [[f64; 3]; 6],
    pub(crate) platform: [[f64; 3]; 6],
    pub(crate) legs: [f64; 6],
}

/// P. Dietmaier, The Stewart-Gough platform of general geometry can have 40 real postures, Advances in Robot Kinematics, 1998.
pub(crate) const DIETMAIER: Platform = Platform {
    unit: 1e6,
    base: [
        [0.0, 0.0, 0.0],
        [1_107_915.0, 0.0, 0.0],
        [549_094.0, 756_063.0, 0.0],
        [735_077.0, -223_935.0, 525_991.0],
        [514_188.0, -526_063.0, -368_418.0],
        [590_473.0, 94_733.0, -205_018.0],
    ],
    platform: [
        [0.0, 0.0, 0.0],
        [542_805.0, 0.0, 0.0],
        [956_919.0, -528_915.0, 0.0],
        [665_885.0, -353_482.0, 1_402_538.0],
        [478_359.0, 1_158_742.0, 107_672.0],
        [-137_087.0, -235_121.0, 353_913.0],
    ],
    legs: [
        1_000_000.0,
        645_275.0,
        1_086_284.0,
        1_503_439.0,
        1_281_933.0,
        771_071.0,
    ],
};

/// Place of the platform, then the first two directions of its frame: the loops of `unknown body = frame(...)`.
impl Equations<9> for Platform {
    fn values<T: Number>(&self, unknowns: &[T; 9]) -> [T; 9] {
        let [p, x, y] = [0, 3, 6].map(|first| [0, 1, 2].map(|k| unknowns[first + k]));
        let z = cross(x, y);
        let (unit, one) = (T::from(self.unit), T::from(1.0));
        core::array::from_fn(|i| match i {
            6 => dot(x, x) - one,
            7 => dot(y, y) - one,
            8 => dot(x, y),
            leg => {
                let [u, v, w] = self.platform[leg].map(T::from);
                let base = self.base[leg].map(T::from);
                let link =
                    [0, 1, 2].map(|k| unit * p[k] + u * x[k] + v * y[k] + w * z[k] - base[k]);
                let length = T::from(self.legs[leg]);
                // Values of about 1. The factor is rounded, which moves no solution.
                T::from(1.0 / (self.unit * self.unit)) * (dot(link, link) - length * length)
            }
        })
    }
}

fn dot<T: Number>([a, b, c]: [T; 3], [d, e, f]: [T; 3]) -> T {
    a * d + b * e + c * f
}

fn cross<T: Number>([a, b, c]: [T; 3], [d, e, f]: [T; 3]) -> [T; 3] {
    [b * f - c * e, c * d - a * f, a * e - b * d]
}

/// The equation of the last leg: the curve that the trace test cuts is of degree 40 then.
pub(crate) const LAST_LEG: usize = 5;
