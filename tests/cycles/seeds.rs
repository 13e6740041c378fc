//! Searches of the longest dwell of the program `longer_dwell` from starts anywhere within its bounds: from every seed one at least leads to 94
//! degrees. `LINKAGE_LONG=1` takes 20 seeds.

#[path = "../longer_dwell/drive.rs"]
#[allow(dead_code, unreachable_pub, reason = "a part of another program")]
mod drive;

use drive::{BAND, design, stroke, way};
use linkage::design::Dwell;
use std::error::Error;

/// Starts of a search; the first one is the published drive.
const STARTS: usize = 8;

#[test]
fn long_dwells_are_found_from_every_seed() -> Result<(), Box<dyn Error>> {
    let long = std::env::var_os("LINKAGE_LONG").is_some();
    let stroke = stroke()?;
    for seed in 0..if long { 20 } else { 1 } {
        let all = design(Dwell::longest(way(), BAND), stroke)?
            .starts(STARTS)
            .seed(seed)
            .run_all()?;
        let long_enough = all.iter().filter(|best| best.goal.to_degrees() >= 94.0);
        let starts: usize = long_enough.map(|best| best.hits).sum();
        // One of them is the published drive.
        assert!(starts > 1, "seed {seed}: {starts} of {STARTS} starts");
    }
    Ok(())
}
