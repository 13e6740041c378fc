//! Resolved expressions, with their types and origins.

use super::function_words::Function;
use super::motion_law::{HIGHEST_SLOPE, Law, MotionLawKind, Repeats};
use super::name::{Name, ScalarParameterId, Variable};
use super::value_type::Type;
use crate::diagnostic::OriginId;

#[derive(Clone, Debug)]
pub struct Expr {
    pub kind: ExprKind,
    pub ty: Type,
    pub origin: OriginId,
}

/// Equal if they have the same meaning, in any place.
impl PartialEq for Expr {
    fn eq(&self, other: &Self) -> bool {
        self.kind == other.kind
    }
}

#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A number in the unit of its dimension: the mechanism's length unit, radians, newtons,
    /// seconds, kilograms.
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
    /// `velocity` 1, `acceleration` 2, `jerk` 3: with respect to the inputs of the function.
    InputDerivative(Box<Expr>, u8),
    /// Derivatives with respect to these scalar parameters, in this order.
    Sensitivity(Box<Expr>, Vec<ScalarParameterId>),
    Margin,
    /// `picture([p, q], ...)`: the picture of the mechanism, with these links in addition to those
    /// of the loops.
    Picture(Vec<Vec<Expr>>),
    /// A quantity of the mechanics, for the speeds that the function lists.
    Mechanics(MechanicalQuantity),
    Error,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
}

/// A number along `argument`, or its slope.
#[derive(Clone, Debug)]
pub struct MotionLaw {
    pub argument: Box<Expr>,
    /// At least two.
    pub knots: Vec<Knot>,
    pub kind: MotionLawKind,
    /// The repetition of the argument.
    pub repeats: Repeats,
    /// The order of the derivative with respect to the argument.
    pub order: u8,
}

/// A point of a course.
#[derive(Clone, Debug)]
pub struct Knot {
    pub abscissa: Expr,
    pub value: Expr,
    /// The slope there, of a spline.
    pub slope: Option<Expr>,
    /// The law that leads to it.
    pub law: Option<Law>,
    /// True if speed and acceleration can jump here.
    pub may_jump: bool,
    pub origin: OriginId,
}

/// Equal if they have the same meaning, in any place.
impl PartialEq for Knot {
    fn eq(&self, other: &Self) -> bool {
        let words = |knot: &Self| (knot.law, knot.may_jump);
        let numbers = |knot: &Self| {
            (
                knot.abscissa.clone(),
                knot.value.clone(),
                knot.slope.clone(),
            )
        };
        numbers(self) == numbers(other) && words(self) == words(other)
    }
}

/// Equal if they have the same meaning, in any place.
impl PartialEq for MotionLaw {
    fn eq(&self, other: &Self) -> bool {
        let words = |law: &Self| (law.kind, law.repeats, law.order);
        self.argument == other.argument && self.knots == other.knots && words(self) == words(other)
    }
}

/// Quantities about bodies, joints and loads.
#[derive(Clone, Debug, PartialEq)]
pub enum MechanicalQuantity {
    /// `reaction(joint)`: the force on the joint's body from the body that it is attached to.
    Reaction(usize),
    /// `moment(joint)`: the moment on the body about the joint's point.
    Moment(usize),
    /// `torque(input)`, `force(input)`: the drive of that input.
    Drive(usize),
    /// `power()`: of all drives.
    Power,
    /// The power that friction turns into heat.
    FrictionPower,
    /// The ratio of useful power to spent power.
    Efficiency,
    KineticEnergy,
    /// The energy of gravity and springs.
    PotentialEnergy,
    /// `shaking_force()`: the sum of the inertia forces.
    ShakingForce,
    /// `shaking_moment()`, `shaking_moment(point)`: their moment about a fixed point, by default
    /// the origin.
    ShakingMoment(Option<Box<Expr>>),
    /// `inertia(input)`, `inertia(input, input)`: an entry of the mass matrix.
    Inertia([usize; 2]),
    /// `inertia()` of these inputs, several: the rows of the mass matrix.
    MassMatrix(Vec<usize>),
    /// `bias(input)`: the drive for velocities and weights.
    Bias(usize),
    /// `generalised_force(input)`: the work of the loads per motion of the input.
    GeneralisedForce(usize),
    /// `driven_acceleration(input)`: without any drive.
    DrivenAcceleration(usize),
}

impl Expr {
    /// Returns the number if it is written without a unit, perhaps with signs. Zero is the same in
    /// every unit.
    pub(in crate::model) fn bare_number(&self) -> Option<f64> {
        match &self.kind {
            ExprKind::Number(number) => {
                Some(*number).filter(|number| *number != 0.0 && self.ty == Type::NUMBER)
            }
            ExprKind::Negate(value) => value.bare_number().map(|number| -number),
            // A computed number has no unit on purpose.
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

    /// Gives zero the type of its surroundings; a bare `0` next to a vector becomes a vector.
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
            // Only compositions of zeros pass their type on to them.
            _ => {}
        }
        self.ty = wanted.clone();
    }
}

impl MotionLaw {
    /// Returns the type of its argument and of the places of its knots.
    pub fn argument_type(&self) -> Type {
        let angle = self
            .knots
            .iter()
            .find(|knot| matches!(knot.abscissa.ty, Type::Scalar(knot) if knot.angle));
        angle
            .map_or(&*self.argument, |knot| &knot.abscissa)
            .ty
            .clone()
    }

    /// Returns the type of its values, without derivatives.
    pub fn value_type(&self) -> Type {
        let angle = self
            .knots
            .iter()
            .find(|knot| matches!(knot.value.ty, Type::Scalar(knot) if knot.angle));
        angle.unwrap_or(&self.knots[0]).value.ty.clone()
    }

    /// The same course of other expressions, from elsewhere.
    pub fn map(
        &self,
        expression: impl Fn(&Expr) -> Expr,
        origin: impl Fn(OriginId) -> OriginId,
    ) -> Self {
        let knot = |old: &Knot| Knot {
            abscissa: expression(&old.abscissa),
            value: expression(&old.value),
            slope: old.slope.as_ref().map(&expression),
            origin: origin(old.origin),
            ..old.clone()
        };
        Self {
            argument: Box::new(expression(&self.argument)),
            knots: self.knots.iter().map(knot).collect(),
            ..*self
        }
    }

    /// The expressions that it is made of, as they are read.
    pub fn operands(&self) -> Vec<&Expr> {
        let mut operands = vec![&*self.argument];
        let knots = self.knots.iter();
        operands.extend(
            knots.flat_map(|knot| [&knot.abscissa, &knot.value].into_iter().chain(&knot.slope)),
        );
        operands
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
