//! Straight-line programs: what a sliced, scheduled graph becomes before it is printed as code.

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

/// Operations of one operand. `Sin` and `Cos` of the same operand become one call where code is printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Unary {
    Neg,
    Abs,
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    /// `+1` for a number that is positive or `+0`, `-1` for a negative one: the derivative of `Abs`.
    Sign,
    /// A power of two near `1/|x|` (1 for 0 and non-finite numbers): scales lengths without rounding.
    InverseScale,
}

/// Operations of two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Binary {
    Add,
    Sub,
    Mul,
    Div,
    /// `atan2(y, x)`
    Atan2,
    /// `sqrt(x^2 + y^2)` without overflow.
    Hypot,
    /// NaN if an operand is.
    Min,
    /// NaN if an operand is.
    Max,
    /// `root(q, scale)`: the square root of `q`; 0 where `q` is negative by no more than 8 roundoffs of `scale`;
    /// NaN below that. It closes a group up to the dead point and refuses beyond.
    Root,
}

/// Operations of three operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Ternary {
    /// `angle_near(y, x, guide)`: the argument of `x + i y`, plus the number of whole turns that brings it nearest to
    /// `guide`.
    AngleNear,
    /// `select(s, a, b)`: `a` where `s >= 0`, `b` where it is negative, NaN where it is NaN.
    Select,
}

/// Operations of three operands that only programs have: contraction makes them from products and sums.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Fused {
    /// `a * b + c`
    MulAdd,
    /// `a * b - c`
    MulSub,
    /// `c - a * b`
    SubMul,
}

/// A straight-line program: instructions in order of execution, results by index.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    pub instructions: Vec<Instruction>,
    pub outputs: Vec<Value>,
}
