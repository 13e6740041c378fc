//! The resolved mechanism: ids instead of names, checked dimensions, one length unit, angles in radians.
//!
//! No spans here: an [`OriginId`] leads back to the source text.

mod course;
mod mechanics;

use std::ops::Range;

pub(crate) use super::functions::Function;
pub(crate) use super::leaf::Leaf;
pub(crate) use super::units::LengthUnit;
pub(crate) use course::{
    Course, CourseKind, Ends, HIGHEST_SLOPE, Knot, Law, Pieces, Repeating, Repeats, SplineWord,
};
pub(crate) use mechanics::*;

use crate::diagnostic::OriginId;

/// Powers of length, force and time of a quantity, in halves so that square roots stay exact (`2` is a length, `4` an
/// area). A mass is force times time squared over length. Numbers and angles convert freely, so all powers of both are 0;
/// `angle` only chooses words in messages, units in docs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Dimension {
    pub(crate) half_lengths: i32,
    pub(crate) half_forces: i32,
    pub(crate) half_times: i32,
    /// How many kilograms the unit has in which it is given and printed; the rest of the powers is newtons, seconds and the
    /// length unit. It does not count for whether two dimensions fit. See [`Dimension::internal_per_unit`].
    pub(crate) half_kilograms: i32,
    pub(crate) angle: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Type {
    Scalar(Dimension),
    /// Two or three components of one dimension.
    Vector(usize, Dimension),
    /// `velocity` with several inputs, `sensitivity`: entries that may differ in dimension.
    Array(Vec<Type>),
    /// A point and three perpendicular directions in space; what it consists of is read as entries 0 (the origin) to 3.
    Frame,
    /// A point and a direction in the plane; its parts are the origin, the axes and the angle of the first.
    PlaneFrame,
    /// The literal `0` (or a vector of such): fits every dimension. The count is 1 for a scalar.
    Zero(usize),
    /// Follows from a mistake already reported.
    Error,
}

#[derive(Clone, Debug)]
pub(crate) struct Expr {
    pub(crate) kind: ExprKind,
    pub(crate) ty: Type,
    pub(crate) origin: OriginId,
}

/// Equal if they say the same, wherever they stand.
impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) enum ExprKind {
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
    /// `rise(x, law)`, `piecewise(x, [...])`, `spline(x, [...])`.
    Course(Course),
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
pub(crate) enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
}

/// What a name stands for; each index counts its own kind in declaration order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Name {
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
pub(crate) struct ScalarParameterId(pub usize);

/// What one can differentiate by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Variable {
    Input(usize),
    Parameter(ScalarParameterId),
}

#[derive(Clone, Debug)]
pub(crate) struct Constant {
    pub(crate) name: String,
    pub(crate) value: Expr,
}

/// One declared parameter; vectors have one scalar parameter for each component.
#[derive(Clone, Debug)]
pub(crate) struct Parameter {
    pub(crate) name: String,
    /// Its doc comment, line by line as written.
    pub(crate) documentation: String,
    pub(crate) ty: Type,
    /// Where its name is declared.
    pub(crate) origin: OriginId,
    /// Whether the user says that it may be a field only.
    pub(crate) may_be_unused: bool,
    /// The default: numbers, functions and constants only.
    pub(crate) nominal: Expr,
    /// Per component; `None`: no tolerance, zero.
    pub(crate) tolerances: Vec<Option<Expr>>,
    /// Its scalar parameters are `first_scalar .. first_scalar + components`.
    pub(crate) first_scalar: ScalarParameterId,
}

#[derive(Clone, Debug)]
pub(crate) struct ScalarParameter {
    /// `crank`, `pivot_d.x`
    pub(crate) name: String,
    pub(crate) parameter: usize,
    pub(crate) dimension: Dimension,
}

#[derive(Clone, Debug)]
pub(crate) struct Input {
    pub(crate) name: String,
    pub(crate) dimension: Dimension,
    pub(crate) reference: Expr,
    pub(crate) range: Option<(Expr, Expr)>,
    /// The arguments that are its speed and acceleration.
    pub(crate) speed: Option<usize>,
    pub(crate) acceleration: Option<usize>,
    pub(crate) origin: OriginId,
}

/// A number that functions take besides inputs: a load, a speed. Nothing that moves depends on it.
#[derive(Clone, Debug)]
pub(crate) struct Argument {
    pub(crate) name: String,
    pub(crate) dimension: Dimension,
    /// `None` for a speed or acceleration.
    pub(crate) reference: Option<Expr>,
}

#[derive(Clone, Debug)]
pub(crate) struct Unknown {
    pub(crate) name: String,
    /// A scalar, or a two- or three-component vector (an unknown point).
    pub(crate) ty: Type,
    /// The start estimate, if there is one: numbers, constants and parameters only.
    pub(crate) estimate: Option<Expr>,
    /// Whether it is one of a part: its estimate is then where the part alone has it.
    pub(crate) of_part: bool,
    pub(crate) origin: OriginId,
}

