//! Run time against error, for the kernel K1 (a crank-rocker with a coupler point): the generated code in
//! several number types, and the other ways of computing the same numbers.
//!
//! `cargo bench -p linkage-benches --bench pareto` takes some minutes and writes `docs/pareto.md`,
//! `docs/pareto.svg` and `docs/pareto-hard.svg`; `cargo bench -p linkage-benches --bench pareto -- --quick` takes one and only prints, unless
//! `--write` is added.
//!
//! All methods see the same positions, in order round the cycle, as a simulation would step through
//! them (which is what Newton's method needs to start from the position before). They are timed
//! in turn, one position at a time unless the name says "sweep".

#[allow(
    dead_code,
    reason = "an example's module, of which only a part is used here"
)]
#[path = "../../tests/programs/double_double/number.rs"]
mod double_double;
mod errors;
mod hostile;
mod labels;
mod methods;
mod panels;
mod plot;
mod table;

use linkage_peers::timing::{Times, interleave, only_tested};
use linkage_peers::{Random, environment};
use std::time::Duration;

/// What is measured of one method.
struct Outcome {
    name: &'static str,
    family: methods::Family,
    times: Times,
    errors: errors::Errors,
}

/// A question that all methods answer.
struct Panel {
    title: &'static str,
    /// What roundoffs are multiplied by to be the unit of errors.
    unit: &'static str,
    /// Names of the parts of the answer whose errors are told apart.
    parts: Vec<&'static str>,
    outcomes: Vec<Outcome>,
}

fn main() -> std::io::Result<()> {
    let has = |option: &str| std::env::args().any(|argument| argument == option);
    let (quick, test) = (has("--quick"), only_tested());
    let (count, seconds) = match (test, quick) {
        (true, _) => (16, 0.01),
        (_, true) => (512, 12.0),
        _ => (2048, 75.0),
    };
    let positions = positions(count);
    let time = Duration::from_secs_f64(seconds);
    let point = panels::point(&positions, time / 2);
    let hostile = hostile::panel(&point);
    let panels = [
        panels::motion(&positions, time),
        point,
        panels::accuracy(&positions, time / 2),
        hostile,
    ];
    let about = environment::describe(if quick {
        "cargo bench -p linkage-benches --bench pareto -- --quick"
    } else {
        "cargo bench -p linkage-benches --bench pareto"
    });
    print!("{}", table::text(&panels, &about));
    if test || (quick && !has("--write")) {
        return Ok(());
    }
    let docs = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs");
    std::fs::write(
        format!("{docs}/pareto.md"),
        table::markdown(&panels, &about),
    )?;
    let [easy, .., hard] = &panels;
    std::fs::write(format!("{docs}/pareto.svg"), plot::svg(easy, &about))?;
    std::fs::write(format!("{docs}/pareto-hard.svg"), plot::svg(hard, &about))
}

/// Random positions in order round the cycle. They are numbers of `f32`, so that it gets the same.
fn positions(count: usize) -> Vec<f64> {
    let mut random = Random::new(20);
    let mut positions: Vec<f64> = (0..count)
        .map(|_| f64::from(random.between(0.0, std::f64::consts::TAU) as f32))
        .collect();
    positions.sort_by(f64::total_cmp);
    positions
}

/// Times the methods and takes their errors.
fn measure<const W: usize>(
    title: &'static str,
    parts: &[errors::Part],
    methods: Vec<methods::Method<'_, W>>,
    exact: &[Vec<linkage_peers::reference::Exact>],
    time: Duration,
) -> Panel {
    let mut facts = Vec::new();
    let mut candidates = Vec::new();
    for method in methods {
        facts.push((
            method.name,
            method.family,
            errors::Errors::of(&method.results, exact, parts),
        ));
        candidates.push(method.candidate);
    }
    let times = interleave(candidates, time);
    let outcomes = facts
        .into_iter()
        .zip(times)
        .map(|((name, family, errors), times)| Outcome {
            name,
            family,
            times,
            errors,
        });
    Panel {
        title,
        unit: "size of the mechanism",
        parts: parts.iter().map(|part| part.name).collect(),
        outcomes: outcomes.collect(),
    }
}
