//! The resolved mechanism: ids instead of names, checked dimensions, one length unit, angles in radians.
//!
//! No spans here: an [`OriginId`] leads back to the source text.

mod mechanics;

pub use super::functions::Function;
pub use super::units::LengthUnit;
pub use mechanics::*;

use crate::diagnostic::OriginId;

/// Powers of length, force and time of a quantity, in halves so that square roots stay exact (`2` is a length, `4` an
/// area). A mass is force times time squared over length. Numbers and angles convert freely, so all powers of both are 0;
/// `angle` only chooses words in messages, units in docs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    pub half_lengths: i32,
    pub half_forces: i32,
    pub half_times: i32,
    /// How many kilograms the unit has in which it is given and printed; the rest of the powers is newtons, seconds and the
    /// length unit. It does not count for whether two dimensions fit. See [`Dimension::internal_per_unit`].
    pub half_kilograms: i32,
    pub angle: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Type {
    Scalar(Dimension),
    /// Two or three components of one dimension.
    Vector(usize, Dimension),
    /// `velocity` with several inputs, `sensitivity`: entries that may differ in dimension.
    Array(Vec<Type>),
    /// A point and three perpendicular directions in space; what it consists of is read as entries 0 (the origin) to 3.
    Frame,
    /// The literal `0` (or a vector of such): fits every dimension. The count is 1 for a scalar.
    Zero(usize),
    /// Follows from a mistake already reported.
    Error,
}

#[derive(Clone, Debug)]
pub struct Expr {
    pub kind: ExprKind,
    pub ty: Type,
    pub origin: OriginId,
}

/// Equal if they say the same, wherever they stand.
impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind
    }
}

#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// In the unit of its dimension: the mechanism's length unit, radians, newtons, seconds, kilograms.
    Number(f64),
    Name(Name),
    Vector(Vec<Expr>),
    Component(Box<Expr>, usize),
    /// Entry of an array (`velocity(p)[1]`), part of a frame (`body.origin`).
    Index(Box<Expr>, usize),
    Negate(Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    Call(Function, Vec<Expr>),
    /// `d(q, x)`, `d(q, x, y)`.
    Derivative(Box<Expr>, Vec<Variable>),
    /// `velocity` 1, `acceleration` 2, `jerk` 3: by the inputs of the function that asks.
    InputDerivative(Box<Expr>, u8),
    /// By these scalar parameters, in this order.
    Sensitivity(Box<Expr>, Vec<ScalarParameterId>),
    Margin,
    /// `picture([p, q], ...)`: what the mechanism looks like, with these links beside those of the loops.
    Picture(Vec<Vec<Expr>>),
    /// A quantity of the mechanics, for the speeds that the function lists.
    Mechanics(Mechanics),
    Error,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
}

/// What a name stands for; each index counts its own kind in declaration order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Name {
    Const(usize),
    Parameter(usize),
    Input(usize),
    Unknown(usize),
    Let(usize),
    Argument(usize),
    /// `PI`
    Pi,
}

/// Index into [`Mechanism::scalar_parameters`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScalarParameterId(pub usize);

/// What one can differentiate by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Variable {
    Input(usize),
    Parameter(ScalarParameterId),
}

#[derive(Clone, Debug)]
pub struct Constant {
    pub name: String,
    pub value: Expr,
    pub origin: OriginId,
}

/// One declared parameter; vectors have one scalar parameter for each component.
#[derive(Clone, Debug)]
pub struct Parameter {
    pub name: String,
    pub ty: Type,
    /// The default: numbers, functions and constants only.
    pub nominal: Expr,
    /// Per component; `None`: no tolerance, zero.
    pub tolerances: Vec<Option<Expr>>,
    /// Its scalar parameters are `first_scalar .. first_scalar + components`.
    pub first_scalar: ScalarParameterId,
    pub origin: OriginId,
}

#[derive(Clone, Debug)]
pub struct ScalarParameter {
    /// `crank`, `pivot_d.x`
    pub name: String,
    pub parameter: usize,
    /// 0 for a scalar.
    pub component: usize,
    pub dimension: Dimension,
}