#[derive(Clone, Debug)]
pub(crate) struct Let {
    pub(crate) name: String,
    /// Uses only names declared before it.
    pub(crate) value: Expr,
    /// Whether it is an unknown frame, made of unknowns of its own.
    pub(crate) is_unknown_frame: bool,
}

/// `left = right`, both of one type: a scalar or a vector of two or three components.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    pub(crate) left: Expr,
    pub(crate) right: Expr,
    pub(crate) origin: OriginId,
}

/// A mechanism within this one: what is its own stands among what is of its kind, under names that begin with its own.
#[derive(Clone, Debug)]
pub(crate) struct Part {
    pub(crate) name: String,
    /// The mechanism that it is, as it is called.
    pub(crate) mechanism: String,
    /// The derived quantities that its inputs are here.
    pub(crate) inputs: Vec<usize>,
    /// What its parameters are here: parameters, or derived quantities for those that are given.
    pub(crate) parameters: Vec<Name>,
    /// Its unknowns.
    pub(crate) unknowns: Range<usize>,
    /// The parts within it, with the mechanisms that they are.
    pub(crate) inner: Vec<(String, String)>,
}

/// Where a part stands in the mechanism that it is a part of.
#[derive(Clone, Debug)]
pub(crate) struct Placed {
    /// The part's name, those of the parts around it in front.
    pub(crate) path: String,
    /// The derived quantity that its origin is, or its frame in space.
    pub(crate) at: Option<Expr>,
    /// The derived quantity that is the angle of its x axis in the plane.
    pub(crate) turned: Option<Expr>,
    /// Its loops, those of parts within it among them.
    pub(crate) loops: Range<usize>,
}

#[derive(Clone, Debug)]
pub(crate) struct EvaluatorDef {
    pub(crate) name: String,
    /// Its doc comment, line by line as written.
    pub(crate) documentation: String,
    pub(crate) result: String,
    /// Inputs in the order of the function's arguments. Numbers from [`Mechanism::inputs`]'s length on are arguments.
    pub(crate) inputs: Vec<usize>,
    /// Origins of the arguments, same order.
    pub(crate) input_origins: Vec<OriginId>,
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) origin: OriginId,
}

#[derive(Clone, Debug)]
pub(crate) struct Quantity {
    pub(crate) field: String,
    /// Its doc comment, line by line as written.
    pub(crate) documentation: String,
    pub(crate) value: Expr,
    /// The value as text.
    pub(crate) written: String,
    /// What it is the derivative of, as text; the value itself if it is none.
    pub(crate) subject: String,
    pub(crate) origin: OriginId,
}

/// A mechanism without a mistake in names, dimensions or arity.
#[derive(Clone, Debug)]
pub(crate) struct Mechanism {
    pub(crate) name: String,
    /// Its doc comment, line by line as written.
    pub(crate) documentation: String,
    pub(crate) unit: LengthUnit,
    pub(crate) constants: Vec<Constant>,
    pub(crate) parameters: Vec<Parameter>,
    pub(crate) scalar_parameters: Vec<ScalarParameter>,
    pub(crate) inputs: Vec<Input>,
    pub(crate) unknowns: Vec<Unknown>,
    pub(crate) lets: Vec<Let>,
    pub(crate) loops: Vec<Loop>,
    /// Loops that follow from these.
    pub(crate) redundant: Vec<Loop>,
    pub(crate) arguments: Vec<Argument>,
    pub(crate) parts: Vec<Part>,
    pub(crate) leaves: Vec<Leaf>,
    /// Parts, and parts of parts, with coordinates of their own.
    pub(crate) placed: Vec<Placed>,
    pub(crate) gravity: Option<Expr>,
    pub(crate) bodies: Vec<Body>,
    /// Those that bodies hang on, and those that close loops.
    pub(crate) joints: Vec<Joint>,
    pub(crate) loads: Vec<Load>,
    pub(crate) elements: Vec<Element>,
    pub(crate) evaluators: Vec<EvaluatorDef>,
    pub(crate) origin: OriginId,
}

impl Mechanism {
    /// The names of its parts and of those within them, each with the mechanism that it is.
    pub(crate) fn paths_of_parts(&self) -> Vec<(String, String)> {
        let parts = self.parts.iter();
        let paths = parts.flat_map(|part| {
            let own = (part.name.clone(), part.mechanism.clone());
            let inner = part.inner.iter();
            let inner = inner.map(|(path, of)| (format!("{}.{path}", part.name), of.clone()));
            std::iter::once(own).chain(inner)
        });
        paths.collect()
    }

    /// A name as it is written.
    pub(crate) fn name(&self, name: Name) -> &str {
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
    pub(crate) fn is_load(&self, index: usize) -> bool {
        let argument = index.checked_sub(self.inputs.len());
        argument.is_some_and(|argument| self.arguments[argument].reference.is_some())
    }

    /// The name of an input or, behind the inputs, an argument.
    pub(crate) fn input_name(&self, index: usize) -> &str {
        match index.checked_sub(self.inputs.len()) {
            None => &self.inputs[index].name,
            Some(argument) => &self.arguments[argument].name,
        }
    }
}
