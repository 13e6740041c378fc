//! Numbers of names: each kind is counted by itself, in the order of declaration.

use crate::model::symbols::frame_kind::FrameKind;
use crate::model::types::Name;
use crate::syntax::{Item, ItemName};

/// Numbers of names of each kind so far.
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
    /// Unknowns that these frames consist of.
    pub(in crate::model) unknowns_of_frames: usize,
}

impl Counts {
    /// Starts with the frames among the unknowns: the derived quantities that they become come
    /// before all others.
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

    /// Returns the name of the value that an item declares. Bodies and joints have names of another
    /// kind.
    pub(in crate::model) fn next_name(&mut self, item: &Item) -> Option<(ItemName, Name)> {
        Some(match item {
            Item::Const(item) => (item.name.clone(), Name::Const(next(&mut self.constants))),
            Item::Param(item) => (
                item.name.clone(),
                Name::Parameter(next(&mut self.parameters)),
            ),
            Item::Input(item) => (
                item.name.clone().into(),
                Name::Input(next(&mut self.inputs)),
            ),
            Item::Unknown(item) if item.is_frame() => {
                (item.name.clone(), Name::Let(next(&mut self.frames)))
            }
            Item::Unknown(item) => (item.name.clone(), Name::Unknown(next(&mut self.unknowns))),
            Item::Let(item) => (item.name.clone(), Name::Let(next(&mut self.lets))),
            Item::Argument(item) => (item.name.clone(), Name::Argument(next(&mut self.arguments))),
            // Names that parts declare come after all others.
            Item::Part(_) => return None,
            Item::Unit(_)
            | Item::Loop(_)
            | Item::Gravity(_)
            | Item::Body(_)
            | Item::Arc(_)
            | Item::Joint(_)
            | Item::Force(_)
            | Item::Torque(_)
            | Item::Spring(_)
            | Item::Damper(_)
            | Item::Friction(_)
            | Item::Linked(_) => return None,
        })
    }
}

pub(in crate::model) fn next(count: &mut usize) -> usize {
    *count += 1;
    *count - 1
}
