//! Two triads whose Newton steps are written by hand, and places on their solutions from high-precision references.

use linkage_runtime::numeric::continuation::{Correction, Step};

/// Plane vectors.
type Vector = [f64; 2];

fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1]]
}

fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

fn times(a: Vector, factor: f64) -> Vector {
    [factor * a[0], factor * a[1]]
}

fn product(a: Vector, b: Vector) -> Vector {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn turned(a: Vector) -> Vector {
    [-a[1], a[0]]
}

pub(crate) fn unit(angle: f64) -> Vector {
    [angle.cos(), angle.sin()]
}

/// Turns a unit vector by a small angle.
fn turn(u: &mut [f64], by: f64) {
    let new = sum([u[0], u[1]], times(turned([u[0], u[1]]), by));
    let length = dot(new, new).sqrt();
    u.copy_from_slice(&times(new, 1.0 / length));
}

/// `J r = f` by Cramer's rule, and the determinant.
fn solve(j: [Vector; 2], f: Vector) -> (Vector, f64) {
    let determinant = j[0][0] * j[1][1] - j[0][1] * j[1][0];
    let r = [
        (f[0] * j[1][1] - f[1] * j[0][1]) / determinant,
        (f[1] * j[0][0] - f[0] * j[1][0]) / determinant,
    ];
    (r, determinant)
}

/// Six links, RR-RR-RR: a crank drives a ternary link on three legs. The state is the direction of the driven leg, then
/// that of the ternary link.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EyeNeedle {
    pub(crate) crank: f64,
    pub(crate) legs: [f64; 3],
    pub(crate) sides: [f64; 2],
    pub(crate) angle: f64,
    pub(crate) pivots: [Vector; 2],
}

impl EyeNeedle {
    pub(crate) const MACHINE: Self = Self {
        crank: 50.0,
        legs: [272.5, 104.5, 261.0],
        sides: [81.0, 174.0],
        angle: 0.404_180_638_031_014_9,
        pivots: [[195.0, 226.0], [46.0, 533.0]],
    };

    /// Its assembly at the crank angle 0.
    pub(crate) fn start() -> Vec<f64> {
        let (leg, link) = (1.086_319_343_635_341_4, 2.541_305_500_641_144_5);
        [unit(leg), unit(link)].concat()
    }

    /// A crank of another length, and legs on the frame so long that the start stays what it is.
    pub(crate) fn with_crank(crank: f64) -> Self {
        let mut triad = Self {
            crank,
            ..Self::MACHINE
        };
        let state = Self::start();
        let arms = triad.arms([state[2], state[3]]);
        let p3 = sum([crank, 0.0], times([state[0], state[1]], triad.legs[0]));
        for (i, arm) in arms.into_iter().enumerate() {
            let d = difference(sum(p3, arm), triad.pivots[i]);
            triad.legs[i + 1] = dot(d, d).sqrt();
        }
        triad
    }

    /// Coefficients of `|A + a u + b t|^2 = r^2` for both legs on the frame: constant, u, 1/u, t, 1/t, u/t, t/u.
    pub(crate) fn system(&self, x: f64) -> Vec<[f64; 2]> {
        let square = |v: Vector| dot(v, v);
        let a = self.legs[0];
        let mut coefficients = Vec::new();
        for (i, b) in self.arms([1.0, 0.0]).into_iter().enumerate() {
            let p = difference(times(unit(x), self.crank), self.pivots[i]);
            let [re, im] = product([p[0], -p[1]], b);
            let r = self.legs[i + 1];
            coefficients.extend([
                [square(p) + a * a + square(b) - r * r, 0.0],
                [a * p[0], -a * p[1]],
                [a * p[0], a * p[1]],
                [re, im],
                [re, -im],
                [a * b[0], -a * b[1]],
                [a * b[0], a * b[1]],
            ]);
        }
        coefficients
    }

