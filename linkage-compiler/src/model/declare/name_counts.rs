//! Numbers of names: each kind is counted by itself, in the order of declaration.

use proc_macro2::Ident;

use crate::model::symbols::frame_kind::FrameKind;
use crate::model::types::Name;
use crate::syntax::Item;

/// How many names there are of each kind so far.
#[derive(Default)]
pub(in crate::model) struct Counts {
    pub(in crate::model) constants: usize,
    pub(in crate::model) parameters: usize,
    pub(in crate::model) inputs: usize,
    pub(in crate::model) unknowns: usize,
    pub(in crate::model) lets: usize,
    pub(in crate::model) arguments: usize,
    /// Unknowns that are frames: derived quantities in front of all others.
    frames: usize,
    /// What these consist of.
    pub(in crate::model) unknowns_of_frames: usize,
}

impl Counts {
    /// Nothing counted yet; what is derived from unknown frames comes first.
    pub(in crate::model) fn new(items: &[Item]) -> Self {
        let frames = items.iter().filter_map(|item| match item {
            Item::Unknown(item) if item.is_frame() => Some(item),
            _ => None,
        });
        Self {
            unknowns_of_frames: frames
                .clone()
                .map(|item| FrameKind::of_item(item).unknowns())
                .sum(),
            lets: frames.count(),
            ..Self::default()
        }
    }

    /// The name of the value that an item declares, if it does. Names of bodies and joints are of their own.
    pub(in crate::model) fn next_name<'i>(&mut self, item: &'i Item) -> Option<(&'i Ident, Name)> {
        Some(match item {
            Item::Const(item) => (&item.name, Name::Const(next(&mut self.constants))),
            Item::Param(item) => (&item.name, Name::Parameter(next(&mut self.parameters))),
            Item::Input(item) => (&item.name, Name::Input(next(&mut self.inputs))),
            Item::Unknown(item) if item.is_frame() => {
                (&item.name, Name::Let(next(&mut self.frames)))
            }
            Item::Unknown(item) => (&item.name, Name::Unknown(next(&mut self.unknowns))),
            Item::Let(item) => (&item.name, Name::Let(next(&mut self.lets))),
            Item::Argument(item) => (&item.name, Name::Argument(next(&mut self.arguments))),
            // What they declare follows behind all others.
            Item::Part(_) => return None,
            Item::Unit(_)
            | Item::Loop(_)
            | Item::Gravity(_)
            | Item::Body(_)
            | Item::Joint(_)
            | Item::Force(_)
            | Item::Torque(_)
            | Item::Spring(_)
            | Item::Damper(_) => return None,
        })
    }
}

pub(in crate::model) fn next(count: &mut usize) -> usize {
    *count += 1;
    *count - 1
}
