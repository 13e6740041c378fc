//! Instructions as C. What they are is matched without a wildcard: a new one does not compile before C knows it.

use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, Source, Ternary, Unary, Value,
};

use super::helper::{Helper, Helpers};
use crate::real::Real;

/// What prints the instructions of a mechanism.
#[derive(Debug)]
pub(crate) struct Printer<'a> {
    pub(crate) real: Real,
    /// The beginning of names that nothing else has.
    pub(crate) own: &'a str,
    pub(crate) helpers: Helpers,
}

/// A program in C: statements, and expressions of its results.
#[derive(Debug)]
pub(crate) struct Printed {
    pub(crate) statements: String,
    pub(crate) results: Vec<String>,
}

impl Printer<'_> {
    /// Prints a program; `load` says where numbers stand.
    pub(crate) fn program(
        &mut self,
        program: &Program,
        load: &dyn Fn(Source) -> String,
    ) -> Printed {
        let read = read(program);
        let mut statements = String::new();
        let mut places: Vec<String> = Vec::with_capacity(program.instructions.len());
        for (index, instruction) in program.instructions.iter().enumerate() {
            let of = |value: Value| &places[value.0][..];
            let place = match *instruction {
                Instruction::Constant(x) => self.real.literal(x),
                Instruction::Load(source) => load(source),
                Instruction::Second(pair) => places[pair.0].replace(".sine", ".cosine"),
                _ if !read[index] => String::new(),
                Instruction::SinCos(a) => {
                    let pair = self.call(Helper::SinCos, "sin_cos", &[of(a)]);
                    let own = self.own;
                    statements += &format!("    const {own}pair v{index} = {pair};\n");
                    format!("v{index}.sine")
                }
                Instruction::Unary(op, a) => {
                    let value = self.unary(op, of(a));
                    self.assign(&mut statements, index, &value)
                }
                Instruction::Binary(op, a, b) => {
                    let value = self.binary(op, of(a), of(b));
                    self.assign(&mut statements, index, &value)
                }
                Instruction::Ternary(op, a, b, c) => {
                    let value = self.ternary(op, of(a), of(b), of(c));
                    self.assign(&mut statements, index, &value)
                }
                Instruction::Fused(op, a, b, c) => {
                    let value = fused(op, of(a), of(b), of(c));
                    self.assign(&mut statements, index, &value)
                }
            };
            places.push(place);
        }
        let results = program.outputs.iter();
        Printed {
            results: results.map(|value| places[value.0].clone()).collect(),
            statements,
        }
    }

    fn assign(&self, statements: &mut String, index: usize, value: &str) -> String {
        *statements += &format!("    const {} v{index} = {value};\n", self.real.name());
        format!("v{index}")
    }

    pub(crate) fn unary(&mut self, op: Unary, a: &str) -> String {
        match op {
            Unary::Neg => format!("-{a}"),
            Unary::Abs => self.library("fabs", a),
            Unary::Sqrt => self.library("sqrt", a),
            // Programs are paired before they are printed; alone they are right all the same.
            Unary::Sin => self.call(Helper::SinCos, "sin_cos", &[a]) + ".sine",
            Unary::Cos => self.call(Helper::SinCos, "sin_cos", &[a]) + ".cosine",
            Unary::Tan => self.call(Helper::Tan, "tan", &[a]),
            Unary::Asin => self.call(Helper::Asin, "asin", &[a]),
            Unary::Acos => self.call(Helper::Acos, "acos", &[a]),
            Unary::Atan => self.call(Helper::Atan, "atan", &[a]),
            Unary::Sign => self.call(Helper::Sign, "sign", &[a]),
            Unary::Whole => self.call(Helper::Whole, "whole", &[a]),
            Unary::Slack => self.call(Helper::Slack, "slack", &[a]),
            Unary::InverseScale => self.call(Helper::InverseScale, "inverse_scale", &[a]),
        }
    }

    pub(crate) fn binary(&mut self, op: Binary, a: &str, b: &str) -> String {
        match op {
            Binary::Add => format!("{a} + {b}"),
            Binary::Sub => format!("{a} - {b}"),
            Binary::Mul => format!("{a} * {b}"),
            Binary::Div => format!("{a} / {b}"),
            Binary::Quotient => self.call(Helper::Quotient, "quotient", &[a, b]),
            Binary::Atan2 => self.call(Helper::Atan2, "atan2", &[a, b]),
            Binary::Hypot => self.call(Helper::Hypot, "hypot", &[a, b]),
            Binary::Min => self.call(Helper::Min, "min", &[a, b]),
            Binary::Max => self.call(Helper::Max, "max", &[a, b]),
        }
    }

    pub(crate) fn ternary(&mut self, op: Ternary, a: &str, b: &str, c: &str) -> String {
        match op {
            Ternary::AngleNear => self.call(Helper::AngleNear, "angle_near", &[a, b, c]),
            Ternary::Root => self.call(Helper::Root, "root", &[a, b, c]),
            Ternary::Select => self.call(Helper::Select, "select", &[a, b, c]),
        }
    }

    /// A call of what stands in the same file.
    pub(crate) fn call(&mut self, helper: Helper, name: &str, operands: &[&str]) -> String {
        self.helpers.need(helper);
        format!("{}{name}({})", self.own, operands.join(", "))
    }

    /// A call of C's library, which most processors have as an instruction.
    fn library(&self, name: &str, a: &str) -> String {
        let suffix = match self.real {
            Real::Double => "",
            Real::Single => "f",
        };
        format!("{name}{suffix}({a})")
    }
}

/// Rounded once or twice, as the compiler is told (`-ffp-contract`).
pub(crate) fn fused(op: Fused, a: &str, b: &str, c: &str) -> String {
    match op {
        Fused::MulAdd => format!("{a} * {b} + {c}"),
        Fused::MulSub => format!("{a} * {b} - {c}"),
        Fused::SubMul => format!("{c} - {a} * {b}"),
    }
}

/// Which values something is computed from, or are results: C's compilers warn of others.
fn read(program: &Program) -> Vec<bool> {
    let mut read = vec![false; program.instructions.len()];
    let operands = program.instructions.iter().flat_map(Instruction::operands);
    operands
        .chain(program.outputs.iter().copied())
        .for_each(|x| read[x.0] = true);
    read
}
