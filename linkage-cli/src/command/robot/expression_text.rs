//! Expressions of the language as text. Those that joints and links stand for are nowhere in a file.

use linkage_language::syntax::{BinaryOp, Expr, ExprKind};

/// The text of an expression, with a bracket about each sum and product.
pub(super) fn text(value: &Expr) -> String {
    match &value.kind {
        ExprKind::Number { text, suffix } => format!("{text}{suffix}"),
        ExprKind::Name(name) => name.to_string(),
        ExprKind::Tuple(parts) => format!("({})", list(parts)),
        ExprKind::Field(value, field) => format!("{}.{field}", text(value)),
        ExprKind::Index(value, index) => format!("{}[{}]", text(value), text(index)),
        ExprKind::Negate(value) => format!("(-{})", text(value)),
        ExprKind::Binary(operator, left, right) => {
            let sign = match operator {
                BinaryOp::Add => '+',
                BinaryOp::Sub => '-',
                BinaryOp::Mul => '*',
                BinaryOp::Div => '/',
            };
            format!("({} {sign} {})", text(left), text(right))
        }
        ExprKind::Power(value, power) => format!("{}^{power}", text(value)),
        ExprKind::Call(function, arguments) => format!("{function}({})", list(arguments)),
        ExprKind::List(parts) => format!("[{}]", list(parts)),
        // It has been reported.
        ExprKind::Error => String::new(),
    }
}

fn list(values: &[Expr]) -> String {
    let texts: Vec<String> = values.iter().map(text).collect();
    texts.join(", ")
}
