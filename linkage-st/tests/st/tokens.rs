//! Words, numbers and signs of structured text.

/// A word, a number or a sign.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Token {
    /// A name or a keyword, in small letters: the language does not distinguish letters.
    Word(String),
    /// `LREAL#1.5`
    Real(f64),
    /// `12`
    Integer(i64),
    /// `:=`, `(`
    Sign(&'static str),
}

/// Signs, the longer ones first.
const SIGNS: [&str; 20] = [
    ":=", "<=", ">=", "<>", "..", "(", ")", "[", "]", ",", ";", ":", ".", "+", "-", "*", "/", "<",
    ">", "=",
];

/// All tokens of a text, without its comments.
pub(crate) fn tokens(text: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        if let Some(comment) = rest.strip_prefix("(*") {
            let end = comment.find("*)").expect("a comment ends");
            assert!(!comment[..end].contains("(*"), "comments are not nested");
            rest = comment[end + 2..].trim_start();
            continue;
        }
        let length = if let Some(number) = rest.strip_prefix("LREAL#") {
            let length = number_length(number);
            tokens.push(Token::Real(real(&number[..length])));
            length + 6
        } else if first.is_ascii_digit() {
            let length = length(rest, |c| c.is_ascii_digit());
            tokens.push(Token::Integer(rest[..length].parse().expect("digits")));
            length
        } else if first.is_ascii_alphabetic() || first == '_' {
            let length = length(rest, |c| c.is_ascii_alphanumeric() || c == '_');
            let word = &rest[..length];
            assert!(!word.contains("__") && !word.ends_with('_'), "{word}");
            tokens.push(Token::Word(word.to_ascii_lowercase()));
            length
        } else {
            let sign = SIGNS.iter().find(|sign| rest.starts_with(**sign));
            let sign = sign.unwrap_or_else(|| panic!("no token: {}", &rest[..rest.len().min(40)]));
            tokens.push(Token::Sign(sign));
            sign.len()
        };
        rest = rest[length..].trim_start();
    }
    tokens
}

fn length(text: &str, is_part: impl Fn(char) -> bool) -> usize {
    text.find(|c| !is_part(c)).unwrap_or(text.len())
}

/// The length of a real literal: digits, a point, digits, and an exponent.
fn number_length(text: &str) -> usize {
    let digits = |from: usize| from + length(&text[from..], |c| c.is_ascii_digit());
    let point = digits(0);
    assert!(
        point > 0 && text[point..].starts_with('.'),
        "a real number has a point"
    );
    let end = digits(point + 1);
    assert!(end > point + 1, "digits follow the point");
    let Some(exponent) = text[end..].strip_prefix('E') else {
        return end;
    };
    let sign = usize::from(exponent.starts_with(['+', '-']));
    let last = digits(end + 1 + sign);
    assert!(last > end + 1 + sign, "an exponent has digits");
    last
}

fn real(text: &str) -> f64 {
    let number: f64 = text.parse().expect("a real number");
    assert!(number.is_finite(), "{text}");
    number
}
