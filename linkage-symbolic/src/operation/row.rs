//! Rows of the table of operations.

/// The facts about an operation of so many operands.
#[derive(Clone, Copy, Debug)]
pub struct OperationRow<const ARITY: usize> {
    /// In texts: a word, or the sign that stands between both operands.
    pub name: &'static str,
    /// Its value on numbers.
    pub value: fn([f64; ARITY]) -> f64,
    /// In rough cycles: when its result is known after its operands. It decides which of two
    /// products is fused, so a change of it changes last digits where multiply-adds are.
    pub latency: u32,
    /// Cost by throughput, where many other operations are computed next to it; an addition is 1.
    pub time: u32,
    /// Size in machine instructions, roughly: its part of the window of a processor.
    pub size: u32,
    /// The class in which it is counted.
    pub class: Class,
    /// True for a function that is a different formula on different sides of some value.
    pub splits: bool,
    /// True if its value is no negative number, whatever the operands are; it may be -0, or NaN.
    pub never_negative: bool,
    /// True if it has no finite value for some finite operands. Overflow does not count.
    pub partial: bool,
    /// Its result for the negative operand: the rules of simplification follow from it.
    pub symmetry: Symmetry,
    /// The code for it in Rust.
    pub call: RustCall,
}

/// The result of an operation of one operand for the negative operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Symmetry {
    /// Neither of the others.
    Neither,
    /// `f(-x) = -f(x)`
    Odd,
    /// `f(-x) = f(x)`
    Even,
}

/// The code of an operation on numbers of `linkage_core::Scalar`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RustCall {
    /// An operator in front of the operand or between both.
    Operator(char),
    /// A method of this name.
    Method(&'static str),
    /// A method of this name with a parameter that says whether multiply-adds are fused.
    FusedMethod(&'static str),
    /// One number of the sine pair, 0 for the sine and 1 for the cosine.
    SinePair(usize),
}

/// The classes in which operations are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// An addition or a subtraction.
    Addition,
    /// A multiplication.
    Multiplication,
    /// Both of them.
    MultiplyAdd,
    /// A division.
    Division,
    /// A square root, alone or within a length.
    Root,
    /// A sine, a cosine, or both of one angle.
    SineCosine,
    /// An arc tangent of two operands.
    ArcTangent,
    /// Any other operation.
    Other,
}

/// A row with the columns that most operations share.
pub(super) const fn row<const ARITY: usize>(
    name: &'static str,
    value: fn([f64; ARITY]) -> f64,
) -> OperationRow<ARITY> {
    OperationRow {
        name,
        value,
        latency: 4,
        time: 1,
        size: 1,
        class: Class::Other,
        splits: false,
        never_negative: false,
        partial: false,
        symmetry: Symmetry::Neither,
        call: RustCall::Method(name),
    }
}

/// Cost of an arc function or a tangent by throughput.
pub(super) const ARC: u32 = 30;

/// A row of a function of an angle.
pub(super) const fn trigonometric(
    name: &'static str,
    value: fn([f64; 1]) -> f64,
) -> OperationRow<1> {
    OperationRow {
        latency: 20,
        time: 20,
        size: 20,
        ..row(name, value)
    }
}

/// A row of an arc function.
pub(super) const fn arc<const ARITY: usize>(
    name: &'static str,
    value: fn([f64; ARITY]) -> f64,
) -> OperationRow<ARITY> {
    OperationRow {
        latency: 20,
        time: ARC,
        size: 50,
        ..row(name, value)
    }
}
