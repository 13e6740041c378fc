//! Which coordinates are angles, by what is done with them.

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
    // An angle that is found late may stand beside names that were looked at before.
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
    /// Names of values that may multiply an angle: made of parameters and numbers without pi, which makes angles of numbers.
    factors: BTreeSet<Name>,
    found: BTreeSet<Name>,
    /// Values that are angles and have not been looked at.
    open: Vec<&'m Expr>,
}

impl<'m> Angles<'m> {
    fn find_factors(&mut self) {
        let mechanism = self.mechanism;
        let constants = mechanism.constants.iter().enumerate();
        let constants = constants.map(|(index, own)| (Name::Const(index), &own.value));
        let lets = mechanism.lets.iter().enumerate();
        let lets = lets.map(|(index, own)| (Name::Let(index), &own.value));
        for (name, value) in constants.chain(lets) {
            if self.is_factor(value) {
                self.factors.insert(name);
            }
        }
    }

    fn look_through(&mut self) {
        let mechanism = self.mechanism;
        for (index, own) in mechanism.lets.iter().enumerate() {
            self.look_at(&own.value);
            if self.is_angle(&own.value) {
                self.found.insert(Name::Let(index));
                self.angle(&own.value);
            }
        }
        for own in mechanism.loops.iter().chain(&mechanism.redundant) {
            self.look_at(&own.left);
            self.look_at(&own.right);
            self.together(&[&own.left, &own.right]);
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
                .for_each(|own| self.look_at(&own.value));
        }
    }

    fn look_at(&mut self, expr: &'m Expr) {
        for part in expr.parts() {
            match &part.kind {
                ExprKind::Call(Function::Min | Function::Max, arguments) => {
                    self.together(&arguments.iter().collect::<Vec<_>>());
                }
                ExprKind::Call(function, arguments) => {
                    if let Some(place) = function.angle_argument() {
                        self.angle(&arguments[place]);
                    }
                }
                ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => self.together(&[a, b]),
                ExprKind::MotionLaw(course) => {
                    let places = course.knots.iter().map(|own| &own.place);
                    let along: Vec<&Expr> =
                        std::iter::once(&*course.argument).chain(places).collect();
                    self.together(&along);
                    let values: Vec<&Expr> = course.knots.iter().map(|own| &own.value).collect();
                    self.together(&values);
                }
                // The others do not tell what their operands are.
                _ => {}
            }
        }
    }

    /// What is added or equal: if one is an angle, all are.
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
                ExprKind::Negate(own) => self.open.push(own),
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
            ExprKind::Negate(own) => self.is_angle(own),
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, a, b) => {
                self.is_angle(a) || self.is_angle(b)
            }
            _ => self.multiplied(value).is_some_and(|own| self.is_angle(own)),
        }
    }

    /// What a product or quotient is a multiple of, if the rest is a plain factor.
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
