//! Names of bodies and joints: a name space of their own.

use std::collections::BTreeMap;
use std::ops::Range;

use proc_macro2::Ident;

use super::super::embed::Members;
use super::super::names::Resolver;
use super::super::part::PartScope;
use super::super::passes::Mechanical;
use crate::diagnostic::SourceSpan;
use crate::diagnostic::text::nearest;
use crate::syntax::{BodyItem, JointKind, JointPart, Member as Named, Word};

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
    /// Declares all bodies and joints: own bodies with the joints that they hang on, those of parts, own joints that close loops, those of
    /// parts. The answer is what the numbers of each part's are.
    pub(super) fn declare_members(
        &mut self,
        bodies: &[&BodyItem],
        others: &[Mechanical],
    ) -> Vec<Members> {
        for (index, item) in bodies.iter().enumerate() {
            self.declare_member(&item.name, Member::Body(index));
            self.declare_joint(&item.joint);
        }
        self.mechanics.bodies = bodies.len();
        let mut all: Vec<Members> = Vec::new();
        for part in 0..self.parts.len() {
            let first_body = self.mechanics.bodies;
            let bodies = self.declare_bodies_of_part(part, first_body);
            self.mechanics.bodies += bodies;
            all.push(Members {
                first_body,
                bodies,
                first_closing: 0,
                on: None,
            });
        }
        for item in others {
            match item {
                Mechanical::Joint(item) => self.declare_joint(&item.joint),
                // They have no names.
                Mechanical::Gravity(_)
                | Mechanical::Force(_)
                | Mechanical::Torque(_)
                | Mechanical::Spring(_)
                | Mechanical::Damper(_) => {}
            }
        }
        for (part, members) in all.iter_mut().enumerate() {
            members.first_closing = self.mechanics.joints.len();
            self.declare_joints_of_part(part, members.bodies..usize::MAX);
        }
        all
    }

    fn declare_joint(&mut self, joint: &JointPart) {
        if let Some(name) = &joint.name {
            let index = self.mechanics.joints.len();
            self.declare_member(name, Member::Joint(index));
        }
        self.mechanics.joints.push(joint.kind);
    }

    /// A part's bodies from this number on, with the joints that they hang on; how many there are.
    fn declare_bodies_of_part(&mut self, part: usize, first: usize) -> usize {
        let PartScope {
            name, span, body, ..
        } = &self.parts[part];
        let Some(body) = body else {
            return 0;
        };
        let bodies = body.mechanism().bodies.iter().enumerate();
        let bodies = bodies.map(|(index, own)| {
            let member = Member::Body(first + index);
            (format!("{name}.{}", own.name), (member, *span))
        });
        let bodies: Vec<_> = bodies.collect();
        let count = bodies.len();
        self.mechanics.members.extend(bodies);
        self.declare_joints_of_part(part, 0..count);
        count
    }

    fn declare_joints_of_part(&mut self, part: usize, among: Range<usize>) {
        let PartScope {
            name, span, body, ..
        } = &self.parts[part];
        let joints = body.iter().flat_map(|body| &body.mechanism().joints);
        for (index, joint) in joints.enumerate() {
            if !among.contains(&index) {
                continue;
            }
            if let Some(own) = &joint.name {
                let member = Member::Joint(self.mechanics.joints.len());
                let members = &mut self.mechanics.members;
                members.insert(format!("{name}.{own}"), (member, *span));
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
    pub(super) fn body_named(&mut self, name: &Named) -> Option<Option<usize>> {
        let text = name.text.clone();
        if text == FRAME {
            return Some(None);
        }
        if self.is_broken_part(&text) {
            return None;
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
        self.diagnostics.error_with_help(name.span, fact, help);
        None
    }

    /// The joint of that name; `None` after a report.
    pub(super) fn joint_named(&mut self, name: &Named) -> Option<usize> {
        let text = name.text.clone();
        if self.is_broken_part(&text) {
            return None;
        }
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
        self.diagnostics.error_with_help(name.span, fact, help);
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
