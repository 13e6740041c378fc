//! Identifiers of the parts of a document.

use crate::document::{Document, FRAME, InputKind};
use crate::names::Names;

/// Identifiers by the indices of parts.
pub(super) struct Spelling {
    pub(super) joints: Vec<String>,
    pub(super) links: Vec<String>,
    pub(super) slots: Vec<String>,
    pub(super) inputs: Vec<String>,
}

impl Spelling {
    /// Chooses identifiers: joints keep their names before links, and links before inputs.
    pub(super) fn new(document: &Document) -> Self {
        let mut names = Names::new();
        let joints = document.joints.iter();
        let joints: Vec<String> = joints.map(|joint| names.unique(&joint.name, "j")).collect();
        let links = document.links.iter().enumerate();
        let links = links.map(|(index, link)| match index {
            FRAME => "frame".to_owned(),
            _ => names.unique(&link.name, "link"),
        });
        let links: Vec<String> = links.collect();
        let slots = document.slots.iter();
        let slots = slots.map(|slot| names.unique(&format!("slot_{}", joints[slot.pin]), "slot"));
        let slots = slots.collect();
        let count = |is_kind: fn(&InputKind) -> bool| {
            let inputs = document.inputs.iter();
            inputs.filter(|input| is_kind(&input.kind)).count()
        };
        let cranks = count(|kind| matches!(kind, InputKind::Crank { .. }));
        let mut index = 0;
        let mut inputs = Vec::new();
        for input in &document.inputs {
            let name = match input.kind {
                InputKind::Crank { .. } if cranks == 1 => "phi".to_owned(),
                InputKind::Crank { .. } => {
                    index += 1;
                    format!("phi{index}")
                }
                InputKind::Length { .. } => "stroke".to_owned(),
                InputKind::Position { .. } => "travel".to_owned(),
            };
            inputs.push(names.unique(&name, "input"));
        }
        Self {
            joints,
            links,
            slots,
            inputs,
        }
    }
}
