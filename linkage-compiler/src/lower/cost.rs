//! What a program costs at a call: the measure by which lowering chooses between equal programs.

use linkage_symbolic::program::{Binary, Instruction, Program, Ternary, Unary, Value};

/// Weights by throughput, an addition being 1. What is loaded was computed elsewhere.
const DIVISION: u32 = 5;
const ROOT: u32 = 6;
const SINE_COSINE: u32 = 20;
const ARC: u32 = 30;

/// The sum of the weights of all operations.
pub(super) fn cost(program: &Program) -> u32 {
    let mut turned: Vec<Value> = Vec::new();
    let mut sum = 0;
    for instruction in &program.instructions {
        sum += match *instruction {
            Instruction::Constant(_) | Instruction::Load(_) => 0,
            Instruction::Unary(Unary::Sin | Unary::Cos, operand) => {
                turned.push(operand);
                0
            }
            Instruction::Unary(op, _) => unary(op),
            Instruction::Binary(op, ..) => binary(op),
            Instruction::Ternary(Ternary::AngleNear, ..) => ARC,
            Instruction::Ternary(..) | Instruction::Fused(..) => 1,
        };
    }
    turned.sort_unstable();
    turned.dedup();
    sum + SINE_COSINE * turned.len() as u32
}

fn unary(op: Unary) -> u32 {
    match op {
        Unary::Sqrt => ROOT,
        Unary::Tan | Unary::Asin | Unary::Acos | Unary::Atan => ARC,
        _ => 1,
    }
}

fn binary(op: Binary) -> u32 {
    match op {
        Binary::Div => DIVISION,
        Binary::Hypot | Binary::Root => ROOT,
        Binary::Atan2 => ARC,
        _ => 1,
    }
}
