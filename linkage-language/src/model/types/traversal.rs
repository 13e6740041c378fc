//! Operands of expressions, for code that visits all of them.

use super::expression::{BinaryOp, Expr, ExprKind, MechanicalQuantity};
use super::name::{Name, ScalarParameterId, Variable};

/// The operand of a derivative, and its variables.
pub enum Derived<'e> {
    /// With respect to the inputs of the function, this many times.
    ByInputs(&'e Expr, u8),
    /// With respect to each of these parameters.
    ByParameters(&'e Expr, &'e [ScalarParameterId]),
    /// With respect to these variables, one after the other.
    By(&'e Expr, &'e [Variable]),
}

impl Expr {
    /// Returns the operand of a derivative; `None` for any other expression.
    pub fn derived(&self) -> Option<Derived<'_>> {
        match &self.kind {
            ExprKind::InputDerivative(inner, order) => Some(Derived::ByInputs(inner, *order)),
            ExprKind::Sensitivity(inner, by) => Some(Derived::ByParameters(inner, by)),
            ExprKind::Derivative(inner, by) => Some(Derived::By(inner, by)),
            ExprKind::Number(_)
            | ExprKind::Name(_)
            | ExprKind::Vector(_)
            | ExprKind::Component(..)
            | ExprKind::Index(..)
            | ExprKind::Negate(_)
            | ExprKind::Binary(..)
            | ExprKind::Call(..)
            | ExprKind::MotionLaw(_)
            | ExprKind::Margin
            | ExprKind::Picture(_)
            | ExprKind::Mechanics(_)
            | ExprKind::Error => None,
        }
    }

    /// The expressions that it is made of directly.
    pub fn operands(&self) -> Vec<&Expr> {
        match &self.kind {
            ExprKind::Vector(operands) | ExprKind::Call(_, operands) => operands.iter().collect(),
            ExprKind::MotionLaw(course) => course.operands(),
            ExprKind::Component(a, _) | ExprKind::Index(a, _) | ExprKind::Negate(a) => vec![a],
            ExprKind::Binary(_, a, b) => vec![a, b],
            ExprKind::Derivative(a, _)
            | ExprKind::InputDerivative(a, _)
            | ExprKind::Sensitivity(a, _) => vec![a],
            ExprKind::Mechanics(quantity) => quantity.operands(),
            ExprKind::Picture(links) => links.iter().flatten().collect(),
            ExprKind::Number(_) | ExprKind::Name(_) | ExprKind::Margin | ExprKind::Error => {
                Vec::new()
            }
        }
    }

    /// Itself and everything below, as it is read. Names are not followed to their definitions.
    pub fn parts(&self) -> impl Iterator<Item = &Expr> {
        let mut open = vec![self];
        std::iter::from_fn(move || {
            let next = open.pop()?;
            open.extend(next.operands().into_iter().rev());
            Some(next)
        })
    }

    /// Returns the terms of a sum, with true for those that it adds. Empty for any other
    /// expression.
    pub fn summands(&self) -> Vec<(bool, &Expr)> {
        match &self.kind {
            ExprKind::Binary(BinaryOp::Add, a, b) => vec![(true, a), (true, b)],
            ExprKind::Binary(BinaryOp::Sub, a, b) => vec![(true, a), (false, b)],
            ExprKind::Negate(a) => vec![(false, a)],
            // Only signs make sums.
            _ => Vec::new(),
        }
    }

    /// Returns true if it is known only in the functions of the `impl` block.
    pub fn is_quantity(&self) -> bool {
        match self.kind {
            ExprKind::Derivative(..)
            | ExprKind::InputDerivative(..)
            | ExprKind::Sensitivity(..)
            | ExprKind::Margin
            | ExprKind::Picture(_)
            | ExprKind::Mechanics(_) => true,
            ExprKind::Number(_)
            | ExprKind::Name(_)
            | ExprKind::Vector(_)
            | ExprKind::Component(..)
            | ExprKind::Index(..)
            | ExprKind::Negate(_)
            | ExprKind::Binary(..)
            | ExprKind::Call(..)
            | ExprKind::MotionLaw(_)
            | ExprKind::Error => false,
        }
    }

    /// The name that it is, if it is one.
    pub fn as_name(&self) -> Option<Name> {
        match self.kind {
            ExprKind::Name(name) => Some(name),
            _ => None,
        }
    }
}

impl MechanicalQuantity {
    fn operands(&self) -> Vec<&Expr> {
        match self {
            MechanicalQuantity::ShakingMoment(point) => point.iter().map(Box::as_ref).collect(),
            MechanicalQuantity::Reaction(_)
            | MechanicalQuantity::Moment(_)
            | MechanicalQuantity::Drive(_)
            | MechanicalQuantity::Power
            | MechanicalQuantity::FrictionPower
            | MechanicalQuantity::Efficiency
            | MechanicalQuantity::KineticEnergy
            | MechanicalQuantity::PotentialEnergy
            | MechanicalQuantity::ShakingForce
            | MechanicalQuantity::Inertia(_)
            | MechanicalQuantity::MassMatrix(_)
            | MechanicalQuantity::Bias(_)
            | MechanicalQuantity::GeneralisedForce(_)
            | MechanicalQuantity::DrivenAcceleration(_) => Vec::new(),
        }
    }
}
