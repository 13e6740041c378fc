//! The resolved mechanism: ids instead of names, checked dimensions, one length unit, angles in radians.
//!
//! No spans here: an [`OriginId`](crate::diagnostic::OriginId) leads back to the source text.

mod angles;
mod bodies;
mod components;
mod dimension;
mod expression;
mod functions;
mod length_unit;
mod mechanism;
mod motion_law;
mod name;
mod shape;
mod type_names;
mod usage;
mod value_type;
mod walk;

pub(crate) use crate::syntax::JointKind;
pub(crate) use bodies::{Between, Body, Element, ElementKind, Inertia, Joint, Load};
pub use components::COMPONENTS;
pub(crate) use dimension::Dimension;
pub(crate) use expression::{BinaryOp, Course, Expr, ExprKind, Knot, Mechanics};
pub(in crate::model) use functions::is_function;
pub(crate) use functions::{CourseWord, Function, MechanicsWord, MotionWord, QuantityWord};
pub(crate) use length_unit::LengthUnit;
pub(crate) use mechanism::{
    Argument, Constant, EvaluatorDef, Input, Leaf, Let, Loop, Mechanism, Parameter, Part, Placed,
    Quantity, ScalarParameter, Unknown,
};
pub(crate) use motion_law::{
    CourseKind, Ends, HIGHEST_SLOPE, Law, Pieces, Repeating, Repeats, SplineWord,
};
pub(crate) use name::{Name, ScalarParameterId, Variable};
pub use shape::Shape;
pub(in crate::model) use type_names::raised;
pub(crate) use usage::AskedPicture;
pub(crate) use value_type::Type;
pub(crate) use walk::Derived;
