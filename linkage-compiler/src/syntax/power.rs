//! Powers of units: `mm^2`, `s^-1`.

use super::ast::{Expr, ExprKind};
use super::parser::{Parsed, Parser};

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
            return self.no_powers();
        };
        self.stream.skip(2 + sign);
        let span = base.span.to(self.stream.previous_span());
        let exponent = if sign == 1 { -exponent } else { exponent };
        Ok(Expr {
            kind: ExprKind::Power(Box::new(base), exponent),
            span,
        })
    }
}
