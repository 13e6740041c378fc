//! Moments of inertia: one number, three, or a symmetric matrix.

use super::clauses::{resolve_point, resolve_scalar};
use crate::diagnostic::SourceSpan;
use crate::model::dispatch::resolve_expression;
use crate::model::expression::clause_values::check_scalar;
use crate::model::expression::nodes::{error_expr, make_expr};
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::Context;
use crate::model::types::{BinaryOp, Dimension, Expr, ExprKind, Inertia, Type};
use crate::syntax::{self, InertiaPart};

const EXAMPLE: &str = "250g*mm^2";
const MATRIX: &str = "((ixx, ixy, ixz), (ixy, iyy, iyz), (ixz, iyz, izz))";

/// `turns` is how the body turns.
pub(in crate::model) fn resolve_inertia(
    scope: &Scope,
    sink: &mut Sink,
    part: &InertiaPart,
    turns: Option<&Expr>,
) -> (Inertia, Option<Expr>) {
    let inertia = match rows(&part.inertia) {
        Some(rows) => resolve_matrix(scope, sink, &rows, part.inertia.span),
        None => {
            let value = resolve_expression(scope, sink, &part.inertia, Context::MECHANICS);
            make_inertia(&scope.names, sink, value)
        }
    };
    if matches!(inertia, Inertia::Tensor(_)) {
        check_tensor(sink, turns, part.inertia.span);
    }
    let at = part.at.as_ref().map(|at| resolve_point(scope, sink, at));
    (inertia, at)
}

fn make_inertia(names: &Names, sink: &mut Sink, value: Expr) -> Inertia {
    if !matches!(value.ty, Type::Vector(3, _) | Type::Zero(3)) {
        return Inertia::Scalar(check_scalar(
            names,
            sink,
            value,
            Dimension::INERTIA,
            "inertia",
            EXAMPLE,
        ));
    }
    let span = sink.span(value.origin);
    let zero = Type::Scalar(Dimension::INERTIA);
    let mut row = |index: usize| {
        let mut entries =
            [(); 3].map(|()| make_expr(sink, ExprKind::Number(0.0), zero.clone(), span));
        let entry = value.component(index);
        entries[index] = check_scalar(names, sink, entry, Dimension::INERTIA, "inertia", EXAMPLE);
        entries
    };
    Inertia::Tensor(Box::new([row(0), row(1), row(2)]))
}

fn resolve_matrix(
    scope: &Scope,
    sink: &mut Sink,
    rows: &[&[syntax::Expr]],
    span: SourceSpan,
) -> Inertia {
    if rows.len() != 3 || rows.iter().any(|row| row.len() != 3) {
        let fact = "a matrix of moments of inertia has three rows of three";
        sink.error_with_help(span, fact, format!("write `{MATRIX}`"));
        return Inertia::Scalar(error_expr(sink, span));
    }
    let mut row = |index: usize| {
        [0, 1, 2].map(|column| {
            let entry: &syntax::Expr = &rows[index][column];
            resolve_scalar(scope, sink, entry, Dimension::INERTIA, "inertia", EXAMPLE)
        })
    };
    let matrix = [row(0), row(1), row(2)];
    for (i, j) in [(0, 1), (0, 2), (1, 2)] {
        let sound = !matrix[i][j].ty.is_error() && !matrix[j][i].ty.is_error();
        if sound && !same(&matrix[i][j], &matrix[j][i]) {
            let fact = "a matrix of moments of inertia is symmetric, these two entries differ";
            let help = format!("write the same in both places: `{MATRIX}`");
            let [first, second] =
                [&matrix[i][j], &matrix[j][i]].map(|entry| sink.span(entry.origin));
            sink.error_with_help(second, fact, help);
            sink.error(first, "the other one is here").is_related = true;
        }
    }
    Inertia::Tensor(Box::new(matrix))
}

/// A tensor is given in the axes of the body's frame.
fn check_tensor(sink: &mut Sink, turns: Option<&Expr>, span: SourceSpan) {
    let (fact, help) = match (sink.components, turns.map(|turns| &turns.ty)) {
        (None, _) | (Some(3), Some(Type::Frame | Type::Error)) => return,
        (Some(2), _) => (
            "in the plane there is one moment of inertia",
            "write the one about the axis across the plane",
        ),
        _ => (
            "several moments of inertia of a body without a frame",
            "name the frame in whose axes they are: `turns frame(p, x, z)`",
        ),
    };
    sink.error_with_help(span, fact, help);
}

/// The rows of a matrix; `None` for anything else.
fn rows(expr: &syntax::Expr) -> Option<Vec<&[syntax::Expr]>> {
    let syntax::ExprKind::Tuple(rows) = &expr.kind else {
        return None;
    };
    let row = |row| match row {
        &syntax::Expr {
            kind: syntax::ExprKind::Tuple(ref entries),
            ..
        } => Some(entries.as_slice()),
        _ => None,
    };
    rows.iter().map(row).collect()
}

/// Returns true if two expressions are written alike.
fn same(left: &Expr, right: &Expr) -> bool {
    let operands = || left.operands().into_iter().zip(right.operands());
    let alike = match (&left.kind, &right.kind) {
        (ExprKind::Number(a), ExprKind::Number(b)) => a == b,
        (ExprKind::Name(a), ExprKind::Name(b)) => a == b,
        (ExprKind::Component(_, a), ExprKind::Component(_, b)) => a == b,
        (ExprKind::Index(_, a), ExprKind::Index(_, b)) => a == b,
        (ExprKind::Call(a, _), ExprKind::Call(b, _)) => a == b,
        (ExprKind::Binary(a, ..), ExprKind::Binary(b, ..)) => {
            let turned = matches!(a, BinaryOp::Add | BinaryOp::Mul)
                && left
                    .operands()
                    .into_iter()
                    .zip(right.operands().into_iter().rev())
                    .all(|(left, right)| same(left, right));
            return a == b && (turned || operands().all(|(left, right)| same(left, right)));
        }
        (ExprKind::Negate(_), ExprKind::Negate(_)) | (ExprKind::Vector(_), ExprKind::Vector(_)) => {
            true
        }
        // Written in another way, even if it means the same.
        _ => false,
    };
    alike && operands().all(|(left, right)| same(left, right))
}
