//! A position among the tokens of a text, without blanks and comments.

use std::ops::Range;

use crate::lexer::{Kind, Token};

/// Reads tokens one after the other.
#[derive(Clone, Debug)]
pub(crate) struct Cursor<'t> {
    pub(crate) text: &'t str,
    pub(crate) tokens: &'t [Token],
    next: usize,
    end: usize,
}

impl<'t> Cursor<'t> {
    /// Reads a whole text.
    pub(crate) fn new(text: &'t str, tokens: &'t [Token]) -> Self {
        Self {
            text,
            tokens,
            next: 0,
            end: tokens.len(),
        }
    }

    /// Reads the tokens within a range.
    pub(crate) fn within(text: &'t str, tokens: &'t [Token], range: &Range<usize>) -> Self {
        Self {
            text,
            tokens,
            next: tokens.partition_point(|token| token.range.start < range.start),
            end: tokens.partition_point(|token| token.range.end <= range.end),
        }
    }

    /// Returns the next token and moves past it.
    pub(crate) fn next(&mut self) -> Option<Token> {
        let found = self.peek()?;
        self.next += 1;
        Some(found.clone())
    }

    /// Returns the next token.
    pub(crate) fn peek(&mut self) -> Option<&'t Token> {
        while self.next < self.end && self.tokens[self.next].is_trivia() {
            self.next += 1;
        }
        (self.next < self.end).then(|| &self.tokens[self.next])
    }

    /// Returns the next token if it is of a kind, and moves past it.
    pub(crate) fn next_if(&mut self, kind: Kind) -> Option<Token> {
        self.peek().filter(|token| token.kind == kind)?;
        self.next()
    }

    /// Moves to the next opening bracket before a `;`, and past its partner. Returns the bytes between
    /// both; to the end if there is no partner.
    pub(crate) fn block(&mut self) -> Option<Range<usize>> {
        loop {
            let token = self.next()?;
            match token.kind {
                Kind::Open => return Some(self.inside(token.range.end)),
                Kind::Mark if token.text(self.text) == ";" => return None,
                _ => {}
            }
        }
    }

    /// Moves past the partner of the bracket before. Returns the bytes from `start` to it.
    fn inside(&mut self, start: usize) -> Range<usize> {
        let mut depth = 1;
        let mut end = start;
        while let Some(token) = self.next() {
            match token.kind {
                Kind::Open => depth += 1,
                Kind::Close => depth -= 1,
                _ => {}
            }
            if depth == 0 {
                return start..token.range.start;
            }
            end = token.range.end;
        }
        start..end
    }

    /// Moves past the next mark outside of brackets. Returns false if there is none.
    pub(crate) fn skip_past(&mut self, mark: char) -> bool {
        self.skip(|token, text| token.kind == Kind::Mark && text.starts_with(mark))
    }

    /// Moves past the next word outside of brackets. Returns false if there is none.
    pub(crate) fn skip_past_word(&mut self, word: &str) -> bool {
        self.skip(|token, text| token.kind == Kind::Word && text == word)
    }

    fn skip(&mut self, is_meant: impl Fn(&Token, &str) -> bool) -> bool {
        while let Some(token) = self.next() {
            if token.kind == Kind::Open {
                self.inside(token.range.end);
            } else if is_meant(&token, token.text(self.text)) {
                return true;
            }
        }
        false
    }

    /// Returns the expression after the next `=`: to a comma, a tolerance, the range or the rates of
    /// an input, or the end.
    pub(crate) fn value(&mut self) -> Option<Range<usize>> {
        if self.peek()?.text(self.text) != "=" {
            return None;
        }
        self.next();
        let start = self.peek()?.range.start;
        let mut end = start;
        while let Some(token) = self.next() {
            let text = token.text(self.text);
            let is_tolerance = matches!(text, "+") && {
                let rest = &self.text[token.range.end..];
                rest.starts_with('-') || rest.starts_with("/-")
            };
            match token.kind {
                Kind::Open => end = self.inside(token.range.end).end + 1,
                Kind::Mark if matches!(text, "," | ";") || is_tolerance => break,
                Kind::Word if matches!(text, "in" | "at") => break,
                _ => end = token.range.end,
            }
        }
        Some(start..end.min(self.text.len())).filter(|range| !range.is_empty())
    }
}
