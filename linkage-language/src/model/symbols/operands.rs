//! Operands of an expression: resolved with the scope of the expression, in the same place.

use super::scope::Scope;
use super::sink::Sink;
use super::site::Context;
use crate::model::types::Expr;
use crate::syntax;

/// Resolves an expression of the syntax tree.
pub(in crate::model) type Resolve = fn(&Scope, &mut Sink, &syntax::Expr, Context) -> Expr;

/// Resolves the operands of one expression.
///
/// Functions that resolve a call or a quantity take it instead of calling the function that calls
/// them.
#[derive(Clone, Copy)]
pub(in crate::model) struct Operands<'a> {
    pub(in crate::model) scope: &'a Scope,
    pub(in crate::model) context: Context<'a>,
    pub(in crate::model) expression: Resolve,
}

impl<'a> Operands<'a> {
    /// Resolves in another place.
    pub(in crate::model) fn within(self, context: Context<'a>) -> Self {
        Self { context, ..self }
    }

    /// Resolves one operand.
    pub(in crate::model) fn resolve(self, sink: &mut Sink, expr: &syntax::Expr) -> Expr {
        (self.expression)(self.scope, sink, expr, self.context)
    }

    /// Resolves several operands, in their order.
    pub(in crate::model) fn resolve_all(self, sink: &mut Sink, list: &[syntax::Expr]) -> Vec<Expr> {
        list.iter().map(|expr| self.resolve(sink, expr)).collect()
    }
}
