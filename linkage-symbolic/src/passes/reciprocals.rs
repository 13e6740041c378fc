//! One reciprocal for many divisions by one divisor. A quotient then is rounded once more than by a
//! division.

use std::collections::{BTreeMap, BTreeSet};

use crate::graph::Binding;
use crate::program::{Binary, Instruction, Program, Value};

/// The number of divisions by one divisor from which on one reciprocal and products are cheaper.
/// Two independent divisions are faster than a reciprocal and two dependent products.
const SHARED_DIVISIONS: usize = 3;

/// Replaces divisions by a divisor that is known at a call only, where there are many.
pub fn share(program: Program) -> Program {
    let shared = shared_divisors(&program);
    if shared.is_empty() {
        return program;
    }
    let mut rewriter = Rewriter::default();
    for instruction in &program.instructions {
        let copy = match *instruction {
            Instruction::Binary(Binary::Div, a, b) if shared.contains(&b) => {
                let reciprocal = rewriter.reciprocal(b);
                match program.instructions[a.0] {
                    Instruction::Constant(1.0) => reciprocal,
                    _ => {
                        let factor = rewriter.copies[a.0];
                        rewriter
                            .program
                            .push(Instruction::Binary(Binary::Mul, factor, reciprocal))
                    }
                }
            }
            _ => {
                let copies = &rewriter.copies;
                rewriter
                    .program
                    .push(instruction.with_operands(|x| copies[x.0]))
            }
        };
        rewriter.copies.push(copy);
    }
    let outputs = program.outputs.iter().map(|x| rewriter.copies[x.0]);
    rewriter.program.outputs = outputs.collect();
    rewriter.program.without_unused()
}

/// Divisors with enough divisions.
fn shared_divisors(program: &Program) -> BTreeSet<Value> {
    let bindings = program.bindings();
    let mut divisions: BTreeMap<Value, usize> = BTreeMap::new();
    for instruction in &program.instructions {
        if let Instruction::Binary(Binary::Div, _, divisor) = *instruction
            && bindings[divisor.0] == Binding::Call
        {
            *divisions.entry(divisor).or_default() += 1;
        }
    }
    divisions.retain(|_, count| *count >= SHARED_DIVISIONS);
    divisions.into_keys().collect()
}

#[derive(Default)]
struct Rewriter {
    program: Program,
    /// The new positions of the values of the whole program.
    copies: Vec<Value>,
    /// The reciprocals, by divisor of the whole program.
    reciprocals: BTreeMap<Value, Value>,
    /// The constant 1, once it is asked for.
    one: Option<Value>,
}

impl Rewriter {
    fn reciprocal(&mut self, divisor: Value) -> Value {
        if let Some(&known) = self.reciprocals.get(&divisor) {
            return known;
        }
        let one = self.one.unwrap_or_else(|| {
            let is_one = |entry: &Instruction| *entry == Instruction::Constant(1.0);
            let known = self.program.instructions.iter().position(is_one);
            known.map_or_else(|| self.program.push(Instruction::Constant(1.0)), Value)
        });
        self.one = Some(one);
        let divided = Instruction::Binary(Binary::Div, one, self.copies[divisor.0]);
        let reciprocal = self.program.push(divided);
        self.reciprocals.insert(divisor, reciprocal);
        reciprocal
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpret::run;
    use crate::program::Source;

    /// `x_k / x_0` for some `k`, and `1 / x_0`; `x_0` comes from `source`.
    fn quotients(count: usize, source: Source) -> Program {
        let mut program = Program::default();
        let divisor = program.push(Instruction::Load(source));
        for k in 1..count {
            let dividend = program.push(Instruction::Load(Source::Input(k)));
            let quotient = program.push(Instruction::Binary(Binary::Div, dividend, divisor));
            program.outputs.push(quotient);
        }
        let one = program.push(Instruction::Constant(1.0));
        let inverse = program.push(Instruction::Binary(Binary::Div, one, divisor));
        program.outputs.push(inverse);
        program
    }

    fn divisions(program: &Program) -> usize {
        let is_division =
            |entry: &&Instruction| matches!(entry, Instruction::Binary(Binary::Div, ..));
        program.instructions.iter().filter(is_division).count()
    }

    #[test]
    fn many_divisions_become_one() {
        let written = quotients(5, Source::Input(0));
        let shared = share(written.clone());
        assert_eq!((divisions(&written), divisions(&shared)), (5, 1));
        let load = |source| match source {
            Source::Input(k) => [0.3, 1.7, -2.9, 1e300, f64::NAN][k],
            _ => f64::NAN,
        };
        for (x, y) in run(&written, load).into_iter().zip(run(&shared, load)) {
            let bound = 2.0 * f64::EPSILON * x.abs();
            assert!(
                (x - y).abs() <= bound || x.is_nan() && y.is_nan(),
                "{x} {y}"
            );
        }
    }

    #[test]
    fn few_divisions_and_early_ones_stay() {
        for written in [
            quotients(2, Source::Input(0)),
            // In `assemble()` nobody waits.
            quotients(5, Source::Parameter(0)),
        ] {
            assert_eq!(share(written.clone()), written);
        }
    }
}
