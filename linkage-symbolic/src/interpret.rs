//! Programs on plain numbers, which close the loops at compile time and are the oracle for
//! generated code, and on numbers of any other arithmetic.

use crate::program::{Binary, Fused, Instruction, Program, Source, Ternary, Unary};

/// The effect of instructions on numbers.
pub trait Arithmetic {
    /// The numbers that programs run on.
    type Number: Copy;

    /// The nearest number.
    fn constant(x: f64) -> Self::Number;
    /// The result of an operation of one operand.
    fn unary(op: Unary, a: Self::Number) -> Self::Number;
    /// Sine and cosine of an angle.
    #[inline(always)]
    fn sine_pair(a: Self::Number) -> [Self::Number; 2] {
        [Self::unary(Unary::Sin, a), Self::unary(Unary::Cos, a)]
    }
    /// The result of an operation of two operands.
    fn binary(op: Binary, a: Self::Number, b: Self::Number) -> Self::Number;
    /// The result of an operation of three operands.
    fn ternary(op: Ternary, a: Self::Number, b: Self::Number, c: Self::Number) -> Self::Number;
    /// The result of a multiply-add.
    fn fused(op: Fused, a: Self::Number, b: Self::Number, c: Self::Number) -> Self::Number;
}

/// The table of operations: sines and the like from the standard library, multiply-adds rounded as
/// their rows say.
pub(crate) struct OfTable;

impl Arithmetic for OfTable {
    type Number = f64;

    fn constant(x: f64) -> f64 {
        x
    }

    fn unary(op: Unary, a: f64) -> f64 {
        op.apply([a])
    }

    fn binary(op: Binary, a: f64, b: f64) -> f64 {
        op.apply([a, b])
    }

    fn ternary(op: Ternary, a: f64, b: f64, c: f64) -> f64 {
        op.apply([a, b, c])
    }

    fn fused(op: Fused, a: f64, b: f64, c: f64) -> f64 {
        op.apply([a, b, c])
    }
}

/// Runs a program; `load` supplies parameters, inputs, modes and so on. Returns the outputs.
pub fn run(program: &Program, load: impl Fn(Source) -> f64) -> Vec<f64> {
    run_by::<OfTable>(program, load)
}

/// The same by another arithmetic.
// Inlined with what is chosen for the machine, whose instructions it then has.
#[inline(always)]
pub fn run_by<A: Arithmetic>(
    program: &Program,
    load: impl Fn(Source) -> A::Number,
) -> Vec<A::Number> {
    let count = program.instructions.len();
    let mut values = Vec::with_capacity(count);
    steps::<A>(program, 0, count, &mut values, load);
    program
        .outputs
        .iter()
        .map(|output| values[output.0])
        .collect()
}

/// Runs the instructions `from..to`; `values` holds the results of those before, and afterwards of
/// those up to `to`.
pub fn run_steps(
    program: &Program,
    from: usize,
    to: usize,
    values: &mut Vec<f64>,
    load: impl Fn(Source) -> f64,
) {
    steps::<OfTable>(program, from, to, values, load);
}

#[inline(always)]
fn steps<A: Arithmetic>(
    program: &Program,
    from: usize,
    to: usize,
    values: &mut Vec<A::Number>,
    load: impl Fn(Source) -> A::Number,
) {
    values.resize(to, A::constant(0.0));
    // Slices: an index of a list is a call where nothing is optimised.
    let (instructions, numbers) = (&program.instructions[..], &mut values[..]);
    let mut index = from;
    while index < to {
        numbers[index] = match instructions[index] {
            Instruction::Constant(x) => A::constant(x),
            Instruction::Load(source) => load(source),
            Instruction::Unary(op, a) => A::unary(op, numbers[a.0]),
            Instruction::Binary(op, a, b) => A::binary(op, numbers[a.0], numbers[b.0]),
            Instruction::Ternary(op, a, b, c) => {
                A::ternary(op, numbers[a.0], numbers[b.0], numbers[c.0])
            }
            Instruction::Fused(op, a, b, c) => {
                A::fused(op, numbers[a.0], numbers[b.0], numbers[c.0])
            }
            Instruction::SinCos(a) => A::unary(Unary::Sin, numbers[a.0]),
            Instruction::Second(pair) => match instructions[pair.0] {
                Instruction::SinCos(a) => A::unary(Unary::Cos, numbers[a.0]),
                _ => unreachable!("nothing else has two results"),
            },
        };
        index += 1;
    }
}
