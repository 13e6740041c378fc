//! Items that depend on features, and those of the block around generated code, as items of the file.

use proc_macro2::{Ident, Literal};
use quote::ToTokens;
use syn::{
    Attribute, Expr, File, ImplItem, Item, ItemImpl, ItemMacro, ItemMod, Path, Stmt, parse_quote,
};

/// The items in a macro that depends on a feature, with its name as an attribute; another item as it is.
pub(super) fn unwrapped(item: Item) -> Vec<Item> {
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
        other => vec![other],
    }
}

/// The block around generated code and its items; another item as it is.
pub(super) fn opened(item: Item) -> Vec<Item> {
    let Item::Const(mut block) = item else {
        return vec![item];
    };
    let mut items = Vec::new();
    if let Expr::Block(body) = &mut *block.expr {
        let statements = std::mem::take(&mut body.block.stmts);
        items.extend(statements.into_iter().map(item_of).flat_map(unwrapped));
        let count = Literal::usize_unsuffixed(items.len());
        *block.expr = parse_quote!(block!(#count));
    }
    items.insert(0, Item::Const(block));
    items
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

pub(super) fn content(module: &mut ItemMod) -> &mut Vec<Item> {
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

pub(super) fn attributes(item: &mut Item) -> &mut Vec<Attribute> {
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
