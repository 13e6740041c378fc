//! Replacements after a mistake: all names are known, and nothing else is reported.

use std::collections::BTreeSet;

use proc_macro2::Ident;

use super::names::FRAME_NAME;
use super::nodes::ident;
use crate::syntax::{Expr, Item, ItemName, LinkedItem, MechanismDef, NamedItem};

/// Returns all names that joints and links declare, without values.
pub(super) fn items(definition: &MechanismDef) -> Vec<Item> {
    let mut names = Vec::new();
    for item in &definition.items {
        match item {
            Item::Linked(LinkedItem::Joints(joints)) => {
                names.extend(
                    joints
                        .iter()
                        .map(|joint| ItemName::from(joint.name.clone())),
                );
            }
            Item::Linked(LinkedItem::Link(link)) => {
                let of_link = |name: &Ident| ItemName::of_link(link.name.clone(), name.clone());
                let span = link.name.span();
                names.extend(["angle", "length"].map(|word| of_link(&ident(word, span))));
                names.extend(link.joints.iter().map(|joint| of_link(&joint.name)));
            }
            Item::Linked(LinkedItem::Slider(slider)) => {
                names.push(slider.name.clone().into());
                let words = ["angle", "radius", "start"];
                let of_slider = |word| {
                    let word = ident(word, slider.name.span());
                    ItemName::of_link(slider.name.clone(), word)
                };
                names.extend(words.map(of_slider));
            }
            Item::Linked(LinkedItem::Lost(lost)) => {
                let is_new = |name: &&Ident| *name != FRAME_NAME;
                let declared = lost.names.iter().filter(is_new);
                names.extend(declared.map(|name| ItemName::from(name.clone())));
            }
            // No other item declares names in this way.
            _ => {}
        }
    }
    let mut seen = BTreeSet::new();
    names.retain(|name| seen.insert(name.to_string()));
    let values = names.into_iter();
    values
        .map(|name| {
            let value = Expr::error((&name).into());
            Item::Let(NamedItem { name, value })
        })
        .collect()
}
