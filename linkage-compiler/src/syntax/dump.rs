//! The syntax tree as text, for tests.

use std::fmt::{self, Display, Formatter};

use super::ast::{BinaryOp, Expr, ExprKind, Item, MechanismDef, NamedItem, Toleranced};

/// One line for each item and quantity, every operation in parentheses.
pub fn dump(definition: &MechanismDef) -> String {
    let mut lines = vec![format!("struct {}", definition.name)];
    lines.extend(
        definition
            .items
            .iter()
            .map(|item| format!("  {}", Line(item))),
    );
    for function in &definition.functions {
        let inputs: Vec<String> = function.inputs.iter().map(ToString::to_string).collect();
        lines.push(format!(
            "fn {}({}) -> {}",
            function.name,
            inputs.join(", "),
            function.result
        ));
        for quantity in &function.quantities {
            lines.push(format!("  {}: {}", quantity.field, quantity.value));
        }
    }
    lines.join("\n") + "\n"
}

struct Line<'a>(&'a Item);

impl Display for Line<'_> {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        let named = |f: &mut Formatter, word: &str, item: &NamedItem| {
            write!(f, "{word} {} = {}", item.name, item.value)
        };
        match self.0 {
            Item::Unit(item) => write!(f, "unit {}", item.unit),
            Item::Const(item) => named(f, "const", item),
            Item::Unknown(item) => named(f, "unknown", item),
            Item::Let(item) => named(f, "let", item),
            Item::Loop(item) => write!(f, "loop {} = {}", item.left, item.right),
            Item::Param(item) => write!(f, "param {} = {}", item.name, item.value),
            Item::Input(item) => {
                write!(f, "input {} = {}", item.name, item.value)?;
                match &item.range {
                    Some((low, high)) => write!(f, " in {low}..{high}"),
                    None => Ok(()),
                }
            }
            _ => Ok(()),
        }
    }
}

impl Display for Toleranced {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Toleranced::Single { nominal, tolerance } => pair(f, nominal, tolerance.as_ref()),
            Toleranced::Components { components, .. } => {
                let mut separator = "(";
                for (nominal, tolerance) in components {
                    f.write_str(separator)?;
                    pair(f, nominal, tolerance.as_ref())?;
                    separator = ", ";
                }
                f.write_str(")")
            }
        }
    }
}

fn pair(f: &mut Formatter, nominal: &Expr, tolerance: Option<&Expr>) -> fmt::Result {
    match tolerance {
        Some(tolerance) => write!(f, "{nominal} +- {tolerance}"),
        None => write!(f, "{nominal}"),
    }
}

impl Display for Expr {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match &self.kind {
            ExprKind::Number { text, suffix } => write!(f, "{text}{suffix}"),
            ExprKind::Name(name) => write!(f, "{name}"),
            ExprKind::Tuple(components) => list(f, "(", components, ")"),
            ExprKind::List(entries) => list(f, "[", entries, "]"),
            ExprKind::Call(name, arguments) => {
                write!(f, "{name}")?;
                list(f, "(", arguments, ")")
            }
            ExprKind::Field(value, field) => write!(f, "{value}.{field}"),
            ExprKind::Index(value, index) => write!(f, "{value}[{index}]"),
            ExprKind::Negate(value) => write!(f, "(-{value})"),
            ExprKind::Binary(operator, left, right) => write!(f, "({left} {operator} {right})"),
            ExprKind::Power(base, power) => write!(f, "{base}^{power}"),
            ExprKind::Error => f.write_str("<error>"),
        }
    }
}

fn list(f: &mut Formatter, open: &str, entries: &[Expr], close: &str) -> fmt::Result {
    let entries: Vec<String> = entries.iter().map(ToString::to_string).collect();
    write!(f, "{open}{}{close}", entries.join(", "))
}

impl Display for BinaryOp {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(match self {
            BinaryOp::Add => "+",
            BinaryOp::Sub => "-",
            BinaryOp::Mul => "*",
            BinaryOp::Div => "/",
        })
    }
}
