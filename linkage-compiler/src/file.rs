//! Several mechanisms in one text.

use proc_macro2::{Delimiter, TokenStream, TokenTree};

/// The mechanisms of a text, each as [`check`](crate::check) takes it. A mechanism begins with its struct block, attributes and visibility
/// included, and ends before that of the next one; what stands before the first belongs to it. A text without any is one, so that it is told
/// what is missing.
///
/// ```
/// use linkage_compiler::mechanisms;
///
/// let text = "struct A {} impl A {} /// Another one. \n pub(crate) struct B {} impl B {}";
/// let parts = mechanisms(text.parse().expect("brackets have partners"));
/// assert_eq!(parts.len(), 2);
/// assert!(parts[1].to_string().ends_with("pub (crate) struct B { } impl B { }"));
/// ```
pub fn mechanisms(text: TokenStream) -> Vec<TokenStream> {
    let tokens: Vec<TokenTree> = text.into_iter().collect();
    let structs = (0..tokens.len()).filter(|&at| is_word(&tokens[at], "struct"));
    let mut starts: Vec<usize> = structs.map(|at| start(&tokens, at)).collect();
    match starts.first_mut() {
        Some(first) => *first = 0,
        None => starts.push(0),
    }
    let ends = starts.iter().skip(1).copied().chain([tokens.len()]);
    let pairs = starts.iter().zip(ends);
    pairs
        .map(|(&start, end)| tokens[start..end].iter().cloned().collect())
        .collect()
}

/// Where the attributes and the visibility of a struct block begin.
fn start(tokens: &[TokenTree], word: usize) -> usize {
    let mut start = word;
    if start > 0 && is_group(&tokens[start - 1], Delimiter::Parenthesis) {
        start -= 1;
    }
    match start > 0 && is_word(&tokens[start - 1], "pub") {
        true => start -= 1,
        false => start = word,
    }
    while start > 1
        && is_group(&tokens[start - 1], Delimiter::Bracket)
        && matches!(&tokens[start - 2], TokenTree::Punct(own) if own.as_char() == '#')
    {
        start -= 2;
    }
    start
}

fn is_word(token: &TokenTree, word: &str) -> bool {
    matches!(token, TokenTree::Ident(own) if own == word)
}

fn is_group(token: &TokenTree, delimiter: Delimiter) -> bool {
    matches!(token, TokenTree::Group(own) if own.delimiter() == delimiter)
}