#[derive(Clone, Debug)]
pub struct Input {
    pub name: String,
    pub dimension: Dimension,
    pub reference: Expr,
    pub range: Option<(Expr, Expr)>,
    /// The arguments that are its speed and acceleration.
    pub speed: Option<usize>,
    pub acceleration: Option<usize>,
    pub origin: OriginId,
}

/// A number that functions take besides inputs: a load, a speed. Nothing that moves depends on it.
#[derive(Clone, Debug)]
pub struct Argument {
    pub name: String,
    pub dimension: Dimension,
    /// `None` for a speed or acceleration.
    pub reference: Option<Expr>,
    pub origin: OriginId,
}

#[derive(Clone, Debug)]
pub struct Unknown {
    pub name: String,
    /// A scalar, or a two- or three-component vector (an unknown point).
    pub ty: Type,
    /// The start estimate: numbers, constants and parameters only.
    pub estimate: Expr,
    pub origin: OriginId,
}

#[derive(Clone, Debug)]
pub struct Let {
    pub name: String,
    /// Uses only names declared before it.
    pub value: Expr,
    pub origin: OriginId,
}

/// `left = right`, both of one type: a scalar or a vector of two or three components.
#[derive(Clone, Debug)]
pub struct Loop {
    pub left: Expr,
    pub right: Expr,
    pub origin: OriginId,
}

#[derive(Clone, Debug)]
pub struct EvaluatorDef {
    pub name: String,
    pub result: String,
    /// Inputs in the order of the function's arguments. Numbers from [`Mechanism::inputs`]'s length on are arguments.
    pub inputs: Vec<usize>,
    /// Origins of the arguments, same order.
    pub input_origins: Vec<OriginId>,
    pub quantities: Vec<Quantity>,
    pub origin: OriginId,
}

#[derive(Clone, Debug)]
pub struct Quantity {
    pub field: String,
    pub value: Expr,
    pub origin: OriginId,
}

/// A mechanism without a mistake in names, dimensions or arity.
#[derive(Clone, Debug)]
pub struct Mechanism {
    pub name: String,
    pub unit: LengthUnit,
    pub constants: Vec<Constant>,
    pub parameters: Vec<Parameter>,
    pub scalar_parameters: Vec<ScalarParameter>,
    pub inputs: Vec<Input>,
    pub unknowns: Vec<Unknown>,
    pub lets: Vec<Let>,
    pub loops: Vec<Loop>,
    pub arguments: Vec<Argument>,
    pub gravity: Option<Expr>,
    pub bodies: Vec<Body>,
    /// Those that bodies hang on, and those that close loops.
    pub joints: Vec<Joint>,
    pub loads: Vec<Load>,
    pub elements: Vec<Element>,
    pub evaluators: Vec<EvaluatorDef>,
    pub origin: OriginId,
}

impl Mechanism {
    /// A name as it is written.
    pub fn name(&self, name: Name) -> &str {
        match name {
            Name::Const(index) => &self.constants[index].name,
            Name::Parameter(index) => &self.parameters[index].name,
            Name::Input(index) => &self.inputs[index].name,
            Name::Unknown(index) => &self.unknowns[index].name,
            Name::Let(index) => &self.lets[index].name,
            Name::Argument(index) => &self.arguments[index].name,
            Name::Pi => "PI",
        }
    }

    /// Whether this one of the inputs and, behind them, arguments is a load: neither an input nor a speed or acceleration.
    pub fn is_load(&self, index: usize) -> bool {
        let argument = index.checked_sub(self.inputs.len());
        argument.is_some_and(|argument| self.arguments[argument].reference.is_some())
    }

    /// The name of an input or, behind the inputs, an argument.
    pub fn input_name(&self, index: usize) -> &str {
        match index.checked_sub(self.inputs.len()) {
            None => &self.inputs[index].name,
            Some(argument) => &self.arguments[argument].name,
        }
    }
}
