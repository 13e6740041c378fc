//! Sine and cosine of one angle as one instruction: the machine computes both for little more than
//! one of them.

use std::collections::BTreeMap;

use crate::program::{Instruction, Program, Unary, Value};

/// Replaces sines and cosines by [`Instruction::SinCos`], each where the first of both was.
pub fn pair(program: Program) -> Program {
    let mut turned: BTreeMap<Value, Used> = BTreeMap::new();
    for instruction in &program.instructions {
        if let Instruction::Unary(op @ (Unary::Sin | Unary::Cos), angle) = *instruction {
            let used = turned.entry(angle).or_default();
            used.cosine |= op == Unary::Cos;
        }
    }
    let mut paired = Program::default();
    let mut copies: Vec<Value> = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let copy = match *instruction {
            Instruction::Unary(op @ (Unary::Sin | Unary::Cos), angle) => {
                let used = turned.get_mut(&angle).expect("all were listed");
                let [sine, cosine] = *used.pair.get_or_insert_with(|| {
                    let sine = paired.push(Instruction::SinCos(copies[angle.0]));
                    let cosine = match used.cosine {
                        true => paired.push(Instruction::Second(sine)),
                        false => sine,
                    };
                    [sine, cosine]
                });
                if op == Unary::Cos { cosine } else { sine }
            }
            _ => paired.push(instruction.with_operands(|x| copies[x.0])),
        };
        copies.push(copy);
    }
    paired.outputs = program.outputs.iter().map(|x| copies[x.0]).collect();
    paired
}

/// The used functions of an angle.
#[derive(Default)]
struct Used {
    cosine: bool,
    /// Sine and cosine, once they are there.
    pair: Option<[Value; 2]>,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpret::run;
    use crate::program::Source;

    fn program(operations: &[Unary]) -> Program {
        let mut program = Program::default();
        let angle = program.push(Instruction::Load(Source::Input(0)));
        for &op in operations {
            let value = program.push(Instruction::Unary(op, angle));
            program.outputs.push(value);
        }
        program
    }

    #[test]
    fn one_instruction_computes_both() {
        for operations in [
            &[Unary::Cos, Unary::Sin][..],
            &[Unary::Sin, Unary::Cos, Unary::Sin],
            &[Unary::Cos],
            &[Unary::Sin],
        ] {
            let written = program(operations);
            let paired = pair(written.clone());
            let is_pair = |entry: &&Instruction| matches!(entry, Instruction::SinCos(_));
            assert_eq!(paired.instructions.iter().filter(is_pair).count(), 1);
            for x in [0.7, -3.0, 0.0, -0.0, f64::INFINITY, f64::NAN] {
                let [expected, found] = [&written, &paired].map(|item| {
                    let values = run(item, |_| x).into_iter();
                    values.map(f64::to_bits).collect::<Vec<_>>()
                });
                assert_eq!(expected, found, "{operations:?} {x}");
            }
        }
    }
}
