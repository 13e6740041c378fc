//! The items of the struct block.

use proc_macro2::Delimiter;

use super::ast::{Attribute, Item, LoopItem, NamedItem, ParamItem, UnitItem, UnknownItem};
use super::expression::PlusMinus;
use super::expression_tree::{Expr, Toleranced};
use super::item_name::ItemName;
use super::joints::{Kind, other_word};
use super::keyword::{ClauseWord, DeclarationWord, ItemWord, LoadWord, MarkWord};
use super::parser::{Parsed, Parser, Reported};
use super::vocabulary::Word;
use crate::diagnostic::SourceSpan;
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

    /// The item, and whether its end has been reached. A misspelt word is reported, and the item read
    /// as the one that is meant, without further messages.
    fn item_after(&mut self, attributes: Vec<Attribute>) -> Parsed<(Item, bool)> {
        let (word, is_meant) = self.item_word()?;
        let mark = self.diagnostics.mark();
        let item = self.item_of_word(word, attributes);
        if is_meant {
            self.diagnostics.rewind(mark);
        }
        item
    }

    fn item_of_word(&mut self, word: ItemWord, attributes: Vec<Attribute>) -> Parsed<(Item, bool)> {
        let start = self.stream.span();
        self.stream.skip(1);
        if word != ItemWord::Declaration(DeclarationWord::Param) {
            self.only_documentation(&attributes, &format!("`{}`", word.word()));
        }
        match word {
            ItemWord::Declaration(word) => self.declaration(word, attributes, start),
            ItemWord::Joint(kind) => self.joint_item(Kind { kind, span: start }),
            ItemWord::Linked(word) => {
                let (item, complete) = self.linked_item(word, start)?;
                Ok((Item::Linked(item), complete))
            }
            ItemWord::Load(word) => {
                let item = match word {
                    LoadWord::Force => Item::Force(self.force_item(start)?),
                    LoadWord::Torque => Item::Torque(self.torque_item(start)?),
                    LoadWord::Spring => Item::Spring(self.spring_item(start)?),
                    LoadWord::Damper => Item::Damper(self.damper_item(start)?),
                    LoadWord::Friction => Item::Friction(self.friction_item(start)?),
                };
                Ok((item, self.end_of_item().is_ok()))
            }
        }
    }

    fn declaration(
        &mut self,
        word: DeclarationWord,
        attributes: Vec<Attribute>,
        start: SourceSpan,
    ) -> Parsed<(Item, bool)> {
        let item = match word {
            DeclarationWord::Unit => Item::Unit(self.unit_item(start)?),
            DeclarationWord::Loop => Item::Loop(self.loop_item(start)?),
            DeclarationWord::Arc => Item::Arc(self.arc_item()?),
            DeclarationWord::Gravity => Item::Gravity(self.gravity_item(start)?),
            DeclarationWord::Param => return self.param_item(attributes),
            DeclarationWord::Input => return self.input_item(),
            DeclarationWord::Body => return self.body_item(),
            DeclarationWord::Part => return self.part_item(),
            DeclarationWord::Const => return self.named_item(word, Item::Const),
            DeclarationWord::Unknown => return self.unknown_item(),
            DeclarationWord::Let => return self.named_item(word, Item::Let),
            DeclarationWord::Argument => return self.named_item(word, Item::Argument),
        };
        Ok((item, self.end_of_item().is_ok()))
    }

    /// `NAME = expr [+- tol] ;` after `param`, and whether its end has been reached.
    fn param_item(&mut self, attributes: Vec<Attribute>) -> Parsed<(Item, bool)> {
        let name = self.item_name("a name after `param`")?;
        let (value, complete) = self.value("", Self::toleranced);
        let lost = |span| Toleranced::Single {
            nominal: Expr::error(span),
            tolerance: None,
        };
        let item = ParamItem {
            attributes,
            name,
            value: value.unwrap_or_else(lost),
        };
        Ok((Item::Param(item), complete))
    }

    /// `NAME = expr ;` after the item's word, and whether its end has been reached.
    fn named_item(
        &mut self,
        word: DeclarationWord,
        make: fn(NamedItem) -> Item,
    ) -> Parsed<(Item, bool)> {
        let wanted = format!("a name after `{}`", word.word());
        let name = if word == DeclarationWord::Let {
            self.item_name(&wanted)?
        } else {
            self.name(&wanted)?.into()
        };
        let help = if word == DeclarationWord::Argument {
            "the value says its dimension: `argument load = 100N;`"
        } else {
            ""
        };
        let plus_minus = if word == DeclarationWord::Let {
            PlusMinus::IsSum
        } else {
            PlusMinus::JointIsMistake
        };
        let (value, complete) = self.value(help, |parser| parser.sum(plus_minus));
        let item = NamedItem {
            name,
            value: value.unwrap_or_else(Expr::error),
        };
        Ok((make(item), complete))
    }

    /// `NAME [= expr] ;` after `unknown`, and whether its end has been reached.
    fn unknown_item(&mut self) -> Parsed<(Item, bool)> {
        let name = self.item_name("a name after `unknown`")?;
        let item = |estimate| Item::Unknown(UnknownItem { name, estimate });
        if self.stream.eat_punct(';') {
            return Ok((item(None), true));
        }
        let (value, complete) = self.value("", |parser| parser.sum(PlusMinus::JointIsMistake));
        Ok((item(Some(value.unwrap_or_else(Expr::error))), complete))
    }

    /// `NAME`, or `NAME.NAME` for a quantity of a link.
    fn item_name(&mut self, what: &str) -> Parsed<ItemName> {
        let name = self.name(what)?;
        if !self.stream.eat_punct('.') {
            return Ok(name.into());
        }
        let quantity = self.name("the name of a quantity after `.`")?;
        Ok(ItemName::of_link(name, quantity))
    }

    /// Returns the word of the item that begins here. The flag is true for a word that is only near to
    /// it, which has been reported.
    fn item_word(&mut self) -> Parsed<(ItemWord, bool)> {
        let listed = || format!("items are {}", ItemWord::listed());
        let Some(word) = self.stream.ident(0).map(ToString::to_string) else {
            return self.expected("an item", &listed());
        };
        if let Some(item) = ItemWord::from_word(&word) {
            return Ok((item, false));
        }
        let help = match word.as_str() {
            "fn" => "functions belong in the `impl` block after the struct".to_owned(),
            clause if ClauseWord::from_word(clause).is_some() => {
                "a clause belongs before the `;` of its body, joint or load".to_owned()
            }
            "pub" => "leave `pub` out: every `param` is a public field".to_owned(),
            "frame" | "ground" => {
                "the fixed link is written `link frame: joint, joint;`".to_owned()
            }
            _ => {
                let near = || nearest(&word, ItemWord::all().map(ItemWord::word));
                let Some(meant) = usual_word(&word).or_else(|| ItemWord::from_word(near()?)) else {
                    return self.expected("an item", &listed());
                };
                let (span, meant_word) = (self.stream.span(), meant.word());
                let fact = format!("expected an item, found {}", self.found());
                let help = format!("did you mean `{meant_word}`?");
                let message = self.diagnostics.error_with_help(span, fact, help);
                message.suggest(format!("write `{meant_word}`"), span, meant_word);
                return Ok((meant, true));
            }
        };
        self.expected("an item", &help)
    }

    /// Reads `= RULE ;`; `help` is the text to write if `=` is missing. After a mistake in it, the
    /// result is the span of the item so far. The flag is true if the end was reached.
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

    /// Reads `=`; `help` is the text to write if it is missing.
    pub(super) fn equals(&mut self, help: &str) -> Parsed<()> {
        if self.stream.eat_punct('=') {
            return if self.stream.is_punct(0, '=') {
                let (span, fact) = (self.stream.span(), "expected `=`, found `==`");
                let message = self.diagnostics.error_with_help(span, fact, "write `=`");
                message.suggest("write `=`", span, "");
                Err(Reported)
            } else {
                Ok(())
            };
        }
        let help = if self.stream.is_punct(0, ':') {
            "leave the type out: the value gives it"
        } else {
            help
        };
        self.expected("`=`", help)
    }

    /// `NAME` after `unit`.
    fn unit_item(&mut self, start: SourceSpan) -> Parsed<UnitItem> {
        let Some(unit) = self.stream.ident(0).cloned() else {
            return self.expected("a length unit", "write `unit mm;`");
        };
        self.stream.skip(1);
        let span = start.to((&unit).into());
        Ok(UnitItem { unit, span })
    }

    /// `expr = expr [redundant]` after `loop`.
    fn loop_item(&mut self, start: SourceSpan) -> Parsed<LoopItem> {
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
        let word = self.stream.ident(0).map(ToString::to_string);
        let redundant = self.stream.eat_word(MarkWord::Redundant.word());
        if let Some(word) = word.filter(|_| !redundant)
            && nearest(&word, [MarkWord::Redundant.word()]).is_some()
        {
            return self.expected(
                "`;`",
                &format!("did you mean `{}`?", MarkWord::Redundant.word()),
            );
        }
        Ok(LoopItem {
            redundant,
            left,
            right,
            span,
            of: None,
        })
    }
}

/// Returns the item that other tools and languages call by this word.
fn usual_word(word: &str) -> Option<ItemWord> {
    match word {
        "point" | "vector" | "var" => Some(ItemWord::Declaration(DeclarationWord::Let)),
        "dimension" | "parameter" => Some(ItemWord::Declaration(DeclarationWord::Param)),
        _ => other_word(word).map(ItemWord::Joint),
    }
}
