//! Searches of dimensions: `cargo bench -p linkage-benches --bench design`.
//!
//! The five path problems of the program `four_bar_paths`, on one thread and on two: all together, with the least sum of each of 20 seeds
//! against the least one known; then residuals with their derivatives a second, in lanes over mechanisms.

mod mechanism {
    include!("../mechanisms/four_bar_paths.rs");
}
#[path = "../tests/programs/four_bar_paths/problems.rs"]
#[allow(dead_code, reason = "the program needs fewer starts")]
mod problems;

use linkage::design::{Candidates, Objective, Rows, Targets};
use linkage::{AssemblyError, Dimensions};
use linkage_peers::timing::{Candidate, interleave, only_tested};
use mechanism::{FourBar, FourBarAssembly};
use problems::{Problem, problems};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Seeds of which each must find the least sum.
const SEEDS: u64 = 20;
/// A sum that is zero but for rounding.
const ZERO: f64 = 1e-24;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()?;
        pool.install(|| searches(threads));
    }
    residuals()?;
    Ok(())
}

/// Every problem from every seed, and the time of all problems for each seed.
fn searches(threads: usize) {
    let seeds = if only_tested() { 1 } else { SEEDS };
    let problems = problems();
    let mut totals = vec![0.0; seeds as usize];
    println!(
        "{:<30}{:>9}{:>14}{:>14}{:>8}{:>14}",
        "problem", "starts", "known", "largest", "found", "evaluations"
    );
    for problem in &problems {
        let (mut largest, mut found, mut evaluations) = (0.0_f64, 0, 0);
        for seed in 0..seeds {
            let began = Instant::now();
            let search = one(problem, seed);
            totals[seed as usize] += began.elapsed().as_secs_f64();
            if let Some((sum, count)) = search {
                largest = largest.max(sum);
                evaluations += count;
                found += usize::from(sum <= (problem.known * (1.0 + 1e-9)).max(ZERO));
            }
        }
        println!(
            "{:<30}{:>9}{:>14.6e}{largest:>14.6e}{found:>5}/{seeds:<2}{:>14}",
            problem.name,
            problem.starts,
            problem.known,
            evaluations / seeds as usize
        );
    }
    totals.sort_by(f64::total_cmp);
    let (least, most) = (totals[0], totals[totals.len() - 1]);
    let median = totals[totals.len() / 2];
    println!(
        "all five, threads: {threads}: {median:.3} s ({least:.3} to {most:.3}) over {seeds} seeds\n"
    );
}

/// The least sum from a seed, and how many mechanisms were evaluated.
fn one(problem: &Problem, seed: u64) -> Option<(f64, usize)> {
    let starts = if only_tested() {
        problem.few / 2
    } else {
        problem.starts
    };
    let found = problem
        .design()
        .ok()?
        .starts(starts)
        .seed(seed)
        .run()
        .ok()?;
    Some((found.best().sum, found.evaluations))
}

/// Residuals with all derivatives of the path of a crank-rocker: rows of the wish, and the sweep below it alone.
fn residuals() -> Result<(), AssemblyError> {
    const MECHANISMS: usize = 64;
    const POINTS: usize = 10;
    let assembly = FourBar::default().assemble()?;
    let values = FourBar::default().values();
    let mechanisms: Vec<FourBar> = (0..MECHANISMS)
        .map(|i| FourBar::from_values(&values.map(|value| value * (1.0 + 1e-4 * i as f64))))
        .collect();
    let inputs = (0..POINTS).map(|i| TAU * i as f64 / POINTS as f64);
    let free: Vec<f64> = (0..MECHANISMS).flat_map(|_| inputs.clone()).collect();
    let wish = Targets::new("tracer", [[10.0, 10.0]; POINTS])
        .computed_by(FourBarAssembly::path_sweep_sets_into);
    let mut rows = Rows::new(2 * POINTS, 9, POINTS);
    let mut evaluator = Objective::<FourBar, FourBarAssembly>::evaluator(&wish);
    let sets: Vec<FourBar> = mechanisms
        .iter()
        .flat_map(|mechanism| [*mechanism; POINTS])
        .collect();
    let mut columns = mechanism::PathColumns::default();
    let items = 2 * POINTS * MECHANISMS;
    let candidates = vec![
        Candidate::new("sweep over mechanisms", items, || {
            assembly.path_sweep_sets_into(black_box(&sets), black_box(&free), &mut columns);
        }),
        Candidate::new("rows of the wish", items, || {
            let candidates = Candidates {
                assembly: &assembly,
                mechanisms: black_box(&mechanisms),
                free: black_box(&free),
            };
            rows.reset(MECHANISMS);
            evaluator.evaluate(&candidates, &mut rows);
        }),
    ];
    let time = if only_tested() {
        Duration::ZERO
    } else {
        Duration::from_secs(1)
    };
    for times in interleave(candidates, time) {
        let spread = times.spread();
        println!(
            "{:<30}{:>8.2} ns a residual with derivatives, {:.1e} a second",
            times.name,
            spread.median,
            1e9 / spread.median
        );
    }
    Ok(())
}