    /// The two sides of the ternary link from its driven joint.
    fn arms(&self, link: Vector) -> [Vector; 2] {
        let side = product(unit(self.angle), link);
        [times(link, self.sides[0]), times(side, self.sides[1])]
    }

    /// Crank angle, angle of the driven leg, angle of the ternary link.
    pub(crate) const PLACES: [[f64; 3]; 4] = [
        [
            1.260_448_221_130_955_1,
            0.880_141_279_692_704_2,
            2.644_676_171_573_129,
        ],
        [
            2.316_263_699_029_844,
            0.754_273_989_413_145_7,
            2.428_228_205_501_683,
        ],
        [
            3.665_191_429_188_092_3,
            0.850_075_744_113_230_4,
            2.140_645_431_129_261_3,
        ],
        [
            5.585_053_606_381_854,
            1.117_370_766_943_491_6,
            2.360_552_532_815_799,
        ],
    ];
}

impl Correction for EyeNeedle {
    fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step {
        turn(&mut state[..2], 0.0);
        turn(&mut state[2..], 0.0);
        let (leg, link) = ([state[0], state[1]], [state[2], state[3]]);
        let p3 = sum(times(unit(x[0]), self.crank), times(leg, self.legs[0]));
        let arms = self.arms(link);
        let along = turned(times(leg, self.legs[0]));
        let (mut j, mut f) = ([[0.0; 2]; 2], [0.0; 2]);
        for i in 0..2 {
            let r = self.legs[i + 1];
            let d = difference(sum(p3, arms[i]), self.pivots[i]);
            f[i] = -0.5 * (dot(d, d) - r * r) / (r * r);
            j[i] = times([dot(d, along), dot(d, turned(arms[i]))], 1.0 / (r * r));
        }
        let (r, determinant) = solve(j, f);
        turn(&mut state[..2], r[0]);
        turn(&mut state[2..], r[1]);
        Step {
            size: r[0].abs().max(r[1].abs()),
            determinant,
        }
    }
}

/// Two cranks that turn against each other and a slider, RR-RR-PR. The state is the direction of the ternary link and the
/// slide in units of 64.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TwoCranks;

impl TwoCranks {
    pub(crate) fn start() -> Vec<f64> {
        let [c, s] = unit(0.499_316_473_658_357_36);
        vec![c, s, 42.057_066_846_697_026 / 64.0]
    }

    /// Crank angle, slide, angle of the ternary link.
    pub(crate) const PLACES: [[f64; 3]; 3] = [
        [
            1.224_978_741_762_784_7,
            41.064_926_386_153_594,
            0.797_793_767_113_617_7,
        ],
        [
            3.577_924_966_588_375_4,
            47.293_537_861_735_75,
            0.440_083_188_897_149_8,
        ],
        [
            5.494_564_230_640_88,
            46.802_708_728_803_07,
            0.286_794_541_158_661_65,
        ],
    ];
}

impl Correction for TwoCranks {
    fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step {
        turn(&mut state[..2], 0.0);
        let link = [state[0], state[1]];
        let p2 = times(unit(-x[0]), 13.0);
        let p6 = sum([82.0, 22.0], times(unit(x[0]), 11.0));
        let p5 = [28.0, 64.0 * state[2]];
        let back = times(product(unit(-1.134_464_013_796_314_2), link), -40.0);
        let forth = sum(back, times(link, 66.0));
        let (mut j, mut f) = ([[0.0; 2]; 2], [0.0; 2]);
        for (i, (arm, from, r)) in [(back, p2, 68.0), (forth, p6, 85.0)]
            .into_iter()
            .enumerate()
        {
            let d = difference(sum(p5, arm), from);
            f[i] = -0.5 * (dot(d, d) - r * r) / (r * r);
            j[i] = times([dot(d, turned(arm)), 64.0 * d[1]], 1.0 / (r * r));
        }
        let (r, determinant) = solve(j, f);
        turn(&mut state[..2], r[0]);
        state[2] += r[1];
        Step {
            size: r[0].abs().max(r[1].abs()),
            determinant,
        }
    }
}
