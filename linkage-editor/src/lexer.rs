//! Words, numbers, marks, comments and blanks of a text: every byte belongs to one token.
//!
//! The compiler reads the tokens of proc-macro2, which have no comments, and none at all if a
//! bracket has no partner. Editors need both.

use std::ops::Range;

/// The kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Blanks and ends of lines.
    Blank,
    /// `// ...` and `/* ... */`.
    Comment,
    /// `/// ...` and `/** ... */`.
    Documentation,
    /// A name or a keyword.
    Word,
    /// A number with its unit.
    Number,
    /// A string or a character.
    Text,
    /// `(`, `[` or `{`.
    Open,
    /// `)`, `]` or `}`.
    Close,
    /// One of the other characters that have a meaning.
    Mark,
    /// A character that means nothing, or a string or comment without an end.
    Unknown,
}

/// A token and its bytes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Token {
    pub(crate) kind: Kind,
    pub(crate) range: Range<usize>,
}

impl Token {
    /// Returns its text.
    pub(crate) fn text<'t>(&self, text: &'t str) -> &'t str {
        &text[self.range.clone()]
    }

    /// Returns true for blanks and comments, doc comments included.
    pub(crate) fn is_trivia(&self) -> bool {
        match self.kind {
            Kind::Blank | Kind::Comment | Kind::Documentation => true,
            Kind::Word
            | Kind::Number
            | Kind::Text
            | Kind::Open
            | Kind::Close
            | Kind::Mark
            | Kind::Unknown => false,
        }
    }
}

/// Returns all tokens of a text, in order and without gaps.
pub(crate) fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut start = 0;
    while let Some(first) = text[start..].chars().next() {
        let (kind, length) = token(&text[start..], first);
        let range = start..start + length;
        start = range.end;
        tokens.push(Token { kind, range });
    }
    tokens
}

/// Returns kind and length of the first token of a text.
fn token(rest: &str, first: char) -> (Kind, usize) {
    let one = first.len_utf8();
    match first {
        _ if is_blank(first) => (Kind::Blank, while_true(rest, is_blank)),
        '/' if rest.starts_with("//") => line_comment(rest),
        '/' if rest.starts_with("/*") => block_comment(rest),
        '(' | '[' | '{' => (Kind::Open, one),
        ')' | ']' | '}' => (Kind::Close, one),
        '"' => string(rest),
        '\'' => character(rest),
        '0'..='9' => (Kind::Number, number(rest)),
        'r' if rest.starts_with("r#\"") || rest.starts_with("r\"") => raw_string(rest),
        'r' if rest.starts_with("r#") => (Kind::Word, 2 + while_true(&rest[2..], continues_word)),
        _ if starts_word(first) => (Kind::Word, while_true(rest, continues_word)),
        _ if "~!@#$%^&*-=+|;:,<.>/?".contains(first) => (Kind::Mark, one),
        _ => (Kind::Unknown, one),
    }
}

fn while_true(rest: &str, belongs: impl Fn(char) -> bool) -> usize {
    rest.find(|c| !belongs(c)).unwrap_or(rest.len())
}

/// Returns true for blanks of Rust; the mark that some editors write at the beginning is one here.
fn is_blank(c: char) -> bool {
    c.is_whitespace() || matches!(c, '\u{200e}' | '\u{200f}' | '\u{feff}')
}

fn starts_word(c: char) -> bool {
    c == '_' || c.is_alphabetic()
}

fn continues_word(c: char) -> bool {
    // Combining marks, which belong to the letter before them, are no letters of their own.
    starts_word(c) || c.is_numeric() || ('\u{300}'..='\u{36f}').contains(&c)
}

fn line_comment(rest: &str) -> (Kind, usize) {
    let end = rest.find('\n').unwrap_or(rest.len());
    let end = rest[..end].trim_end_matches('\r').len();
    let is_documentation = rest.starts_with("///") && !rest.starts_with("////");
    let kind = match is_documentation || rest.starts_with("//!") {
        true => Kind::Documentation,
        false => Kind::Comment,
    };
    (kind, end)
}

