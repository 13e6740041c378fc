//! Programs as text: for golden files and for reading.

use std::fmt;

use crate::program::{Binary, Fused, Instruction, Program, Source};

impl fmt::Display for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Parameter(index) => write!(f, "parameter {index}"),
            Self::Input(index) => write!(f, "input {index}"),
            Self::Mode(index) => write!(f, "mode {index}"),
            Self::Centre(angle) => write!(f, "centre {angle}"),
            Self::Winding(angle, input) => write!(f, "winding {angle} {input}"),
            Self::Prepared(slot) => write!(f, "prepared {slot}"),
            Self::Carried(index) => write!(f, "carried {index}"),
            Self::State(group, component) => write!(f, "state {group} {component}"),
            Self::Limit => write!(f, "limit"),
        }
    }
}

impl fmt::Display for Instruction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant(value) => write!(f, "{value:?}"),
            Self::Load(source) => write!(f, "{source}"),
            Self::Unary(op, a) => write!(f, "{} v{}", op.row().name, a.0),
            Self::Binary(op, a, b) => match op {
                Binary::Add | Binary::Sub | Binary::Mul | Binary::Div => {
                    write!(f, "v{} {} v{}", a.0, op.row().name, b.0)
                }
                _ => write!(f, "{} v{} v{}", op.row().name, a.0, b.0),
            },
            Self::Ternary(op, a, b, c) => {
                write!(f, "{} v{} v{} v{}", op.row().name, a.0, b.0, c.0)
            }
            Self::SinCos(a) => write!(f, "sin_cos v{}", a.0),
            Self::Second(a) => write!(f, "second v{}", a.0),
            Self::Fused(Fused::MulAdd, a, b, c) => write!(f, "v{} * v{} + v{}", a.0, b.0, c.0),
            Self::Fused(Fused::MulSub, a, b, c) => write!(f, "v{} * v{} - v{}", a.0, b.0, c.0),
            Self::Fused(Fused::SubMul, a, b, c) => write!(f, "v{} - v{} * v{}", c.0, a.0, b.0),
        }
    }
}

/// One line for each instruction, then the outputs.
impl fmt::Display for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (index, instruction) in self.instructions.iter().enumerate() {
            writeln!(f, "v{index} = {instruction}")?;
        }
        let outputs: Vec<String> = self.outputs.iter().map(|v| format!("v{}", v.0)).collect();
        writeln!(f, "return {}", outputs.join(" "))
    }
}
