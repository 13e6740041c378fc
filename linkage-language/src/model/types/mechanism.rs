//! A resolved mechanism.

use super::dimension::Dimension;
use super::expression::Expr;
use super::length_unit::LengthUnit;
use super::link_elements::LinkElements;
use super::mechanics::{Body, Element, Friction, Joint, Load};
use super::mechanism_part::{Leaf, MechanismPart, Placed};
use super::name::{Name, ScalarParameterId};
use super::value_type::Type;
use crate::diagnostic::OriginId;
use crate::syntax::{LinkInventory, LinkLoop};

/// A mechanism without a mistake in names, dimensions or arity.
#[derive(Clone, Debug)]
pub struct Mechanism {
    pub name: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    pub unit: LengthUnit,
    pub constants: Vec<Constant>,
    pub parameters: Vec<Parameter>,
    pub scalar_parameters: Vec<ScalarParameter>,
    pub inputs: Vec<Input>,
    pub unknowns: Vec<Unknown>,
    pub lets: Vec<Let>,
    pub loops: Vec<Loop>,
    /// Loops that follow from these.
    pub redundant: Vec<Loop>,
    pub arguments: Vec<Argument>,
    pub parts: Vec<MechanismPart>,
    pub leaves: Vec<Leaf>,
    /// Parts, and parts of parts, with coordinates of their own.
    pub placed: Vec<Placed>,
    pub gravity: Option<Expr>,
    pub bodies: Vec<Body>,
    /// Those that bodies hang on, and those that close loops.
    pub joints: Vec<Joint>,
    pub loads: Vec<Load>,
    pub elements: Vec<Element>,
    pub frictions: Vec<Friction>,
    pub arcs: Vec<Arc>,
    pub evaluators: Vec<EvaluatorDef>,
    /// The joints and links that items stand for.
    pub links: Option<LinkInventory>,
    /// The links and wheels that pictures show, those of parts included.
    pub link_elements: LinkElements,
    pub origin: OriginId,
}

impl Mechanism {
    /// The names of its parts and of those within them, each with the mechanism that it is.
    pub fn paths_of_parts(&self) -> Vec<(String, String)> {
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

    /// Returns true for an argument that is a load: neither an input nor a speed or acceleration.
    /// Arguments are counted after the inputs.
    pub fn is_load(&self, index: usize) -> bool {
        let argument = index.checked_sub(self.inputs.len());
        argument.is_some_and(|argument| self.arguments[argument].reference.is_some())
    }

    /// Returns the name of an input or, with a number after the inputs, of an argument.
    pub fn input_name(&self, index: usize) -> &str {
        match index.checked_sub(self.inputs.len()) {
            None => &self.inputs[index].name,
            Some(argument) => &self.arguments[argument].name,
        }
    }

    /// Returns the index in [`Mechanism::placed`] of the part whose point this is, and the point in
    /// the frame of the part.
    pub fn standing<'e>(&self, expr: &'e Expr) -> Option<(usize, &'e Expr)> {
        let is_length = expr
            .ty
            .dimension()
            .is_some_and(|dimension| dimension.half_lengths == 2);
        let parts = self.placed.iter().enumerate().filter(|_| is_length);
        let mut found = parts.filter_map(|(index, part)| Some((index, part.point_behind(expr)?)));
        found.next()
    }

    /// Returns the expression of a name, if it has one.
    pub fn value_of(&self, name: Name) -> Option<&Expr> {
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
pub struct Constant {
    pub name: String,
    pub value: Expr,
}

/// One declared parameter; vectors have one scalar parameter for each component.
#[derive(Clone, Debug)]
pub struct Parameter {
    pub name: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    pub ty: Type,
    /// The place of its declaration.
    pub origin: OriginId,
    /// True if the user accepts that it is only a field.
    pub may_be_unused: bool,
    /// The default: numbers, functions and constants only.
    pub nominal: Expr,
    /// Per component; `None`: no tolerance, zero.
    pub tolerances: Vec<Option<Expr>>,
    /// Its scalar parameters are `first_scalar .. first_scalar + components`.
    pub first_scalar: ScalarParameterId,
}

#[derive(Clone, Debug)]
pub struct ScalarParameter {
    /// `crank`, `pivot_d.x`
    pub name: String,
    pub parameter: usize,
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

/// A number that functions take besides inputs: a load, a speed. Positions do not depend on it.
#[derive(Clone, Debug)]
pub struct Argument {
    pub name: String,
    pub dimension: Dimension,
    /// `None` for a speed or acceleration.
    pub reference: Option<Expr>,
}

#[derive(Clone, Debug)]
pub struct Unknown {
    pub name: String,
    /// A scalar, or a two- or three-component vector (an unknown point).
    pub ty: Type,
    /// The start estimate, if there is one: numbers, constants and parameters only.
    pub estimate: Option<Expr>,
    /// True for an unknown of a part: its estimate is then the value in the part alone.
    pub of_part: bool,
    pub origin: OriginId,
}

#[derive(Clone, Debug)]
pub struct Let {
    pub name: String,
    /// Uses only names declared before it.
    pub value: Expr,
    /// True for an unknown frame, which consists of unknowns.
    pub is_unknown_frame: bool,
}

/// A curved slot: a loop keeps its slider at a constant distance from its centre.
#[derive(Clone, Debug)]
pub struct Arc {
    pub name: String,
    /// The point in the slot.
    pub slider: Expr,
    pub centre: Expr,
    /// A unit vector that turns with the link that has the slot.
    pub direction: Expr,
}

/// `left = right`, both of one type: a scalar or a vector of two or three components.
#[derive(Clone, Debug)]
pub struct Loop {
    pub left: Expr,
    pub right: Expr,
    pub origin: OriginId,
    /// The joint or link that it stands for; `None` for a loop as it is written.
    pub of: Option<LinkLoop>,
}

#[derive(Clone, Debug)]
pub struct EvaluatorDef {
    pub name: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    pub result: String,
    /// Inputs in the order of the function's arguments. Numbers after the last of
    /// [`Mechanism::inputs`] are arguments.
    pub inputs: Vec<usize>,
    /// Origins of the arguments, same order.
    pub input_origins: Vec<OriginId>,
    pub quantities: Vec<Quantity>,
    pub origin: OriginId,
}

#[derive(Clone, Debug)]
pub struct Quantity {
    pub field: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    pub value: Expr,
    /// The value as text.
    pub written: String,
    /// The expression below its derivatives as text; the value itself if it is no derivative.
    pub subject: String,
    pub origin: OriginId,
}
