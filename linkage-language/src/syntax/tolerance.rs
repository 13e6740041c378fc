//! Values of parameters: nominal values with tolerances.

use super::expression::PlusMinus;
use super::expression_tree::{Expr, ExprKind, Toleranced};
use super::parser::{Parsed, Parser};
use crate::diagnostic::SourceSpan;

impl Parser<'_> {
    /// `a +- b`, or a vector with such components; parentheses around the whole change nothing.
    pub(super) fn toleranced(&mut self) -> Parsed<Toleranced> {
        if let Some(group) = self.stream.parenthesis(0).cloned()
            && self.value_ends_after_group()
        {
            let span = SourceSpan {
                first: group.span_open(),
                last: group.span_close(),
            };
            self.stream.skip(1);
            let content = |parser: &mut Parser| parser.comma_list(")", Parser::toleranced);
            let (components, trailing) = self.within(&group, |parser| parser.nested(content))?;
            let inner = self.components(components, trailing, span)?;
            return self.outer_tolerance(inner);
        }
        let nominal = self.sum(PlusMinus::IsTolerance)?;
        self.outer_tolerance(Toleranced::Single {
            nominal,
            tolerance: None,
        })
    }

    /// Returns true if the parenthesis is the whole value, or all of it before the tolerance.
    fn value_ends_after_group(&self) -> bool {
        let at = |wanted| self.stream.is_punct(1, wanted);
        let tolerance = at('+')
            && (self.stream.is_punct(2, '-')
                || self.stream.is_punct(2, '/') && self.stream.is_punct(3, '-'));
        self.stream.peek(1).is_none() || at(';') || at(',') || tolerance
    }

    fn components(
        &mut self,
        mut components: Vec<Toleranced>,
        trailing: bool,
        span: SourceSpan,
    ) -> Parsed<Toleranced> {
        if components.is_empty() {
            return self.fail_at(span, "expected an expression between `(` and `)`", "");
        }
        if components.len() == 1 && !trailing {
            return Ok(components.remove(0));
        }
        let mut pairs = Vec::new();
        for component in components {
            match component {
                Toleranced::Single { nominal, tolerance } => pairs.push((nominal, tolerance)),
                Toleranced::Components { span, .. } => {
                    let help = "write `(x, y)` with numbers as components";
                    return self.fail_at(span, "a component cannot be a vector", help);
                }
            }
        }
        if pairs.iter().any(|(_, tolerance)| tolerance.is_some()) {
            return Ok(Toleranced::Components {
                components: pairs,
                span,
            });
        }
        let kind = ExprKind::Tuple(pairs.into_iter().map(|(nominal, _)| nominal).collect());
        Ok(Toleranced::Single {
            nominal: Expr { kind, span },
            tolerance: None,
        })
    }

    /// `+- tolerance` after a value, if it is there.
    fn outer_tolerance(&mut self, inner: Toleranced) -> Parsed<Toleranced> {
        let sign = self.stream.span();
        if !self.eat_tolerance_sign() {
            return Ok(inner);
        }
        let tolerance = self.sum(PlusMinus::IsTolerance)?;
        let span = sign.to(tolerance.span);
        match inner {
            _ if self.at_tolerance() => self.fail("a second tolerance", "write one `+-`"),
            Toleranced::Single {
                nominal,
                tolerance: None,
            } => Ok(Toleranced::Single {
                nominal,
                tolerance: Some(tolerance),
            }),
            _ => self.fail_at(span, "a second tolerance", "write one `+-`"),
        }
    }
}
