//! Every operation of the table, alone.

use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, Source, Ternary, Unary, Value,
};

/// All operations, each of the first ones of three inputs.
#[must_use]
pub fn operations() -> Vec<Instruction> {
    let [a, b, c] = [0, 1, 2].map(Value);
    let unary = Unary::ALL.iter().map(|&op| Instruction::Unary(op, a));
    let binary = Binary::ALL.iter().map(|&op| Instruction::Binary(op, a, b));
    let ternary = Ternary::ALL
        .iter()
        .map(|&op| Instruction::Ternary(op, a, b, c));
    let fused = Fused::ALL.iter().map(|&op| Instruction::Fused(op, a, b, c));
    unary.chain(binary).chain(ternary).chain(fused).collect()
}

/// A program of one operation of three inputs.
#[must_use]
pub fn program(operation: Instruction) -> Program {
    let mut program = Program::default();
    for input in 0..3 {
        program.push(Instruction::Load(Source::Input(input)));
    }
    let value = program.push(operation);
    program.outputs.push(value);
    program
}
