//! Units as factors: `2.5N/mm`, `9.80665m/s^2`, `press / (3 * mm^2)`.

use super::conversion::convert_product;
use super::names::Resolver;
use super::place::Context;
use super::types::{self, BinaryOp, Dimension, Expr, Type};
use crate::diagnostic::SourceSpan;
use crate::syntax::{self, ExprKind, is_unit};

/// A number with units, or units alone.
#[derive(Default)]
struct Measure {
    /// Digits and whether they are negative.
    number: Option<(String, bool)>,
    /// Units and their powers.
    units: Vec<(String, i32)>,
    /// Whether there is a unit that is not glued to the number.
    loose: bool,
}

impl Resolver<'_> {
    /// A product or quotient. A number and the units that it is multiplied with are one number, converted exactly.
    pub(super) fn product_or_quotient(&mut self, expr: &syntax::Expr, context: Context) -> Expr {
        let ExprKind::Binary(operator, left, right) = &expr.kind else {
            return self.failed(expr.span);
        };
        if let Some(measure) = self.measure(expr)
            && measure.loose
        {
            return self.measured(measure, expr);
        }
        let left = self.operand(left, context);
        let right = self.operand(right, context);
        self.binary(BinaryOp::from(*operator), left, right, expr.span)
    }

    /// An operand of a product or quotient, which may be a unit.
    fn operand(&mut self, expr: &syntax::Expr, context: Context) -> Expr {
        match self.measure(expr) {
            Some(measure) if measure.loose => self.measured(measure, expr),
            _ => self.expression(expr, context),
        }
    }

    fn measured(&mut self, measure: Measure, expr: &syntax::Expr) -> Expr {
        let (text, negative) = match &measure.number {
            Some((text, negative)) => (text.as_str(), *negative),
            None => ("1", false),
        };
        let units: Vec<(&str, i32)> = measure
            .units
            .iter()
            .map(|(name, power)| (name.as_str(), *power))
            .collect();
        let converted = convert_product(text, &units, self.unit);
        let number = self.literal(converted, "the number with its units", expr.span);
        match negative {
            true => self.negate(number, expr.span),
            false => number,
        }
    }

    /// A power that is no factor of a product, or not of a unit.
    pub(super) fn lonely_power(
        &mut self,
        base: &syntax::Expr,
        power: i32,
        span: SourceSpan,
    ) -> Expr {
        let ExprKind::Name(name) = &base.kind else {
            return self.failed(span);
        };
        let text = name.to_string();
        let (fact, help) = match self.find(&text) {
            Some(symbol) => (
                format!(
                    "there is no operator for powers, but of units: `{text}` is {}",
                    symbol.kind()
                ),
                match is_unit(&text) {
                    true => format!("the name hides the unit `{text}`: give it another one"),
                    false => format!("write `{text} * {text}` for a square"),
                },
            ),
            None if is_unit(&text) => (
                format!("the unit `{text}^{power}` without a number"),
                format!("write `1 * {text}^{power}`"),
            ),
            None => {
                self.unknown_name(name, None);
                return self.failed(span);
            }
        };
        self.diagnostics.error_with_help(span, fact, help);
        self.failed(span)
    }

    /// What to say where a name has been taken for the unit that it hides: `0.2N*s/mm` beside `unknown s`.
    pub(super) fn hidden_unit(&self, value: &Expr) -> Option<String> {
        value.parts().find_map(|part| self.hides_unit(part))
    }

    fn hides_unit(&self, product: &Expr) -> Option<String> {
        let types::ExprKind::Binary(BinaryOp::Mul | BinaryOp::Div, left, right) = &product.kind
        else {
            return None;
        };
        let of_literal = is_literal(left)
            && matches!(left.ty, Type::Scalar(dimension) if dimension != Dimension::NUMBER);
        let name = right.as_name().filter(|_| of_literal)?;
        let symbol = self.symbols.iter().find(|symbol| symbol.name == name)?;
        let (text, kind) = (&symbol.text, symbol.kind());
        let help = format!("`{text}` is {kind} here, not the unit: give it another name");
        is_unit(text).then_some(help)
    }

    /// Products and quotients of units with at most one number above the line.
    fn measure(&self, expr: &syntax::Expr) -> Option<Measure> {
        let unit = |name: &proc_macro2::Ident, power| {
            let text = name.to_string();
            (is_unit(&text) && self.find(&text).is_none()).then(|| Measure {
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
                let mut measure = self.measure(value)?;
                let (text, negative) = measure.number?;
                measure.number = Some((text, !negative));
                Some(measure)
            }
            ExprKind::Binary(syntax::BinaryOp::Mul, left, right) => {
                self.measure(left)?.times(self.measure(right)?, 1)
            }
            ExprKind::Binary(syntax::BinaryOp::Div, left, right) => {
                let below = self.measure(right)?;
                let divisible = below.number.is_none();
                divisible.then_some(())?;
                self.measure(left)?.times(below, -1)
            }
            // No product of numbers and units.
            _ => None,
        }
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

fn is_literal(value: &Expr) -> bool {
    match &value.kind {
        types::ExprKind::Number(_) => true,
        types::ExprKind::Negate(inner) => is_literal(inner),
        _ => false,
    }
}
