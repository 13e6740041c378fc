//! Shapes of expressions from the syntax alone, for the skeleton: an expression that is obviously a
//! vector is one, the rest are numbers.

use std::collections::BTreeMap;

use super::outline::{params, plain};
use linkage_language::model::{Function, MechanicsWord, MotionWord, QuantityWord, Shape};
use linkage_language::syntax::{
    BinaryOp, Expr, ExprKind, Item, MechanismDef, ParamItem, Toleranced, Word,
};

/// More vectors than most pictures have.
const MANY_POINTS: usize = 64;

/// Names may stand for expressions with names in them; deeper than this, something is wrong with
/// the source.
const DEPTH: usize = 24;

/// The expressions that the names of a mechanism stand for.
pub(super) struct Guess<'a> {
    names: BTreeMap<String, &'a Expr>,
    vectors: BTreeMap<String, usize>,
    scalar_parameters: usize,
    /// Components of points in the mechanics.
    components: usize,
}

impl<'a> Guess<'a> {
    pub(super) fn new(def: &'a MechanismDef) -> Self {
        let mut guess = Self {
            names: BTreeMap::new(),
            vectors: BTreeMap::new(),
            scalar_parameters: 0,
            components: 2,
        };
        for item in &def.items {
            match item {
                Item::Const(item) | Item::Let(item) => {
                    guess
                        .names
                        .entry(plain(&item.name.field()))
                        .or_insert(&item.value);
                }
                Item::Unknown(item) => {
                    if let Some(estimate) = &item.estimate {
                        guess
                            .names
                            .entry(plain(&item.name.field()))
                            .or_insert(estimate);
                    }
                }
                Item::Param(param) => match &param.value {
                    Toleranced::Single { nominal, .. } => {
                        guess
                            .names
                            .entry(plain(&param.name.field()))
                            .or_insert(nominal);
                    }
                    Toleranced::Components { components, .. } => {
                        guess
                            .vectors
                            .insert(plain(&param.name.field()), components.len());
                    }
                },
                // Scalars, or nothing with a value.
                Item::Unit(_)
                | Item::Input(_)
                | Item::Argument(_)
                | Item::Part(_)
                | Item::Loop(_)
                | Item::Gravity(_)
                | Item::Body(_)
                | Item::Arc(_)
                | Item::Joint(_)
                | Item::Force(_)
                | Item::Torque(_)
                | Item::Spring(_)
                | Item::Damper(_)
                | Item::Friction(_)
                | Item::Linked(_) => {}
            }
        }
        let mut points = def.items.iter().filter_map(|item| match item {
            Item::Body(body) => Some(&body.joint.at),
            _ => None,
        });
        if points.any(|point| guess.shape(point, 0) == Shape::Vector(3)) {
            guess.components = 3;
        }
        guess.scalar_parameters = params(def)
            .map(|param| guess.parameter(param).width())
            .sum();
        guess
    }

    pub(super) fn parameter(&self, param: &ParamItem) -> Shape {
        match &param.value {
            Toleranced::Single { nominal, .. } => self.shape(nominal, 0),
            Toleranced::Components { components, .. } => vector(components.len()),
        }
    }

    /// The shape of `expr` in a function of so many inputs, arguments aside.
    pub(super) fn shape(&self, expr: &Expr, inputs: usize) -> Shape {
        self.at_depth(expr, inputs, DEPTH)
    }

