//! Straight-line programs: what a sliced, scheduled graph becomes before it is printed as code.

use crate::graph::Binding;
use crate::operation::Class;
pub use crate::operation::{Binary, Fused, Ternary, Unary};

/// Where a program finds a number that it does not compute itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Source {
    /// A scalar parameter of the mechanism, by index.
    Parameter(usize),
    /// A driving coordinate, by index in the mechanism.
    Input(usize),
    /// The assembly mode of a group with two modes, by mode index: `+1` or `-1`.
    Mode(usize),
    /// The centre of a continuous angle, by index among the continuous angles.
    Centre(usize),
    /// How many turns a continuous angle makes for each turn of an input.
    Winding(usize, usize),
    /// A value computed once in `assemble()`, by slot.
    Prepared(usize),
    /// A value from the stage before, by index.
    Carried(usize),
    /// What is prepared of the solution of a coupled group near a position, by group (among the coupled ones) and
    /// component: an approximate state, then the least determinant that is certified.
    State(usize, usize),
    /// The largest correction of a prepared state that is certified.
    Limit,
}

impl Source {
    /// When a number is known.
    pub fn binding(self) -> Binding {
        match self {
            Self::Input(_) | Self::State(..) | Self::Limit | Self::Carried(_) => Binding::Call,
            Self::Parameter(_)
            | Self::Mode(_)
            | Self::Centre(_)
            | Self::Winding(..)
            | Self::Prepared(_) => Binding::Parameter,
        }
    }
}

/// The result of an earlier instruction, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(pub usize);

/// One operation. Operands are results of earlier instructions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Instruction {
    Constant(f64),
    Load(Source),
    Unary(Unary, Value),
    Binary(Binary, Value, Value),
    Ternary(Ternary, Value, Value, Value),
    /// A product and a sum, rounded once or twice as the machine can.
    Fused(Fused, Value, Value, Value),
}

impl Instruction {
    /// The values that it needs.
    pub fn operands(&self) -> impl Iterator<Item = Value> + use<> {
        let operands = match *self {
            Self::Constant(_) | Self::Load(_) => [None; 3],
            Self::Unary(_, a) => [Some(a), None, None],
            Self::Binary(_, a, b) => [Some(a), Some(b), None],
            Self::Ternary(_, a, b, c) | Self::Fused(_, a, b, c) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }

    /// In rough cycles: when its result is known after its operands.
    pub fn latency(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().latency,
            Self::Binary(op, ..) => op.row().latency,
            Self::Ternary(op, ..) => op.row().latency,
            Self::Fused(op, ..) => op.row().latency,
        }
    }

    /// In machine instructions, roughly; loads and constants come with what uses them.
    pub fn size(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().size,
            Self::Binary(op, ..) => op.row().size,
            Self::Ternary(op, ..) => op.row().size,
            Self::Fused(op, ..) => op.row().size,
        }
    }

    /// By throughput, an addition being 1; what is loaded was computed elsewhere.
    pub fn time(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().time,
            Self::Binary(op, ..) => op.row().time,
            Self::Ternary(op, ..) => op.row().time,
            Self::Fused(op, ..) => op.row().time,
        }
    }

    /// As what it is counted; `None` for a load or a constant.
    pub fn class(&self) -> Option<Class> {
        Some(match self {
            Self::Constant(_) | Self::Load(_) => return None,
            Self::Unary(op, _) => op.row().class,
            Self::Binary(op, ..) => op.row().class,
            Self::Ternary(op, ..) => op.row().class,
            Self::Fused(op, ..) => op.row().class,
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
        }
    }
}

/// A straight-line program: instructions in order of execution, results by index.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    pub instructions: Vec<Instruction>,
    pub outputs: Vec<Value>,
}
