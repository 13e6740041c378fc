//! Tokens and comments of a Rust file, with their lines.
//!
//! This lexer is fast without optimisation, and it keeps comments, which `proc-macro2` drops.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// An identifier or a keyword.
    Word,
    /// A bracket or punctuation; `::`, `->`, `=>` and `..` are one sign.
    Sign,
    /// A number, a text, a character or a lifetime.
    Other,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct Token<'t> {
    pub(crate) kind: Kind,
    pub(crate) text: &'t str,
    pub(crate) line: usize,
}

impl Token<'_> {
    pub(crate) fn is(&self, text: &str) -> bool {
        self.kind != Kind::Other && self.text == text
    }

    pub(crate) fn is_word(&self) -> bool {
        self.kind == Kind::Word
    }
}

/// A comment up to the end of its line, or a block.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Comment<'t> {
    /// The text with its slashes.
    pub(crate) text: &'t str,
    pub(crate) line: usize,
    /// The number of letters before it in its line.
    pub(crate) column: usize,
}

#[derive(Debug, Default)]
pub(crate) struct Lexed<'t> {
    pub(crate) tokens: Vec<Token<'t>>,
    pub(crate) comments: Vec<Comment<'t>>,
    /// The token that closes what a token opens.
    partners: Vec<usize>,
}

impl Lexed<'_> {
    /// The index of the bracket that closes the one at an index; the index itself for other tokens.
    pub(crate) fn partner(&self, index: usize) -> usize {
        self.partners[index]
    }
}

const JOINED: [&str; 4] = ["::", "->", "=>", ".."];

pub(crate) fn lexed(text: &str) -> Lexed<'_> {
    let bytes = text.as_bytes();
    let mut lexed = Lexed::default();
    let (mut index, mut line, mut line_start) = (0, 1, 0);
    while index < bytes.len() {
        let start = index;
        let kind = match bytes[index] {
            b'\n' => {
                (index, line) = (index + 1, line + 1);
                line_start = index;
                continue;
            }
            letter if letter.is_ascii_whitespace() => {
                index += 1;
                continue;
            }
            b'/' if matches!(bytes.get(index + 1), Some(b'/' | b'*')) => {
                index = end_of_comment(bytes, index);
                lexed.comments.push(Comment {
                    text: &text[start..index],
                    line,
                    column: text[line_start..start].chars().count(),
                });
                line += newlines(&bytes[start..index]);
                continue;
            }
            b'"' => {
                index = end_of_string(bytes, index);
                Kind::Other
            }
            b'\'' => {
                index = end_of_character(text, index);
                Kind::Other
            }
            letter if letter.is_ascii_digit() => {
                index = end_of_number(bytes, index);
                Kind::Other
            }
            letter if is_of_word(letter) => {
                index = end_of_word(bytes, index);
                match (&text[start..index], bytes.get(index)) {
                    ("r" | "br" | "cr", Some(b'"' | b'#')) => {
                        if let Some(end) = end_of_raw(bytes, index) {
                            index = end;
                            Kind::Other
                        } else {
                            // A raw identifier: the word follows.
                            index += 1;
                            continue;
                        }
                    }
                    ("b" | "c", Some(b'"')) => {
                        index = end_of_string(bytes, index);
                        Kind::Other
                    }
                    ("b", Some(b'\'')) => {
                        index = end_of_character(text, index);
                        Kind::Other
                    }
                    _ => Kind::Word,
                }
            }
            _ => {
                let rest = &text[index..];
                let joined = JOINED.iter().any(|sign| rest.starts_with(sign));
                index += if joined { 2 } else { 1 };
                Kind::Sign
            }
        };
        let text = &text[start..index];
        lexed.tokens.push(Token { kind, text, line });
        line += newlines(&bytes[start..index]);
        // Only texts have several lines; what follows in the last one is seldom a comment.
        if kind == Kind::Other
            && let Some(last) = text.rfind('\n')
        {
            line_start = start + last + 1;
        }
    }
    lexed.partners = partners(&lexed.tokens);
    lexed
}

fn partners(tokens: &[Token]) -> Vec<usize> {
    let mut partners: Vec<usize> = (0..tokens.len()).collect();
    let mut open = Vec::new();
    for (index, token) in tokens.iter().enumerate() {
        if token.kind != Kind::Sign {
            continue;
        }
        match token.text {
            "(" | "[" | "{" => open.push(index),
            ")" | "]" | "}" => {
                if let Some(start) = open.pop() {
                    partners[start] = index;
                }
            }
            _ => {}
        }
    }
    // A bracket that nothing closes reaches to the end.
    for start in open {
        partners[start] = tokens.len().saturating_sub(1);
    }
    partners
}