fn block_comment(rest: &str) -> (Kind, usize) {
    let bytes = rest.as_bytes();
    let (mut depth, mut index) = (0, 0);
    while index + 1 < bytes.len() {
        match &bytes[index..index + 2] {
            b"/*" => {
                depth += 1;
                index += 2;
            }
            b"*/" => {
                depth -= 1;
                index += 2;
                if depth == 0 {
                    let is_documentation = rest.starts_with("/**") && !rest.starts_with("/***");
                    let kind = match is_documentation && index > 4 || rest.starts_with("/*!") {
                        true => Kind::Documentation,
                        false => Kind::Comment,
                    };
                    return (kind, index);
                }
            }
            _ => index += 1,
        }
    }
    (Kind::Unknown, rest.len())
}

fn string(rest: &str) -> (Kind, usize) {
    let mut escaped = false;
    for (index, c) in rest.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return (Kind::Text, index + 1),
            _ => {}
        }
    }
    (Kind::Unknown, rest.find('\n').unwrap_or(rest.len()))
}

fn raw_string(rest: &str) -> (Kind, usize) {
    let end = if rest.starts_with("r#") { "\"#" } else { "\"" };
    let start = 1 + end.len();
    match rest[start..].find(end) {
        Some(found) => (Kind::Text, start + found + end.len()),
        None => (Kind::Unknown, rest.find('\n').unwrap_or(rest.len())),
    }
}

/// A character, or the apostrophe of a lifetime.
fn character(rest: &str) -> (Kind, usize) {
    let mut inner = rest.char_indices().skip(1);
    let end = match inner.next() {
        Some((_, '\\')) => rest
            .get(3..)
            .and_then(|rest| rest.find('\''))
            .map(|end| 4 + end),
        Some((_, c)) if c != '\n' => {
            let end = 1 + c.len_utf8();
            rest[end..].starts_with('\'').then_some(end + 1)
        }
        _ => None,
    };
    match end {
        Some(end) => (Kind::Text, end),
        None => (Kind::Unknown, 1),
    }
}

/// Returns the length of a number with its unit: `30`, `1.5mm`, `2e-3m`, but `0` in `0..360deg`.
fn number(rest: &str) -> usize {
    let is_digit = |c: char| c.is_ascii_digit() || c == '_';
    let mut end = while_true(rest, is_digit);
    if let Some(fraction) = rest[end..].strip_prefix('.') {
        let next = fraction.chars().next();
        let is_member = next.is_some_and(|c| c == '.' || starts_word(c));
        if !is_member {
            end += 1 + while_true(fraction, is_digit);
        }
    }
    let power = &rest[end..];
    if power.starts_with(['e', 'E']) {
        let sign = usize::from(power[1..].starts_with(['+', '-']));
        let digits = while_true(&power[1 + sign..], is_digit);
        if power[1 + sign..].starts_with(|c: char| c.is_ascii_digit()) {
            end += 1 + sign + digits;
        }
    }
    end + while_true(&rest[end..], continues_word)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<(Kind, &str)> {
        let all = tokens(text);
        let end = all.iter().fold(0, |end, token| {
            assert_eq!(token.range.start, end, "no gaps");
            token.range.end
        });
        assert_eq!(end, text.len());
        let solid = all.iter().filter(|token| token.kind != Kind::Blank);
        solid.map(|token| (token.kind, token.text(text))).collect()
    }

    #[test]
    fn numbers_end_before_ranges_and_members() {
        let texts: Vec<&str> = kinds("0..360deg 1.5e-3m 2.mm 3.x 1e 4_0.0..5")
            .into_iter()
            .filter_map(|(kind, text)| (kind == Kind::Number).then_some(text))
            .collect();
        assert_eq!(
            texts,
            ["0", "360deg", "1.5e-3m", "2", "3", "1e", "4_0.0", "5"]
        );
    }

    #[test]
    fn comments_are_tokens() {
        let text = "/// a\n// b\n//// c\n/** d */ /* e /* f */ */ g";
        let found: Vec<Kind> = kinds(text).into_iter().map(|(kind, _)| kind).collect();
        let expected = [
            Kind::Documentation,
            Kind::Comment,
            Kind::Comment,
            Kind::Documentation,
            Kind::Comment,
            Kind::Word,
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn tokens_without_an_end_are_unknown() {
        for text in ["/* a", "\"a", "'", "\\", "°", "r#\"a"] {
            assert_eq!(kinds(text)[0].0, Kind::Unknown, "{text}");
        }
    }
}
