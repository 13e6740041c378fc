//! Programs in a target language: the part that is the same for all languages.

use super::instruction::{Instruction, Value};
use super::straight_line::Program;
use crate::graph::Source;
use crate::operation::{Fused, RustCall};

/// A language that programs are printed in. Each value of a program is an expression of the
/// language: a literal, a variable, or a member of one.
pub trait Language {
    /// Returns a number as a literal.
    fn number(&self, x: f64) -> String;

    /// Returns the expression of a number that the program loads; `index` is that of the
    /// instruction.
    fn load(&mut self, index: usize, source: Source) -> String;

    /// Defines a variable for the value of an instruction. Returns its name.
    fn define(&mut self, index: usize, value: &str) -> String;

    /// Defines variables for the sine and the cosine of an angle. Returns the expressions of both.
    fn define_sine_pair(&mut self, index: usize, angle: &str) -> [String; 2];

    /// Returns a call of the function for an operation; `name` is that of its row in the table of
    /// operations.
    fn call(&mut self, name: &'static str, operands: &[&str]) -> String;

    /// Returns the expression of a sine, or of a cosine (number 1), without a variable.
    fn sine_or_cosine(&mut self, number: usize, angle: &str) -> String;
}

/// Prints a program: definitions in order, by methods of `language`. Returns the expressions of the
/// results. Values that nothing reads are left out.
pub fn print<L: Language>(program: &Program, language: &mut L) -> Vec<String> {
    let read = read(program);
    let mut values: Vec<String> = Vec::with_capacity(program.instructions.len());
    let mut cosine = String::new();
    for (index, instruction) in program.instructions.iter().enumerate() {
        let value = |value: Value| &values[value.0][..];
        let printed = match *instruction {
            Instruction::Constant(x) => language.number(x),
            Instruction::Load(source) => language.load(index, source),
            // It is right after the instruction that computes both.
            Instruction::Second(_) => std::mem::take(&mut cosine),
            _ if !read[index] => String::new(),
            Instruction::SinCos(a) => {
                let sine;
                [sine, cosine] = language.define_sine_pair(index, value(a));
                sine
            }
            Instruction::Unary(op, a) => {
                let row = op.row();
                let printed = operation(language, row.name, row.call, &[value(a)]);
                language.define(index, &printed)
            }
            Instruction::Binary(op, a, b) => {
                let row = op.row();
                let printed = operation(language, row.name, row.call, &[a, b].map(value));
                language.define(index, &printed)
            }
            Instruction::Ternary(op, a, b, c) => {
                let row = op.row();
                let printed = operation(language, row.name, row.call, &[a, b, c].map(value));
                language.define(index, &printed)
            }
            Instruction::Fused(op, a, b, c) => {
                let printed = fused(op, [a, b, c].map(value));
                language.define(index, &printed)
            }
        };
        values.push(printed);
    }
    let results = program.outputs.iter();
    results.map(|output| values[output.0].clone()).collect()
}

/// The expression of an operation: an operator, or a call.
fn operation<L: Language>(
    language: &mut L,
    name: &'static str,
    call: RustCall,
    operands: &[&str],
) -> String {
    match (call, operands) {
        (RustCall::Operator(sign), [a, b]) => format!("{a} {sign} {b}"),
        (RustCall::Operator(sign), _) => format!("{sign}{}", operands.concat()),
        // Programs are paired before they are printed, but a program without this pass must be
        // right too.
        (RustCall::SinePair(number), _) => language.sine_or_cosine(number, operands[0]),
        (RustCall::Method(_) | RustCall::FusedMethod(_), _) => language.call(name, operands),
    }
}

/// A multiply-add as a product and a sum. Compilers of the language may round them once.
fn fused(op: Fused, [a, b, c]: [&str; 3]) -> String {
    match op {
        Fused::MulAdd => format!("{a} * {b} + {c}"),
        Fused::MulSub => format!("{a} * {b} - {c}"),
        Fused::SubMul => format!("{c} - {a} * {b}"),
    }
}

/// Returns true for each value that another one is computed from, or that is a result.
fn read(program: &Program) -> Vec<bool> {
    let mut read = vec![false; program.instructions.len()];
    let operands = program.instructions.iter().flat_map(Instruction::operands);
    operands
        .chain(program.outputs.iter().copied())
        .for_each(|x| read[x.0] = true);
    read
}
