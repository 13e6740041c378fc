//! The blank between two tokens of a line.

use linkage_language::syntax::{ClauseWord, ItemWord, Word, is_unit};

use crate::lexer::{Kind, Token};

/// The tokens around a gap.
pub(super) struct Gap<'t> {
    pub(super) text: &'t str,
    /// All tokens but blanks.
    pub(super) tokens: &'t [&'t Token],
    /// The token after the gap, not the first one.
    pub(super) index: usize,
}

impl Gap<'_> {
    fn token(&self, index: usize) -> &str {
        self.tokens[index].text(self.text)
    }

    /// Returns true if there is a blank between the two tokens in the text.
    fn is_wide(&self) -> bool {
        self.tokens[self.index - 1].range.end < self.tokens[self.index].range.start
    }

    /// Returns true if a blank is written between the two tokens.
    pub(super) fn has_blank(&self) -> bool {
        let (before, after) = (self.index - 1, self.index);
        let (left, right) = (self.token(before), self.token(after));
        let [left_kind, right_kind] = [before, after].map(|index| self.tokens[index].kind);
        match (left, right) {
            ("{", "}") => return false,
            ("{", _) | (_, "{" | "}") => return true,
            ("(" | "[", _) | (_, ")" | "]" | "," | ";") => return false,
            ("," | ";" | "}", _) => return true,
            ("#" | "!" | "&" | "'" | "$", _) => return false,
            (".", _) | (_, ".") => return false,
            _ => {}
        }
        match (left_kind, right_kind) {
            (Kind::Mark, Kind::Mark) => self.between_marks(left, right),
            (Kind::Mark, _) => self.after_mark(before),
            (_, Kind::Mark) => self.before_mark(right),
            (Kind::Word, Kind::Open) => {
                self.is_wide() || is_before_value(left) || self.is_load(before)
            }
            (_, _) => true,
        }
    }

    /// Returns true for the word of a load, whose value follows: `force (0, -load) on ram`.
    fn is_load(&self, word: usize) -> bool {
        let begins_item = word == 0
            || self.tokens[word - 1].is_trivia()
            || matches!(self.token(word - 1), "{" | "}" | ";");
        begins_item
            && matches!(
                ItemWord::from_word(self.token(word)),
                Some(ItemWord::Load(_))
            )
    }

    fn between_marks(&self, left: &str, right: &str) -> bool {
        // `=-5deg`, `2*-a`; in `+-` and `..=` the marks belong together.
        let is_range = left == "=" && self.index >= 2 && self.token(self.index - 2) == ".";
        let splits = matches!(left, "=" | "*" | "/" | ":") && right == "-" && !is_range;
        let is_tolerance = left == "/" && self.index >= 2 && self.token(self.index - 2) == "+";
        (splits && !is_tolerance && right != "=") || self.is_wide()
    }

    /// The blank after a mark before a word, a number or a bracket.
    fn after_mark(&self, mark: usize) -> bool {
        match self.token(mark) {
            "-" => !self.is_sign(mark),
            "=" => mark == 0 || self.token(mark - 1) != ".",
            "*" | "/" => !self.is_tight_product(mark),
            "+" => true,
            ">" => mark > 0 && self.token(mark - 1) == "-",
            ":" => mark == 0 || self.token(mark - 1) != ":",
            "^" => false,
            _ => self.is_wide(),
        }
    }

    /// The blank before a mark after a word, a number or a bracket.
    fn before_mark(&self, mark: &str) -> bool {
        match mark {
            ":" | "?" | "^" => false,
            "*" | "/" => !self.is_tight_product(self.index),
            "+" | "-" | "=" => true,
            "#" => true,
            _ => self.is_wide(),
        }
    }

    /// Returns true for the minus of a value, and false for a difference.
    fn is_sign(&self, mark: usize) -> bool {
        let Some(before) = mark.checked_sub(1) else {
            return true;
        };
        let word = self.token(before);
        match self.tokens[before].kind {
            Kind::Open => true,
            Kind::Mark => {
                // `+-` begins a tolerance.
                let is_tolerance = matches!(word, "+" | "/")
                    && self.tokens[before].range.end == self.tokens[mark].range.start;
                let is_of_three = word == "/" && before > 0 && self.token(before - 1) == "+";
                !(is_tolerance && (word == "+" || is_of_three))
            }
            Kind::Word => is_before_value(word) || self.is_load(before),
            _ => false,
        }
    }

    /// Returns true for `N*mm`, `9.8m/s^2`: a product of units, as the user wrote it.
    fn is_tight_product(&self, mark: usize) -> bool {
        let Some(next) = self
            .tokens
            .get(mark + 1)
            .filter(|next| next.kind == Kind::Word)
        else {
            return false;
        };
        let Some(before) = mark.checked_sub(1).map(|before| &self.tokens[before]) else {
            return false;
        };
        let is_after_unit = match before.kind {
            Kind::Number => before.text(self.text).ends_with(char::is_alphabetic),
            Kind::Word => is_unit(before.text(self.text)),
            _ => false,
        };
        // A power of a unit comes before.
        let is_after_power = mark >= 2 && self.token(mark - 2) == "^";
        let is_written_so = before.range.end == self.tokens[mark].range.start
            && self.tokens[mark].range.end == next.range.start;
        (is_after_unit || is_after_power) && is_unit(next.text(self.text)) && is_written_so
    }
}

/// Returns true for a word of the language that a value follows.
fn is_before_value(word: &str) -> bool {
    matches!(
        word,
        "in" | "through" | "teeth" | "radii" | "radius" | "length" | "by"
    ) || ClauseWord::from_word(word).is_some()
        || word == "loop"
}