    fn at_depth(&self, expr: &Expr, inputs: usize, depth: usize) -> Shape {
        let Some(depth) = depth.checked_sub(1) else {
            return Shape::Scalar;
        };
        let shape = |expr: &Expr| self.at_depth(expr, inputs, depth);
        match &expr.kind {
            ExprKind::Name(name) => {
                let name = plain(name);
                match (self.vectors.get(&name), self.names.get(&name)) {
                    (Some(n), _) => vector(*n),
                    (None, Some(value)) => shape(value),
                    (None, None) => Shape::Scalar,
                }
            }
            ExprKind::Tuple(components) => vector(components.len()),
            ExprKind::Index(array, _) => match shape(array) {
                Shape::Array(_, entry) => *entry,
                _ => Shape::Scalar,
            },
            ExprKind::Field(value, _) if shape(value) == Shape::Frame => Shape::Vector(3),
            ExprKind::Field(value, _) if shape(value) == Shape::PlaneFrame => Shape::Vector(2),
            ExprKind::Negate(inner) => shape(inner),
            ExprKind::Binary(BinaryOp::Div, left, _) => shape(left),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub | BinaryOp::Mul, left, right) => {
                match shape(left) {
                    Shape::Scalar => shape(right),
                    other => other,
                }
            }
            ExprKind::Call(name, arguments) => {
                let name = plain(name);
                let first = || arguments.first().map_or(Shape::Scalar, shape);
                if let Some(function) = Function::from_word(&name) {
                    return call(function, &first);
                }
                match QuantityWord::from_word(&name) {
                    Some(QuantityWord::Motion(word)) => {
                        self.motion(word, &first, arguments, inputs)
                    }
                    Some(QuantityWord::Mechanics(word)) => self.mechanics(word, arguments, inputs),
                    None => Shape::Scalar,
                }
            }
            ExprKind::Number { .. }
            | ExprKind::Field(..)
            | ExprKind::Power(..)
            | ExprKind::List(_)
            | ExprKind::Error => Shape::Scalar,
        }
    }

    fn motion(
        &self,
        word: MotionWord,
        first: &dyn Fn() -> Shape,
        arguments: &[Expr],
        inputs: usize,
    ) -> Shape {
        let array = |n: usize, entry: Shape| Shape::Array(n, Box::new(entry));
        match word {
            MotionWord::Velocity if inputs > 1 => array(inputs, first()),
            MotionWord::Acceleration if inputs > 1 => array(inputs, array(inputs, first())),
            MotionWord::Omega if inputs > 1 => array(inputs, vector(3)),
            MotionWord::Alpha if inputs > 1 => array(inputs, array(inputs, vector(3))),
            MotionWord::Omega
            | MotionWord::Alpha
            | MotionWord::ScrewPoint
            | MotionWord::ScrewDirection => vector(3),
            MotionWord::Derivative
            | MotionWord::Velocity
            | MotionWord::Acceleration
            | MotionWord::Jerk => first(),
            MotionWord::Sensitivity => {
                let listed = match arguments.get(1).map(|list| &list.kind) {
                    // A vector parameter stands for its components.
                    Some(ExprKind::List(list)) => list
                        .iter()
                        .map(|entry| self.shape(entry, inputs).width())
                        .sum(),
                    _ => self.scalar_parameters,
                };
                array(listed, first())
            }
            MotionWord::Margin | MotionWord::ScrewPitch => Shape::Scalar,
            // An array of this length has no index beyond its end.
            MotionWord::Picture => array(MANY_POINTS, vector(self.components)),
        }
    }

    fn mechanics(&self, word: MechanicsWord, arguments: &[Expr], inputs: usize) -> Shape {
        match word {
            MechanicsWord::Reaction | MechanicsWord::ShakingForce => vector(self.components),
            MechanicsWord::Moment | MechanicsWord::ShakingMoment => match self.components {
                3 => Shape::Vector(3),
                _ => Shape::Scalar,
            },
            MechanicsWord::Inertia if arguments.is_empty() && inputs > 1 => {
                let row = Shape::Array(inputs, Box::new(Shape::Scalar));
                Shape::Array(inputs, Box::new(row))
            }
            MechanicsWord::Inertia
            | MechanicsWord::Bias
            | MechanicsWord::GeneralisedForce
            | MechanicsWord::DrivenAcceleration
            | MechanicsWord::Torque
            | MechanicsWord::Force
            | MechanicsWord::Power
            | MechanicsWord::FrictionPower
            | MechanicsWord::Efficiency
            | MechanicsWord::KineticEnergy
            | MechanicsWord::PotentialEnergy => Shape::Scalar,
        }
    }
}

/// `first` is the shape of the first argument.
fn call(function: Function, first: &dyn Fn() -> Shape) -> Shape {
    match function {
        Function::Polar | Function::Dir => Shape::Vector(2),
        Function::Turn => Shape::Vector(3),
        Function::PointIn | Function::CoordinatesIn => match first() {
            Shape::PlaneFrame => Shape::Vector(2),
            _ => Shape::Vector(3),
        },
        Function::Frame => match first() {
            Shape::Vector(2) => Shape::PlaneFrame,
            _ => Shape::Frame,
        },
        Function::Rotate | Function::Unit => first(),
        Function::Cross => match first() {
            Shape::Vector(3) => Shape::Vector(3),
            _ => Shape::Scalar,
        },
        Function::Dot
        | Function::Norm
        | Function::Distance
        | Function::Angle
        | Function::TriangleAngle
        | Function::Sin
        | Function::Cos
        | Function::Tan
        | Function::Asin
        | Function::Acos
        | Function::Atan
        | Function::Atan2
        | Function::Sqrt
        | Function::Hypot
        | Function::Abs
        | Function::Min
        | Function::Max => Shape::Scalar,
    }
}

fn vector(components: usize) -> Shape {
    match components {
        2 | 3 => Shape::Vector(components),
        _ => Shape::Scalar,
    }
}
