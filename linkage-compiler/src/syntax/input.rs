//! Inputs: value, range, speed and acceleration.

use proc_macro2::Ident;

use super::ast::{Attribute, Expr, InputItem, Item};
use super::expression::PlusMinus;
use super::parser::{Parsed, Parser};

impl Parser<'_> {
    /// `NAME = expr [in lo..hi] [at SPEED [, ACCELERATION]] ;` after `input`, and whether its end has been reached.
    pub(super) fn input_item(&mut self, attributes: Vec<Attribute>) -> Parsed<(Item, bool)> {
        let name = self.name("a name after `input`")?;
        let mut input = InputItem {
            attributes,
            value: Expr::error((&name).into()),
            name,
            range: None,
            speed: None,
            acceleration: None,
        };
        let complete = self.input_parts(&mut input).is_ok();
        Ok((Item::Input(input), complete))
    }

    fn input_parts(&mut self, input: &mut InputItem) -> Parsed<()> {
        self.equals()?;
        input.value = self.sum(PlusMinus::JointIsMistake)?;
        if self.stream.eat_word("in") {
            input.range = Some(self.range()?);
        }
        if self.stream.eat_word("at") {
            input.speed = Some(self.rate("speed")?);
            if self.stream.eat_punct(',') {
                input.acceleration = Some(self.rate("acceleration")?);
            }
        }
        self.end_of_item()
    }

    fn range(&mut self) -> Parsed<(Expr, Expr)> {
        let low = self.expression()?;
        if !self.stream.is_puncts("..") {
            return self.unexpected_after_expression("`..` between the ends of the range");
        }
        self.stream.skip(2);
        self.stream.eat_punct('=');
        if self.stream.at_end() || self.stream.is_punct(0, ';') || self.at_rates() {
            return self.fail(
                "the range has no upper end",
                "write both ends: `0deg..360deg`",
            );
        }
        let high = self.expression()?;
        Ok((low, high))
    }

    /// `at` and a name, where an expression may stand too.
    fn at_rates(&self) -> bool {
        self.stream.is_word(0, "at") && self.stream.ident(1).is_some()
    }

    /// The argument that is the input's speed or acceleration.
    fn rate(&mut self, what: &str) -> Parsed<Ident> {
        if self.stream.ident(0).is_none() {
            let help =
                "name the arguments that functions take: `input phi = 30deg at omega, epsilon;`";
            return self.expected(&format!("a name for the {what} after `at`"), help);
        }
        self.name(&format!("a name for the {what} after `at`"))
    }
}
