//! Comments in lines of one width.

use crate::names::in_comment;

/// The width of comments.
pub(crate) const COLUMNS: usize = 100;

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
