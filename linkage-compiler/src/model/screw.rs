//! `screw_point`, `screw_direction`, `screw_pitch`: the axis about which a body turns and along which it shifts at one moment, as expressions of
//! its angular velocity and the velocity of its origin, so that they are differentiated like anything else.

use super::frame::type_of_part;
use super::functions::MotionWord;
use super::names::Resolver;
use super::place::Context;
use super::types::{BinaryOp, Dimension, Expr, ExprKind, Function, Name, Type, Variable};
use crate::diagnostic::SourceSpan;
use crate::syntax::{self, Word};

/// The part of a frame that is its origin.
const ORIGIN: usize = 0;

impl Resolver<'_> {
    pub(super) fn screw(
        &mut self,
        word: MotionWord,
        inputs: Option<&[usize]>,
        arguments: &[syntax::Expr],
        context: Context,
        span: SourceSpan,
    ) -> Expr {
        let name = word.word();
        let [quantity] = arguments else {
            self.wrong_count(name, &["frame"], arguments.len(), span);
            return self.failed(span);
        };
        let body = self.moving_frame(name, quantity, context);
        let Some(inputs) = inputs else {
            return self.failed(span);
        };
        let drives = inputs.iter().filter(|input| **input < self.input_count);
        let drives: Vec<usize> = drives.copied().collect();
        let [input] = drives[..] else {
            self.not_one_input(name, &drives, span);
            return self.failed(span);
        };
        let by = self.dimension_of(Variable::Input(input));
        let rates = by.and_then(|by| {
            let [turn, way] = [Dimension::ANGLE, Dimension::LENGTH].map(|own| own.over(by));
            Some((turn?, way?))
        });
        match (&body.ty, rates) {
            (Type::Frame, Some(rates)) => self.screw_in_space(word, &body, rates, span),
            (Type::PlaneFrame, Some(rates)) => self.pole(word, &body, rates, span),
            _ => self.failed(span),
        }
    }

    /// With `w` for `omega(body)` and `v` for `velocity(body.origin)` the axis goes through `body.origin + cross(w, v) / dot(w, w)` along `w`.
    fn screw_in_space(
        &mut self,
        word: MotionWord,
        body: &Expr,
        (turn, way): (Dimension, Dimension),
        span: SourceSpan,
    ) -> Expr {
        let kind = ExprKind::InputDerivative(Box::new(body.clone()), 1);
        let w = self.make(kind, Type::Vector(3, turn), span);
        let origin = self.part_of_body(body, ORIGIN, span);
        let kind = ExprKind::InputDerivative(Box::new(origin.clone()), 1);
        let v = self.make(kind, Type::Vector(3, way), span);
        if word == MotionWord::ScrewDirection {
            let kind = ExprKind::Call(Function::Unit, vec![w]);
            return self.make(kind, Type::Vector(3, Dimension::NUMBER), span);
        }
        let (Some(square), Some(product)) = (turn.times(turn), turn.times(way)) else {
            return self.failed(span);
        };
        let kind = ExprKind::Call(Function::Dot, vec![w.clone(), w.clone()]);
        let square = self.make(kind, Type::Scalar(square), span);
        if word == MotionWord::ScrewPitch {
            let kind = ExprKind::Call(Function::Dot, vec![w, v]);
            let along = self.make(kind, Type::Scalar(product), span);
            return self.over(along, square, Type::Scalar(Dimension::LENGTH), span);
        }
        let kind = ExprKind::Call(Function::Cross, vec![w, v]);
        let across = self.make(kind, Type::Vector(3, product), span);
        let arm = self.over(across, square, Type::Vector(3, Dimension::LENGTH), span);
        self.beside(origin, arm, span)
    }

    /// In the plane the axis is a point, the pole: `body.origin + (-v.y, v.x) / w`.
    fn pole(
        &mut self,
        word: MotionWord,
        body: &Expr,
        (turn, way): (Dimension, Dimension),
        span: SourceSpan,
    ) -> Expr {
        if word != MotionWord::ScrewPoint {
            let fact = format!("`{}` is about a frame in space", word.word());
            let help = "in the plane a body turns about a point: `screw_point(body)`";
            self.diagnostics.error_with_help(span, fact, help);
            return self.failed(span);
        }
        let angle = self.part_of_body(body, super::frame::ANGLE_PART, span);
        let kind = ExprKind::InputDerivative(Box::new(angle), 1);
        let w = self.make(kind, Type::Scalar(turn), span);
        let origin = self.part_of_body(body, ORIGIN, span);
        let kind = ExprKind::InputDerivative(Box::new(origin.clone()), 1);
        let v = self.make(kind, Type::Vector(2, way), span);
        let [x, y] = [0, 1].map(|k| {
            let kind = ExprKind::Component(Box::new(v.clone()), k);
            self.make(kind, Type::Scalar(way), span)
        });
        let back = self.make(ExprKind::Negate(Box::new(y)), Type::Scalar(way), span);
        let kind = ExprKind::Vector(vec![back, x]);
        let across = self.make(kind, Type::Vector(2, way), span);
        let arm = self.over(across, w, Type::Vector(2, Dimension::LENGTH), span);
        self.beside(origin, arm, span)
    }

    fn part_of_body(&mut self, body: &Expr, part: usize, span: SourceSpan) -> Expr {
        let kind = ExprKind::Index(Box::new(body.clone()), part);
        self.make(kind, type_of_part(&body.ty, part), span)
    }

    fn over(&mut self, a: Expr, b: Expr, ty: Type, span: SourceSpan) -> Expr {
        let kind = ExprKind::Binary(BinaryOp::Div, Box::new(a), Box::new(b));
        self.make(kind, ty, span)
    }

    fn beside(&mut self, point: Expr, arm: Expr, span: SourceSpan) -> Expr {
        let ty = point.ty.clone();
        let kind = ExprKind::Binary(BinaryOp::Add, Box::new(point), Box::new(arm));
        self.make(kind, ty, span)
    }

    fn not_one_input(&mut self, name: &str, inputs: &[usize], span: SourceSpan) {
        let (fact, help) = match inputs.len() {
            0 => (
                format!("`{name}` in a function without an input"),
                match self.names_of(|name| matches!(name, Name::Input(_))).first() {
                    Some(input) => format!("list the input: `fn name({input})`"),
                    None => "declare an `input` in the struct block".to_owned(),
                },
            ),
            count => (
                format!("`{name}` needs one input, the function has {count}"),
                "with several inputs a body has an axis for each: ask for `omega(body)`, `velocity(body.origin)` and `body.origin`, and give \
                 an entry of each of the arrays to `linkage::Screw::of`"
                    .to_owned(),
            ),
        };
        self.diagnostics.error_with_help(span, fact, help);
    }
}
