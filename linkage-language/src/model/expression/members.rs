//! Bodies and joints that clauses and functions name.

use crate::diagnostic::text::nearest;
use crate::model::symbols::member_names::{FRAME, Member, MemberNames};
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::sink::Sink;
use crate::syntax::{Member as Named, Word};

/// The body of that name, `Some(None)` for the frame; `None` after a report.
pub(in crate::model) fn find_body(
    parts: &Parts,
    members: &MemberNames,
    sink: &mut Sink,
    name: &Named,
) -> Option<Option<usize>> {
    let text = name.text.clone();
    if text == FRAME {
        return Some(None);
    }
    if parts.is_broken_part(&text) || members.links.lost {
        return None;
    }
    let fact = match members.by_name.get(&text) {
        Some((Member::Body(body), _)) => return Some(Some(*body)),
        Some(_) => format!("`{text}` is a joint, not a body"),
        None => format!("unknown body `{text}`"),
    };
    let mut names = members.wanted(|member| matches!(member, Member::Body(_)));
    names.push(FRAME);
    let help = match nearest(&text, names.iter().copied()) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("bodies are `{}`", names.join("`, `")),
    };
    sink.error_with_help(name.span, fact, help);
    None
}

/// The joint of that name; `None` after a report.
pub(in crate::model) fn find_joint(
    parts: &Parts,
    members: &MemberNames,
    sink: &mut Sink,
    name: &Named,
) -> Option<usize> {
    let text = name.text.clone();
    if parts.is_broken_part(&text) || members.links.lost {
        return None;
    }
    let found = members.by_name.get(&text).map(|(member, _)| *member);
    if let Some(Member::Joint(joint)) = found {
        return Some(joint);
    }
    if let Some(hint) = members.links.reactions.get(&text) {
        sink.error_with_help(name.span, &hint.fact, &hint.help);
        return None;
    }
    let fact = match found {
        Some(_) => format!("`{text}` is a body, not a joint"),
        None => format!("unknown joint `{text}`"),
    };
    let names = members.wanted(|member| matches!(member, Member::Joint(_)));
    let help = match (nearest(&text, names.iter().copied()), found) {
        (_, Some(Member::Body(body))) => hanging_help(members, body),
        (Some(name), _) => format!("did you mean `{name}`?"),
        (None, _) if names.is_empty() => {
            format!(
                "no joint has a name: write `body ... = pin {text} on ...` or `pin {text} = BODY on BODY at POINT`"
            )
        }
        (None, _) => format!("joints are `{}`", names.join("`, `")),
    };
    sink.error_with_help(name.span, fact, help);
    None
}

/// Returns a help with the joint that a body is attached by.
fn hanging_help(members: &MemberNames, body: usize) -> String {
    let mut names = members.by_name.iter();
    match names.find(|(_, (member, _))| *member == Member::Joint(body)) {
        Some((name, _)) => format!("it hangs on the joint `{name}`"),
        None => {
            let kind = members.joints[body].word();
            format!("give the joint that it hangs on a name: `{kind} NAME on ...`")
        }
    }
}
