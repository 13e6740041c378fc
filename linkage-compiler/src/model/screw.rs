//! `screw_point`, `screw_direction`, `screw_pitch`: the axis about which a body turns and along which it shifts at one moment, as expressions of
//! its angular velocity and the velocity of its origin, so that they are differentiated like anything else.

use super::frame::{ANGLE_PART, type_of_part};
use super::functions::MotionWord;
use super::names::Resolver;
use super::place::Context;
use super::types::{BinaryOp, Dimension, Expr, ExprKind, Function, Type};
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
        let Some(inputs) = self.drives(name, inputs, span) else {
            return self.failed(span);
        };
        let [input] = inputs[..] else {
            let help = "with several inputs a body has an axis for each: ask for `omega(body)`, `velocity(body.origin)` and `body.origin`, and give \
                        an entry of each of the arrays to `linkage::Screw::of`";
            self.needs_one_input(name, inputs.len(), help, span);
            return self.failed(span);
        };
        match &body.ty {
            Type::Frame => self.screw_in_space(word, &body, input, span),
            Type::PlaneFrame => self.pole(word, &body, input, span),
            _ => self.failed(span),
        }
    }

    /// With `w` for `omega(body)` and `v` for `velocity(body.origin)` the axis goes through `body.origin + cross(w, v) / dot(w, w)` along `w`.
    fn screw_in_space(
        &mut self,
        word: MotionWord,
        body: &Expr,
        input: usize,
        span: SourceSpan,
    ) -> Expr {
        let w = self.derivative_by(body.clone(), &[input], 1, span);
        if word == MotionWord::ScrewDirection {
            let kind = ExprKind::Call(Function::Unit, vec![w]);
            return self.make(kind, Type::Vector(3, Dimension::NUMBER), span);
        }
        let origin = self.part_of_body(body, ORIGIN, span);
        let v = self.derivative_by(origin.clone(), &[input], 1, span);
        let (Some(square), Some(product)) = (times(&w, &w), times(&w, &v)) else {
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
    fn pole(&mut self, word: MotionWord, body: &Expr, input: usize, span: SourceSpan) -> Expr {
        if word != MotionWord::ScrewPoint {
            let fact = format!("`{}` is about a frame in space", word.word());
            let help = "in the plane a body turns about a point: `screw_point(body)`";
            self.diagnostics.error_with_help(span, fact, help);
            return self.failed(span);
        }
        let angle = self.part_of_body(body, ANGLE_PART, span);
        let w = self.derivative_by(angle, &[input], 1, span);
        let origin = self.part_of_body(body, ORIGIN, span);
        let v = self.derivative_by(origin.clone(), &[input], 1, span);
        let Some(way) = v.ty.dimension() else {
            return self.failed(span);
        };
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
}

/// The dimension of a product.
fn times(a: &Expr, b: &Expr) -> Option<Dimension> {
    a.ty.dimension()?.times(b.ty.dimension()?)
}
