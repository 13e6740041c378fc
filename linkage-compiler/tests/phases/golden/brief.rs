//! Generated items for reading: without what stands in another golden file or before every item.
//!
//! - `5-lower` shows the statements of programs. Here their number stands for them, with a check sum: it tells a change of how they are printed.
//! - Of many statements or elements that differ in numbers only, the first is printed, and how many more there are, with a check sum.
//! - Items and methods that `crank_rocker` has, too, are shown there only: here their number stands for them, with a check sum.
//! - What silences lints is printed once. An item outside of other items without it is marked as `#[loud]`.
//! - The items of the block around generated code follow it, with their number in its place.
//! - Macros that depend on features become an attribute of the first item within, with the number of items: the printer leaves
//!   bodies of macros as they are.

use proc_macro2::{Delimiter, Group, Literal, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{File, Item, parse_quote};

use super::features::{attributes, content, opened, unwrapped};
use super::sample::Sample;

/// The items as text; those that a `sample` of another mechanism has, too, are only counted.
pub(super) fn brief(items: &TokenStream, sample: Option<&Sample>) -> String {
    let mut file = opened_file(items);
    if let Some(sample) = sample {
        sample.leave_out(&mut file);
    }
    prettyplease::unparse(&file)
}

/// The items as those of a file.
pub(super) fn opened_file(items: &TokenStream) -> File {
    let mut file: File =
        syn::parse2(shortened(items.clone(), Delimiter::Brace)).expect("it is Rust");
    file.items = file.items.into_iter().flat_map(unwrapped).collect();
    let mut all = file
        .items
        .iter_mut()
        .flat_map(|item| attributes(item).iter());
    let silence = all.find(|attribute| attribute.path().is_ident("allow"));
    let silence = silence
        .expect("generated items silence lints")
        .to_token_stream();
    quieten(&mut file.items, &silence.to_string(), true);
    file.items = file.items.into_iter().flat_map(opened).collect();
    let once: Item = parse_quote!(#silence mod every_item {});
    file.items.insert(0, once);
    file
}

/// Takes what silences lints from all items and from those of modules; those of the `outermost` must have it.
fn quieten(items: &mut [Item], silence: &str, outermost: bool) {
    for item in items {
        let attributes = attributes(item);
        let place = attributes
            .iter()
            .position(|a| a.to_token_stream().to_string() == silence);
        match place {
            Some(place) => drop(attributes.remove(place)),
            None if outermost => attributes.insert(0, parse_quote!(#[loud])),
            None => {}
        }
        if let Item::Mod(module) = item {
            quieten(content(module), silence, false);
        }
    }
}

/// Runs of statements or elements become short, at every depth.
fn shortened(tokens: TokenStream, delimiter: Delimiter) -> TokenStream {
    let mut out = TokenStream::new();
    let mut run = Run::default();
    for part in parts(tokens, delimiter) {
        if run.kind != kind(&part) {
            std::mem::take(&mut run).finish(&mut out);
            run.kind = kind(&part);
        }
        run.parts.push(part);
    }
    run.finish(&mut out);
    out
}

/// Cuts a body behind every semicolon and block, a list behind every comma.
fn parts(tokens: TokenStream, delimiter: Delimiter) -> Vec<Vec<TokenTree>> {
    let body = delimiter == Delimiter::Brace;
    let end = if body { ';' } else { ',' };
    let mut parts = vec![Vec::new()];
    for token in tokens {
        let ends = match &token {
            TokenTree::Punct(punct) => punct.as_char() == end,
            TokenTree::Group(group) => body && group.delimiter() == Delimiter::Brace,
            _ => false,
        };
        parts.last_mut().expect("there is one").push(token);
        if ends {
            parts.push(Vec::new());
        }
    }
    parts
}

/// What neighbours must have in common to be printed together.
#[derive(Default, PartialEq)]
enum Kind {
    #[default]
    Other,
    /// It sets temporaries of a program.
    Statement,
    /// It speaks of the generated code's own names: this text, with every number as `0`.
    Like(String),
}

fn kind(part: &[TokenTree]) -> Kind {
    if is_statement(part) {
        return Kind::Statement;
    }
    let text = text(part);
    let text = text.trim_end_matches([' ', ',']);
    // What ends with a block may be an arm of a match, and what begins with attributes has docs.
    match text.contains("__") && !text.ends_with('}') && !text.starts_with('#') {
        true => Kind::Like(without_numbers(text)),
        false => Kind::Other,
    }
}

fn text(part: &[TokenTree]) -> String {
    part.iter().cloned().collect::<TokenStream>().to_string()
}

fn without_numbers(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c.is_ascii_digit() {
            true if out.ends_with('0') => {}
            true => out.push('0'),
            false => out.push(c),
        }
    }
    out
}

/// Does it set temporaries: one, a sine and its cosine, or several that are only declared?
fn is_statement(part: &[TokenTree]) -> bool {
    let (target, rest) = match part {
        [first, target, rest @ ..] if first.to_string() == "let" => (target, rest),
        [target, rest @ ..] => (target, rest),
        [] => return false,
    };
    let temporary = |token: &TokenTree| {
        let name = token.to_string();
        let number = name.strip_prefix("__v").map(str::parse::<usize>);
        matches!(number, Some(Ok(_)))
    };
    let listed = |token: TokenTree| {
        temporary(&token) || token.to_string() == "_" || token.to_string() == ","
    };
    let targets = match target {
        TokenTree::Group(group) => group.stream().into_iter().all(listed),
        token => temporary(token),
    };
    let sets = |token: &TokenTree| matches!(token.to_string().as_str(), "=" | ";");
    targets && rest.first().is_some_and(sets)
}

/// Neighbours of one kind.
#[derive(Default)]
struct Run {
    kind: Kind,
    parts: Vec<Vec<TokenTree>>,
}

/// So many of a kind are worth a line that says how many there are.
const MANY: usize = 4;

impl Run {
    fn finish(self, out: &mut TokenStream) {
        let shown = match self.kind {
            Kind::Statement => 0,
            Kind::Like(_) if self.parts.len() >= MANY => 1,
            _ => self.parts.len(),
        };
        let (shown, rest) = self.parts.split_at(shown);
        out.extend(shown.iter().flatten().cloned().map(within));
        let Some(last) = rest.last() else { return };
        let number = Literal::usize_unsuffixed(rest.len());
        let sum = format!("{:08x}", sum(&text(&rest.concat())));
        out.extend(match self.kind {
            Kind::Statement => quote!(statements!(#number, #sum)),
            _ => quote!(more!(#number, #sum)),
        });
        if let Some(TokenTree::Punct(end)) = last.last()
            && matches!(end.as_char(), ';' | ',')
        {
            out.extend([TokenTree::Punct(end.clone())]);
        }
    }
}

/// The same inside of a group.
fn within(token: TokenTree) -> TokenTree {
    match token {
        TokenTree::Group(group) => {
            let inner = shortened(group.stream(), group.delimiter());
            TokenTree::Group(Group::new(group.delimiter(), inner))
        }
        other => other,
    }
}

/// FNV-1a with 32 bits: the same on every machine and with every compiler.
pub(super) fn sum(text: &str) -> u32 {
    text.bytes().fold(0x811c_9dc5, |sum, byte| {
        (sum ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}
