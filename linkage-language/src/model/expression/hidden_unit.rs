//! Names that hide a unit.

use crate::model::symbols::declared_names::Names;
use crate::model::types;
use crate::model::types::{BinaryOp, Dimension, Expr, Type};
use crate::syntax::is_meant_as_unit;

/// Returns a help if a name has been taken for the unit that it hides: `0.2N*s/mm` next to `unknown
/// s`.
pub(in crate::model) fn hidden_unit_help(names: &Names, value: &Expr) -> Option<String> {
    value.parts().find_map(|part| hides_unit(names, part))
}

pub(in crate::model) fn hides_unit(names: &Names, product: &Expr) -> Option<String> {
    let types::ExprKind::Binary(BinaryOp::Mul | BinaryOp::Div, left, right) = &product.kind else {
        return None;
    };
    let of_literal = is_literal(left)
        && matches!(left.ty, Type::Scalar(dimension) if dimension != Dimension::NUMBER);
    let name = right.as_name().filter(|_| of_literal)?;
    let symbol = names.symbol(name)?;
    let (text, kind) = (&symbol.text, symbol.kind());
    let help = format!("`{text}` is {kind} here, not the unit: give it another name");
    is_meant_as_unit(text).then_some(help)
}

pub(in crate::model) fn is_literal(value: &Expr) -> bool {
    match &value.kind {
        types::ExprKind::Number(_) => true,
        types::ExprKind::Negate(inner) => is_literal(inner),
        _ => false,
    }
}
