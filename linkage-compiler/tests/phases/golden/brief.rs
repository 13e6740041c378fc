//! Generated items for reading: without what stands in another golden file or before every item.
//!
//! - `5-lower` shows the statements of programs. Here their number stands for them, with a check sum: it tells a change of how they are printed.
//! - Of many statements or elements that differ in numbers only, the first is printed, and how many more there are, with a check sum.
//! - What silences lints is printed once. An item outside of other items without it is marked as `#[loud]`.
//! - Macros that depend on features become an attribute of the first item within, with the number of items: the printer leaves
//!   bodies of macros as they are.

use proc_macro2::{Delimiter, Group, Ident, Literal, TokenStream, TokenTree};
use quote::{ToTokens, quote};
use syn::{
    Attribute, Expr, File, ImplItem, Item, ItemImpl, ItemMacro, ItemMod, Path, Stmt, parse_quote,
};

/// The items as text.
pub(super) fn brief(items: &TokenStream) -> String {
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
    let once: File = parse_quote!(#silence mod every_item {});
    prettyplease::unparse(&once) + &prettyplease::unparse(&file)
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
fn sum(text: &str) -> u32 {
    text.bytes().fold(0x811c_9dc5, |sum, byte| {
        (sum ^ u32::from(byte)).wrapping_mul(0x0100_0193)
    })
}

/// The items in a macro that depends on a feature, with its name as an attribute; another item as it is.
fn unwrapped(item: Item) -> Vec<Item> {
    match item {
        Item::Macro(item) if is_feature(&item.mac.path) => {
            let file = item.mac.parse_body::<File>();
            let file = file.unwrap_or_else(|e| panic!("{e} in {}", item.mac.to_token_stream()));
            let mut items: Vec<Item> = file.items.into_iter().flat_map(unwrapped).collect();
            let mark = feature(&item.mac.path, items.len());
            if let Some(first) = items.first_mut() {
                attributes(first).insert(0, mark);
            }
            items
        }
        Item::Impl(mut item) => {
            let members = std::mem::take(&mut item.items);
            item.items = members.into_iter().flat_map(unwrapped_member).collect();
            vec![Item::Impl(item)]
        }
        Item::Mod(mut module) => {
            let items = std::mem::take(content(&mut module));
            *content(&mut module) = items.into_iter().flat_map(unwrapped).collect();
            vec![Item::Mod(module)]
        }
        Item::Const(mut item) => {
            if let Expr::Block(body) = &mut *item.expr {
                let statements = std::mem::take(&mut body.block.stmts);
                let items = statements.into_iter().map(item_of).flat_map(unwrapped);
                body.block.stmts = items.map(Stmt::Item).collect();
            }
            vec![Item::Const(item)]
        }
        other => vec![other],
    }
}

/// A statement of the block around generated code as an item.
fn item_of(statement: Stmt) -> Item {
    match statement {
        Stmt::Item(item) => item,
        Stmt::Macro(call) => Item::Macro(ItemMacro {
            attrs: call.attrs,
            ident: None,
            mac: call.mac,
            semi_token: call.semi_token,
        }),
        other => panic!("items: {}", other.to_token_stream()),
    }
}

fn content(module: &mut ItemMod) -> &mut Vec<Item> {
    &mut module.content.as_mut().expect("it has a body").1
}

fn unwrapped_member(member: ImplItem) -> Vec<ImplItem> {
    let member = match member {
        ImplItem::Macro(member) if is_feature(&member.mac.path) => member,
        other => return vec![other],
    };
    let members = member.mac.tokens;
    let block: ItemImpl = parse_quote!(impl Members { #members });
    let members = block.items.into_iter().flat_map(unwrapped_member);
    let mut members: Vec<ImplItem> = members.collect();
    let mark = feature(&member.mac.path, members.len());
    match members.first_mut() {
        Some(ImplItem::Fn(function)) => function.attrs.insert(0, mark),
        other => panic!("a method: {}", other.to_token_stream()),
    }
    members
}

fn last(path: &Path) -> &Ident {
    &path.segments.last().expect("a macro has a name").ident
}

/// True for a macro whose content depends on a feature.
fn is_feature(path: &Path) -> bool {
    last(path).to_string().starts_with("if_")
}

/// The attribute that stands for such a macro.
fn feature(path: &Path, items: usize) -> Attribute {
    let (name, items) = (last(path), Literal::usize_unsuffixed(items));
    parse_quote!(#[#name(#items)])
}

fn attributes(item: &mut Item) -> &mut Vec<Attribute> {
    match item {
        Item::Const(item) => &mut item.attrs,
        Item::Struct(item) => &mut item.attrs,
        Item::Type(item) => &mut item.attrs,
        Item::Impl(item) => &mut item.attrs,
        Item::Macro(item) => &mut item.attrs,
        Item::Mod(item) => &mut item.attrs,
        Item::Use(item) => &mut item.attrs,
        other => panic!(
            "types, their methods and imports: {}",
            other.to_token_stream()
        ),
    }
}
