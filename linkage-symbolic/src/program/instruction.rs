//! The instructions of programs.

use crate::graph::Source;
use crate::operands::Operands;
use crate::operation::{Binary, Class, Fused, Ternary, Unary};

/// The result of an earlier instruction, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(pub usize);

/// One operation. Operands are results of earlier instructions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Instruction {
    /// A number.
    Constant(f64),
    /// A number from elsewhere.
    Load(Source),
    /// An operation of one operand.
    Unary(Unary, Value),
    /// An operation of two operands.
    Binary(Binary, Value, Value),
    /// An operation of three operands.
    Ternary(Ternary, Value, Value, Value),
    /// A product and a sum, rounded once or twice as the machine can.
    Fused(Fused, Value, Value, Value),
    /// Sine and cosine of an angle. Its value is the sine; the cosine is the
    /// [`Second`](Self::Second) result, right behind it.
    SinCos(Value),
    /// The second result of an instruction that has two.
    Second(Value),
}

impl Instruction {
    /// The values that it needs.
    pub fn operands(&self) -> Operands<Value> {
        let none = Value(0);
        let (list, count) = match *self {
            Self::Constant(_) | Self::Load(_) => ([none; 3], 0),
            Self::Unary(_, a) | Self::SinCos(a) | Self::Second(a) => ([a, none, none], 1),
            Self::Binary(_, a, b) => ([a, b, none], 2),
            Self::Ternary(_, a, b, c) | Self::Fused(_, a, b, c) => ([a, b, c], 3),
        };
        Operands::new(list, count)
    }

    /// True for loads and constants: stages repeat them where they are needed and never carry them.
    pub(crate) fn is_free(&self) -> bool {
        matches!(self, Self::Load(_) | Self::Constant(_))
    }

    /// In rough cycles: when its result is known after its operands.
    pub fn latency(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().latency,
            Self::Binary(op, ..) => op.row().latency,
            Self::Ternary(op, ..) => op.row().latency,
            Self::Fused(op, ..) => op.row().latency,
            Self::SinCos(_) => Unary::Sin.row().latency,
            Self::Second(_) => 0,
        }
    }

    /// The size in machine instructions, roughly; loads and constants belong to the instructions
    /// that use them.
    pub fn size(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().size,
            Self::Binary(op, ..) => op.row().size,
            Self::Ternary(op, ..) => op.row().size,
            Self::Fused(op, ..) => op.row().size,
            Self::SinCos(_) => Unary::Sin.row().size,
            Self::Second(_) => Unary::Cos.row().size,
        }
    }

    /// The cost by throughput, where an addition is 1; loaded values were computed elsewhere.
    pub fn time(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().time,
            Self::Binary(op, ..) => op.row().time,
            Self::Ternary(op, ..) => op.row().time,
            Self::Fused(op, ..) => op.row().time,
            Self::SinCos(_) => Unary::Sin.row().time,
            Self::Second(_) => 0,
        }
    }

    /// The class in which it is counted; `None` for instructions without cost.
    pub fn class(&self) -> Option<Class> {
        Some(match self {
            Self::Constant(_) | Self::Load(_) | Self::Second(_) => return None,
            Self::Unary(op, _) => op.row().class,
            Self::Binary(op, ..) => op.row().class,
            Self::Ternary(op, ..) => op.row().class,
            Self::Fused(op, ..) => op.row().class,
            Self::SinCos(_) => Class::SineCosine,
        })
    }

    /// The same operation of other values.
    #[must_use]
    pub fn with_operands(self, other: impl Fn(Value) -> Value) -> Self {
        match self {
            Self::Constant(_) | Self::Load(_) => self,
            Self::Unary(operation, a) => Self::Unary(operation, other(a)),
            Self::Binary(operation, a, b) => Self::Binary(operation, other(a), other(b)),
            Self::Ternary(operation, a, b, c) => {
                Self::Ternary(operation, other(a), other(b), other(c))
            }
            Self::Fused(operation, a, b, c) => Self::Fused(operation, other(a), other(b), other(c)),
            Self::SinCos(a) => Self::SinCos(other(a)),
            Self::Second(a) => Self::Second(other(a)),
        }
    }
}
