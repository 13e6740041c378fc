//! Powers of units: `mm^2`, `s^-1`.

use super::expression_tree::{Expr, ExprKind};
use super::parser::{Parsed, Parser};

const NO_POWERS: &str = "there is no operator for powers";

/// Larger exponents belong to no unit.
const LARGEST: i32 = 9;

impl Parser<'_> {
    /// `^ INTEGER` after a name, if it is there.
    pub(super) fn power(&mut self, base: Expr) -> Parsed<Expr> {
        if !self.stream.is_punct(0, '^') {
            return Ok(base);
        }
        let sign = usize::from(self.stream.is_punct(1, '-'));
        let written = self.stream.literal(1 + sign).map(ToString::to_string);
        let exponent = written.and_then(|digits| digits.parse::<i32>().ok());
        let Some(exponent) = exponent.filter(|value| value.abs() <= LARGEST) else {
            let help = format!(
                "write `a * a` for a square; units have whole exponents up to {LARGEST}: `mm^2`"
            );
            return self.fail(NO_POWERS, &help);
        };
        self.stream.skip(2 + sign);
        let span = base.span.to(self.stream.previous_span());
        let exponent = if sign == 1 { -exponent } else { exponent };
        Ok(Expr {
            kind: ExprKind::Power(Box::new(base), exponent),
            span,
        })
    }

    /// Refuses `5mm^2` and `5^2`, whose base is ambiguous.
    pub(super) fn no_power_of_number(&mut self, number: Expr) -> Parsed<Expr> {
        match &number.kind {
            ExprKind::Number { text, suffix }
                if self.stream.is_punct(0, '^') && !suffix.is_empty() =>
            {
                let sign = usize::from(self.stream.is_punct(1, '-'));
                let exponent = self.stream.literal(1 + sign).map(ToString::to_string);
                let exponent = exponent.unwrap_or_else(|| "2".to_owned());
                let minus = &"-"[..sign];
                let help = format!("write `{text} * {suffix}^{minus}{exponent}`");
                self.fail("a number with a unit has no powers", &help)
            }
            _ => Ok(number),
        }
    }

    pub(super) fn no_powers<T>(&mut self) -> Parsed<T> {
        self.fail(NO_POWERS, "write `a * a` for a square")
    }
}
