//! Resolved expressions, with their types and origins.

use super::function_words::Function;
use super::motion_law::{HIGHEST_SLOPE, Law, MotionLawKind, Repeats};
use super::name::{Name, ScalarParameterId, Variable};
use super::value_type::Type;
use crate::diagnostic::OriginId;

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
    MotionLaw(MotionLaw),
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
    Mechanics(MechanicalQuantity),
    Error,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
}

/// A number along `argument`, or its slope.
#[derive(Clone, Debug)]
pub(crate) struct MotionLaw {
    pub(crate) argument: Box<Expr>,
    /// At least two.
    pub(crate) knots: Vec<Knot>,
    pub(crate) kind: MotionLawKind,
    /// How the argument repeats.
    pub(crate) repeats: Repeats,
    /// Which derivative by the argument it is.
    pub(crate) order: u8,
}

/// Where something is known.
#[derive(Clone, Debug)]
pub(crate) struct Knot {
    pub(crate) place: Expr,
    pub(crate) value: Expr,
    /// The slope there, of a spline.
    pub(crate) slope: Option<Expr>,
    /// The law that leads to it.
    pub(crate) law: Option<Law>,
    /// Whether speed and acceleration may jump here.
    pub(crate) may_jump: bool,
    pub(crate) origin: OriginId,
}

/// Equal if they say the same, wherever they stand.
impl PartialEq for Knot {
    fn eq(&self, other: &Self) -> bool {
        let words = |own: &Self| (own.law, own.may_jump);
        let numbers = |own: &Self| (own.place.clone(), own.value.clone(), own.slope.clone());
        numbers(self) == numbers(other) && words(self) == words(other)
    }
}

/// Equal if they say the same, wherever they stand.
impl PartialEq for MotionLaw {
    fn eq(&self, other: &Self) -> bool {
        let all = |own: &Self| (own.kind, own.repeats, own.order);
        self.argument == other.argument && self.knots == other.knots && all(self) == all(other)
    }
}

/// What bodies, joints and loads give.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum MechanicalQuantity {
    /// `reaction(joint)`: the force on the joint's body from the one that it hangs on.
    Reaction(usize),
    /// `moment(joint)`: the moment on the body about the joint's point.
    Moment(usize),
    /// `torque(input)`, `force(input)`: what drives that input.
    Drive(usize),
    /// `power()`: of all drives.
    Power,
    KineticEnergy,
    /// Of gravity and springs.
    PotentialEnergy,
    /// `shaking_force()`: the sum of the inertia forces.
    ShakingForce,
    /// `shaking_moment()`, `shaking_moment(point)`: their moment about a fixed point, the origin if it is not named.
    ShakingMoment(Option<Box<Expr>>),
}

impl Expr {
    /// The number, if it is written as one without a unit, perhaps with signs. Zero is the same in every unit.
    pub(in crate::model) fn bare_number(&self) -> Option<f64> {
        match &self.kind {
            ExprKind::Number(number) => {
                Some(*number).filter(|number| *number != 0.0 && self.ty == Type::NUMBER)
            }
            ExprKind::Negate(value) => value.bare_number().map(|number| -number),
            // What is computed is a number on purpose.
            _ => None,
        }
    }

    /// One component of a vector.
    pub(in crate::model) fn component(&self, component: usize) -> Expr {
        if let ExprKind::Vector(components) = &self.kind {
            return components[component].clone();
        }
        let ty = match &self.ty {
            Type::Vector(_, dimension) => Type::Scalar(*dimension),
            Type::Zero(_) => Type::Zero(1),
            other => other.clone(),
        };
        let kind = ExprKind::Component(Box::new(self.clone()), component);
        Expr {
            kind,
            ty,
            origin: self.origin,
        }
    }

    /// Gives zero the type that its surroundings ask for; a bare `0` beside a vector becomes a vector.
    pub(in crate::model) fn settle(&mut self, wanted: &Type) {
        let Type::Zero(count) = self.ty else { return };
        let Some(wanted_count) = wanted.components() else {
            return;
        };
        let component_type = match wanted {
            Type::Vector(_, dimension) => Type::Scalar(*dimension),
            Type::Zero(_) => Type::Zero(1),
            other => other.clone(),
        };
        if count == 1 && wanted_count > 1 {
            let mut component = self.clone();
            component.settle(&component_type);
            self.kind = ExprKind::Vector(vec![component; wanted_count]);
        } else if count != wanted_count {
            return;
        }
        match &mut self.kind {
            ExprKind::Vector(components) => {
                components
                    .iter_mut()
                    .for_each(|component| component.settle(&component_type));
            }
            ExprKind::Negate(value) => value.settle(wanted),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, left, right) => {
                left.settle(wanted);
                right.settle(wanted);
            }
            // Only what is put together of zeros hands its type on to them.
            _ => {}
        }
        self.ty = wanted.clone();
    }
}

impl MotionLaw {
    /// Of what its argument and the places of its knots are.
    pub(crate) fn argument_type(&self) -> Type {
        let angle = self
            .knots
            .iter()
            .find(|own| matches!(own.place.ty, Type::Scalar(own) if own.angle));
        angle.map_or(&*self.argument, |own| &own.place).ty.clone()
    }

    /// Of what its values are, were it not differentiated.
    pub(crate) fn value_type(&self) -> Type {
        let angle = self
            .knots
            .iter()
            .find(|own| matches!(own.value.ty, Type::Scalar(own) if own.angle));
        angle.unwrap_or(&self.knots[0]).value.ty.clone()
    }

    /// The same course of other expressions, from elsewhere.
    pub(crate) fn map(
        &self,
        expression: impl Fn(&Expr) -> Expr,
        origin: impl Fn(OriginId) -> OriginId,
    ) -> Self {
        let knot = |own: &Knot| Knot {
            place: expression(&own.place),
            value: expression(&own.value),
            slope: own.slope.as_ref().map(&expression),
            origin: origin(own.origin),
            ..own.clone()
        };
        Self {
            argument: Box::new(expression(&self.argument)),
            knots: self.knots.iter().map(knot).collect(),
            ..*self
        }
    }

    /// The expressions that it is made of, as they are read.
    pub(crate) fn operands(&self) -> Vec<&Expr> {
        let mut all = vec![&*self.argument];
        let knots = self.knots.iter();
        all.extend(knots.flat_map(|own| [&own.place, &own.value].into_iter().chain(&own.slope)));
        all
    }

    /// Its derivative by its argument; `None` for more of them than a course has.
    pub(in crate::model) fn slope(&self) -> Option<Self> {
        let order = self.order + 1;
        (order <= HIGHEST_SLOPE).then(|| Self {
            order,
            ..self.clone()
        })
    }
}
