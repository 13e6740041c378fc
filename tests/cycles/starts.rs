//! Several starts, and the certificate of what is found.

use super::{N, Rocker, RockerAssembly, design, speed, tip};
use linkage::Dimensions;
use linkage::design::{BestCycle, CycleDesign, DesignError, Dwell, Figure, Interruption, Peak};
use linkage::tolerance::Tolerances;

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
