//! Every operation of the table on intervals: bounds hold all values.

use linkage_compiler::ir::Generated;
use linkage_core::{Enclosure, Scalar};
use linkage_corpus::operations::{operations, program};
use linkage_random::Random;
use linkage_symbolic::interpret::{run, run_by};
use linkage_symbolic::program::{Instruction, Program, Source, Ternary, Unary};

/// Intervals that each operation is tried on, and numbers in each of them.
const INTERVALS: usize = 400;
const NUMBERS: usize = 20;

/// Operations whose intervals are no bounds of their values: a slack and a scale are constants of a whole interval, and a root takes
/// negative discriminants for 0.
fn is_left_out(operation: Instruction) -> bool {
    matches!(
        operation,
        Instruction::Unary(Unary::Slack | Unary::InverseScale, _)
            | Instruction::Ternary(Ternary::GuardedSqrt, ..)
    )
}

/// Middle and half width of three operands.
fn boxes(random: &mut Random) -> [[f64; 2]; 3] {
    let widest = random.ratio(1e-3, 2.0);
    [(); 3].map(|()| {
        [
            random.between(-3.0, 3.0),
            widest * random.between(-1.0, 1.0),
        ]
    })
}

/// The number of intervals whose bounds were known.
fn checked(operation: Instruction, program: &Program, random: &mut Random) -> usize {
    let mut known = 0;
    for _ in 0..INTERVALS {
        let operands = boxes(random);
        let at = |share: f64| operands.map(|[middle, half]| middle + half * share);
        let share = Enclosure::over(-1.0, 1.0);
        let bounds = run_by::<Generated<Enclosure, false>>(program, |source| match source {
            Source::Input(index) => {
                let [middle, half] = operands[index].map(Enclosure::from_f64);
                middle + half * share
            }
            _ => unreachable!("there is nothing else"),
        });
        let [low, high] = bounds[0].range();
        if low.is_nan() || high.is_nan() {
            continue;
        }
        known += 1;
        for _ in 0..NUMBERS {
            let numbers = at(random.between(-1.0, 1.0));
            let value = run(program, |source| match source {
                Source::Input(index) => numbers[index],
                _ => unreachable!("there is nothing else"),
            })[0];
            let rounding = 1e-12 * value.abs().max(1.0);
            let holds = low - rounding <= value && value <= high + rounding;
            assert!(
                holds || value.is_nan(),
                "{operation:?} of {numbers:?} is {value:e}, but not between {low:e} and {high:e}"
            );
        }
    }
    known
}

#[test]
fn bounds_hold_all_values_of_each_operation() {
    let mut random = Random::new(7);
    for operation in operations() {
        if is_left_out(operation) {
            continue;
        }
        let known = checked(operation, &program(operation), &mut random);
        assert!(known > INTERVALS / 20, "{operation:?}: {known} intervals");
    }
}
