//! The resolved mechanism: ids instead of names, checked dimensions, one length unit, angles in
//! radians.
//!
//! No spans here: an [`OriginId`](crate::diagnostic::OriginId) leads back to the source text.

mod angles;
mod components;
mod dimension;
mod expression;
mod function_words;
mod length_unit;
mod mechanics;
mod mechanism;
mod motion_law;
mod name;
mod parts_of_frame;
mod traversal;
mod type_names;
mod usage;
mod value_shape;
mod value_type;

pub(crate) use crate::syntax::JointKind;
pub(in crate::model) use angles::angles;
pub use components::COMPONENTS;
pub(crate) use dimension::Dimension;
pub(crate) use expression::{BinaryOp, Expr, ExprKind, Knot, MechanicalQuantity, MotionLaw};
pub(in crate::model) use function_words::is_function;
pub(crate) use function_words::{Function, MechanicsWord, MotionLawWord, MotionWord, QuantityWord};
pub(crate) use length_unit::LengthUnit;
pub(crate) use mechanics::{Between, Body, Element, ElementKind, Inertia, Joint, Load};
pub(crate) use mechanism::{
    Argument, Constant, EvaluatorDef, Input, Leaf, Let, Loop, Mechanism, MechanismPart, Parameter,
    Placed, Quantity, ScalarParameter, Unknown,
};
pub(crate) use motion_law::{
    Ends, HIGHEST_SLOPE, Law, MotionLawKind, Pieces, Repeating, Repeats, SplineWord,
};
pub(crate) use name::{Name, ScalarParameterId, Variable};
pub(in crate::model) use parts_of_frame::{ANGLE_PART, type_of_part};
pub(crate) use parts_of_frame::{PARTS as FRAME_PARTS, PLANE_PARTS, VECTORS_OF_PLANE};
pub(crate) use traversal::Derived;
pub(in crate::model) use type_names::raised;
pub(crate) use usage::AskedPicture;
pub use value_shape::Shape;
pub(crate) use value_type::Type;