fn newlines(bytes: &[u8]) -> usize {
    bytes.iter().filter(|byte| **byte == b'\n').count()
}

/// Letters beyond ASCII are taken for letters of a word.
fn is_of_word(letter: u8) -> bool {
    letter.is_ascii_alphanumeric() || letter == b'_' || !letter.is_ascii()
}

fn end_of_word(bytes: &[u8], mut index: usize) -> usize {
    while index < bytes.len() && is_of_word(bytes[index]) {
        index += 1;
    }
    index
}

fn end_of_number(bytes: &[u8], index: usize) -> usize {
    let end = end_of_word(bytes, index);
    // A point belongs to it if a digit follows: not that of a range or of a method.
    let is_point = bytes.get(end) == Some(&b'.');
    if is_point && bytes.get(end + 1).is_some_and(u8::is_ascii_digit) {
        return end_of_word(bytes, end + 1);
    }
    end
}

fn end_of_comment(bytes: &[u8], start: usize) -> usize {
    let mut index = start;
    if bytes[start + 1] == b'/' {
        while index < bytes.len() && bytes[index] != b'\n' {
            index += 1;
        }
        return index;
    }
    let mut depth = 0;
    while index < bytes.len() {
        if bytes[index..].starts_with(b"/*") {
            (depth, index) = (depth + 1, index + 2);
        } else if bytes[index..].starts_with(b"*/") {
            (depth, index) = (depth - 1, index + 2);
            if depth == 0 {
                break;
            }
        } else {
            index += 1;
        }
    }
    index
}

fn end_of_string(bytes: &[u8], start: usize) -> usize {
    let mut index = start + 1;
    while index < bytes.len() {
        match bytes[index] {
            b'\\' => index += 2,
            b'"' => return index + 1,
            _ => index += 1,
        }
    }
    bytes.len()
}

/// The end of a raw string whose `#` or quote is at an index; none for a raw identifier.
fn end_of_raw(bytes: &[u8], start: usize) -> Option<usize> {
    let mut quote = start;
    while bytes.get(quote) == Some(&b'#') {
        quote += 1;
    }
    if bytes.get(quote) != Some(&b'"') {
        return None;
    }
    let hashes = &bytes[start..quote];
    let mut index = quote + 1;
    while index < bytes.len() {
        if bytes[index] == b'"' && bytes[index + 1..].starts_with(hashes) {
            return Some(index + 1 + hashes.len());
        }
        index += 1;
    }
    Some(bytes.len())
}

/// The end of a character or of a lifetime.
fn end_of_character(text: &str, start: usize) -> usize {
    let bytes = text.as_bytes();
    if bytes.get(start + 1) == Some(&b'\\') {
        let mut index = start + 3;
        while index < bytes.len() && bytes[index] != b'\'' {
            index += 1;
        }
        return index + 1;
    }
    let mut letters = text[start + 1..].char_indices().skip(1);
    match letters.next() {
        Some((length, '\'')) => start + 1 + length + 1,
        _ => end_of_word(bytes, start + 1),
    }
}

fn words(text: &str) -> Vec<&str> {
    lexed(text).tokens.iter().map(|token| token.text).collect()
}

#[test]
fn texts_and_lifetimes_are_no_words() {
    assert_eq!(
        words(r##"f('a', '\'', "x\"y", r#"a "b" c"#, b"z")"##),
        [
            "f",
            "(",
            "'a'",
            ",",
            r"'\''",
            ",",
            r#""x\"y""#,
            ",",
            r##"r#"a "b" c"#"##,
            ",",
            r#"b"z""#,
            ")"
        ]
    );
    assert_eq!(
        words("fn f<'a>(r#in: &'a T) -> 1.5..x.0"),
        [
            "fn", "f", "<", "'a", ">", "(", "in", ":", "&", "'a", "T", ")", "->", "1.5", "..", "x",
            ".", "0"
        ]
    );
}

#[test]
fn comments_have_lines_and_columns() {
    let lexed = lexed("//! ä\nlet x = 1; // one\n/* two /* in */\n it */ y");
    let found: Vec<_> = lexed
        .comments
        .iter()
        .map(|comment| (comment.line, comment.column, comment.text))
        .collect();
    assert_eq!(
        found,
        [
            (1, 0, "//! ä"),
            (2, 11, "// one"),
            (3, 0, "/* two /* in */\n it */"),
        ]
    );
    assert_eq!(lexed.tokens.last().map(|token| token.line), Some(4));
}
