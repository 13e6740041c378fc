//! Declaration of the names of bodies and joints.

use std::ops::Range;

use proc_macro2::Ident;

use crate::diagnostic::SourceSpan;
use crate::model::declare::passes::Mechanical;
use crate::model::expression::refused_names::{check_reserved, report_duplicate};
use crate::model::parts::embed_bodies::MemberNumbers;
use crate::model::symbols::member_names::{FRAME, Member, MemberNames};
use crate::model::symbols::part_scopes::{PartScope, Parts};
use crate::model::symbols::sink::Sink;
use crate::syntax::{BodyItem, JointPart};

/// Declares all bodies and joints: own bodies with the joints that they are attached by, those of
/// parts, own joints that close loops, those of parts. Returns the numbers of each part's bodies
/// and joints.
pub(in crate::model) fn declare_members(
    parts: &Parts,
    members: &mut MemberNames,
    sink: &mut Sink,
    bodies: &[&BodyItem],
    others: &[Mechanical],
) -> Vec<MemberNumbers> {
    for (index, item) in bodies.iter().enumerate() {
        declare_member(members, sink, &item.name, Member::Body(index));
        declare_joint(members, sink, &item.joint);
        members.has_masses |= !item.masses.is_empty() || !item.inertias.is_empty();
    }
    members.bodies = bodies.len();
    let mut numbers_of_parts: Vec<MemberNumbers> = Vec::new();
    for part in 0..parts.scopes.len() {
        let first_body = members.bodies;
        let bodies = declare_bodies_of_part(parts, members, part, first_body);
        members.bodies += bodies;
        numbers_of_parts.push(MemberNumbers {
            first_body,
            bodies,
            first_closing: 0,
            on: None,
        });
    }
    for item in others {
        match item {
            Mechanical::Joint(item) => declare_joint(members, sink, &item.joint),
            // The others have no names.
            Mechanical::Gravity(_) => {}
            Mechanical::Friction(_) => members.has_friction = true,
            Mechanical::Force(_)
            | Mechanical::Torque(_)
            | Mechanical::Spring(_)
            | Mechanical::Damper(_) => members.has_loads = true,
        }
    }
    for (part, numbers) in numbers_of_parts.iter_mut().enumerate() {
        numbers.first_closing = members.joints.len();
        declare_joints_of_part(parts, members, part, numbers.bodies..usize::MAX);
    }
    numbers_of_parts
}

pub(in crate::model) fn declare_joint(
    members: &mut MemberNames,
    sink: &mut Sink,
    joint: &JointPart,
) {
    if let Some(name) = &joint.name {
        let index = members.joints.len();
        declare_member(members, sink, name, Member::Joint(index));
    }
    members.joints.push(joint.kind);
}

/// A part's bodies from this number on, with the joints that they hang on; how many there are.
pub(in crate::model) fn declare_bodies_of_part(
    parts: &Parts,
    members: &mut MemberNames,
    part: usize,
    first: usize,
) -> usize {
    let PartScope {
        name, span, body, ..
    } = &parts.scopes[part];
    let Some(body) = body else {
        return 0;
    };
    let mechanism = body.mechanism();
    let mut masses = mechanism.bodies.iter();
    members.has_masses |= masses.any(|body| !body.masses.is_empty() || !body.inertias.is_empty());
    members.has_loads |= !mechanism.loads.is_empty() || !mechanism.elements.is_empty();
    members.has_friction |= !mechanism.frictions.is_empty();
    let bodies = mechanism.bodies.iter().enumerate();
    let bodies = bodies.map(|(index, body)| {
        let member = Member::Body(first + index);
        (format!("{name}.{}", body.name), (member, *span))
    });
    let bodies: Vec<_> = bodies.collect();
    let count = bodies.len();
    members.by_name.extend(bodies);
    declare_joints_of_part(parts, members, part, 0..count);
    count
}

pub(in crate::model) fn declare_joints_of_part(
    parts: &Parts,
    members: &mut MemberNames,
    part: usize,
    among: Range<usize>,
) {
    let PartScope {
        name, span, body, ..
    } = &parts.scopes[part];
    let joints = body.iter().flat_map(|body| &body.mechanism().joints);
    for (index, joint) in joints.enumerate() {
        if !among.contains(&index) {
            continue;
        }
        if let Some(joint_name) = &joint.name {
            let member = Member::Joint(members.joints.len());
            let members = &mut members.by_name;
            members.insert(format!("{name}.{joint_name}"), (member, *span));
        }
        members.joints.push(joint.kind);
    }
}

pub(in crate::model) fn declare_member(
    members: &mut MemberNames,
    sink: &mut Sink,
    ident: &Ident,
    member: Member,
) {
    let text = ident.to_string();
    let span = SourceSpan::from(ident);
    check_reserved(sink, ident);
    if text == FRAME {
        let fact = "`frame` is the fixed link";
        sink.error_with_help(span, fact, "choose another name");
        return;
    }
    match members.by_name.get(&text) {
        Some((_, first)) => {
            let first = *first;
            let fact = format!("the name `{text}` is given to two bodies or joints");
            report_duplicate(sink, &fact, &text, span, first);
        }
        None => {
            members.by_name.insert(text, (member, span));
        }
    }
}
