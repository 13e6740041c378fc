//! A resolved mechanism.

use std::ops::Range;

use super::dimension::Dimension;
use super::expression::{BinaryOp, Expr, ExprKind};
use super::function_words::Function;
use super::length_unit::LengthUnit;
use super::mechanics::{Body, Element, Joint, Load};
use super::name::{Name, ScalarParameterId};
use super::value_type::Type;
use crate::diagnostic::OriginId;

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
    pub(crate) parts: Vec<MechanismPart>,
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
            let first = (part.name.clone(), part.mechanism.clone());
            let inner = part.inner.iter();
            let inner =
                inner.map(|(path, mechanism)| (format!("{}.{path}", part.name), mechanism.clone()));
            std::iter::once(first).chain(inner)
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

    /// Returns true for an argument that is a load: neither an input nor a speed or acceleration.
    /// Arguments are counted after the inputs.
    pub(crate) fn is_load(&self, index: usize) -> bool {
        let argument = index.checked_sub(self.inputs.len());
        argument.is_some_and(|argument| self.arguments[argument].reference.is_some())
    }

    /// Returns the name of an input or, with a number after the inputs, of an argument.
    pub(crate) fn input_name(&self, index: usize) -> &str {
        match index.checked_sub(self.inputs.len()) {
            None => &self.inputs[index].name,
            Some(argument) => &self.arguments[argument].name,
        }
    }

    /// Returns the index in [`Mechanism::placed`] of the part whose point this is, and the point in
    /// the frame of the part.
    pub(crate) fn standing<'e>(&self, expr: &'e Expr) -> Option<(usize, &'e Expr)> {
        let is_length = expr
            .ty
            .dimension()
            .is_some_and(|dimension| dimension.half_lengths == 2);
        let parts = self.placed.iter().enumerate().filter(|_| is_length);
        let mut found = parts.filter_map(|(index, part)| Some((index, part.point_behind(expr)?)));
        found.next()
    }

    /// Returns the expression of a name, if it has one.
    pub(crate) fn value_of(&self, name: Name) -> Option<&Expr> {
        match name {
            Name::Const(index) => Some(&self.constants[index].value),
            Name::Let(index) => Some(&self.lets[index].value),
            Name::Parameter(_)
            | Name::Input(_)
            | Name::Unknown(_)
            | Name::Argument(_)
            | Name::Pi => None,
        }
    }
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
    /// The place of its declaration.
    pub(crate) origin: OriginId,
    /// True if the user accepts that it is only a field.
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

/// A number that functions take besides inputs: a load, a speed. Positions do not depend on it.
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
    /// True for an unknown of a part: its estimate is then the value in the part alone.
    pub(crate) of_part: bool,
    pub(crate) origin: OriginId,
}

#[derive(Clone, Debug)]
pub(crate) struct Let {
    pub(crate) name: String,
    /// Uses only names declared before it.
    pub(crate) value: Expr,
    /// True for an unknown frame, which consists of unknowns.
    pub(crate) is_unknown_frame: bool,
}

/// `left = right`, both of one type: a scalar or a vector of two or three components.
#[derive(Clone, Debug)]
pub(crate) struct Loop {
    pub(crate) left: Expr,
    pub(crate) right: Expr,
    pub(crate) origin: OriginId,
}

/// A mechanism within this one. Its items are among the items of the same kind, with names that
/// begin with its own.
#[derive(Clone, Debug)]
pub(crate) struct MechanismPart {
    pub(crate) name: String,
    /// The mechanism that it is, as it is called.
    pub(crate) mechanism: String,
    /// The derived quantities that its inputs are here.
    pub(crate) inputs: Vec<usize>,
    /// Its parameters here: parameters, or derived quantities for those that are given.
    pub(crate) parameters: Vec<Name>,
    /// Its unknowns.
    pub(crate) unknowns: Range<usize>,
    /// The parts within it, with the mechanisms that they are.
    pub(crate) inner: Vec<(String, String)>,
}

/// The location of a part in the mechanism around it.
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

/// A part without parts, or one within a part: the ranges of its own derived quantities, loops and
/// unknowns.
#[derive(Clone, Debug)]
pub(crate) struct Leaf {
    pub(crate) lets: Range<usize>,
    pub(crate) loops: Range<usize>,
    pub(crate) unknowns: Range<usize>,
}

#[derive(Clone, Debug)]
pub(crate) struct EvaluatorDef {
    pub(crate) name: String,
    /// Its doc comment, line by line as written.
    pub(crate) documentation: String,
    pub(crate) result: String,
    /// Inputs in the order of the function's arguments. Numbers after the last of
    /// [`Mechanism::inputs`] are arguments.
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
    /// The expression below its derivatives as text; the value itself if it is no derivative.
    pub(crate) subject: String,
    pub(crate) origin: OriginId,
}

impl Placed {
    /// Returns the point of the part that this expression is in the mechanism around it. The
    /// inverse of `PartFrame::seen_point`.
    pub(crate) fn point_behind<'e>(&self, seen: &'e Expr) -> Option<&'e Expr> {
        let turned_back = |turned: &'e Expr| match (&self.turned, &turned.kind) {
            (None, _) => Some(turned),
            (Some(angle), ExprKind::Call(Function::Rotate, arguments)) => {
                (arguments[1] == *angle).then(|| &arguments[0])
            }
            (Some(_), _) => None,
        };
        match (&self.at, &seen.kind) {
            (None, _) => self.turned.as_ref().and_then(|_| turned_back(seen)),
            (Some(at), ExprKind::Call(Function::PointIn, arguments)) => {
                (arguments[0] == *at).then(|| &arguments[1])
            }
            (Some(at), ExprKind::Binary(BinaryOp::Add, origin, turned)) if **origin == *at => {
                turned_back(turned)
            }
            (Some(_), _) => None,
        }
    }
}
