//! Names of joints and links: their numbers, and messages about names that have none.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use super::linkage::{FRAME, Joint, Linkage};
use crate::diagnostic::Diagnostics;
use crate::diagnostic::text::{list, nearest};
use crate::syntax::{Item, LinkedItem, MechanismDef};

/// The name of the fixed link.
pub(super) const FRAME_NAME: &str = "frame";

/// Words that others have for the fixed link.
const GROUND: [&str; 8] = [
    "ground", "base", "fixed", "stand", "chassis", "earth", "bed", "frm",
];

/// The numbers of joints and links.
pub(super) struct Names {
    pub(super) joints: BTreeMap<String, usize>,
    pub(super) links: BTreeMap<String, usize>,
    /// The joints of each link as they are written, whether the link has been read or not.
    written: BTreeMap<String, Vec<String>>,
    /// Names of values that can be points: a link may hold on to one.
    points: Vec<String>,
    inputs: Vec<String>,
}

/// Returns true for a name that the fixed link would have elsewhere.
pub(super) fn is_ground(name: &str) -> bool {
    let name = name.to_lowercase();
    GROUND.contains(&name.as_str()) || nearest(&name, [FRAME_NAME, GROUND[0]]).is_some()
}

impl Names {
    /// The names of a mechanism before its joints and links are read.
    pub(super) fn new(definition: &MechanismDef) -> Self {
        let mut written: BTreeMap<String, Vec<String>> = BTreeMap::new();
        for item in &definition.items {
            if let Item::Linked(LinkedItem::Link(link)) = item {
                let joints = link.joints.iter().map(|joint| joint.name.to_string());
                written
                    .entry(link.name.to_string())
                    .or_default()
                    .extend(joints);
            }
        }
        Self {
            joints: BTreeMap::new(),
            links: BTreeMap::from([(FRAME_NAME.to_owned(), FRAME)]),
            written,
            points: points(definition),
            inputs: inputs(definition),
        }
    }

    /// Returns the joint of that name, a point of the ordinary language included.
    pub(super) fn joint(
        &mut self,
        linkage: &mut Linkage,
        name: &Ident,
        diagnostics: &mut Diagnostics,
    ) -> Option<usize> {
        let text = name.to_string();
        if let Some(number) = self.joints.get(&text) {
            return Some(*number);
        }
        if self.points.contains(&text) {
            self.joints.insert(text, linkage.joints.len());
            linkage.joints.push(Joint {
                name: name.clone(),
                drawn: None,
            });
            return Some(linkage.joints.len() - 1);
        }
        if let Some(joints) = self.written.get(&text) {
            let joints: Vec<&str> = joints.iter().map(String::as_str).collect();
            let fact = format!("`{text}` is a link, not a joint");
            let help = match joints[..] {
                [] => "name a joint".to_owned(),
                _ => format!("name one of its joints: {}", list(&joints)),
            };
            diagnostics.error_with_help(name.into(), fact, help);
            return None;
        }
        if self.inputs.contains(&text) {
            let fact = format!("`{text}` is an input, not a joint");
            let help = format!(
                "write `at {text}` for the direction of the link, or `length {text}` for its length"
            );
            diagnostics.error_with_help(name.into(), fact, help);
            return None;
        }
        let near = nearest(&text, self.joints.keys().map(String::as_str));
        let help = match near {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("write where it is drawn: `joint {text} = (x, y);`"),
        };
        let fact = format!("unknown joint `{text}`");
        let message = diagnostics.error_with_help(name.into(), fact, help);
        if let Some(near) = near {
            message.suggest(format!("write `{near}`"), name.into(), near);
        }
        None
    }

    /// Returns the link of that name.
    pub(super) fn link(&self, name: &Ident, diagnostics: &mut Diagnostics) -> Option<usize> {
        let text = name.to_string();
        if let Some(number) = self.links.get(&text) {
            return Some(*number);
        }
        // A mistake in the link has been reported.
        if self.written.contains_key(&text) {
            return None;
        }
        if self.is_joint(&text) {
            let fact = format!("`{text}` is a joint, not a link");
            let links = self.links_with(&text);
            let help = match links[..] {
                [] => format!("declare a link with it: `link NAME: {text}, joint;`"),
                _ => format!("links with this joint are {}", list(&links)),
            };
            diagnostics.error_with_help(name.into(), fact, help);
            return None;
        }
        let near = nearest(&text, self.links.keys().map(String::as_str));
        let near = near.or(is_ground(&text).then_some(FRAME_NAME));
        let help = match near {
            Some(FRAME_NAME) => format!("the fixed link is called `{FRAME_NAME}`"),
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("declare it: `link {text}: joint, joint;`"),
        };
        let fact = format!("unknown link `{text}`");
        let message = diagnostics.error_with_help(name.into(), fact, help);
        if let Some(near) = near {
            message.suggest(format!("write `{near}`"), name.into(), near);
        }
        None
    }

    /// Reports a link or a slider with the name of a joint: its quantities would hide the coordinates.
    pub(super) fn refuse_name_of_joint(&self, name: &Ident, diagnostics: &mut Diagnostics) {
        if self.joints.contains_key(&name.to_string()) {
            let fact = format!("`{name}` is a joint already");
            diagnostics.error_with_help(name.into(), fact, "choose another name");
        }
    }

    /// Returns true for the name of a joint that is no link.
    pub(super) fn is_joint(&self, name: &str) -> bool {
        self.joints.contains_key(name) && !self.links.contains_key(name)
    }

    /// Returns the links with a joint of this name, the frame aside.
    pub(super) fn links_with(&self, joint: &str) -> Vec<&str> {
        let links = self.written.iter();
        let links = links.filter(|(link, joints)| {
            *link != FRAME_NAME && joints.iter().any(|other| other == joint)
        });
        links.map(|(link, _)| link.as_str()).collect()
    }
}

fn points(definition: &MechanismDef) -> Vec<String> {
    let items = definition.items.iter();
    items
        .filter_map(|item| match item {
            Item::Let(item) => Some(item.name.to_string()),
            Item::Param(item) => Some(item.name.to_string()),
            Item::Unknown(item) => Some(item.name.to_string()),
            _ => None,
        })
        .collect()
}

fn inputs(definition: &MechanismDef) -> Vec<String> {
    let items = definition.items.iter();
    items
        .filter_map(|item| match item {
            Item::Input(item) => Some(item.name.to_string()),
            _ => None,
        })
        .collect()
}
