//! Moments of inertia: one number, three, or a symmetric matrix.

use super::super::names::Resolver;
use super::super::types::{BinaryOp, Dimension, Expr, ExprKind, Inertia, Type};
use super::CONTEXT;
use crate::diagnostic::SourceSpan;
use crate::syntax::{self, InertiaPart};

const EXAMPLE: &str = "250g*mm^2";
const MATRIX: &str = "((ixx, ixy, ixz), (ixy, iyy, iyz), (ixz, iyz, izz))";

impl Resolver<'_> {
    /// `turns` is how the body turns.
    pub(super) fn inertia(
        &mut self,
        part: &InertiaPart,
        turns: Option<&Expr>,
    ) -> (Inertia, Option<Expr>) {
        let inertia = match rows(&part.inertia) {
            Some(rows) => self.matrix(&rows, part.inertia.span),
            None => {
                let value = self.expression(&part.inertia, CONTEXT);
                self.scalar_or_diagonal(value)
            }
        };
        if matches!(inertia, Inertia::Tensor(_)) {
            self.check_tensor(turns, part.inertia.span);
        }
        let at = part.at.as_ref().map(|at| self.point_clause(at));
        (inertia, at)
    }

    fn scalar_or_diagonal(&mut self, value: Expr) -> Inertia {
        if !matches!(value.ty, Type::Vector(3, _) | Type::Zero(3)) {
            return Inertia::Scalar(self.scalar_value(
                value,
                Dimension::INERTIA,
                "inertia",
                EXAMPLE,
            ));
        }
        let span = self.origins.span(value.origin);
        let zero = Type::Scalar(Dimension::INERTIA);
        let mut row = |index: usize| {
            let mut entries =
                [(); 3].map(|()| self.make(ExprKind::Number(0.0), zero.clone(), span));
            let entry = value.component(index);
            entries[index] = self.scalar_value(entry, Dimension::INERTIA, "inertia", EXAMPLE);
            entries
        };
        Inertia::Tensor(Box::new([row(0), row(1), row(2)]))
    }

    fn matrix(&mut self, rows: &[&[syntax::Expr]], span: SourceSpan) -> Inertia {
        if rows.len() != 3 || rows.iter().any(|row| row.len() != 3) {
            let fact = "a matrix of moments of inertia has three rows of three";
            self.diagnostics
                .error_with_help(span, fact, format!("write `{MATRIX}`"));
            return Inertia::Scalar(self.failed(span));
        }
        let mut row = |index: usize| {
            [0, 1, 2].map(|column| {
                let entry: &syntax::Expr = &rows[index][column];
                self.scalar_clause(entry, Dimension::INERTIA, "inertia", EXAMPLE)
            })
        };
        let matrix = [row(0), row(1), row(2)];
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let sound = !matrix[i][j].ty.is_error() && !matrix[j][i].ty.is_error();
            if sound && !same(&matrix[i][j], &matrix[j][i]) {
                let fact = "a matrix of moments of inertia is symmetric, these two entries differ";
                let help = format!("write the same in both places: `{MATRIX}`");
                let [first, second] =
                    [&matrix[i][j], &matrix[j][i]].map(|entry| self.origins.span(entry.origin));
                self.diagnostics.error_with_help(second, fact, help);
                self.diagnostics.error(first, "the other one is here");
            }
        }
        Inertia::Tensor(Box::new(matrix))
    }

    /// A tensor is given in the axes of the body's frame.
    fn check_tensor(&mut self, turns: Option<&Expr>, span: SourceSpan) {
        let (fact, help) = match (self.mechanics.components, turns.map(|turns| &turns.ty)) {
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
        self.diagnostics.error_with_help(span, fact, help);
    }
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

/// Whether two expressions are written alike.
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
