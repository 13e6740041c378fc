//! Comments in lines of one width.

use crate::names::in_comment;

/// The width of comments.
const COLUMNS: usize = 100;

/// Adds a comment in lines of the width. Lines after the first one are indented.
pub(crate) fn comment(text: &mut String, start: &str, words: &str) {
    let mut line = start.to_owned();
    let mut is_empty = true;
    for word in words.split_whitespace() {
        if !is_empty && line.chars().count() + 1 + word.chars().count() > COLUMNS {
            text.push_str(&line);
            text.push('\n');
            line = start.replace('-', " ");
            is_empty = true;
        }
        if !is_empty {
            line.push(' ');
        }
        line.push_str(word);
        is_empty = false;
    }
    text.push_str(line.trim_end());
    text.push('\n');
}

/// Adds all warnings as a list.
pub(crate) fn warnings_as_comments(text: &mut String, warnings: &[String]) {
    if !warnings.is_empty() {
        text.push_str("//\n// Not taken, or to be confirmed:\n");
    }
    for warning in warnings {
        comment(text, "// - ", &in_comment(warning));
    }
}

/// Adds an item in lines of the width. They break after commas that are in so many brackets at most.
/// Lines after the first one are indented once more.
pub(crate) fn item(text: &mut String, indent: usize, item: &str, brackets: usize) {
    let mut line = " ".repeat(indent);
    let mut is_empty = true;
    for piece in pieces(item, brackets) {
        if !is_empty && line.len() + piece.trim_end().len() > COLUMNS {
            text.push_str(line.trim_end());
            text.push('\n');
            line = " ".repeat(indent + 4);
        }
        line.push_str(piece);
        is_empty = false;
    }
    text.push_str(line.trim_end());
    text.push('\n');
}

/// Splits an item after its commas in so many brackets at most. A comment is one piece.
fn pieces(item: &str, brackets: usize) -> Vec<&str> {
    let mut pieces = Vec::new();
    let mut start = 0;
    let mut depth = 0;
    let end = item.find("//").unwrap_or(item.len());
    for (index, letter) in item[..end].char_indices() {
        match letter {
            '(' | '[' => depth += 1,
            ')' | ']' => depth -= 1,
            ',' if depth <= brackets && item[index..].starts_with(", ") => {
                pieces.push(&item[start..index + 2]);
                start = index + 2;
            }
            _ => {}
        }
    }
    pieces.push(&item[start..]);
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_break_after_commas_outside_of_brackets() {
        let mut text = String::new();
        let point = "(1234567890mm, 1234567890mm)";
        item(
            &mut text,
            4,
            &format!("body a = pin, at {point}, mass {point}, inertia {point};"),
            0,
        );
        let wanted =
            format!("    body a = pin, at {point}, mass {point},\n        inertia {point};\n");
        assert_eq!(text, wanted);
        let short = "link a: b, c;    // a comment, which is longer than a line, but is not broken, at all, at all";
        let mut text = String::new();
        item(&mut text, 4, short, 0);
        assert_eq!(text, format!("    {short}\n"));
    }
}
