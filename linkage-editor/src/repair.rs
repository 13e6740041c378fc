//! Texts that are no sequence of tokens, made one: the compiler reads nothing else.
//!
//! A text that is being written has brackets without partners. Every byte before the end stays where
//! it is, so that places in the repaired text are places in the text.

use std::ops::Range;

use proc_macro2::{Literal, TokenStream};

use crate::lexer::{Kind, Token};

/// Returns the text if it is a sequence of tokens, or else a similar one: characters without a
/// meaning and brackets without partners become blanks, missing braces follow at the end. `None` if
/// that is no sequence of tokens either.
pub(crate) fn readable(text: &str, tokens: &[Token]) -> Option<String> {
    let mut bytes = text.as_bytes().to_vec();
    for token in tokens.iter().filter(|token| is_unreadable(text, token)) {
        blank(&mut bytes, &token.range);
    }
    let open = balance(text, tokens, &mut bytes);
    bytes.extend(std::iter::repeat_n(b'}', open));
    let repaired = String::from_utf8(bytes).ok()?;
    repaired.parse::<TokenStream>().ok()?;
    Some(repaired)
}

/// Returns true for a token that the compiler cannot read.
fn is_unreadable(text: &str, token: &Token) -> bool {
    match token.kind {
        Kind::Unknown => true,
        Kind::Number | Kind::Text => token.text(text).parse::<Literal>().is_err(),
        Kind::Word => syn_word(token.text(text)).is_none(),
        Kind::Blank
        | Kind::Comment
        | Kind::Documentation
        | Kind::Open
        | Kind::Close
        | Kind::Mark => false,
    }
}

/// Reads a word alone; letters of some scripts are in no name of Rust.
fn syn_word(word: &str) -> Option<TokenStream> {
    word.parse().ok()
}

fn blank(bytes: &mut [u8], range: &Range<usize>) {
    bytes[range.clone()].fill(b' ');
}

/// Removes brackets without partners. Returns the number of braces that are open at the end.
fn balance(text: &str, tokens: &[Token], bytes: &mut [u8]) -> usize {
    let mut open: Vec<&Token> = Vec::new();
    for token in tokens {
        match token.kind {
            Kind::Open => open.push(token),
            Kind::Close => {
                let wanted = partner(token.text(text));
                match open.iter().rposition(|open| open.text(text) == wanted) {
                    Some(found) => {
                        open.drain(found + 1..)
                            .for_each(|lone| blank(bytes, &lone.range));
                        open.pop();
                    }
                    None => blank(bytes, &token.range),
                }
            }
            // In parentheses there is no semicolon.
            Kind::Mark if token.text(text) == ";" => {
                while open.last().is_some_and(|open| open.text(text) != "{") {
                    open.pop()
                        .into_iter()
                        .for_each(|lone| blank(bytes, &lone.range));
                }
            }
            // A block begins within no other one.
            Kind::Word if matches!(token.text(text), "struct" | "impl") => {
                let lone = open.iter().filter(|open| open.text(text) != "{");
                lone.for_each(|lone| blank(bytes, &lone.range));
                open.retain(|open| open.text(text) == "{");
                if close_before(text, tokens, token, bytes, open.len()) {
                    open.clear();
                }
            }
            _ => {}
        }
    }
    let (braces, lone): (Vec<&Token>, _) =
        open.into_iter().partition(|open| open.text(text) == "{");
    lone.into_iter().for_each(|lone| blank(bytes, &lone.range));
    braces.len()
}

fn partner(close: &str) -> &'static str {
    match close {
        ")" => "(",
        "]" => "[",
        _ => "{",
    }
}

/// Writes this number of closing braces into the blanks before an item, its visibility and comments.
/// Returns false if there are too few.
fn close_before(
    text: &str,
    tokens: &[Token],
    item: &Token,
    bytes: &mut [u8],
    count: usize,
) -> bool {
    let end = tokens.partition_point(|token| token.range.start < item.range.start);
    let before = tokens[..end].iter().rev();
    let belongs = |token: &&Token| match token.kind {
        Kind::Blank | Kind::Documentation => true,
        Kind::Word => token.text(text) == "pub",
        _ => false,
    };
    let blanks = before
        .take_while(belongs)
        .filter(|token| token.kind == Kind::Blank);
    // The end of a line ends a comment, so it stays.
    let widest = blanks.max_by_key(|token| token.range.len());
    let Some(widest) = widest.filter(|token| token.range.len() > count) else {
        return false;
    };
    let is_ascii = widest.text(text).is_ascii();
    if is_ascii {
        bytes[widest.range.end - count..widest.range.end].fill(b'}');
    }
    is_ascii
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lexer::tokens;

    fn repaired(text: &str) -> String {
        readable(text, &tokens(text)).expect("it can be read")
    }

    #[test]
    fn places_stay() {
        for (text, expected) in [
            (
                "struct A { let a = (1; let b = 2;",
                "struct A { let a =  1; let b = 2;}",
            ),
            ("struct A { ) } }", "struct A {   }  "),
            ("struct A { 2° \"x }", "struct A { 2       }"),
            ("struct A {\n\n\nimpl A { }", "struct A {\n\n}impl A { }"),
        ] {
            let found = repaired(text);
            assert_eq!(&found, expected, "{text}");
        }
    }
}
