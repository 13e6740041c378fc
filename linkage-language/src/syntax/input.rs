//! Inputs: value, range, speed and acceleration.

use proc_macro2::{Delimiter, Group, Ident, Spacing, TokenTree};

use super::ast::{InputItem, Item};
use super::expression::PlusMinus;
use super::expression_tree::Expr;
use super::parser::{Parsed, Parser};

const RATES: &str = "`at` names the arguments that are its speed and acceleration: `input phi = 30deg at omega, epsilon;`";

impl Parser<'_> {
    /// Reads `NAME = expr [in lo..hi] [at SPEED [, ACCELERATION]] ;` after `input`. The flag is
    /// true if its end has been reached.
    pub(super) fn input_item(&mut self) -> Parsed<(Item, bool)> {
        let name = self.name("a name after `input`")?;
        let mut input = InputItem {
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
        self.equals("")?;
        input.value = self.sum(PlusMinus::JointIsMistake)?;
        loop {
            if input.range.is_none() && self.stream.eat_word("in") {
                input.range = Some(self.range()?);
            } else if input.speed.is_none() && self.stream.eat_word("at") {
                self.rates(input)?;
            } else if self.at_clause_word() {
                let wanted = match input.speed {
                    None => "`in`, `at` or `;`",
                    Some(_) => "`;`",
                };
                let help = match self.stream.is_word(0, "from") {
                    true => "write the range as `in LOW..HIGH`: `in 0deg..360deg`",
                    false => RATES,
                };
                return self.expected(wanted, help);
            } else {
                return self.end_of_item();
            }
        }
    }

    /// `SPEED [, ACCELERATION]`
    fn rates(&mut self, input: &mut InputItem) -> Parsed<()> {
        input.speed = Some(self.rate("speed")?);
        if self.stream.eat_punct(',') {
            input.acceleration = Some(self.rate("acceleration")?);
        }
        match self.stream.peek(0) {
            Some(TokenTree::Ident(next))
                if input.acceleration.is_none() && next != "in" && !self.at_item() =>
            {
                self.expected("`,` or `;`", RATES)
            }
            Some(TokenTree::Punct(next)) if next.as_char() == ',' => self.expected("`;`", RATES),
            _ => Ok(()),
        }
    }

    fn range(&mut self) -> Parsed<(Expr, Expr)> {
        if let Some(group) = self.range_in_one_piece() {
            self.stream.skip(1);
            return self.within(&group, |parser| parser.range());
        }
        if self.lacks_operand() {
            return self.expected("the lower end of the range", "write `in 0deg..360deg`");
        }
        let low = self.expression()?;
        if !self.stream.is_puncts("..") {
            return self.other_range();
        }
        self.stream.skip(2);
        self.stream.eat_punct('=');
        if self.lacks_operand() {
            return self.fail(
                "the range has no upper end",
                "write both ends: `0deg..360deg`",
            );
        }
        let high = self.expression()?;
        Ok((low, high))
    }

    /// An invisible group that holds a range: `$range:expr` of a `macro_rules` macro.
    fn range_in_one_piece(&self) -> Option<Group> {
        let group = self.stream.group(0, Delimiter::None)?;
        let dot = |token: TokenTree| matches!(token, TokenTree::Punct(p) if p.as_char() == '.' && p.spacing() == Spacing::Joint);
        group.stream().into_iter().any(dot).then(|| group.clone())
    }

    /// Reports another notation of `..` or of a range.
    fn other_range<T>(&mut self) -> Parsed<T> {
        const WANTED: &str = "`..` between the ends of the range";
        const HELP: &str = "write both ends with `..` between them: `in 0deg..360deg`";
        let otherwise = ["to", "until", "through", "and"];
        let word = otherwise.iter().any(|word| self.stream.is_word(0, word));
        let bracket = matches!(self.stream.previous(), Some(TokenTree::Group(_)));
        if word || self.stream.is_punct(0, ',') && !self.at_decimal_comma() || bracket {
            return self.expected(WANTED, HELP);
        }
        if self.at_end_of_clauses() {
            return self.expected(WANTED, HELP);
        }
        self.unexpected_after_expression(WANTED)
    }

    /// The argument that is the input's speed or acceleration.
    fn rate(&mut self, what: &str) -> Parsed<Ident> {
        let wanted = format!("a name for the {what} after `at`");
        match self.stream.ident(0) {
            None => self.expected(&wanted, RATES),
            Some(_) => self.name(&wanted),
        }
    }
}
