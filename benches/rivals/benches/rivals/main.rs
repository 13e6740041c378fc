//! Time to a given error, against solvers of the registry: `cargo bench --manifest-path benches/rivals/Cargo.toml`.
//!
//! The path problem of five points with their angles, six variables, on one thread. Each method runs until its limit of time from
//! each seed, begins anew where it stops, and every improvement is noted with its time. The error is how far the sum of squares
//! is above the least one known, as part of it. All others than `linkage::design` get Grashof's condition and the bounds as a
//! penalty, which does not touch the least sum: all of them hold there.
//!
//! What `run_pylinkage.py` has measured of the same problem stands below it, as it was then.

mod mechanism {
    include!("../../../../mechanisms/four_bar_paths.rs");
}
mod methods;
mod objective;
mod plot;
#[path = "../../../../tests/programs/four_bar_paths/problems.rs"]
#[allow(dead_code, reason = "the program needs fewer starts")]
mod problems;
mod pylinkage;

use mechanism::{FourBar, FourBarAssembly};
use methods::METHODS;
use objective::Trace;
use plot::Line;
use std::time::Duration;

/// Errors that are asked for.
const ERRORS: [f64; 5] = [1.0, 1e-1, 1e-2, 1e-4, 1e-8];

fn main() -> std::io::Result<()> {
    let tested = !std::env::args().any(|argument| argument == "--bench");
    let (seeds, limit) = if tested {
        (1, Duration::from_millis(20))
    } else {
        (10, Duration::from_secs(1))
    };
    let one = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("a pool");
    println!(
        "median time in ms to an error; in parentheses how many of {seeds} seeds came there within {limit:?}"
    );
    print!("{:<48}", "method");
    ERRORS.iter().for_each(|error| print!("{error:>18e}"));
    println!();
    let mut lines = Vec::new();
    for (name, run) in METHODS {
        let traces: Vec<_> = (0..seeds)
            .map(|seed| one.install(|| run(seed, limit)))
            .collect();
        print_row(name, |error| time_to(&traces, error));
        let points = plot::errors().map(|error| (time_to(&traces, error).0, error));
        let points = points.collect();
        lines.push(Line { name, points });
    }
    let measured = pylinkage::measured();
    for method in &measured.methods {
        print_row(method.name, |error| method.time_to(error));
        let points = method.points().collect();
        lines.push(Line {
            name: method.name,
            points,
        });
    }
    println!("{}", measured.about);
    if tested {
        return Ok(());
    }
    let about = format!(
        "Five points with their angles, six variables; median of {seeds} seeds on one thread, each begins anew for {} s.",
        limit.as_secs()
    );
    let docs = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/design.svg");
    std::fs::write(docs, plot::svg(&lines, &[&about, measured.about]))
}

/// A row of the table: a method's median time to each error, and how many seeds came there.
fn print_row(name: &str, time_to: impl Fn(f64) -> (f64, usize)) {
    print!("{name:<48}");
    for error in ERRORS {
        let (median, reached) = time_to(error);
        let text = if median.is_finite() {
            format!("{:.2}", 1e3 * median)
        } else {
            "-".into()
        };
        print!("{:>18}", format!("{text} ({reached})"));
    }
    println!();
}

/// The median time to an error, infinite if half of the traces do not come there, and how many do.
fn time_to(traces: &[Trace], error: f64) -> (f64, usize) {
    let mut times: Vec<f64> = traces.iter().map(|trace| trace.time_to(error)).collect();
    times.sort_by(f64::total_cmp);
    let reached = times.iter().filter(|time| time.is_finite()).count();
    (times[times.len() / 2], reached)
}
