//! `screw_point`, `screw_direction`, `screw_pitch`: the instantaneous screw axis of a body.
//!
//! They are expressions of the angular velocity of the body and the velocity of its origin, so they
//! have derivatives like any other expression.

use super::input_derivative::{listed_inputs, make_derivative, refuse_several_inputs};
use super::moving_frame::resolve_moving_frame;
use crate::diagnostic::SourceSpan;
use crate::model::expression::call_messages::refuse_wrong_count;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::values::Values;
use crate::model::types::{
    ANGLE_PART, BinaryOp, Dimension, Expr, ExprKind, Function, MotionWord, Type, type_of_part,
};
use crate::syntax::{self, Word};

/// The part of a frame that is its origin.
const ORIGIN: usize = 0;

pub(in crate::model) fn resolve_screw(
    operands: Operands,
    sink: &mut Sink,
    word: MotionWord,
    inputs: Option<&[usize]>,
    arguments: &[syntax::Expr],
    span: SourceSpan,
) -> Expr {
    let name = word.word();
    let [quantity] = arguments else {
        refuse_wrong_count(sink, name, &["frame"], arguments.len(), span);
        return error_expr(sink, span);
    };
    let body = resolve_moving_frame(operands, sink, name, quantity);
    let Some(inputs) = inputs else {
        return error_expr(sink, span);
    };
    let Some(inputs) = listed_inputs(
        &operands.scope.names,
        &operands.scope.values,
        sink,
        name,
        inputs,
        span,
    ) else {
        return error_expr(sink, span);
    };
    let [input] = inputs[..] else {
        let help = "with several inputs a body has an axis for each: ask for `omega(body)`, `velocity(body.origin)` and `body.origin`, and give \
                    an entry of each of the arrays to `linkage::Screw::of`";
        refuse_several_inputs(sink, name, inputs.len(), help, span);
        return error_expr(sink, span);
    };
    match &body.ty {
        Type::Frame => make_screw(
            &operands.scope.names,
            &operands.scope.values,
            sink,
            word,
            &body,
            input,
            span,
        ),
        Type::PlaneFrame => make_pole(
            &operands.scope.names,
            &operands.scope.values,
            sink,
            word,
            &body,
            input,
            span,
        ),
        _ => error_expr(sink, span),
    }
}

/// Returns a quantity of the screw. With `w` for `omega(body)` and `v` for `velocity(body.origin)`
/// the axis goes through `body.origin + cross(w, v) / dot(w, w)` along `w`.
fn make_screw(
    names: &Names,
    values: &Values,
    sink: &mut Sink,
    word: MotionWord,
    body: &Expr,
    input: usize,
    span: SourceSpan,
) -> Expr {
    let w = make_derivative(names, values, sink, body.clone(), &[input], 1, span);
    if word == MotionWord::ScrewDirection {
        let kind = ExprKind::Call(Function::Unit, vec![w]);
        return make_expr(sink, kind, Type::Vector(3, Dimension::NUMBER), span);
    }
    let origin = make_part_of_frame(sink, body, ORIGIN, span);
    let v = make_derivative(names, values, sink, origin.clone(), &[input], 1, span);
    let (Some(square), Some(product)) = (times(&w, &w), times(&w, &v)) else {
        return error_expr(sink, span);
    };
    let kind = ExprKind::Call(Function::Dot, vec![w.clone(), w.clone()]);
    let square = make_expr(sink, kind, Type::Scalar(square), span);
    if word == MotionWord::ScrewPitch {
        let kind = ExprKind::Call(Function::Dot, vec![w, v]);
        let along = make_expr(sink, kind, Type::Scalar(product), span);
        return make_quotient(sink, along, square, Type::Scalar(Dimension::LENGTH), span);
    }
    let kind = ExprKind::Call(Function::Cross, vec![w, v]);
    let across = make_expr(sink, kind, Type::Vector(3, product), span);
    let arm = make_quotient(
        sink,
        across,
        square,
        Type::Vector(3, Dimension::LENGTH),
        span,
    );
    make_sum(sink, origin, arm, span)
}

/// In the plane the axis is a point, the pole: `body.origin + (-v.y, v.x) / w`.
fn make_pole(
    names: &Names,
    values: &Values,
    sink: &mut Sink,
    word: MotionWord,
    body: &Expr,
    input: usize,
    span: SourceSpan,
) -> Expr {
    if word != MotionWord::ScrewPoint {
        let fact = format!("`{}` is about a frame in space", word.word());
        let help = "in the plane a body turns about a point: `screw_point(body)`";
        sink.error_with_help(span, fact, help);
        return error_expr(sink, span);
    }
    let angle = make_part_of_frame(sink, body, ANGLE_PART, span);
    let w = make_derivative(names, values, sink, angle, &[input], 1, span);
    let origin = make_part_of_frame(sink, body, ORIGIN, span);
    let v = make_derivative(names, values, sink, origin.clone(), &[input], 1, span);
    let Some(way) = v.ty.dimension() else {
        return error_expr(sink, span);
    };
    let [x, y] = [0, 1].map(|k| {
        let kind = ExprKind::Component(Box::new(v.clone()), k);
        make_expr(sink, kind, Type::Scalar(way), span)
    });
    let back = make_expr(sink, ExprKind::Negate(Box::new(y)), Type::Scalar(way), span);
    let kind = ExprKind::Vector(vec![back, x]);
    let across = make_expr(sink, kind, Type::Vector(2, way), span);
    let arm = make_quotient(sink, across, w, Type::Vector(2, Dimension::LENGTH), span);
    make_sum(sink, origin, arm, span)
}

fn make_part_of_frame(sink: &mut Sink, body: &Expr, part: usize, span: SourceSpan) -> Expr {
    let kind = ExprKind::Index(Box::new(body.clone()), part);
    make_expr(sink, kind, type_of_part(&body.ty, part), span)
}

fn make_quotient(sink: &mut Sink, a: Expr, b: Expr, ty: Type, span: SourceSpan) -> Expr {
    let kind = ExprKind::Binary(BinaryOp::Div, Box::new(a), Box::new(b));
    make_expr(sink, kind, ty, span)
}

fn make_sum(sink: &mut Sink, point: Expr, arm: Expr, span: SourceSpan) -> Expr {
    let ty = point.ty.clone();
    let kind = ExprKind::Binary(BinaryOp::Add, Box::new(point), Box::new(arm));
    make_expr(sink, kind, ty, span)
}

/// The dimension of a product.
fn times(a: &Expr, b: &Expr) -> Option<Dimension> {
    a.ty.dimension()?.times(b.ty.dimension()?)
}
