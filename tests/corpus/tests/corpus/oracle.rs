//! Programs against the expression graph, derivatives against differences, closed loops and the chosen configuration,
//! for random mechanisms.

use std::f64::consts::TAU;
use std::sync::Arc;

use linkage_corpus::{Case, Entry, Function, Kind, Position, Subject, Variable};
use linkage_random::Random;

use super::case;

/// Mechanisms for each test; `ORACLE_COUNT=5000` in the environment takes more.
const COUNT: u64 = super::KEPT as u64;

fn count() -> u64 {
    let wanted = std::env::var("ORACLE_COUNT").ok();
    wanted.and_then(|text| text.parse().ok()).unwrap_or(COUNT)
}

fn cases() -> impl Iterator<Item = Arc<Case>> {
    (0..count()).map(|seed| case(seed).unwrap_or_else(|message| panic!("{message}")))
}

#[test]
fn every_mechanism_compiles() {
    // From behind, so that two threads share the work of compiling.
    let seeds = (0..count()).rev();
    let refused: Vec<String> = seeds.filter_map(|seed| case(seed).err()).collect();
    assert!(
        refused.is_empty(),
        "{} refused, first {}",
        refused.len(),
        refused[0]
    );
}

#[test]
fn programs_agree_with_the_graph() {
    let mut worst = 0.0;
    for case in cases() {
        let mut random = Random::new(case.seed);
        for (index, function) in case.sample.functions.iter().enumerate() {
            let at = case.position(&mut random);
            let program = case.subject.by_program(index, &at);
            let graph = case.subject.by_graph(index, &at);
            if function.kind == Kind::Closure {
                continue;
            }
            let differences = case.differences(index, &at, &program, &graph);
            for (k, difference) in differences.into_iter().enumerate() {
                worst = f64::max(worst, difference);
                let entry = function.entries.get(k);
                let (p, g) = (program[k], graph[k]);
                let what = || {
                    format!(
                        "result {k} {entry:?}: program {p:e}, graph {g:e}, {difference} roundoffs"
                    )
                };
                assert!(difference <= 32.0, "{}", case.complain(function, &what()));
            }
        }
    }
    println!("largest difference: {worst:.2} times what a roundoff of the data does");
}

#[test]
fn derivatives_agree_with_differences() {
    for case in cases() {
        let mut random = Random::new(case.seed);
        for (index, function) in case.sample.functions.iter().enumerate() {
            if function.kind == Kind::Derivatives {
                let at = case.position(&mut random);
                check_differences(&case, index, function, &at);
            }
        }
    }
}

fn check_differences(case: &Case, index: usize, function: &Function, at: &Position) {
    let values = case.subject.by_program(index, at);
    for (k, entry) in function.entries.iter().enumerate() {
        let Some((&last, before)) = entry.by.split_last() else {
            continue;
        };
        let base = find(&function.entries, entry, before);
        // Five-point differences of two step sizes.
        let unit = case.unit_of(last);
        let difference = |h: f64| {
            let f = |step: f64| {
                case.subject
                    .by_program(index, &case.shifted(at, last, step * h))[base]
            };
            (8.0 * (f(1.0) - f(-1.0)) - (f(2.0) - f(-2.0))) / (12.0 * h)
        };
        let h = unit * case.sample.range * 0.02;
        let (coarse, fine) = (difference(h), difference(h / 2.0));
        let noise = 1e-12 * (values[base].abs() + 50.0 * case.sample.millimetre) / h;
        let tolerance = 2.0 * (coarse - fine).abs() + 1e-6 * values[k].abs() + 10.0 * noise;
        let tolerance = tolerance + 1e-9 / unit;
        let what = || {
            let (name, by) = (&entry.name, &entry.by);
            let value = values[k];
            format!("{name} {by:?}: derivative {value:e}, difference {fine:e} (coarser {coarse:e})")
        };
        let error = (values[k] - fine).abs();
        assert!(error <= tolerance, "{}", case.complain(function, &what()));
    }
}

/// The result that was differentiated.
fn find(entries: &[Entry], derivative: &Entry, by: &[Variable]) -> usize {
    let same = |e: &Entry| {
        e.quantity == derivative.quantity && e.component == derivative.component && e.by == by
    };
    entries
        .iter()
        .position(same)
        .expect("it is a result of the same function")
}

#[test]
fn loops_stay_closed() {
    for case in cases() {
        let mut random = Random::new(case.seed);
        for (index, function) in case.sample.functions.iter().enumerate() {
            if function.kind != Kind::Closure {
                continue;
            }
            let at = case.position(&mut random);
            for by in [Subject::by_program, Subject::by_graph] {
                let left: Vec<f64> = by(&case.subject, index, &at);
                // Derivatives may be large, but a slip would show in the first digits.
                for open in left {
                    let what = || format!("a loop is open by {open:e}");
                    assert!(open.abs() < 1e-7, "{}", case.complain(function, &what()));
                }
            }
        }
    }
}

#[test]
fn the_chosen_configuration_is_assembled() {
    for case in cases() {
        let at = case.subject.reference();
        for (index, function) in case.sample.functions.iter().enumerate() {
            if function.kind != Kind::Position {
                continue;
            }
            let values = case.subject.by_program(index, &at);
            if let Some(margin) = values.get(function.entries.len()) {
                assert!(
                    (0.05..1.0 + 4.0 * f64::EPSILON).contains(margin),
                    "{}",
                    case.complain(function, &format!("margin {margin}"))
                );
            }
            for (entry, value) in function.entries.iter().zip(&values) {
                check_configuration(&case, function, entry, *value);
            }
        }
    }
}

fn check_configuration(case: &Case, function: &Function, entry: &Entry, value: f64) {
    let Some(unknown) = case.sample.unknowns.iter().find(|u| u.name == entry.name) else {
        return;
    };
    let chosen = unknown.value[entry.component];
    let (difference, allowed) = match unknown.is_angle {
        true => (value - chosen, 0.01),
        false => (value / case.sample.millimetre - chosen, 0.5),
    };
    // A mechanism may count an angle from another turn than the chosen one; its estimate is the same.
    assert!(
        difference.abs() < allowed,
        "{}",
        case.complain(
            function,
            &format!(
                "{} is {value}, chosen {chosen} ({} turns)",
                unknown.name,
                difference / TAU
            )
        )
    );
}
