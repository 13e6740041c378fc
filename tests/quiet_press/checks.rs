//! What must hold of the presses, by other ways than those of the search.

use crate::check::Check;
use crate::{
    Found, Press, PressAssembly, SIDE, SPEED, Trade, design, print, sampled, shaking, torque,
};
use linkage::balancing::Balance;
use linkage::design::{Figure, Peak};
use std::error::Error;
use std::f64::consts::TAU;

/// The peak beside samples, and beside the presses nearby.
pub(crate) fn compare(peak: &Found, stroke: f64, check: &mut Check) {
    let of = |press: &PressAssembly| sampled(|phi| press.drive(phi, SPEED).t);
    check.near(
        "peak by samples, N m",
        1e-3 * of(&peak.assembly),
        1e-3 * peak.goal,
        1e-4,
    );
    let highest = sampled(|phi| peak.assembly.side(phi, SPEED).f.x);
    check.holds("the guide bears its force", highest < SIDE * (1.0 + 1e-6));
    let ram = |i: i32| peak.assembly.motion(TAU * f64::from(i) / 7200.0).ram;
    let (low, high) = (0..7200)
        .map(ram)
        .fold((f64::MAX, f64::MIN), |(low, high), y| {
            (low.min(y), high.max(y))
        });
    check.near("stroke, mm", high - low, stroke, 1e-4);

    // Presses that keep the stroke: its crank follows from rod and offset.
    let best = peak.mechanism;
    let mut least = f64::INFINITY;
    for k in 0..60_u32 {
        let random = |j: u32| {
            f64::from((k.wrapping_mul(2_654_435_761_u32.rotate_left(7 * j))) >> 12 & 1023) / 511.5
                - 1.0
        };
        let rod = (best.rod + random(0)).clamp(120.0, 220.0);
        let offset = (best.offset + random(1)).clamp(-25.0, 25.0);
        let (mut short, mut long) = (35.0, 45.0);
        for _ in 0..60 {
            let crank = 0.5 * (short + long);
            let reach = |length: f64| (length * length - offset * offset).sqrt();
            if reach(rod + crank) - reach(rod - crank) < stroke {
                short = crank
            } else {
                long = crank
            }
        }
        let [ahead, across] = [best.ahead + 0.1 * random(2), best.across + 0.1 * random(3)];
        let Ok(other) = (Press {
            crank: short,
            rod,
            offset,
            ahead,
            across,
        })
        .assemble() else {
            continue;
        };
        if sampled(|phi| other.side(phi, SPEED).f.x) <= SIDE {
            least = least.min(of(&other));
        }
    }
    println!("  least peak of presses nearby: {:.4} N m", 1e-3 * least);
    check.holds(
        "no press nearby has a lower peak",
        least >= peak.goal * (1.0 - 1e-5) && least.is_finite(),
    );
}

/// With the lengths that were found, the best counterweights are a linear problem.
pub(crate) fn compare_counterweights(
    peak: &Found,
    check: &mut Check,
) -> Result<(), Box<dyn Error>> {
    let bare = Press {
        ahead: 0.0,
        across: 0.0,
        ..peak.mechanism
    }
    .assemble()?;
    let turn: Vec<f64> = (0..7200).map(|i| TAU * f64::from(i) / 7200.0).collect();
    let torques: Vec<f64> = turn.iter().map(|&phi| bare.drive(phi, SPEED).t).collect();
    let masses = [Press::INDEX_AHEAD, Press::INDEX_ACROSS];
    let effects: Vec<[f64; 2]> = turn
        .iter()
        .map(|&phi| masses.map(|k| bare.effects(phi, SPEED).e[k]))
        .collect();
    let least = Balance::new(&torques, &effects)?.peak()?;
    check.near(
        "peak with the best counterweights, N m",
        1e-3 * peak.goal,
        1e-3 * least.after.peak,
        1e-5,
    );
    check.near(
        "mass along the crank, kg",
        peak.mechanism.ahead,
        least.values[0],
        1e-2,
    );
    Ok(())
}

/// With no more shaking than before the peak is higher than without that limit, and still lower than it was.
pub(crate) fn compare_shaking(
    first: &PressAssembly,
    peak: &Found,
    stroke: f64,
    check: &mut Check,
) -> Result<(), Box<dyn Error>> {
    let of = |press: &PressAssembly| {
        sampled(|phi| {
            let force = press.shaking(phi, SPEED).f;
            force.x.hypot(force.y)
        })
    };
    let (before, shaken) = (of(first), of(&peak.assembly));
    let calm = design(stroke)?
        .want(Peak(torque()).least())
        .want(Peak(shaking()).at_most(before))
        .run()?;
    print("no more shaking", &calm.assembly);
    println!(
        "  shaking: {before:.1} N before, {shaken:.1} N at the least peak, {:.1} N within its limit",
        of(&calm.assembly)
    );
    check.holds(
        "the foundation bears no more than before",
        of(&calm.assembly) <= before * (1.0 + 1e-6),
    );
    let torques = sampled(|phi| first.drive(phi, SPEED).t);
    let between = peak.goal * (1.0 - 1e-6) <= calm.goal && calm.goal < torques;
    check.holds("which costs some of the peak, not all of it", between);
    Ok(())
}

/// The front: none of its presses is better in both, and that of our guide is on it or beside it.
pub(crate) fn compare_front(front: &[Trade], peak: &Found, check: &mut Check) {
    println!("Peak of the torque against the force on the guide:");
    for found in front {
        println!(
            "  {:8.3} N m  {:7.1} N",
            1e-3 * found.best.goal,
            found.other
        );
    }
    let falls =
        |pair: &[Trade]| pair[0].best.goal < pair[1].best.goal && pair[0].other > pair[1].other;
    check.holds(
        "compromises contradict each other",
        front.len() > 2 && front.windows(2).all(falls),
    );
    let beaten = |found: &Trade| found.other <= SIDE && found.best.goal < peak.goal * (1.0 - 1e-5);
    check.holds(
        "none is better than the press that was found",
        !front.iter().any(beaten),
    );
}
