//! Is a named vector a point, or a step from one point to another?

use std::collections::BTreeMap;

use crate::model::{BinaryOp, Expr, ExprKind, Function, Loop, Mechanism, Name, Type};

/// What was seen of each name.
#[derive(Debug)]
pub(super) struct Roles<'m> {
    mechanism: &'m Mechanism,
    seen: BTreeMap<Name, Evidence>,
    /// What each `let` moves with.
    moves: Vec<Moves>,
    /// Whether a `let` is a named vector less another one.
    differences: Vec<bool>,
}

/// What something moves with.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Moves {
    Not,
    Inputs,
    Unknowns,
}

#[derive(Clone, Copy, Debug, Default)]
struct Evidence {
    as_point: bool,
    as_step: bool,
}

impl<'m> Roles<'m> {
    pub(super) fn of(mechanism: &'m Mechanism) -> Self {
        let mut roles = Self {
            mechanism,
            seen: BTreeMap::new(),
            moves: Vec::with_capacity(mechanism.lets.len()),
            differences: Vec::with_capacity(mechanism.lets.len()),
        };
        for own in &mechanism.lets {
            let moves = roles.moves(&own.value);
            roles.moves.push(moves);
            let difference = roles.is_difference(&own.value);
            roles.differences.push(difference);
            roles.look_at(&own.value);
        }
        for own in &mechanism.loops {
            match own.left.ty {
                Type::Vector(..) => roles.look_at_loop(own),
                _ => [&own.left, &own.right]
                    .into_iter()
                    .for_each(|side| roles.look_at(side)),
            }
        }
        for joint in &mechanism.joints {
            roles.point(&joint.at);
            roles.look_at(&joint.at);
        }
        roles
    }

    /// Whether a name stands for a step; seen as both, it is a point.
    pub(super) fn is_step(&self, name: Name) -> bool {
        let seen = self.seen.get(&name);
        seen.is_some_and(|seen| seen.as_step && !seen.as_point)
    }

    /// On each side of a vector loop the first name is a point, others are steps.
    fn look_at_loop(&mut self, own: &Loop) {
        let mut terms = Vec::new();
        for (is_left, side) in [(true, &own.left), (false, &own.right)] {
            let mut summands = Vec::new();
            self.signed_terms(side, true, &mut summands);
            let summands = summands.into_iter();
            terms.extend(summands.map(|(plus, term)| (plus == is_left, plus, term)));
        }
        for side in [true, false] {
            let own = terms.iter().filter(|(plus, _, _)| *plus == side);
            let mut own: Vec<(bool, &Expr)> = own.map(|(_, own, term)| (*own, *term)).collect();
            // What is fixed begins; what the other side subtracts leads to where the difference begins.
            own.sort_by_key(|(own, term)| (self.moves(term) != Moves::Not, *own));
            let names = own.iter().filter(|(_, term)| self.derived(term).is_some());
            let names: Vec<_> = names.collect();
            for (index, (_, name)) in names.into_iter().enumerate() {
                match index == 0 && !self.is_difference(name) {
                    true => self.point(name),
                    false => self.step(name),
                }
            }
            own.into_iter().for_each(|(_, term)| self.look_inside(term));
        }
    }

    pub(super) fn moves(&self, expr: &Expr) -> Moves {
        let names = expr.parts().filter_map(Expr::as_name);
        let moves = names.map(|name| match name {
            Name::Input(_) => Moves::Inputs,
            Name::Unknown(_) => Moves::Unknowns,
            Name::Let(index) => self.moves[index],
            Name::Const(_) | Name::Parameter(_) | Name::Argument(_) | Name::Pi => Moves::Not,
        });
        moves.max().unwrap_or(Moves::Not)
    }

    /// Whether names are subtracted from as many: `q - p`.
    fn is_difference(&self, expr: &Expr) -> bool {
        if let ExprKind::Name(Name::Let(index)) = expr.kind {
            return self.differences[index];
        }
        let mut terms = Vec::new();
        self.signed_terms(expr, true, &mut terms);
        let names = |sign: bool| {
            let own = terms
                .iter()
                .filter(|(plus, term)| *plus == sign && self.derived(term).is_some());
            own.count()
        };
        names(true) > 0 && names(true) == names(false)
    }

    fn look_at(&mut self, expr: &Expr) {
        let mechanism = self.mechanism;
        if let Some((_, own)) = mechanism.standing(expr) {
            self.point(own);
            return self.look_at(own);
        }
        match &expr.kind {
            ExprKind::Binary(BinaryOp::Add | BinaryOp::Sub, ..) => {
                let mut terms = Vec::new();
                self.signed_terms(expr, true, &mut terms);
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
                self.signed_terms(sum, true, &mut terms);
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
        let mut steps = |own: &[Expr]| own.iter().for_each(|own| self.step(own));
        match function {
            Norm | Unit | Angle | Dot | Cross => steps(arguments),
            Rotate => steps(&arguments[..1]),
            Turn => steps(&arguments[..2]),
            PointIn => steps(&arguments[1..]),
            Frame => {
                steps(&arguments[1..]);
                self.point(&arguments[0]);
            }
            Distance => arguments.iter().for_each(|own| self.point(own)),
            CoordinatesIn => self.point(&arguments[1]),
            // They take numbers.
            Polar | Dir | TriangleAngle | Sin | Cos | Tan | Asin | Acos | Atan | Atan2 | Sqrt
            | Hypot | Abs | Min | Max => {}
        }
    }

    fn point(&mut self, expr: &Expr) {
        if let Some(name) = self.derived(expr) {
            self.seen.entry(name).or_default().as_point = true;
        }
    }

    fn step(&mut self, expr: &Expr) {
        if let Some(name) = self.derived(expr) {
            self.seen.entry(name).or_default().as_step = true;
        }
    }

    /// A name that may stand for a point or for a step.
    fn derived(&self, expr: &Expr) -> Option<Name> {
        let name = self.of_part(expr).as_name()?;
        match name {
            Name::Let(_) | Name::Unknown(_) => Some(name),
            // Where points are given, they are numbers.
            Name::Const(_) | Name::Parameter(_) | Name::Input(_) | Name::Argument(_) | Name::Pi => {
                None
            }
        }
    }

    /// The terms of a sum; true for those that are added.
    fn signed_terms<'e>(&self, expr: &'e Expr, plus: bool, terms: &mut Vec<(bool, &'e Expr)>) {
        let expr = self.of_part(expr);
        let summands = expr.summands();
        if summands.is_empty() {
            return terms.push((plus, expr));
        }
        for (adds, summand) in summands {
            self.signed_terms(summand, plus == adds, terms);
        }
    }

    /// What is seen of a part that stands elsewhere, as the part has it.
    fn of_part<'e>(&self, expr: &'e Expr) -> &'e Expr {
        match self.mechanism.standing(expr) {
            Some((_, own)) => self.of_part(own),
            None => expr,
        }
    }
}
