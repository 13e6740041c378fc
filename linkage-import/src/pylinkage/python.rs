//! A dictionary as Python prints it, with the spelling of JSON.

/// Replaces quotes, tuples and the words of Python. Other texts become JSON that is broken.
pub(super) fn as_json(text: &str) -> String {
    let mut json = String::with_capacity(text.len() + 16);
    let mut letters = text.chars().peekable();
    while let Some(letter) = letters.next() {
        if letter.is_ascii_alphanumeric() || letter == '_' {
            let mut word = letter.to_string();
            let is_in_word = |next: &char| next.is_ascii_alphanumeric() || "_.".contains(*next);
            while let Some(next) = letters.next_if(is_in_word) {
                word.push(next);
            }
            json.push_str(match &word[..] {
                "None" => "null",
                "True" => "true",
                "False" => "false",
                other => other,
            });
            continue;
        }
        match letter {
            '\'' | '"' => quoted(letter, &mut letters, &mut json),
            '(' => json.push('['),
            ')' => json.push(']'),
            // JSON has no comma in front of a closing bracket.
            ',' => {
                let mut rest = letters.clone().skip_while(|next| next.is_whitespace());
                if !matches!(rest.next(), Some(')' | ']' | '}')) {
                    json.push(',');
                }
            }
            other => json.push(other),
        }
    }
    json
}

fn quoted(quote: char, letters: &mut impl Iterator<Item = char>, json: &mut String) {
    json.push('"');
    while let Some(letter) = letters.next() {
        match letter {
            '\\' => match letters.next() {
                Some('\'') => json.push('\''),
                Some(next) => {
                    json.push('\\');
                    json.push(next);
                }
                None => {}
            },
            '"' if quote == '\'' => json.push_str("\\\""),
            other if other == quote => break,
            other => json.push(other),
        }
    }
    json.push('"');
}
