//! The resolved mechanism: ids instead of names, checked dimensions, one length unit, angles in radians.
//!
//! No spans here: an [`OriginId`](crate::diagnostic::OriginId) leads back to the source text.

mod bodies;
mod dimension;
mod expression;
mod mechanism;
mod motion_law;
mod name;
mod value_type;

pub(crate) use super::functions::Function;
pub(crate) use super::units::LengthUnit;
pub(crate) use crate::syntax::JointKind;
pub(crate) use bodies::{Between, Body, Element, ElementKind, Inertia, Joint, Load};
pub(crate) use dimension::Dimension;
pub(crate) use expression::{BinaryOp, Course, Expr, ExprKind, Knot, Mechanics};
pub(crate) use mechanism::{
    Argument, Constant, EvaluatorDef, Input, Leaf, Let, Loop, Mechanism, Parameter, Part, Placed,
    Quantity, ScalarParameter, Unknown,
};
pub(crate) use motion_law::{
    CourseKind, Ends, HIGHEST_SLOPE, Law, Pieces, Repeating, Repeats, SplineWord,
};
pub(crate) use name::{Name, ScalarParameterId, Variable};
pub(crate) use value_type::Type;
