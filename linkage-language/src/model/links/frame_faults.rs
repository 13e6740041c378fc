//! Messages about the fixed link: none, one of another name, links that nothing joins to it.

use proc_macro2::Ident;

use super::linkage::{FRAME, Linkage};
use super::names::{FRAME_NAME, is_ground};
use super::rigid_bodies::Bodies;
use crate::diagnostic::text::list;
use crate::diagnostic::{Diagnostics, EditLocation};

/// Reports a mechanism in which nothing is fixed.
pub(super) fn report_missing_frame(linkage: &Linkage, diagnostics: &mut Diagnostics) {
    let is_used = linkage.sliders.iter().any(|slider| slider.guide == FRAME);
    let holds_known_point = linkage.joints.iter().any(|joint| joint.drawn.is_none());
    let frame = &linkage.links[FRAME];
    if is_used || holds_known_point || !frame.joints.is_empty() {
        return;
    }
    let mut links = linkage.links[FRAME + 1..].iter();
    if let Some(ground) = links.find(|link| is_ground(&link.name.to_string())) {
        let name = &ground.name;
        let fact = format!("the link `{name}` moves: the fixed link is called `{FRAME_NAME}`");
        let help = format!("write `link {FRAME_NAME}: ...;`");
        let message = diagnostics.error_with_help(name.into(), fact, help);
        message.suggest(format!("write `{FRAME_NAME}`"), name.into(), FRAME_NAME);
        return;
    }
    let ends = loose_ends(linkage);
    let ends: Vec<String> = ends.into_iter().map(Ident::to_string).collect();
    let joints = match ends.len() {
        0 => "joint, joint".to_owned(),
        _ => ends.join(", "),
    };
    let item = format!("link {FRAME_NAME}: {joints};");
    let fact = "no link is fixed: the mechanism has no frame";
    let help = format!("name the joints that stay where they are: `{item}`");
    let message = diagnostics.error_with_help((&frame.name).into(), fact, help);
    let first = linkage.links.get(FRAME + 1).filter(|_| !ends.is_empty());
    if let Some(link) = first {
        let title = format!("add `{item}`");
        message.suggest_text(title, (&link.name).into(), EditLocation::BeforeItem, item);
    }
}

/// Returns the joints that only one link has, of links that are joined to others once: those are
/// pivots in most drawings.
fn loose_ends<'l>(linkage: &'l Linkage) -> Vec<&'l Ident> {
    let holders = |joint: usize| {
        let links = linkage.links.iter();
        links.filter(|link| link.joints.contains(&joint)).count()
    };
    let links = linkage.links[FRAME + 1..].iter();
    let single = links.filter(|link| {
        let shared = link.joints.iter().filter(|joint| holders(**joint) > 1);
        shared.count() == 1
    });
    let joints = single.flat_map(|link| &link.joints);
    let mut loose: Vec<usize> = joints
        .copied()
        .filter(|joint| holders(*joint) == 1)
        .collect();
    loose.sort_unstable();
    loose
        .iter()
        .map(|joint| &linkage.joints[*joint].name)
        .collect()
}

/// Reports bodies that no joints lead to from the frame, all of them once.
pub(super) fn report_unreached(
    linkage: &Linkage,
    bodies: &Bodies,
    reached: &[bool],
    diagnostics: &mut Diagnostics,
) {
    let unreached = (0..bodies.list.len()).filter(|body| !reached[*body]);
    let names = unreached.map(|body| &linkage.links[bodies.list[body].lead()].name);
    let names: Vec<&Ident> = names.collect();
    let Some(first) = names.first() else { return };
    let texts: Vec<String> = names.iter().map(ToString::to_string).collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    let (links, them) = match texts[..] {
        [_] => ("link", "it"),
        _ => ("links", "one of them"),
    };
    let fact = format!(
        "no way leads from the frame to the {links} {}",
        list(&texts)
    );
    let help = format!(
        "let {them} share a joint with a link that leads to the frame, or slide on one; the frame has its \
         joints in `link {FRAME_NAME}: ...;`"
    );
    diagnostics.error_with_help((*first).into(), fact, help);
}
