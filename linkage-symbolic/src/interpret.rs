//! Programs on plain numbers: the oracle for the generated code, and what closes the loops at compile time.

use crate::program::{Instruction, Program, Source};

/// Runs a program; `load` supplies parameters, inputs, modes and so on. Returns the outputs.
pub fn run(program: &Program, load: impl Fn(Source) -> f64) -> Vec<f64> {
    let mut values = Vec::new();
    run_steps(program, 0, program.instructions.len(), &mut values, load);
    program
        .outputs
        .iter()
        .map(|output| values[output.0])
        .collect()
}

/// Runs the instructions `from..to`; `values` holds the results of those before.
pub fn run_steps(
    program: &Program,
    from: usize,
    to: usize,
    values: &mut Vec<f64>,
    load: impl Fn(Source) -> f64,
) {
    values.truncate(from);
    for instruction in &program.instructions[from..to] {
        let value = match *instruction {
            Instruction::Constant(value) => value,
            Instruction::Load(source) => load(source),
            Instruction::Unary(op, a) => op.apply([values[a.0]]),
            Instruction::Binary(op, a, b) => op.apply([values[a.0], values[b.0]]),
            Instruction::Ternary(op, a, b, c) => op.apply([values[a.0], values[b.0], values[c.0]]),
            Instruction::Fused(op, a, b, c) => op.apply([values[a.0], values[b.0], values[c.0]]),
            Instruction::SinCos(a) => values[a.0].sin(),
            Instruction::Second(pair) => match program.instructions[pair.0] {
                Instruction::SinCos(a) => values[a.0].cos(),
                _ => unreachable!("nothing else has two results"),
            },
        };
        values.push(value);
    }
}
