//! The resolved mechanism: ids instead of names, checked dimensions, one length unit, angles in
//! radians.
//!
//! No spans here: an [`OriginId`](crate::diagnostic::OriginId) leads back to the source text.

mod angles;
mod components;
mod dimension;
mod expression;
mod function_words;
mod joint;
mod length_unit;
mod link_elements;
mod mechanics;
mod mechanism;
mod mechanism_part;
mod motion_law;
mod name;
mod parts_of_frame;
mod quantity_parameters;
mod traversal;
mod type_names;
mod usage;
mod value_shape;
mod value_type;

pub use crate::syntax::{JointCount, JointKind, LinkInventory, LinkLoop};
pub(in crate::model) use angles::angles;
pub use components::COMPONENTS;
pub use dimension::Dimension;
pub use expression::{BinaryOp, Expr, ExprKind, Knot, MechanicalQuantity, MotionLaw};
pub(in crate::model) use function_words::is_function;
pub use function_words::{
    CalledWord, Function, MechanicsWord, MotionLawWord, MotionWord, QuantityWord,
};
pub use joint::Rotation;
pub use length_unit::LengthUnit;
pub use link_elements::{LinkElements, PairOfWheels, PairedWheel, RigidLink, StraightSlot};
pub use mechanics::{Between, Body, Contact, Element, ElementKind, Friction, Inertia, Joint, Load};
pub use mechanism::{
    Arc, Argument, Constant, EvaluatorDef, Input, Let, Loop, Mechanism, Parameter, Quantity,
    ScalarParameter, Unknown,
};
pub use mechanism_part::{Leaf, MechanismPart, Placed};
pub use motion_law::{
    Degree, Ends, HIGHEST_SLOPE, Law, MotionLawKind, Pieces, Repeating, Repeats, SplineWord,
};
pub use name::{Name, ScalarParameterId, Variable};
pub(in crate::model) use parts_of_frame::{ANGLE_PART, type_of_part};
pub use parts_of_frame::{PARTS as FRAME_PARTS, PLANE_PARTS, VECTORS_OF_PLANE};
pub use traversal::Derived;
pub(in crate::model) use type_names::raised;
pub use usage::AskedPicture;
pub use value_shape::Shape;
pub use value_type::Type;
