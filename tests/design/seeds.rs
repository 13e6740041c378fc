//! Each seed finds the least sum that is known of each of the five path problems of the program `four_bar_paths`. `LINKAGE_LONG=1` takes 20 seeds and
//! all five, others one seed and the four that take a few hundred starts.

#[path = "../programs/four_bar_paths/problems.rs"]
#[allow(dead_code, reason = "a part of another program")]
pub(crate) mod problems;

use linkage::design::DesignError;
use problems::problems;

use super::{FourBar, FourBarAssembly};

/// A sum of squares of lengths of some ten millimetres that is zero but for rounding.
const ZERO: f64 = 1e-24;
/// Problems with more starts are for long runs.
const FEW: usize = 512;

#[test]
fn every_seed_finds_the_best_value() -> Result<(), DesignError> {
    let long = std::env::var_os("LINKAGE_LONG").is_some();
    let seeds = if long { 20 } else { 1 };
    for problem in problems() {
        if !long && problem.starts > FEW {
            continue;
        }
        let bound = (problem.known * (1.0 + 1e-9)).max(ZERO);
        for seed in 0..seeds {
            let found = problem.design()?.seed(seed).run()?;
            let sum = found.best().sum;
            assert!(
                sum <= bound,
                "{}, seed {seed}: {sum:e}, not {bound:e}",
                problem.name
            );
        }
    }
    Ok(())
}
