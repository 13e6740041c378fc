//! Starts of searches: several starts with a certificate, all assemblies, and any seed.

#[path = "../longer_dwell/drive.rs"]
#[allow(dead_code, unreachable_pub, reason = "a part of another program")]
mod drive;

use super::{N, Rocker, RockerAssembly, design, speed, tip};
use drive::{BAND, stroke, way};
use linkage::Dimensions;
use linkage::design::{
    BestCycle, CycleDesign, DesignError, Dwell, Figure, Highest, Interruption, Peak,
};
use linkage::tolerance::Tolerances;
use std::error::Error;

// Several starts, and the certificate of what is found.

#[test]
fn starts_are_reproducible_and_their_optima_listed() -> Result<(), DesignError> {
    let run = |starts: usize, seed: u64| {
        let mut reports = Vec::new();
        let design = design()
            .want(Dwell::longest(tip(), 1.0))
            .starts(starts)
            .seed(seed);
        let found = design
            .progress(|p| reports.push((p.done, p.count)))
            .run_all();
        assert_eq!(reports.last(), Some(&(starts, starts)));
        assert!(reports.windows(2).all(|pair| pair[0].0 < pair[1].0));
        found
    };
    let (one, other) = (run(8, 3)?, run(8, 3)?);
    assert_eq!(values(&one), values(&other));
    assert!(one.iter().map(|best| best.hits).sum::<usize>() <= 8 && one[0].hits > 1);
    assert!(one.windows(2).all(|pair| pair[0].goal >= pair[1].goal));
    let alone = run(1, 0)?;
    assert!(alone.len() == 1 && one[0].goal >= alone[0].goal - 1e-6);

    let flag = std::sync::atomic::AtomicBool::new(true);
    let ended = design()
        .want(Dwell::longest(tip(), 1.0))
        .cancel(&flag)
        .run()?;
    assert!(!ended.converged && ended.steps == 0 && ended.goal < alone[0].goal);
    let none = std::time::Duration::ZERO;
    assert!(
        !design()
            .want(Dwell::longest(tip(), 1.0))
            .time_limit(none)
            .run()?
            .converged
    );
    Ok(())
}

fn values(all: &[BestCycle<Rocker, RockerAssembly>]) -> Vec<([f64; N], f64, usize, usize)> {
    all.iter()
        .map(|best| (best.mechanism.values(), best.goal, best.hits, best.steps))
        .collect()
}

/// In the worst case, too, where each search gathers corners of the tolerances of its own.
#[test]
fn threads_do_not_matter() {
    let wide = Tolerances::new(Rocker::PARAMETERS, &[0.05; N]).expect("as many");
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("a pool");
        let run = || {
            let dwell = Dwell::longest(tip(), 1.0).in_worst_case(&wide);
            design().want(dwell).starts(5).run_all()
        };
        pool.install(run).expect("some are found")
    };
    assert_eq!(values(&with(1)), values(&with(3)));
}

#[test]
fn what_is_found_is_certified() {
    // Circuits of another mechanism: none of them is what was found.
    let other = |rocker: &Rocker| {
        Rocker {
            coupler: rocker.coupler + 0.1,
            ..*rocker
        }
        .circuits()
    };
    let design = CycleDesign::new(
        Rocker::default(),
        Rocker::assemble,
        Rocker::assemble_from,
        other,
    );
    let design = design
        .expect("assembles")
        .vary_by("crank", 0.1)
        .want(Peak(speed()).least());
    assert_eq!(
        design.run().err(),
        Some(DesignError::NotWhole(Interruption::Apart))
    );
}

// Searches in all assemblies of the first mechanism.

/// From the assembly of the declaration, or from another one.
fn from(assembly: RockerAssembly) -> CycleDesign<'static, Rocker, RockerAssembly, N> {
    let design = CycleDesign::new(
        Rocker::default(),
        |_| Ok(assembly),
        Rocker::assemble_from,
        Rocker::circuits,
    );
    let design = design.expect("it is given").vary_by("crank", 0.1);
    design.vary_by("coupler", 0.1).vary_by("rocker", 0.1)
}

/// The other assembly is the mirror image: its rocker swings below the frame, where the tip is elsewhere. All is found that starting there finds.
#[test]
fn both_assemblies_are_searched() -> Result<(), DesignError> {
    let wish = || Highest(tip()).least();
    let alone = design().want(wish()).starts(3).run_all()?;
    let all = design()
        .want(wish())
        .starts(3)
        .in_all_assemblies()
        .run_all()?;
    let own = Rocker::default().assemble().expect("assembles");
    let circuits = Rocker::default().circuits().expect("assembles");
    let others = circuits.whole().map(|branch| &branch.assembly);
    let mut others = others.filter(|assembly| assembly.modes() != own.modes());
    let (Some(other), None) = (others.next(), others.next()) else {
        panic!("two assemblies");
    };
    let there = from(*other).want(wish()).starts(3).run_all()?;
    assert!((there[0].goal - alone[0].goal).abs() > 1.0);
    assert_eq!(all[0].goal, f64::min(there[0].goal, alone[0].goal));
    let goals = |goal: f64| all.iter().any(|best| best.goal == goal);
    assert!(alone.iter().chain(&there).all(|best| goals(best.goal)));
    assert_eq!(all.len(), alone.len() + there.len());
    let hits: usize = all.iter().map(|best| best.hits).sum();
    assert_eq!(hits, 6);
    let modes = all.iter().map(|best| best.assembly.modes());
    assert!(modes.clone().any(|modes| modes == own.modes()));
    assert!(modes.clone().any(|modes| modes == other.modes()));
    // Begun in the other one, the same are found.
    let back = from(*other)
        .want(wish())
        .starts(3)
        .in_all_assemblies()
        .run_all()?;
    let values = |all: &[linkage::design::BestCycle<Rocker, RockerAssembly>]| {
        let mut goals: Vec<f64> = all.iter().map(|best| best.goal).collect();
        goals.sort_by(f64::total_cmp);
        goals
    };
    assert_eq!(values(&back), values(&all));
    Ok(())
}

// Searches of the longest dwell of the program `longer_dwell` from starts anywhere within its bounds: from every seed one at least leads to 94
// degrees. `LINKAGE_LONG=1` takes 20 seeds.

/// Starts of a search; the first one is the published drive.
const STARTS: usize = 8;

#[test]
fn long_dwells_are_found_from_every_seed() -> Result<(), Box<dyn Error>> {
    let long = std::env::var_os("LINKAGE_LONG").is_some();
    let stroke = stroke()?;
    for seed in 0..if long { 20 } else { 1 } {
        let all = drive::design(Dwell::longest(way(), BAND), stroke)?
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
