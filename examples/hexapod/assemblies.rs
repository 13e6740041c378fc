//! All assemblies of a platform: the one that P. Dietmaier found in 1998, of which all 40 are real.

use super::check::Check;
use super::numbers;
use linkage::design::exact::{Equations, Number, Solution, solutions_traced};
use serde_json::Value;
use std::error::Error;

/// Six legs from a base to a platform, in millionths of the unit: whole numbers, so that the published digits are exact.
struct Platform {
    base: [[f64; 3]; 6],
    platform: [[f64; 3]; 6],
    legs: [f64; 6],
}

/// P. Dietmaier, The Stewart-Gough platform of general geometry can have 40 real postures, Advances in Robot Kinematics, 1998.
const DIETMAIER: Platform = Platform {
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
        let (million, one) = (T::from(1e6), T::from(1.0));
        core::array::from_fn(|i| match i {
            6 => dot(x, x) - one,
            7 => dot(y, y) - one,
            8 => dot(x, y),
            leg => {
                let [u, v, w] = self.platform[leg].map(T::from);
                let base = self.base[leg].map(T::from);
                let link =
                    [0, 1, 2].map(|k| million * p[k] + u * x[k] + v * y[k] + w * z[k] - base[k]);
                let length = T::from(self.legs[leg]);
                // Values of about 1. The factor is rounded, which moves no solution.
                T::from(1e-12) * (dot(link, link) - length * length)
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
const LAST_LEG: usize = 5;

/// Lists all assemblies and compares them with solutions in 80 digits.
pub(super) fn show(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let found = solutions_traced(&DIETMAIER, LAST_LEG)?;
    let trace = found.trace.ok_or("the test was asked for")?;
    println!(
        "       {} real, {} complex, {} undecided; no more over {} loops; trace test: {} points, their sum linear to {:.0e}",
        found.real.len(),
        found.complex,
        found.undecided,
        found.idle,
        trace.degree,
        trace.miss
    );
    check.holds("40 assemblies, all of them real", found.real.len() == 40);
    check.holds("none is missing", found.is_complete());
    let known: Vec<Value> = serde_json::from_str(include_str!("dietmaier.json"))?;
    let known: Vec<[f64; 9]> = known.iter().map(unknowns).collect::<Result<_, _>>()?;
    let mut met: Vec<usize> = Vec::new();
    let mut pairs = Vec::new();
    for solution in &found.real {
        let nearest = (0..known.len())
            .min_by(|&a, &b| off(solution, &known[a]).total_cmp(&off(solution, &known[b])))
            .ok_or("there are known solutions")?;
        met.push(nearest);
        pairs.extend(solution.values.into_iter().zip(known[nearest]));
    }
    // Roundoffs of numbers up to 1: the solutions are certified with more digits.
    check.all_near("places and directions", pairs, 2.5e-16);
    let errors = found.real.iter().map(|solution| (solution.error, 0.0));
    check.all_near("bounds of their errors", errors, 2.5e-16);
    met.sort_unstable();
    check.holds(
        "each known one is found once",
        met.into_iter().eq(0..known.len()),
    );
    Ok(())
}

fn unknowns(known: &Value) -> Result<[f64; 9], Box<dyn Error>> {
    let [p, x, y] = ["p", "x", "y"].map(|part| numbers::<3>(&known[part]));
    let all = [p?, x?, y?].concat();
    all.try_into().map_err(|_| "three vectors".into())
}

fn off(solution: &Solution<9>, known: &[f64; 9]) -> f64 {
    let pairs = solution.values.iter().zip(known);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
