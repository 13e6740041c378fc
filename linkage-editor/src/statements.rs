//! Items of blocks, and the comments that belong to them.

use std::ops::Range;

use linkage_language::syntax::{ItemWord, Word};

use crate::lexer::{Kind, Token};

/// Returns the items of a block: from the first token to the last one before the separator. Items
/// begin at the words of items, too, where the separator of the item before is missing.
pub(crate) fn statements(
    text: &str,
    tokens: &[Token],
    block: &Range<usize>,
    separator: char,
) -> Vec<Range<usize>> {
    let mut found = Vec::new();
    let mut item: Option<Range<usize>> = None;
    let mut depth = 0;
    let first = tokens.partition_point(|token| token.range.start < block.start);
    let inside = tokens[first..].iter();
    let inside = inside.take_while(|token| token.range.end <= block.end);
    for token in inside.filter(|token| !token.is_trivia()) {
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close => depth -= 1,
            _ => {}
        }
        if separator == ';' && begins_item(text, token) {
            found.extend(item.take());
            depth = 0;
        }
        let is_separator = token.kind == Kind::Mark && token.text(text).starts_with(separator);
        let is_unclosed = separator == ';' && is_separator;
        if is_separator && (depth <= 0 || is_unclosed) {
            found.extend(item.take());
            depth = 0;
        } else {
            let start = item.map_or(token.range.start, |item| item.start);
            item = Some(start..token.range.end);
        }
    }
    found.extend(item);
    found
}

/// Returns true for the word of an item at the beginning of a line.
pub(crate) fn begins_item(text: &str, token: &Token) -> bool {
    let before = text[..token.range.start].trim_end_matches([' ', '\t']);
    let begins_line = before.is_empty() || before.ends_with(['\n', '\r']);
    let is_word = token.kind == Kind::Word && begins_line;
    is_word && ItemWord::from_word(token.text(text)).is_some()
}

/// Returns the text of the doc comment before an item, or else of the comment after it on its line.
pub(crate) fn documentation(text: &str, tokens: &[Token], item: Range<usize>) -> String {
    let first = tokens.partition_point(|token| token.range.start < item.start);
    let mut lines: Vec<&str> = Vec::new();
    for token in tokens[..first].iter().rev() {
        match token.kind {
            Kind::Documentation => lines.push(content(token.text(text))),
            Kind::Blank => {}
            // Visibility stands between the comment and the word of the item.
            Kind::Word if token.text(text) == "pub" => {}
            _ => break,
        }
    }
    if lines.is_empty() && !item.is_empty() {
        lines.extend(comment_after(text, tokens, item.end));
    }
    lines.reverse();
    lines.join("\n")
}

/// Returns the comment behind an item on the line on which it ends.
fn comment_after<'t>(text: &'t str, tokens: &[Token], end: usize) -> Option<&'t str> {
    let next = tokens.partition_point(|token| token.range.start < end);
    for token in &tokens[next..] {
        let written = token.text(text);
        match token.kind {
            Kind::Mark if matches!(written, ";" | ",") => {}
            Kind::Blank if !written.contains('\n') => {}
            Kind::Comment => return Some(content(written)),
            _ => return None,
        }
    }
    None
}

/// Returns a comment without its marks.
fn content(comment: &str) -> &str {
    let inner = comment
        .strip_prefix("/*")
        .and_then(|inner| inner.strip_suffix("*/"))
        .unwrap_or_else(|| comment.trim_start_matches('/'));
    inner.trim_start_matches(['*', '!']).trim()
}
