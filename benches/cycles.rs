//! Searches over whole cycles: `cargo bench -p linkage-benches --bench cycles`.
//!
//! The dwell of the program `longer_dwell`, as drawn and in the worst case of its tolerances, from the published drive to the certified
//! optimum on one thread; then from starts within the bounds, on all threads, with all distinct optima.

#[path = "../tests/longer_dwell/drive.rs"]
#[allow(dead_code, unreachable_pub, reason = "a part of another program")]
mod drive;

use drive::{BAND, EyeNeedle, design, way};
use linkage::design::Dwell;
use linkage::tolerance::Tolerances;
use linkage_peers::timing::{Candidate, interleave, only_tested};
use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Starts within the bounds.
const STARTS: usize = 200;

fn main() -> Result<(), Box<dyn Error>> {
    let stroke = drive::stroke()?;
    let tolerances = Tolerances::complete(EyeNeedle::PARAMETERS)?;
    let drawn = || design(Dwell::longest(way(), BAND), stroke);
    let built = || {
        design(
            Dwell::longest(way(), BAND).in_worst_case(&tolerances),
            stroke,
        )
    };
    let time = Duration::from_millis(if only_tested() { 1 } else { 3000 });
    let run = |name: &'static str, design: &dyn Fn() -> Result<drive::Problem, Box<dyn Error>>| {
        let found = design()?.run()?;
        println!(
            "{name}: {:.4} degrees in {} steps",
            found.goal.to_degrees(),
            found.steps
        );
        Ok::<_, Box<dyn Error>>(())
    };
    run("as drawn", &drawn)?;
    run("worst case", &built)?;
    let candidates = vec![
        Candidate::new("as drawn", 1, || {
            black_box(drawn().and_then(|design| Ok(design.run()?)).is_ok());
        }),
        Candidate::new("worst case", 1, || {
            black_box(built().and_then(|design| Ok(design.run()?)).is_ok());
        }),
    ];
    for times in interleave(candidates, time) {
        println!("{:<12} {:6.1} ms", times.name, 1e-6 * times.spread().median);
    }
    let starts = if only_tested() { 2 } else { STARTS };
    let begin = Instant::now();
    let all = drawn()?.starts(starts).run_all()?;
    println!("{starts} starts in {:.2} s:", begin.elapsed().as_secs_f64());
    for best in all {
        println!(
            "{:10.4} degrees, {} starts",
            best.goal.to_degrees(),
            best.hits
        );
    }
    Ok(())
}
