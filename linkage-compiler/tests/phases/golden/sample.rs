//! Items that are the same for two mechanisms, except for the names of these.

use std::collections::BTreeSet;

use proc_macro2::{Literal, TokenStream};
use quote::ToTokens;
use syn::{File, ImplItem, Item, parse_quote};

use super::brief::{opened_file, sum};
use super::features::content;

/// The items and methods of a mechanism as texts.
pub(super) struct Sample(BTreeSet<String>);

impl Sample {
    pub(super) fn new(items: &TokenStream) -> Self {
        let file = opened_file(items);
        let names = mechanisms(&file);
        let mut texts = BTreeSet::new();
        for item in &file.items {
            texts.insert(text(item, &names));
            if let Item::Impl(item) = item {
                let members = item.items.iter();
                texts.extend(members.map(|member| text(member, &names)));
            }
        }
        Self(texts)
    }

    /// Leaves out of another mechanism's file whatever the sample has.
    pub(super) fn leave_out(&self, file: &mut File) {
        let names = mechanisms(file);
        self.items(&mut file.items, &names);
    }

    fn items(&self, items: &mut Vec<Item>, names: &[String]) {
        *items = self.shorter(
            std::mem::take(items),
            names,
            |number, sum| parse_quote!(same!(#number, #sum);),
        );
        for item in items {
            match item {
                Item::Impl(item) => {
                    let members = std::mem::take(&mut item.items);
                    item.items = self.shorter(members, names, |number, sum| -> ImplItem {
                        parse_quote!(same!(#number, #sum);)
                    });
                }
                Item::Mod(module) => self.items(content(module), names),
                _ => {}
            }
        }
    }

    /// Neighbours that the sample has become one, made of their number and their check sum.
    fn shorter<I: ToTokens>(
        &self,
        items: Vec<I>,
        names: &[String],
        left_out: impl Fn(Literal, String) -> I,
    ) -> Vec<I> {
        let mut out = Vec::new();
        let mut same: Vec<String> = Vec::new();
        let finish = |same: &mut Vec<String>, out: &mut Vec<I>| {
            if !same.is_empty() {
                let number = Literal::usize_unsuffixed(same.len());
                out.push(left_out(number, format!("{:08x}", sum(&same.concat()))));
                same.clear();
            }
        };
        for item in items {
            let text = text(&item, names);
            if self.0.contains(&text) {
                same.push(text);
            } else {
                finish(&mut same, &mut out);
                out.push(item);
            }
        }
        finish(&mut same, &mut out);
        out
    }
}

/// The names of the mechanisms, each before a name that is a part of it.
fn mechanisms(file: &File) -> Vec<String> {
    let structs = file.items.iter().filter_map(|item| match item {
        Item::Struct(item) => Some(item.ident.to_string()),
        _ => None,
    });
    let structs: BTreeSet<String> = structs.collect();
    let assembled = |name: &&String| structs.contains(&format!("{name}Assembly"));
    let mut names: Vec<String> = structs.iter().filter(assembled).cloned().collect();
    names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    names
}

/// An item without the names of mechanisms.
fn text(item: &impl ToTokens, names: &[String]) -> String {
    let text = item.to_token_stream().to_string();
    let without = |text: String, name: &String| text.replace(name, "Mechanism");
    names.iter().fold(text, without)
}
