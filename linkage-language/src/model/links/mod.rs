//! Joints and links: the second way to write a mechanism. They become parameters, unknowns, points
//! and loops, so that after `model` only their inventory and elements are
//! known, for messages and pictures.
//!
//! `collect` finds what the names mean, `rigid_bodies` joins links that are one body, `order` decides from
//! which joint each body is reached and where loops close, and `link_items` writes the items.

mod ball_links;
mod bodies_on_slots;
mod collect;
mod collect_sliders;
mod curved_slots;
mod drawing;
mod drawn_faults;
mod driven_angles;
mod elements;
mod frame_faults;
mod inventory;
mod link_bodies;
mod link_items;
mod linkage;
mod locations;
mod lost;
mod measure;
mod mechanics;
mod mixed_coordinates;
mod names;
mod nodes;
mod order;
mod printed;
mod reaction_hints;
mod rigid_bodies;
mod sheet;
mod slides;
mod space;
mod space_progress;
mod undeclared_inputs;
mod wheel_faults;
mod wheels;
mod written_measures;

use std::collections::BTreeMap;

use proc_macro2::TokenStream;

use crate::diagnostic::Diagnostics;
use crate::syntax::{Item, LinkElements, LinkedItem, MechanismDef, parse};

/// Reads the mechanisms of a text, with loops in the place of their joints and links.
pub fn read(tokens: TokenStream, diagnostics: &mut Diagnostics) -> Vec<MechanismDef> {
    let definitions = parse(tokens, diagnostics);
    expand(definitions, diagnostics)
}

/// Replaces the joints and links of each mechanism by other items. After a mistake their names stay
/// known, without values: an item that could not be read would cause further messages.
pub fn expand(definitions: Vec<MechanismDef>, diagnostics: &mut Diagnostics) -> Vec<MechanismDef> {
    let definitions = definitions.into_iter();
    definitions
        .map(|definition| match last_linked(&definition) {
            Some(last) => expand_mechanism(definition, last, diagnostics),
            None => definition,
        })
        .collect()
}

/// Returns true for an item that could not be read, not even its name.
fn is_nameless(item: &Item) -> bool {
    matches!(item, Item::Linked(LinkedItem::Lost(lost)) if lost.names.is_empty())
}

/// Returns the position of the last item about joints and links.
fn last_linked(definition: &MechanismDef) -> Option<usize> {
    let mut items = definition.items.iter();
    items.rposition(|item| matches!(item, Item::Linked(_)))
}

/// Writes all that the joints and links of a mechanism stand for in the place of the last of them,
/// so that derived quantities before can be used by links, and those after can use joints.
fn expand_mechanism(
    mut definition: MechanismDef,
    last: usize,
    diagnostics: &mut Diagnostics,
) -> MechanismDef {
    let sound = diagnostics.is_empty();
    let linkage = sound.then(|| collect::collect(&definition, diagnostics));
    let linkage = linkage.filter(|_| diagnostics.is_empty());
    let mut renamed = BTreeMap::new();
    let mut items = Vec::new();
    let mut links = None;
    let mut link_elements = LinkElements::default();
    if let Some(linkage) = linkage {
        let bodies = rigid_bodies::bodies(&linkage);
        let drawing = drawing::drawing(&definition, &linkage);
        items = link_items::items(&definition, &linkage, &bodies, &drawing, diagnostics);
        links = Some(inventory::inventory(&linkage, &bodies, &drawing, &items));
        link_elements = elements::elements(&linkage, &bodies, &drawing);
        renamed = mechanics::renamed_bodies(&linkage, &bodies);
    }
    definition.warnings = diagnostics.take_warnings();
    definition.links_are_lost = !diagnostics.is_empty();
    if definition.links_are_lost {
        items = lost::items(&definition);
        link_elements = LinkElements::default();
    }
    definition.link_names_are_lost = definition.items.iter().any(is_nameless);
    let after = definition.items.split_off(last + 1);
    definition.items.extend(items);
    definition.items.extend(after);
    let is_linked = |item: &Item| matches!(item, Item::Linked(_));
    definition.items.retain(|item| !is_linked(item));
    mechanics::rename(&mut definition, &renamed);
    definition.links = links;
    definition.link_elements = link_elements;
    definition
}
