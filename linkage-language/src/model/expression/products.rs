//! Units as factors: `2.5N/mm`, `9.80665m/s^2`, `press / (3 * mm^2)`.

use super::literal::make_literal;
use super::nodes::error_expr;
use super::operators::{make_binary, make_negation};
use super::refused_names::refuse_unknown_name;
use crate::diagnostic::SourceSpan;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::Names;
use crate::model::symbols::member_names::MemberNames;
use crate::model::symbols::operands::Operands;
use crate::model::symbols::sink::Sink;
use crate::model::types::{BinaryOp, Expr};
use crate::model::units::conversion::convert_product;
use crate::syntax::{self, ExprKind, is_meant_as_unit, is_unit};

/// A number with units, or units alone.
#[derive(Default)]
struct Measure {
    /// Digits and whether they are negative.
    number: Option<(String, bool)>,
    /// Units and their powers.
    units: Vec<(String, i32)>,
    /// True if there is a unit that is not glued to the number.
    loose: bool,
}

/// Resolves a product or quotient. A number and the units that it is multiplied with are one
/// number, converted exactly.
pub(in crate::model) fn resolve_product(
    operands: Operands,
    sink: &mut Sink,
    expr: &syntax::Expr,
) -> Expr {
    let ExprKind::Binary(operator, left, right) = &expr.kind else {
        return error_expr(sink, expr.span);
    };
    if let Some(measure) = read_measure(&operands.scope.names, expr)
        && measure.loose
    {
        return make_measured(
            &operands.scope.names,
            &operands.scope.units,
            sink,
            measure,
            expr,
        );
    }
    let left = resolve_factor(operands, sink, left);
    let right = resolve_factor(operands, sink, right);
    make_binary(
        &operands.scope.names,
        &operands.scope.units,
        sink,
        BinaryOp::from(*operator),
        left,
        right,
        expr.span,
    )
}

/// An operand of a product or quotient, which may be a unit.
fn resolve_factor(operands: Operands, sink: &mut Sink, expr: &syntax::Expr) -> Expr {
    match read_measure(&operands.scope.names, expr) {
        Some(measure) if measure.loose => make_measured(
            &operands.scope.names,
            &operands.scope.units,
            sink,
            measure,
            expr,
        ),
        _ => operands.resolve(sink, expr),
    }
}

fn make_measured(
    names: &Names,
    units: &AssumedUnits,
    sink: &mut Sink,
    measure: Measure,
    expr: &syntax::Expr,
) -> Expr {
    let (text, negative) = match &measure.number {
        Some((text, negative)) => (text.as_str(), *negative),
        None => ("1", false),
    };
    let powers: Vec<(&str, i32)> = measure
        .units
        .iter()
        .map(|(name, power)| (name.as_str(), *power))
        .collect();
    let converted = convert_product(text, &powers, units.length);
    let number = make_literal(sink, converted, "the number with its units", expr.span);
    if negative {
        make_negation(names, sink, number, expr.span)
    } else {
        number
    }
}

/// A power that is no factor of a product, or not of a unit.
pub(in crate::model) fn refuse_lonely_power(
    names: &Names,
    members: &MemberNames,
    sink: &mut Sink,
    base: &syntax::Expr,
    power: i32,
    span: SourceSpan,
) -> Expr {
    let ExprKind::Name(name) = &base.kind else {
        return error_expr(sink, span);
    };
    let text = name.to_string();
    let (fact, help) = match names.find(&text) {
        Some(symbol) => (
            format!(
                "there is no operator for powers, but of units: `{text}` is {}",
                symbol.kind()
            ),
            if is_meant_as_unit(&text) {
                format!("the name hides the unit `{text}`: give it another one")
            } else {
                format!("write `{text} * {text}` for a square")
            },
        ),
        None if is_unit(&text) => (
            format!("the unit `{text}^{power}` without a number"),
            format!("write `1 * {text}^{power}`"),
        ),
        None => {
            refuse_unknown_name(names, members, sink, name, None);
            return error_expr(sink, span);
        }
    };
    sink.error_with_help(span, fact, help);
    error_expr(sink, span)
}

/// Products and quotients of units with at most one number above the line.
fn read_measure(names: &Names, expr: &syntax::Expr) -> Option<Measure> {
    let unit = |name: &proc_macro2::Ident, power| {
        let text = name.to_string();
        (is_unit(&text) && names.find(&text).is_none()).then(|| Measure {
            units: vec![(text, power)],
            loose: true,
            ..Measure::default()
        })
    };
    match &expr.kind {
        ExprKind::Name(name) => unit(name, 1),
        ExprKind::Power(base, power) => match &base.kind {
            ExprKind::Name(name) => unit(name, *power),
            _ => None,
        },
        ExprKind::Number { text, suffix } => {
            let glued = (!suffix.is_empty()).then(|| (suffix.clone(), 1));
            Some(Measure {
                number: Some((text.clone(), false)),
                units: glued.into_iter().collect(),
                loose: false,
            })
        }
        ExprKind::Negate(value) => {
            let mut measure = read_measure(names, value)?;
            let (text, negative) = measure.number?;
            measure.number = Some((text, !negative));
            Some(measure)
        }
        ExprKind::Binary(syntax::BinaryOp::Mul, left, right) => {
            read_measure(names, left)?.times(read_measure(names, right)?, 1)
        }
        ExprKind::Binary(syntax::BinaryOp::Div, left, right) => {
            let below = read_measure(names, right)?;
            let divisible = below.number.is_none();
            divisible.then_some(())?;
            read_measure(names, left)?.times(below, -1)
        }
        // No product of numbers and units.
        _ => None,
    }
}

impl Measure {
    fn times(mut self, other: Measure, sign: i32) -> Option<Measure> {
        if self.number.is_some() && other.number.is_some() {
            return None;
        }
        let units = other.units.into_iter();
        self.units
            .extend(units.map(|(name, power)| (name, sign.saturating_mul(power))));
        Some(Measure {
            number: self.number.or(other.number),
            loose: self.loose || other.loose,
            ..self
        })
    }
}
