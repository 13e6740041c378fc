//! Expressions, with Rust's precedence.

use proc_macro2::{Delimiter, Group, Ident, TokenTree};

use super::expression_tree::{BinaryOp, Expr, ExprKind};
use super::keyword::is_keyword;
use super::parser::{Parsed, Parser};
use crate::diagnostic::SourceSpan;

/// The meaning of an outermost `+-`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum PlusMinus {
    /// The end of the sum and the start of a tolerance.
    IsTolerance,
    /// Plus minus something.
    IsSum,
    /// Written without a space it can only be meant as a tolerance, which has no place here.
    JointIsMistake,
}

impl Parser<'_> {
    pub(super) fn expression(&mut self) -> Parsed<Expr> {
        self.sum(PlusMinus::IsSum)
    }

    pub(super) fn sum(&mut self, plus_minus: PlusMinus) -> Parsed<Expr> {
        let mut left = self.product()?;
        loop {
            let operator = match () {
                () if plus_minus == PlusMinus::IsTolerance && self.at_tolerance() => break,
                () if self.stream.is_puncts("+/-") => return self.misplaced_tolerance(),
                () if plus_minus == PlusMinus::JointIsMistake
                    && self.stream.is_puncts("+-")
                    && self.stream.is_joint() =>
                {
                    return self.misplaced_tolerance();
                }
                () if self.stream.is_punct(0, '+') => BinaryOp::Add,
                () if self.stream.is_punct(0, '-') => BinaryOp::Sub,
                () => break,
            };
            self.stream.skip(1);
            self.count_operator()?;
            let right = self.product()?;
            left = binary(operator, left, right);
        }
        Ok(left)
    }

    /// `+-` or `+/-`, spaces or not.
    pub(super) fn at_tolerance(&self) -> bool {
        self.stream.is_puncts("+-") || self.stream.is_puncts("+/-")
    }

    pub(super) fn eat_tolerance_sign(&mut self) -> bool {
        let length = match () {
            () if self.stream.is_puncts("+-") => 2,
            () if self.stream.is_puncts("+/-") => 3,
            () => 0,
        };
        self.stream.skip(length);
        length > 0
    }

    pub(super) fn misplaced_tolerance<T>(&mut self) -> Parsed<T> {
        let help = "write it outermost in a `param`, or in a component of its vector";
        self.fail("a tolerance cannot stand here", help)
    }

    fn product(&mut self) -> Parsed<Expr> {
        let mut left = self.signed()?;
        loop {
            let operator = match () {
                () if self.stream.is_puncts("**") => return self.no_powers(),
                () if self.stream.is_punct(0, '*') => BinaryOp::Mul,
                () if self.stream.is_punct(0, '/') => BinaryOp::Div,
                () => break,
            };
            self.stream.skip(1);
            self.count_operator()?;
            let right = self.signed()?;
            left = binary(operator, left, right);
        }
        Ok(left)
    }

    fn signed(&mut self) -> Parsed<Expr> {
        let start = self.stream.span();
        if !self.stream.eat_punct('-') {
            return self.postfix();
        }
        let operand = self.nested(Self::signed)?;
        let span = start.to(operand.span);
        Ok(Expr {
            kind: ExprKind::Negate(Box::new(operand)),
            span,
        })
    }

    fn postfix(&mut self) -> Parsed<Expr> {
        let mut value = self.primary()?;
        loop {
            if self.stream.is_punct(0, '.') && !self.stream.is_punct(1, '.') {
                self.count_operator()?;
                value = self.component(value)?;
            } else if let Some(group) = self.stream.group(0, Delimiter::Bracket).cloned() {
                self.count_operator()?;
                value = self.index(value, &group)?;
            } else {
                return Ok(value);
            }
        }
    }

    /// `.x`, the value before it having been read.
    fn component(&mut self, value: Expr) -> Parsed<Expr> {
        if let (ExprKind::Number { text, .. }, Some(unit)) = (&value.kind, self.stream.ident(1)) {
            let help = format!("write `{text}{unit}` or `{text}.0{unit}`");
            let span = value.span.to(unit.span().into());
            return self.fail_at(span, "a digit must follow the decimal point", &help);
        }
        self.stream.skip(1);
        let help = "components are `.x`, `.y` and `.z`";
        let Some(field) = self.stream.ident(0).cloned() else {
            return self.expected("a component after `.`", help);
        };
        if self.stream.group(1, Delimiter::Parenthesis).is_some() {
            let help = match field.to_string().as_str() {
                "powi" | "powf" | "pow" => "write `a * a` for a square".to_owned(),
                "to_degrees" | "to_radians" => {
                    "angles carry their unit (`30deg`) and are radians in results".to_owned()
                }
                _ => format!("write `{field}(...)` with the value as an argument"),
            };
            return self.fail("there are no methods here, only functions", &help);
        }
        if is_keyword(&field.to_string()) {
            return self.expected("a component after `.`", help);
        }
        self.stream.skip(1);
        let span = value.span.to((&field).into());
        Ok(Expr {
            kind: ExprKind::Field(Box::new(value), field),
            span,
        })
    }

    fn index(&mut self, value: Expr, group: &Group) -> Parsed<Expr> {
        let (mut entries, _) = self.in_brackets(group)?;
        let span = value.span.to(group.span_close().into());
        match (entries.pop(), entries.is_empty()) {
            (Some(entry), true) => Ok(Expr {
                kind: ExprKind::Index(Box::new(value), Box::new(entry)),
                span,
            }),
            _ => self.fail_at(group.span().into(), "expected one index", "write `[0]`"),
        }
    }

    fn primary(&mut self) -> Parsed<Expr> {
        let span = self.stream.span();
        match self.stream.peek(0).cloned() {
            Some(TokenTree::Literal(_)) => {
                let number = self.number()?;
                self.no_power_of_number(number)
            }
            Some(TokenTree::Ident(ident)) => self.name_or_call(ident),
            Some(TokenTree::Group(group)) => match group.delimiter() {
                Delimiter::Parenthesis | Delimiter::None => self.parenthesis(&group),
                Delimiter::Bracket => {
                    let (entries, _) = self.in_brackets(&group)?;
                    Ok(Expr {
                        kind: ExprKind::List(entries),
                        span,
                    })
                }
                Delimiter::Brace => self.expected("an expression", "parentheses group terms"),
            },
            Some(TokenTree::Punct(punct)) if punct.as_char() == '.' => self.leading_point(),
            Some(TokenTree::Punct(punct)) if punct.as_char() == '+' => {
                self.expected("an expression", "leave the sign `+` out")
            }
            _ => self.expected("an expression", ""),
        }
    }

    /// `.5mm`
    fn leading_point<T>(&mut self) -> Parsed<T> {
        let Some(digits) = self.stream.literal(1) else {
            return self.expected("an expression", "");
        };
        let span = self.stream.span().to(digits.span().into());
        let help = format!("write `0.{digits}`");
        self.fail_at(span, "a digit must precede the decimal point", &help)
    }

    fn name_or_call(&mut self, ident: Ident) -> Parsed<Expr> {
        let span = SourceSpan::from(&ident);
        if self.stream.is_puncts("::") || self.at_path() {
            let help = "only names of this mechanism and `PI` can be used";
            return self.fail("a path cannot stand here", help);
        }
        // `param a = ` while the user types it: the next item is not its value, nor is a clause
        // after `mass 2 * `.
        let clause_here = self.clauses_follow() && self.lacks_operand();
        if is_keyword(&ident.to_string()) || self.at_declaration() || clause_here {
            let help = match ident.to_string().as_str() {
                "if" | "match" => {
                    "there are no cases here: decide outside, and hand the value over as an `argument`"
                }
                _ => "",
            };
            return self.expected("an expression", help);
        }
        self.stream.skip(1);
        let Some(group) = self.stream.group(0, Delimiter::Parenthesis).cloned() else {
            return self.power(Expr {
                kind: ExprKind::Name(ident),
                span,
            });
        };
        self.stream.skip(1);
        let arguments = |parser: &mut Parser| {
            parser.nested(|parser| parser.comma_list(")", Parser::expression))
        };
        let (arguments, _) = self.within(&group, arguments)?;
        let span = span.to(group.span_close().into());
        Ok(Expr {
            kind: ExprKind::Call(ident, arguments),
            span,
        })
    }

    fn at_path(&self) -> bool {
        self.stream.is_punct(1, ':') && self.stream.is_punct(2, ':')
    }

    /// `(a)`, `(a, b)`, ...
    fn parenthesis(&mut self, group: &Group) -> Parsed<Expr> {
        let span = SourceSpan {
            first: group.span_open(),
            last: group.span_close(),
        };
        self.stream.skip(1);
        let content = |parser: &mut Parser| {
            parser.nested(|parser| parser.comma_list(")", Parser::expression))
        };
        let (mut components, trailing) = self.within(group, content)?;
        if components.len() == 1 && !trailing {
            // The parentheses belong to the words that a message underlines.
            return Ok(Expr {
                span,
                ..components.remove(0)
            });
        }
        if components.is_empty() {
            return self.fail_at(span, "expected an expression between `(` and `)`", "");
        }
        Ok(Expr {
            kind: ExprKind::Tuple(components),
            span,
        })
    }

    fn in_brackets(&mut self, group: &Group) -> Parsed<(Vec<Expr>, bool)> {
        self.stream.skip(1);
        self.within(group, |parser| {
            parser.nested(|parser| parser.comma_list("]", Parser::expression))
        })
    }
}

fn binary(operator: BinaryOp, left: Expr, right: Expr) -> Expr {
    let span = left.span.to(right.span);
    Expr {
        kind: ExprKind::Binary(operator, Box::new(left), Box::new(right)),
        span,
    }
}
