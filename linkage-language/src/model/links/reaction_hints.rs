//! Messages for those who ask for the reaction of a joint or link that has none of this name.

use std::collections::BTreeMap;

use super::drawing::{Drawing, nominal};
use super::linkage::{FRAME, Link, Linkage};
use crate::diagnostic::text::list;
use crate::syntax::{Expr, ExprKind, Item, JointPart, ReactionHint};

/// A joint of the mechanics, and the body that its reaction acts on.
struct Pin<'i> {
    name: String,
    body: String,
    at: &'i Expr,
}

/// Returns the messages by the name that has no reaction. `items` are those that the linkage stands
/// for.
pub(super) fn reaction_hints(
    linkage: &Linkage,
    drawing: &Drawing,
    items: &[Item],
) -> BTreeMap<String, ReactionHint> {
    let pins: Vec<Pin> = items.iter().filter_map(pin).collect();
    let mut hints = BTreeMap::new();
    for joint in &linkage.joints {
        let name = joint.name.to_string();
        let here: Vec<&Pin> = pins.iter().filter(|pin| pin.is_at(&name)).collect();
        if !here.is_empty() && here.iter().all(|pin| pin.name != name) {
            hints.insert(name.clone(), of_joint(&name, &here));
        }
    }
    for link in &linkage.links[FRAME + 1..] {
        let name = link.name.to_string();
        let ends = link.joints.iter();
        let ends: Vec<String> = ends
            .map(|joint| linkage.joints[*joint].name.to_string())
            .collect();
        let of_link = |pin: &&Pin| {
            let at_joint = ends.iter().any(|end| pin.is_at(end));
            at_joint && (pin.is_only_at(&pins) || pin.is_on(&name))
        };
        let here: Vec<&str> = pins
            .iter()
            .filter(of_link)
            .map(|pin| pin.name.as_str())
            .collect();
        if !here.is_empty() {
            hints.insert(name, of_body(link, &ends, &here, drawing));
        }
    }
    hints
}

fn pin(item: &Item) -> Option<Pin<'_>> {
    let (joint, body): (&JointPart, String) = match item {
        Item::Body(body) => (&body.joint, body.name.to_string()),
        Item::Joint(item) => (&item.joint, item.body.text.clone()),
        _ => return None,
    };
    let name = joint.name.as_ref()?.to_string();
    let at = &joint.at;
    Some(Pin { name, body, at })
}

impl Pin<'_> {
    fn is_at(&self, joint: &str) -> bool {
        matches!(&self.at.kind, ExprKind::Name(name) if name == joint)
    }

    fn is_on(&self, link: &str) -> bool {
        self.body == link || self.body.strip_suffix("_rod") == Some(link)
    }

    /// Returns true for the one joint at its point: it belongs to both of its bodies.
    fn is_only_at(&self, pins: &[Pin]) -> bool {
        let ExprKind::Name(point) = &self.at.kind else {
            return false;
        };
        let point = point.to_string();
        pins.iter().filter(|pin| pin.is_at(&point)).count() == 1
    }
}

fn of_joint(name: &str, pins: &[&Pin]) -> ReactionHint {
    let forces: Vec<String> = pins
        .iter()
        .map(|pin| format!("`reaction({})` on `{}`", pin.name, pin.body))
        .collect();
    ReactionHint {
        fact: format!("`{name}` joins more than two links, and has a pin for each further one"),
        help: format!("name the pin: {}", forces.join(", ")),
    }
}

fn of_body(link: &Link, ends: &[String], pins: &[&str], drawing: &Drawing) -> ReactionHint {
    let name = &link.name;
    if link.is_arc() {
        let middle = pins.iter().find(|pin| {
            let middle = ends[0].as_str();
            **pin == middle
                || pin
                    .strip_prefix(middle)
                    .is_some_and(|rest| rest.starts_with('_'))
        });
        return ReactionHint {
            fact: format!("`{name}` is a slot that is an arc, and no joint of forces"),
            help: match middle {
                Some(pin) => format!(
                    "the slot presses on its pin in the line to `{}`: write `reaction({pin})`",
                    ends[0]
                ),
                None => format!("joints at it are {}", list(pins)),
            },
        };
    }
    let length = link.length.map(nominal);
    let cylinder = length.filter(|length| !drawing.is_constant(length));
    match cylinder {
        Some(length) => ReactionHint {
            fact: format!("`{name}` is a cylinder, not a joint"),
            help: match length.kind {
                ExprKind::Name(input) => format!(
                    "the force along it is `force({input})`; its joints are {}",
                    list(pins)
                ),
                _ => format!("its joints are {}", list(pins)),
            },
        },
        None => ReactionHint {
            fact: format!("`{name}` is a link, not a joint"),
            help: format!("its joints are {}", list(pins)),
        },
    }
}
