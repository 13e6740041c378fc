//! Prepared states of groups without a closed form.

mod circuits;
mod closing;
mod grid;
mod hostile;
mod initial_state;
mod table;
mod triads;

use linkage_random::Random;
use linkage_runtime::numeric::continuation::{Correction, Range, Refusal, Step, Table};
use std::f64::consts::TAU;
use triads::EyeNeedle;

const TURN: Range = Range {
    low: 0.0,
    high: TAU,
    turn: true,
};

fn range(low: f64, high: f64) -> Range {
    Range {
        low,
        high,
        turn: false,
    }
}

fn build(triad: EyeNeedle, range: Range, partial: bool) -> Result<Table, Refusal> {
    let mut triad = triad;
    Table::build(&mut triad, 0.0, &EyeNeedle::start(), range, partial)
}

/// The largest first and second corrections at many inputs between `low` and `high`, and how many of them the certificate
/// of evaluators refuses.
fn survey(
    table: &Table,
    correction: &mut dyn Correction,
    low: f64,
    high: f64,
) -> (f64, f64, usize) {
    let mut random = Random::new(7);
    let (mut first, mut second, mut refused) = (0.0_f64, 0.0_f64, 0);
    let mut state = vec![0.0; table.width()];
    for _ in 0..10_000 {
        let x = [random.between(low, high)];
        let floor = table.state(x[0], &mut state);
        let step = correction.correct(&x, &mut state);
        if certified(step, floor) {
            first = first.max(step.size);
            second = second.max(correction.correct(&x, &mut state).size);
        } else {
            refused += 1;
        }
    }
    (first, second, refused)
}

fn certified(step: Step, floor: f64) -> bool {
    step.size < 1e-7 && step.determinant * floor >= floor * floor
}

/// A length that is the square root of a function of the input.
fn root(square: impl Fn(f64) -> f64) -> impl FnMut(&[f64], &mut [f64]) -> Step {
    move |x, state| {
        let step = (square(x[0]) - state[0] * state[0]) / (2.0 * state[0]);
        let determinant = 2.0 * state[0];
        state[0] += step;
        Step {
            size: step.abs(),
            determinant,
        }
    }
}
