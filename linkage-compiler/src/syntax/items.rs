//! The items of the struct block.

use proc_macro2::Delimiter;

use super::ast::{
    Attribute, Expr, Item, LoopItem, NamedItem, ParamItem, SourceSpan, Toleranced, UnitItem,
};
use super::expression::PlusMinus;
use super::joints::{Kind, other_word};
use super::parser::{Parsed, Parser};
use super::words::{self, ITEMS};
use crate::diagnostic::text::nearest;

impl Parser<'_> {
    /// All items up to the end of the block; those that cannot be read are reported and left out.
    pub(super) fn items(&mut self) -> Vec<Item> {
        let mut items = Vec::new();
        while !self.stream.at_end() {
            self.start_item();
            if self.stream.eat_punct(';') {
                continue;
            }
            items.extend(self.item());
        }
        items
    }

    /// One item with its `;`. Its name alone is enough to keep it: the value is then an error.
    fn item(&mut self) -> Option<Item> {
        let item = self
            .attributes()
            .and_then(|attributes| self.item_after(attributes));
        match item {
            Ok((item, complete)) => {
                if !complete {
                    self.skip_item();
                }
                Some(item)
            }
            Err(_) => {
                self.skip_item();
                None
            }
        }
    }

    /// The item, and whether its end has been reached.
    fn item_after(&mut self, attributes: Vec<Attribute>) -> Parsed<(Item, bool)> {
        let word = self.item_word()?;
        let start = self.stream.span();
        self.stream.skip(1);
        if word != "param" {
            self.only_documentation(&attributes, &format!("`{word}`"));
        }
        if let Some(kind) = Kind::find(word, start) {
            return self.joint_item(kind, attributes);
        }
        match word {
            "unit" => {
                let item = Item::Unit(self.unit(start)?);
                Ok((item, self.end_of_item().is_ok()))
            }
            "loop" => {
                let item = Item::Loop(self.closure(start)?);
                Ok((item, self.end_of_item().is_ok()))
            }
            "param" => {
                let name = self.name(&format!("a name after `{word}`"))?;
                let (value, complete) = self.value("", Self::toleranced);
                let lost = |span| Toleranced::Single {
                    nominal: Expr::error(span),
                    tolerance: None,
                };
                let value = value.unwrap_or_else(lost);
                Ok((
                    Item::Param(ParamItem {
                        attributes,
                        name,
                        value,
                    }),
                    complete,
                ))
            }
            "input" => self.input_item(attributes),
            "gravity" => {
                let item = Item::Gravity(self.gravity(start)?);
                Ok((item, self.end_of_item().is_ok()))
            }
            "body" => self.body_item(attributes),
            "force" | "torque" => {
                let load = self.load(word, start)?;
                let item = match word {
                    "force" => Item::Force(load),
                    _ => Item::Torque(load),
                };
                Ok((item, self.end_of_item().is_ok()))
            }
            "spring" | "damper" => {
                let element = self.element(word, start)?;
                let item = match word {
                    "spring" => Item::Spring(element),
                    _ => Item::Damper(element),
                };
                Ok((item, self.end_of_item().is_ok()))
            }
            _ => {
                let name = self.name(&format!("a name after `{word}`"))?;
                let help = match word {
                    "argument" => "the value says its dimension: `argument load = 100N;`",
                    _ => "",
                };
                let plus_minus = match word {
                    "let" => PlusMinus::IsSum,
                    _ => PlusMinus::JointIsMistake,
                };
                let (value, complete) = self.value(help, |parser| parser.sum(plus_minus));
                let value = value.unwrap_or_else(Expr::error);
                let item = NamedItem {
                    attributes,
                    name,
                    value,
                };
                let item = match word {
                    "const" => Item::Const(item),
                    "unknown" => Item::Unknown(item),
                    "argument" => Item::Argument(item),
                    _ => Item::Let(item),
                };
                Ok((item, complete))
            }
        }
    }

    fn item_word(&mut self) -> Parsed<&'static str> {
        let Some(word) = self.stream.ident(0).map(ToString::to_string) else {
            return self.expected("an item", &format!("items are {}", ITEMS.join(" ")));
        };
        if let Some(item) = ITEMS.iter().find(|item| **item == word) {
            return Ok(item);
        }
        let help = match word.as_str() {
            "fn" => "functions belong in the `impl` block after the struct".to_owned(),
            clause if words::clause(clause).is_some() => {
                "a clause belongs before the `;` of its body, joint or load".to_owned()
            }
            "pub" => "leave `pub` out: every `param` is a public field".to_owned(),
            _ => match other_word(&word).or_else(|| nearest(&word, ITEMS)) {
                Some(item) => format!("did you mean `{item}`?"),
                None => format!("items are {}", ITEMS.join(" ")),
            },
        };
        self.expected("an item", &help)
    }

    /// `= RULE ;`; `help` says what to write if `=` is missing. A mistake in it leaves the span of the item so far; the flag says whether the end was reached.
    pub(super) fn value<T>(
        &mut self,
        help: &str,
        rule: impl FnOnce(&mut Self) -> Parsed<T>,
    ) -> (Result<T, SourceSpan>, bool) {
        let span = self.stream.previous_span();
        let value = match self.equals(help) {
            Ok(()) => rule(self),
            Err(reported) => Err(reported),
        };
        match value {
            Ok(value) => (Ok(value), self.end_of_item().is_ok()),
            Err(_) => (Err(span), false),
        }
    }

    /// `=`; `help` says what to write if it is missing.
    pub(super) fn equals(&mut self, help: &str) -> Parsed<()> {
        if self.stream.eat_punct('=') {
            return match self.stream.is_punct(0, '=') {
                true => self.fail("expected `=`, found `==`", "write `=`"),
                false => Ok(()),
            };
        }
        let help = match self.stream.is_punct(0, ':') {
            true => "leave the type out: the value gives it",
            false => help,
        };
        self.expected("`=`", help)
    }

    fn unit(&mut self, start: SourceSpan) -> Parsed<UnitItem> {
        let Some(unit) = self.stream.ident(0).cloned() else {
            return self.expected("a length unit", "write `unit mm;`");
        };
        self.stream.skip(1);
        let span = start.to((&unit).into());
        Ok(UnitItem { unit, span })
    }

    fn closure(&mut self, start: SourceSpan) -> Parsed<LoopItem> {
        if self.stream.group(0, Delimiter::Brace).is_some() {
            let help = "write `loop expression = expression;`";
            return self.fail("`loop` is an equation here", help);
        }
        let left = self.expression()?;
        if self.stream.is_punct(0, ';') {
            let help = "a loop equates two sides: `loop a + b = c;`";
            return self.expected("`=`", help);
        }
        if !self.stream.is_punct(0, '=') {
            return self.unexpected_after_expression("`=`");
        }
        self.equals("")?;
        let right = self.expression()?;
        let span = start.to(right.span);
        Ok(LoopItem { left, right, span })
    }
}
