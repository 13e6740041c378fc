//! Expressions: everything but calls.

use super::conversion::{Literal, convert};
use super::frame::{PARTS_HELP, PLANE_PARTS_HELP};
use super::names::Resolver;
use super::parameter::COMPONENTS;
use super::place::Context;
use super::types::{BinaryOp, Expr, ExprKind, Type};
use crate::diagnostic::SourceSpan;
use crate::syntax;

impl Resolver<'_> {
    pub(super) fn expression(&mut self, expr: &syntax::Expr, context: Context) -> Expr {
        let span = expr.span;
        match &expr.kind {
            syntax::ExprKind::Number { text, suffix } => self.number(text, suffix, span),
            syntax::ExprKind::Name(ident) => match self.look_up(ident, context) {
                Some((name, ty)) => self.make(ExprKind::Name(name), ty, span),
                None => self.failed(span),
            },
            syntax::ExprKind::Tuple(components) => {
                let components = self.expressions(components, context);
                self.vector(components, span)
            }
            syntax::ExprKind::Field(value, field) => match self.part_named(value) {
                Some(path) => self.member(&path, field, context, span),
                None => {
                    let value = self.expression(value, context);
                    self.component(value, field, span)
                }
            },
            syntax::ExprKind::Index(value, index) => {
                let value = self.expression(value, context);
                self.entry(value, index, span)
            }
            syntax::ExprKind::Negate(value) => {
                let value = self.expression(value, context);
                self.negate(value, span)
            }
            syntax::ExprKind::Binary(syntax::BinaryOp::Mul | syntax::BinaryOp::Div, ..) => {
                self.product_or_quotient(expr, context)
            }
            syntax::ExprKind::Binary(operator, left, right) => {
                let left = self.expression(left, context);
                let right = self.expression(right, context);
                self.binary(BinaryOp::from(*operator), left, right, span)
            }
            syntax::ExprKind::Call(function, arguments) => {
                self.call(function, arguments, context, span)
            }
            syntax::ExprKind::List(_) => {
                let fact = "a list in brackets cannot stand here";
                let help = "write a vector as `(x, y)`; a list is the second argument of \
                            `sensitivity`";
                self.diagnostics.error_with_help(span, fact, help);
                self.failed(span)
            }
            syntax::ExprKind::Power(base, power) => self.lonely_power(base, *power, span),
            syntax::ExprKind::Error => self.failed(span),
        }
    }

    pub(super) fn expressions(&mut self, list: &[syntax::Expr], context: Context) -> Vec<Expr> {
        list.iter()
            .map(|expr| self.expression(expr, context))
            .collect()
    }

    pub(super) fn make(&mut self, kind: ExprKind, ty: Type, span: SourceSpan) -> Expr {
        Expr {
            kind,
            ty,
            origin: self.origins.add(span),
        }
    }

    /// What a reported mistake leaves.
    pub(super) fn failed(&mut self, span: SourceSpan) -> Expr {
        self.make(ExprKind::Error, Type::Error, span)
    }

    fn number(&mut self, text: &str, suffix: &str, span: SourceSpan) -> Expr {
        let converted = convert(text, suffix, self.unit);
        self.literal(converted, &format!("`{text}{suffix}`"), span)
    }

    /// A converted number; `what` it is in messages.
    pub(super) fn literal(&mut self, converted: Literal, what: &str, span: SourceSpan) -> Expr {
        let problem = match converted {
            Literal::BareZero => return self.make(ExprKind::Number(0.0), Type::Zero(1), span),
            Literal::Value(value, dimension) => {
                return self.make(ExprKind::Number(value), Type::Scalar(dimension), span);
            }
            Literal::TooLarge => "too large for a 64-bit number",
            Literal::TooSmall => "so small that it becomes zero",
            Literal::Beyond => "in a power of a unit beyond all use",
            Literal::Malformed => "not a number with a unit",
        };
        let fact = format!("{what} is {problem}");
        self.diagnostics
            .error_with_help(span, fact, "check the exponent and the unit");
        self.failed(span)
    }

    pub(super) fn vector(&mut self, mut components: Vec<Expr>, span: SourceSpan) -> Expr {
        if !(2..=3).contains(&components.len()) {
            let found = components.len();
            let fact = format!("a vector has two or three components, found {found}");
            self.diagnostics
                .error_with_help(span, fact, "write `(x, y)` or `(x, y, z)`");
            return self.failed(span);
        }
        if let Some(inner) = components.iter().find(|component| {
            matches!(component.ty, Type::Vector(..)) || matches!(component.ty, Type::Zero(2..))
        }) {
            let fact = format!("a component must be a scalar, found {}", inner.ty);
            let span = self.origins.span(inner.origin);
            let help = self.nested_help(&components);
            self.diagnostics.error_with_help(span, fact, help);
            return self.failed(span);
        }
        let mut all: Vec<&mut Expr> = components.iter_mut().collect();
        let ty = match self.common_type(&mut all, "the components of a vector") {
            Type::Scalar(dimension) => Type::Vector(components.len(), dimension),
            Type::Zero(_) => Type::Zero(components.len()),
            _ => return self.failed(span),
        };
        if let Type::Vector(_, dimension) = ty {
            let component = Type::Scalar(dimension);
            components
                .iter_mut()
                .for_each(|value| value.settle(&component));
        }
        self.make(ExprKind::Vector(components), ty, span)
    }

    fn component(&mut self, value: Expr, field: &proc_macro2::Ident, span: SourceSpan) -> Expr {
        if value.ty.is_frame() {
            return self.part(value, field, span);
        }
        if value.ty.is_error() || self.refuse_compound(&value) {
            return self.failed(span);
        }
        let index = COMPONENTS.iter().position(|component| field == component);
        let count = value.ty.components().unwrap_or(1);
        let ty = match &value.ty {
            Type::Vector(_, dimension) => Type::Scalar(*dimension),
            _ => Type::Zero(1),
        };
        match index {
            Some(index) if index < count && count > 1 => {
                self.make(ExprKind::Component(Box::new(value), index), ty, span)
            }
            _ => {
                let fact = format!("{} has no component `{field}`", value.ty);
                let help = match count {
                    1 => "only vectors have components".to_owned(),
                    2 if field == COMPONENTS[2] => {
                        "components are `.x`, `.y`; a space vector is written `(x, y, z)`"
                            .to_owned()
                    }
                    _ => format!("components are `.{}`", COMPONENTS[..count].join("`, `.")),
                };
                self.diagnostics.error_with_help(field.into(), fact, help);
                self.failed(span)
            }
        }
    }

    /// `value[index]`
    fn entry(&mut self, value: Expr, index: &syntax::Expr, span: SourceSpan) -> Expr {
        if value.ty.is_error() {
            return self.failed(span);
        }
        let Type::Array(entries) = &value.ty else {
            let fact = format!("{} has no entries", value.ty);
            let help = match value.ty {
                Type::Frame => PARTS_HELP,
                Type::PlaneFrame => PLANE_PARTS_HELP,
                _ => "components of a vector are `.x`, `.y` and `.z`",
            };
            self.diagnostics.error_with_help(span, fact, help);
            return self.failed(span);
        };
        let count = entries.len();
        match entry_number(index) {
            Some(number) if number < count => {
                let ty = entries[number].clone();
                self.make(ExprKind::Index(Box::new(value), number), ty, span)
            }
            Some(number) => {
                let fact = format!("entry {number} of {}", value.ty);
                let help = match count {
                    1 => "write `[0]`".to_owned(),
                    _ => format!("write a number from 0 to {}", count.saturating_sub(1)),
                };
                self.diagnostics.error_with_help(index.span, fact, help);
                self.failed(span)
            }
            None if matches!(index.kind, syntax::ExprKind::Error) => self.failed(span),
            None => {
                let fact = "an index must be a whole number";
                self.diagnostics
                    .error_with_help(index.span, fact, "write `[0]`");
                self.failed(span)
            }
        }
    }
}

fn entry_number(index: &syntax::Expr) -> Option<usize> {
    match &index.kind {
        syntax::ExprKind::Number { text, suffix } if suffix.is_empty() => text.parse().ok(),
        _ => None,
    }
}

impl From<syntax::BinaryOp> for BinaryOp {
    fn from(operator: syntax::BinaryOp) -> Self {
        match operator {
            syntax::BinaryOp::Add => BinaryOp::Add,
            syntax::BinaryOp::Sub => BinaryOp::Sub,
            syntax::BinaryOp::Mul => BinaryOp::Mul,
            syntax::BinaryOp::Div => BinaryOp::Div,
        }
    }
}
