//! Begins and ends of items, recognised by their words, and the continuation after a mistake.

use proc_macro2::TokenTree;

use super::keyword::{ClauseWord, DeclarationWord, ItemWord, LinkedWord, is_keyword};
use super::parser::{Parsed, Parser};
use super::vocabulary::Word;
use crate::diagnostic::EditLocation;

impl Parser<'_> {
    /// Reads `;`, which the last item may lack. A missing one before the next item is reported and
    /// skipped.
    pub(super) fn end_of_item(&mut self) -> Parsed<()> {
        if self.stream.eat_punct(';') || self.stream.at_end() {
            return Ok(());
        }
        if self.at_item() || self.stream.is_punct(0, '#') {
            let span = self.stream.previous_span();
            let (fact, help) = ("the item lacks its `;`", "write `;` here");
            let message = self.diagnostics.error_with_help(span, fact, help);
            message.suggest_text("write `;`", span, EditLocation::After, ";");
            return Ok(());
        }
        if self.stream.is_punct(0, ',')
            && self.stream.is_punct(2, '=')
            && let Some(name) = self.stream.ident(1).map(ToString::to_string)
        {
            let help = format!("each name has an item: write `;` and its word before `{name}`");
            return self.expected("`;`", &help);
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
        if is_keyword(word.word()) {
            return true;
        }
        let Some(name) = self.stream.ident(1).map(ToString::to_string) else {
            return false;
        };
        // A value that lacks its `;`.
        let is_word = is_keyword(&name) || ItemWord::from_word(&name).is_some();
        if is_word && self.stream.ident(2).is_some() {
            return false;
        }
        let is_clause = ClauseWord::from_word(&name).is_some();
        let equals_follows = self.stream.is_punct(2, '=');
        match word {
            // `body at p` is a value before a clause, `body at = ` a body.
            ItemWord::Declaration(word) if names_without_equals(word) => {
                name != "in" && (!is_clause || equals_follows)
            }
            ItemWord::Load(_) => !is_clause,
            // Their words can be names of values: `link` in `loop a = link redundant`.
            ItemWord::Linked(LinkedWord::Joint) => equals_follows,
            ItemWord::Declaration(DeclarationWord::Arc)
            | ItemWord::Linked(LinkedWord::Link | LinkedWord::Slider) => {
                self.stream.is_punct(2, ':')
            }
            ItemWord::Linked(LinkedWord::Gears | LinkedWord::Belt | LinkedWord::Weld) => {
                self.stream.is_punct(2, ',')
            }
            ItemWord::Declaration(_) | ItemWord::Joint(_) => equals_follows,
        }
    }

    /// `gravity =`, or a load: its word, the beginning of a value, and a clause before the next
    /// `;`.
    fn at_unnamed_item(&self) -> bool {
        let follows_operator = matches!(
            self.stream.previous(),
            Some(TokenTree::Punct(punct)) if !matches!(punct.as_char(), ';' | ',')
        );
        let Some(word) = self.item_word_ahead().filter(|_| !follows_operator) else {
            return false;
        };
        match word {
            ItemWord::Load(_) => {
                let begins_value = self.stream.literal(1).is_some()
                    || self.stream.is_punct(1, '-')
                    || self.stream.parenthesis(1).is_some();
                begins_value && self.clause_before_semicolon()
            }
            ItemWord::Declaration(word) if names_without_equals(word) => false,
            ItemWord::Declaration(DeclarationWord::Arc) | ItemWord::Linked(_) => false,
            ItemWord::Declaration(_) | ItemWord::Joint(_) => self.stream.is_punct(1, '='),
        }
    }

    fn item_word_ahead(&self) -> Option<ItemWord> {
        ItemWord::from_word(&self.stream.ident(0)?.to_string())
    }

    fn clause_before_semicolon(&self) -> bool {
        (1..)
            .map_while(|ahead| self.stream.peek(ahead))
            .take_while(|token| !matches!(token, TokenTree::Punct(punct) if punct.as_char() == ';'))
            .any(|token| {
                let ends = [ClauseWord::On, ClauseWord::From];
                matches!(token, TokenTree::Ident(ident) if ends.iter().any(|word| ident == word.word()))
            })
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

/// Returns true if the word and a name are enough to recognise an item without its `=`. The other
/// words are names of values, too (`gravity`), or keywords that need no more.
fn names_without_equals(word: DeclarationWord) -> bool {
    match word {
        DeclarationWord::Unit
        | DeclarationWord::Param
        | DeclarationWord::Input
        | DeclarationWord::Unknown
        | DeclarationWord::Argument
        | DeclarationWord::Part
        | DeclarationWord::Body => true,
        DeclarationWord::Const
        | DeclarationWord::Let
        | DeclarationWord::Loop
        | DeclarationWord::Gravity
        | DeclarationWord::Arc => false,
    }
}
