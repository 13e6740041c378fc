//! Names of bodies and joints: a name space of their own.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use super::super::names::Resolver;
use super::super::passes::Mechanical;
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::nearest;
use crate::syntax::{BodyItem, JointKind, Word};

/// The fixed link.
const FRAME: &str = "frame";

#[derive(Clone, Copy, PartialEq, Eq)]
enum Member {
    Body(usize),
    Joint(usize),
}

/// What the mechanics of a mechanism is about.
#[derive(Default)]
pub(in crate::model) struct Scope {
    members: BTreeMap<String, (Member, SourceSpan)>,
    pub(super) bodies: usize,
    /// Kinds of all joints: those that bodies hang on in the order of the bodies, then those that close loops.
    pub(super) joints: Vec<JointKind>,
    /// Components of points; `None` before the first.
    pub(super) components: Option<usize>,
}

impl Scope {
    /// Whether a body or joint has this name.
    pub(in crate::model) fn has(&self, name: &str) -> bool {
        self.members.contains_key(name)
    }
}

impl Resolver<'_> {
    /// Declares all bodies and joints.
    pub(super) fn declare_members(&mut self, bodies: &[&BodyItem], others: &[Mechanical]) {
        self.mechanics.bodies = bodies.len();
        let hanging = bodies.iter().map(|item| (Some(&item.name), &item.joint));
        let closing = others.iter().filter_map(|item| match item {
            Mechanical::Joint(item) => Some((None, &item.joint)),
            // They have no names.
            Mechanical::Gravity(_)
            | Mechanical::Force(_)
            | Mechanical::Torque(_)
            | Mechanical::Spring(_)
            | Mechanical::Damper(_) => None,
        });
        for (index, (body, joint)) in hanging.chain(closing).enumerate() {
            if let Some(body) = body {
                self.declare_member(body, Member::Body(index));
            }
            if let Some(name) = &joint.name {
                self.declare_member(name, Member::Joint(index));
            }
            self.mechanics.joints.push(joint.kind);
        }
    }

    fn declare_member(&mut self, ident: &Ident, member: Member) {
        let text = ident.to_string();
        let span = SourceSpan::from(ident);
        self.check_reserved(ident);
        if text == FRAME {
            let fact = "`frame` is the fixed link";
            self.diagnostics
                .error_with_help(span, fact, "choose another name");
            return;
        }
        match self.mechanics.members.get(&text) {
            Some((_, first)) => {
                let first = *first;
                let fact = format!("the name `{text}` is given to two bodies or joints");
                self.duplicate(&fact, &text, span, first);
            }
            None => {
                self.mechanics.members.insert(text, (member, span));
            }
        }
    }

    /// The body of that name, `Some(None)` for the frame; `None` after a report.
    pub(super) fn body_named(&mut self, ident: &Ident) -> Option<Option<usize>> {
        let text = ident.to_string();
        if text == FRAME {
            return Some(None);
        }
        let fact = match self.mechanics.members.get(&text) {
            Some((Member::Body(body), _)) => return Some(Some(*body)),
            Some(_) => format!("`{text}` is a joint, not a body"),
            None => format!("unknown body `{text}`"),
        };
        let mut names = self.members(|member| matches!(member, Member::Body(_)));
        names.push(FRAME);
        let help = match nearest(&text, names.iter().copied()) {
            Some(name) => format!("did you mean `{name}`?"),
            None => format!("bodies are `{}`", names.join("`, `")),
        };
        self.diagnostics.error_with_help(ident.into(), fact, help);
        None
    }

    /// The joint of that name; `None` after a report.
    pub(super) fn joint_named(&mut self, ident: &Ident) -> Option<usize> {
        let text = ident.to_string();
        let found = self.mechanics.members.get(&text).map(|(member, _)| *member);
        let fact = match found {
            Some(Member::Joint(joint)) => return Some(joint),
            Some(_) => format!("`{text}` is a body, not a joint"),
            None => format!("unknown joint `{text}`"),
        };
        let names = self.members(|member| matches!(member, Member::Joint(_)));
        let help = match (nearest(&text, names.iter().copied()), found) {
            (_, Some(Member::Body(body))) => self.hanging_help(body),
            (Some(name), _) => format!("did you mean `{name}`?"),
            (None, _) if names.is_empty() => {
                format!(
                    "no joint has a name: write `body ... = pin {text} on ...` or `pin {text} = BODY on BODY at POINT`"
                )
            }
            (None, _) => format!("joints are `{}`", names.join("`, `")),
        };
        self.diagnostics.error_with_help(ident.into(), fact, help);
        None
    }

    /// What to write for the joint that a body hangs on.
    fn hanging_help(&self, body: usize) -> String {
        let mut members = self.mechanics.members.iter();
        match members.find(|(_, (member, _))| *member == Member::Joint(body)) {
            Some((name, _)) => format!("it hangs on the joint `{name}`"),
            None => {
                let kind = self.mechanics.joints[body].word();
                format!("give the joint that it hangs on a name: `{kind} NAME on ...`")
            }
        }
    }

    fn members(&self, wanted: fn(Member) -> bool) -> Vec<&str> {
        let members = self.mechanics.members.iter();
        members
            .filter(|(_, (member, _))| wanted(*member))
            .map(|(name, _)| name.as_str())
            .collect()
    }
}
