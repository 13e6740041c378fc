//! Where items begin and end, judging by their words, and how reading goes on after a mistake.

use proc_macro2::TokenTree;

use super::parser::{Parsed, Parser};
use super::words::{self, ITEMS, is_keyword};

impl Parser<'_> {
    /// `;`, which the last item may lack; a missing one before the next item is reported and read over.
    pub(super) fn end_of_item(&mut self) -> Parsed<()> {
        if self.stream.eat_punct(';') || self.stream.at_end() {
            return Ok(());
        }
        if self.at_item() || self.stream.is_punct(0, '#') {
            let span = self.stream.previous_span();
            let _ = self.fail_at::<()>(span, "the item lacks its `;`", "write `;` here");
            return Ok(());
        }
        self.unexpected_after_expression("`;`")
    }

    /// The beginning of an item, where no expression can begin.
    pub(super) fn at_item(&self) -> bool {
        self.at_declaration() || self.at_unnamed_item()
    }

    /// The word of an item and a name, or a word that cannot be a name itself.
    pub(super) fn at_declaration(&self) -> bool {
        let Some(word) = self.item_word_ahead() else {
            return false;
        };
        if is_keyword(&word) {
            return true;
        }
        let Some(name) = self.stream.ident(1).map(ToString::to_string) else {
            return false;
        };
        // A value that lacks its `;`.
        let is_word = is_keyword(&name) || ITEMS.contains(&name.as_str());
        if is_word && self.stream.ident(2).is_some() {
            return false;
        }
        match word.as_str() {
            "unit" | "param" | "input" | "unknown" | "argument" | "body" => {
                // `body at p` is a value before a clause, `body at = ` a body.
                name != "in" && (words::clause(&name).is_none() || self.stream.is_punct(2, '='))
            }
            "force" | "torque" | "spring" | "damper" => words::clause(&name).is_none(),
            _ => self.stream.is_punct(2, '='),
        }
    }

    /// `gravity =`, or a load: its word, the beginning of a value, and a clause before the next `;`.
    fn at_unnamed_item(&self) -> bool {
        let follows_operator = matches!(
            self.stream.previous(),
            Some(TokenTree::Punct(punct)) if !matches!(punct.as_char(), ';' | ',')
        );
        let Some(word) = self.item_word_ahead().filter(|_| !follows_operator) else {
            return false;
        };
        match word.as_str() {
            "force" | "torque" | "spring" | "damper" => {
                let begins_value = self.stream.literal(1).is_some()
                    || self.stream.is_punct(1, '-')
                    || self.stream.parenthesis(1).is_some();
                begins_value && self.clause_before_semicolon()
            }
            "unit" | "param" | "input" | "unknown" | "argument" | "body" => false,
            _ => self.stream.is_punct(1, '='),
        }
    }

    fn item_word_ahead(&self) -> Option<String> {
        let word = self.stream.ident(0)?.to_string();
        ITEMS.contains(&word.as_str()).then_some(word)
    }

    fn clause_before_semicolon(&self) -> bool {
        (1..)
            .map_while(|ahead| self.stream.peek(ahead))
            .take_while(|token| !matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';'))
            .any(|token| matches!(token, TokenTree::Ident(word) if word == "on" || word == "from"))
    }

    /// To the start of the next item, after a mistake.
    pub(super) fn skip_item(&mut self) {
        while !self.stream.at_end() && !self.at_item() {
            if self.stream.eat_punct(';') {
                return;
            }
            self.stream.skip(1);
        }
    }
}
