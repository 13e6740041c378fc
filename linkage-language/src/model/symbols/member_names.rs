//! Names of bodies and joints: a name space of their own.

use std::collections::BTreeMap;

use crate::diagnostic::SourceSpan;
use crate::syntax::{JointKind, MechanismDef, ReactionHint};

/// The body or joint that a name is given to.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::model) enum Member {
    Body(usize),
    Joint(usize),
}

/// The facts about joints and links that messages about names need.
#[derive(Default)]
pub(in crate::model) struct LinkNames {
    /// True for a mechanism with joints and links.
    pub(in crate::model) present: bool,
    /// True after a mistake in them: bodies and quantities of links are unknown.
    pub(in crate::model) lost: bool,
    /// True after a mistake in the name of one of them: any unknown name may be meant.
    pub(in crate::model) nameless: bool,
    /// The joints of each link.
    pub(in crate::model) members: BTreeMap<String, Vec<String>>,
    /// Messages about names that are no joints of forces.
    pub(in crate::model) reactions: BTreeMap<String, ReactionHint>,
}

impl LinkNames {
    pub(in crate::model) fn new(definition: &MechanismDef) -> Self {
        let inventory = definition.links.as_ref();
        Self {
            present: inventory.is_some() || definition.links_are_lost,
            lost: definition.links_are_lost,
            nameless: definition.link_names_are_lost,
            members: inventory.map_or_else(BTreeMap::new, |links| links.members.clone()),
            reactions: inventory.map_or_else(BTreeMap::new, |links| links.reactions.clone()),
        }
    }
}

/// Bodies and joints by their names.
#[derive(Default)]
pub(in crate::model) struct MemberNames {
    pub(in crate::model) by_name: BTreeMap<String, (Member, SourceSpan)>,
    pub(in crate::model) bodies: usize,
    /// True if a body has a mass or a moment of inertia.
    pub(in crate::model) has_masses: bool,
    /// True if a force, a torque, a spring or a damper is declared.
    pub(in crate::model) has_loads: bool,
    /// True if a joint has friction.
    pub(in crate::model) has_friction: bool,
    pub(in crate::model) links: LinkNames,
    /// Kinds of all joints: those that bodies are attached by in the order of the bodies, then
    /// those that close loops.
    pub(in crate::model) joints: Vec<JointKind>,
}

impl MemberNames {
    /// Returns true if a body or joint has this name.
    pub(in crate::model) fn has(&self, name: &str) -> bool {
        self.by_name.contains_key(name)
    }

    /// Returns the names of all bodies or of all joints.
    pub(in crate::model) fn wanted(&self, wanted: fn(Member) -> bool) -> Vec<&str> {
        let members = self.by_name.iter();
        members
            .filter(|(_, (member, _))| wanted(*member))
            .map(|(name, _)| name.as_str())
            .collect()
    }
}

/// The fixed link.
pub(in crate::model) const FRAME: &str = "frame";
