//! A seed gives the same designs, however many threads there are.

#[path = "../programs/four_bar_paths/problems.rs"]
#[allow(dead_code, reason = "a part of another program")]
pub(crate) mod problems;

use super::{FourBar, FourBarAssembly, FourBarDesign, LENGTHS, evenly, points, problem};
use linkage::design::{Design, DesignError, DesignSearch, Objective, Progress, Relation, Targets};
use problems::problems;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

type Found = DesignSearch<FourBar, FourBarAssembly>;

fn small<'a>() -> FourBarDesign<'a> {
    problem().want(moved()).starts(256)
}

/// Points that no four-bar with this arm passes through.
fn moved() -> impl Objective<FourBar, FourBarAssembly> {
    let inputs = evenly(0.3, 0.9, 5);
    let moved: Vec<[f64; 2]> = points(&inputs)
        .iter()
        .map(|[x, y]| [x + 3.0 * y.sin(), *y])
        .collect();
    Targets::new("tracer", moved).computed_by(FourBarAssembly::path_sweep_sets_into)
}

#[test]
fn threads_do_not_matter() {
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("a pool");
        pool.install(|| small().seed(3).run())
            .expect("it can be found")
    };
    let (one, three) = (with(1), with(3));
    assert_eq!(one.designs.len(), three.designs.len());
    for (a, b) in one.designs.iter().zip(&three.designs) {
        assert_eq!(
            (a.mechanism, a.sum, a.start, a.hits),
            (b.mechanism, b.sum, b.start, b.hits)
        );
    }
    assert_eq!(one.evaluations, three.evaluations);
    let other = small().seed(4).run().expect("it can be found");
    assert_ne!(one.best().mechanism, other.best().mechanism);
}

#[test]
fn progress_time_and_cancellation() {
    let mut done = Vec::new();
    let found = small()
        .progress(|p| done.push((p.done, p.count)))
        .run()
        .expect("it can be found");
    assert!(!found.ended_early);
    assert_eq!(done.last(), Some(&(256, 256)));
    assert!(done.windows(2).all(|pair| pair[0].0 < pair[1].0));

    let stop = AtomicBool::new(true);
    let told = |design: FourBarDesign| design.run().map(|_| ()).expect_err("it is ended");
    assert_eq!(
        told(small().cancel(&stop)).to_string(),
        "the search was cancelled before the first of 256 starts was done; give it more time, or fewer starts"
    );
    assert_eq!(
        told(small().time_limit(Duration::ZERO)).to_string(),
        "the time limit of 0ns ended the search before the first of 256 starts was done; give it more time, or fewer starts"
    );
}

/// What was found until a search is cancelled is what one with so many starts finds, the best of it at least.
#[test]
fn an_ended_search_gives_what_it_has() {
    let stop = AtomicBool::new(false);
    let ended = small()
        .starts(4096)
        .cancel(&stop)
        .progress(|p| stop.store(p.done >= 96, Ordering::Relaxed))
        .run()
        .expect("some are found");
    assert!(ended.ended_early && (96..4096).contains(&ended.starts));
    let whole = small().starts(ended.starts).run().expect("the same");
    assert!(!whole.ended_early);
    assert!(!ended.designs.is_empty());
    for (a, b) in ended.designs.iter().zip(&whole.designs) {
        assert_eq!((a.mechanism, a.sum, a.hits), (b.mechanism, b.sum, b.hits));
    }
    let all = |found: &Found| found.designs.len() + found.not_whole + found.left_out;
    assert_eq!(all(&ended), all(&whole));
    assert!(ended.to_string().contains("ended early"), "{ended}");

    // One of which nothing is left says what refused the starts until then.
    stop.store(false, Ordering::Relaxed);
    let none = small()
        .hold(Relation::at_most([("crank", 1.0)], 5.0))
        .starts(4096)
        .cancel(&stop)
        .progress(|p| stop.store(p.done >= 96, Ordering::Relaxed))
        .run()
        .expect_err("only its bound holds the relation");
    let text = none.to_string();
    let DesignError::Ended {
        refusals,
        count: 4096,
        limit: None,
    } = none
    else {
        panic!("{text}");
    };
    assert_eq!(refusals.refused, refusals.starts);
    let told = format!(
        "the search was cancelled after {} of 4096 starts; none of",
        refusals.starts
    );
    assert!(text.starts_with(&told), "{text}");
}

/// A short list says how many distinct optima are left out, and begins as a long one.
#[test]
fn what_is_left_out_is_counted() {
    let (long, short) = (small().run(), small().listed(3).run());
    let (long, short) = (long.expect("found"), short.expect("found"));
    assert!(long.designs.len() > 4 && long.left_out == 0, "{long}");
    assert_eq!(short.designs, long.designs[..3]);
    let all = |found: &Found| found.designs.len() + found.not_whole + found.left_out;
    assert_eq!(all(&short), all(&long));
    let told = format!("{} optima with larger sums are left out", short.left_out);
    assert!(
        short.left_out >= 2 && short.to_string().contains(&told),
        "{short}"
    );
    assert!(!long.to_string().contains("left out"));

    // With values of a catalogue they are cut when they are rounded, not before: the best one may come from any of them.
    let listed = |listed: usize| {
        let lengths = (0..30).map(|i| 5.0 + 1.9 * f64::from(i));
        let design = Design::new(
            FourBar::default(),
            FourBar::assemble,
            FourBar::assemblies,
            FourBar::circuits,
        );
        let design = design
            .expect("it assembles")
            .want(moved())
            .starts(64)
            .listed(listed);
        let design = design.hold(Relation::crank_turns(LENGTHS, 0.0));
        let design = design.vary("frame", 5.0, 60.0).vary("crank", 5.0, 60.0);
        let design = design
            .catalogue("coupler", lengths.clone())
            .catalogue("rocker", lengths);
        design.run().expect("found")
    };
    assert_eq!(listed(1).designs, listed(100).designs[..1]);
}

#[test]
fn progress_is_a_bar() {
    let bar = |done, least| {
        let count = 1024;
        Progress { done, count, least }.to_string()
    };
    assert_eq!(
        bar(320, 0.012345),
        format!(
            "[{}{}] 320 of 1024, least 0.012345",
            "#".repeat(9),
            "-".repeat(21)
        )
    );
    assert_eq!(
        bar(0, f64::INFINITY),
        format!("[{}] 0 of 1024", "-".repeat(30))
    );
    assert_eq!(
        bar(1024, 0.5),
        format!("[{}] 1024 of 1024, least 0.5", "#".repeat(30))
    );
}

// Each seed finds the least sum that is known of each of the five path problems of the program `four_bar_paths`. `LINKAGE_LONG=1` takes 20 seeds and
// all five, others one seed and the four that take a few hundred starts.

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
