//! Is a named vector a point, or a step from one point to another?

use crate::model::{BinaryOp, Expr, ExprKind, Function, Mechanism, Name};

/// What was seen of each name.
#[derive(Debug)]
pub(super) struct Roles {
    lets: Vec<Evidence>,
    unknowns: Vec<Evidence>,
}

#[derive(Clone, Copy, Debug, Default)]
struct Evidence {
    as_point: bool,
    as_step: bool,
}

impl Roles {
    pub(super) fn of(mechanism: &Mechanism) -> Self {
        let mut roles = Self {
            lets: vec![Evidence::default(); mechanism.lets.len()],
            unknowns: vec![Evidence::default(); mechanism.unknowns.len()],
        };
        for own in &mechanism.lets {
            roles.look_at(&own.value);
        }
        for side in mechanism
            .loops
            .iter()
            .flat_map(|own| [&own.left, &own.right])
        {
            roles.point(side);
            roles.look_at(side);
        }
        for joint in &mechanism.joints {
            roles.point(&joint.at);
            roles.look_at(&joint.at);
        }
        roles
    }

    /// Whether a name stands for a step; seen as both, it is a point.
    pub(super) fn is_step(&self, name: Name) -> bool {
        let evidence = match name {
            Name::Let(index) => self.lets[index],
            Name::Unknown(index) => self.unknowns[index],
            _ => return false,
        };
        evidence.as_step && !evidence.as_point
    }

    fn look_at(&mut self, expr: &Expr) {
        match &expr.kind {
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => {
                let mut terms = Vec::new();
                signed_terms(expr, true, &mut terms);
                for (index, (plus, term)) in terms.iter().enumerate() {
                    match (index, plus) {
                        (0, true) => self.point(term),
                        (_, true) => self.step(term),
                        // `q - p` says nothing about `p`.
                        (_, false) => {}
                    }
                }
                return terms
                    .into_iter()
                    .for_each(|(_, term)| self.look_inside(term));
            }
            // A mean of points.
            ExprKind::Binary(BinaryOp::Div, sum, divisor)
                if matches!(divisor.kind, ExprKind::Number(_)) =>
            {
                let mut terms = Vec::new();
                signed_terms(sum, true, &mut terms);
                return terms
                    .into_iter()
                    .for_each(|(_, term)| self.look_inside(term));
            }
            ExprKind::Call(function, arguments) => self.arguments(*function, arguments),
            _ => {}
        }
        self.look_inside(expr);
    }

    fn look_inside(&mut self, expr: &Expr) {
        if let ExprKind::Call(function, arguments) = &expr.kind {
            self.arguments(*function, arguments);
        }
        expr.operands()
            .into_iter()
            .for_each(|own| self.look_at(own));
    }

    fn arguments(&mut self, function: Function, arguments: &[Expr]) {
        use Function::*;
        match (function, arguments) {
            (Norm | Unit | Angle | Dot | Cross, all) => all.iter().for_each(|own| self.step(own)),
            (Rotate, [vector, _]) => self.step(vector),
            (Turn, [vector, axis, _]) => [vector, axis].into_iter().for_each(|own| self.step(own)),
            (Distance, all) => all.iter().for_each(|own| self.point(own)),
            (Frame, [origin, x, z]) => {
                self.point(origin);
                [x, z].into_iter().for_each(|own| self.step(own));
            }
            (PointIn, [_, vector]) => self.step(vector),
            (CoordinatesIn, [_, point]) => self.point(point),
            _ => {}
        }
    }

    fn point(&mut self, expr: &Expr) {
        if let Some(evidence) = self.evidence(expr) {
            evidence.as_point = true;
        }
    }

    fn step(&mut self, expr: &Expr) {
        if let Some(evidence) = self.evidence(expr) {
            evidence.as_step = true;
        }
    }

    fn evidence(&mut self, expr: &Expr) -> Option<&mut Evidence> {
        match expr.kind {
            ExprKind::Name(Name::Let(index)) => Some(&mut self.lets[index]),
            ExprKind::Name(Name::Unknown(index)) => Some(&mut self.unknowns[index]),
            _ => None,
        }
    }
}

/// The terms of a sum; true for those that are added.
fn signed_terms<'e>(expr: &'e Expr, plus: bool, terms: &mut Vec<(bool, &'e Expr)>) {
    match &expr.kind {
        ExprKind::Binary(BinaryOp::Add, a, b) => {
            signed_terms(a, plus, terms);
            signed_terms(b, plus, terms);
        }
        ExprKind::Binary(BinaryOp::Sub, a, b) => {
            signed_terms(a, plus, terms);
            signed_terms(b, !plus, terms);
        }
        ExprKind::Negate(a) => signed_terms(a, !plus, terms),
        _ => terms.push((plus, expr)),
    }
}
