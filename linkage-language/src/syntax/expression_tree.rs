//! The syntax tree of expressions.

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;

#[derive(Clone, Debug)]
pub struct Expr {
    pub kind: ExprKind,
    pub span: SourceSpan,
}

#[derive(Clone, Debug)]
pub enum ExprKind {
    /// A number and its unit suffix (empty: none), both as written; `text` has no underscores.
    Number {
        text: String,
        suffix: String,
    },
    Name(Ident),
    /// `(a, b)` or `(a, b, c)`; any other count is kept too, for `resolve` to refuse.
    Tuple(Vec<Expr>),
    /// `v.x`
    Field(Box<Expr>, Ident),
    /// `v[0]`
    Index(Box<Expr>, Box<Expr>),
    Negate(Box<Expr>),
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `mm^2`: a power, of units only.
    Power(Box<Expr>, i32),
    /// `name(args)`, also `d(...)`, `sensitivity(q, [..])`, `margin()`.
    Call(Ident, Vec<Expr>),
    /// `[a, b]`, only meaningful as second argument of `sensitivity`.
    List(Vec<Expr>),
    /// The replacement of a syntax error. It has been reported, so later phases do not report it
    /// again.
    Error,
}

/// A parameter's value: one expression with a tolerance, or a vector whose components have
/// tolerances.
#[derive(Clone, Debug)]
pub enum Toleranced {
    /// `nominal [+- tolerance]`; the nominal value may be a scalar or a vector.
    Single {
        nominal: Expr,
        tolerance: Option<Expr>,
    },
    /// `(x [+- tx], y [+- ty])` where at least one component has a tolerance.
    Components {
        components: Vec<(Expr, Option<Expr>)>,
        span: SourceSpan,
    },
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    Add,
    Sub,
    Mul,
    Div,
}

impl Expr {
    /// Returns the expressions that it is made of.
    pub fn operands(&self) -> Vec<&Expr> {
        match &self.kind {
            ExprKind::Tuple(parts) | ExprKind::List(parts) | ExprKind::Call(_, parts) => {
                parts.iter().collect()
            }
            ExprKind::Field(value, _) | ExprKind::Negate(value) | ExprKind::Power(value, _) => {
                vec![&**value]
            }
            ExprKind::Index(left, right) | ExprKind::Binary(_, left, right) => {
                vec![&**left, &**right]
            }
            ExprKind::Number { .. } | ExprKind::Name(_) | ExprKind::Error => Vec::new(),
        }
    }

    /// Returns the expression that replaces a mistake.
    pub fn error(span: SourceSpan) -> Self {
        Expr {
            kind: ExprKind::Error,
            span,
        }
    }
}
