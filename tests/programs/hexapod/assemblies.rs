//! All assemblies of platforms: of the one that P. Dietmaier found in 1998 all 40 are real, of the one that is followed here eight at one end of the
//! path, and six at the other.

use super::geometry::{FEET, JOINTS};
use super::numbers;
use super::platform::{DIETMAIER, LAST_LEG, Platform};
use crate::check::Check;
use linkage::design::exact::{Solution, solutions_traced};
use serde_json::Value;
use std::error::Error;

/// Lists all assemblies and compares them with solutions in 80 digits.
pub(super) fn show(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let known: Vec<Value> =
        serde_json::from_str(include_str!("../../../mechanisms/hexapod/dietmaier.json"))?;
    check.holds("40 known assemblies, all of them real", known.len() == 40);
    compare(check, &DIETMAIER, &known, 1.0)?;
    let ends: Vec<Value> =
        serde_json::from_str(include_str!("../../../mechanisms/hexapod/assemblies.json"))?;
    for (known, real) in ends.iter().zip([8, 6]) {
        let platform = followed(numbers::<6>(&known["legs"])?);
        let known = known["poses"].as_array().ok_or("there are known poses")?;
        check.holds("so many are known to be real", known.len() == real);
        compare(check, &platform, known, 1000.0)?;
    }
    Ok(())
}

/// The platform that is followed here, in millionths of a millimetre; its place is in metres.
fn followed(legs: [f64; 6]) -> Platform {
    let whole = |x: f64| (x * 1e6).round();
    Platform {
        unit: 1e9,
        base: FEET.map(|own| own.map(whole)),
        platform: JOINTS.map(|own| own.map(whole)),
        legs: legs.map(whole),
    }
}

/// `unit` is what the known places count of the unit of the platform's.
fn compare(
    check: &mut Check,
    platform: &Platform,
    known: &[Value],
    unit: f64,
) -> Result<(), Box<dyn Error>> {
    let found = solutions_traced(platform, LAST_LEG)?;
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
    check.holds(
        "40 assemblies, real and complex",
        found.real.len() + found.complex == 40 && found.real.len() == known.len(),
    );
    check.holds("none is missing", found.is_complete());
    let known = known.iter().map(|own| unknowns(own, unit));
    let known: Vec<[f64; 9]> = known.collect::<Result<_, _>>()?;
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

fn unknowns(known: &Value, unit: f64) -> Result<[f64; 9], Box<dyn Error>> {
    let [p, x, y] = ["p", "x", "y"].map(|part| numbers::<3>(&known[part]));
    let all = [p?.map(|place| place / unit), x?, y?].concat();
    all.try_into().map_err(|_| "three vectors".into())
}

fn off(solution: &Solution<9>, known: &[f64; 9]) -> f64 {
    let pairs = solution.values.iter().zip(known);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
