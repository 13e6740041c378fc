//! Coordinates that are angles, which follows from their uses.

use std::collections::BTreeSet;

use super::expression::{BinaryOp, Expr, ExprKind};
use super::function_words::Function;
use super::mechanism::Mechanism;
use super::name::Name;
use super::value_type::Type;

/// Inputs, unknowns and derived quantities that are turned by, or added to angles.
pub(in crate::model) fn angles(mechanism: &Mechanism) -> BTreeSet<Name> {
    let mut angles = Angles {
        mechanism,
        factors: BTreeSet::new(),
        found: BTreeSet::new(),
        open: Vec::new(),
    };
    angles.find_factors();
    // An angle that is found late can occur next to names that were examined before.
    loop {
        let before = angles.found.len();
        angles.look_through();
        if angles.found.len() == before {
            return angles.found;
        }
    }
}

struct Angles<'m> {
    mechanism: &'m Mechanism,
    /// Names of values that can multiply an angle. They consist of parameters and numbers without
    /// pi, which makes angles of numbers.
    factors: BTreeSet<Name>,
    found: BTreeSet<Name>,
    /// Values that are angles and have not been looked at.
    open: Vec<&'m Expr>,
}

impl<'m> Angles<'m> {
    fn find_factors(&mut self) {
        let mechanism = self.mechanism;
        let constants = mechanism.constants.iter().enumerate();
        let constants = constants.map(|(index, constant)| (Name::Const(index), &constant.value));
        let lets = mechanism.lets.iter().enumerate();
        let lets = lets.map(|(index, item)| (Name::Let(index), &item.value));
        for (name, value) in constants.chain(lets) {
            if self.is_factor(value) {
                self.factors.insert(name);
            }
        }
    }

    fn look_through(&mut self) {
        let mechanism = self.mechanism;
        for (index, item) in mechanism.lets.iter().enumerate() {
            self.look_at(&item.value);
            if self.is_angle(&item.value) {
                self.found.insert(Name::Let(index));
                self.angle(&item.value);
            }
        }
        for equation in mechanism.loops.iter().chain(&mechanism.redundant) {
            self.look_at(&equation.left);
            self.look_at(&equation.right);
            self.together(&[&equation.left, &equation.right]);
        }
        for value in mechanism.expressions_of_mechanics() {
            self.look_at(value);
        }
        for turns in mechanism
            .bodies
            .iter()
            .filter_map(|body| body.turns.as_ref())
        {
            self.angle(turns);
        }
        for function in &mechanism.evaluators {
            function
                .quantities
                .iter()
                .for_each(|item| self.look_at(&item.value));
        }
    }

    fn look_at(&mut self, expr: &'m Expr) {
        for part in expr.parts() {
            match &part.kind {
                ExprKind::Call(Function::Min | Function::Max, arguments) => {
                    self.together(&arguments.iter().collect::<Vec<_>>());
                }
                ExprKind::Call(function, arguments) => {
                    if let Some(index) = function.angle_argument() {
                        self.angle(&arguments[index]);
                    }
                }
                ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => self.together(&[a, b]),
                ExprKind::MotionLaw(course) => {
                    let places = course.knots.iter().map(|knot| &knot.abscissa);
                    let along: Vec<&Expr> =
                        std::iter::once(&*course.argument).chain(places).collect();
                    self.together(&along);
                    let values: Vec<&Expr> = course.knots.iter().map(|knot| &knot.value).collect();
                    self.together(&values);
                }
                // The others tell nothing about their operands.
                _ => {}
            }
        }
    }

    /// Handles terms of a sum, and sides of an equation: if one is an angle, all are.
    fn together(&mut self, values: &[&'m Expr]) {
        if values.iter().any(|value| self.is_angle(value)) {
            values.iter().for_each(|value| self.angle(value));
        }
    }

    /// The names that a value takes being an angle from.
    fn angle(&mut self, value: &'m Expr) {
        self.open.push(value);
        while let Some(value) = self.open.pop() {
            match &value.kind {
                ExprKind::Name(name) => self.mark(*name),
                ExprKind::Negate(operand) => self.open.push(operand),
                ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => {
                    self.open.extend([&**a, &**b]);
                }
                _ => self.open.extend(self.multiplied(value)),
            }
        }
    }

    fn mark(&mut self, name: Name) {
        match name {
            Name::Input(_) | Name::Unknown(_) => {
                self.found.insert(name);
            }
            Name::Let(index) => {
                if self.found.insert(name) {
                    self.open.push(&self.mechanism.lets[index].value);
                }
            }
            Name::Const(_) | Name::Parameter(_) | Name::Argument(_) | Name::Pi => {}
        }
    }

    fn is_angle(&self, value: &Expr) -> bool {
        if matches!(value.ty, Type::Scalar(dimension) if dimension.angle) {
            return true;
        }
        match &value.kind {
            ExprKind::Name(name) => self.found.contains(name),
            ExprKind::Negate(operand) => self.is_angle(operand),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => {
                self.is_angle(a) || self.is_angle(b)
            }
            _ => self
                .multiplied(value)
                .is_some_and(|operand| self.is_angle(operand)),
        }
    }

    /// Returns the factor of a product or quotient that is not plain, if the rest is.
    fn multiplied<'e>(&self, value: &'e Expr) -> Option<&'e Expr> {
        match &value.kind {
            ExprKind::Binary(BinaryOp::Mul, a, b) if self.is_factor(a) => Some(b),
            ExprKind::Binary(BinaryOp::Mul | BinaryOp::Div, a, b) if self.is_factor(b) => Some(a),
            // Neither is known to be a number.
            _ => None,
        }
    }

    fn is_factor(&self, value: &Expr) -> bool {
        value.ty == Type::NUMBER
            && value
                .parts()
                .filter_map(Expr::as_name)
                .all(|name| match name {
                    Name::Const(_) | Name::Let(_) => self.factors.contains(&name),
                    Name::Parameter(_) => true,
                    Name::Input(_) | Name::Unknown(_) | Name::Argument(_) | Name::Pi => false,
                })
    }
}
