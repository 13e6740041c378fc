//! Items that are written into a struct block.

use crate::diagnostics::Edit;
use crate::lexer::{Kind, Token};
use crate::outline::Outline;
use crate::statements::statements;

/// Returns the byte before which an item is inserted: that of the item of the struct block around a
/// byte, or of its last one, with its doc comment.
pub(crate) fn item_at(
    text: &str,
    tokens: &[Token],
    outline: &Outline,
    offset: usize,
) -> Option<usize> {
    let items = statements(text, tokens, &outline.body, ';');
    let around = items
        .iter()
        .find(|item| item.start <= offset && offset <= item.end);
    let start = around.or(items.last())?.start;
    Some(before_documentation(tokens, start))
}

/// Returns the beginning of the doc comment directly before an item, or of the item.
fn before_documentation(tokens: &[Token], start: usize) -> usize {
    let first = tokens.partition_point(|token| token.range.start < start);
    let before = tokens[..first].iter().rev();
    let before = before.take_while(|token| matches!(token.kind, Kind::Blank | Kind::Documentation));
    let comments = before.filter(|token| token.kind == Kind::Documentation);
    comments.last().map_or(start, |token| token.range.start)
}

/// Writes an item on a line before the item that begins at a byte.
pub(crate) fn insertion(text: &str, location: usize, item: &str) -> Edit {
    let line = text[..location].rfind('\n').map_or(0, |end| end + 1);
    let indent = &text[line..location];
    let is_blank = indent.chars().all(char::is_whitespace);
    Edit {
        range: location..location,
        text: match is_blank {
            true => format!("{item}\n{indent}"),
            false => format!("{item} "),
        },
    }
}
