//! The graph of links and joints as a tree, and the joints that close loops.

use std::collections::BTreeMap;

use super::poses::{Frames, name_of, text_of};
use super::single_joints::{add_joint, close};
use crate::error::ImportError;
use crate::names::shown;
use crate::robots::model::Robot;
use crate::xml::XmlElement;

/// A joint with the links that it joins.
struct Ends<'t> {
    element: &'t XmlElement,
    parent: Option<String>,
    child: Option<String>,
}

/// Makes a tree of the joints, beginning at the world, or at the first link without one. The others
/// close loops. Returns the bodies of links.
pub(super) fn tree(
    robot: &mut Robot,
    model: &XmlElement,
    frames: &Frames,
) -> Result<BTreeMap<String, usize>, ImportError> {
    let mut joints: Vec<Ends> = Vec::new();
    for element in model.named("joint") {
        let end = |name: &str| frames.link(text_of(element, name).unwrap_or_default(), 0);
        joints.push(Ends {
            element,
            parent: end("parent")?,
            child: end("child")?,
        });
    }
    let links: Vec<&str> = model
        .named("link")
        .map(name_of)
        .collect::<Result<_, ImportError>>()?;
    let mut bodies: BTreeMap<String, usize> = BTreeMap::new();
    let is_held = joints
        .iter()
        .any(|joint| joint.parent.is_none() || joint.child.is_none());
    if !is_held && let Some(first) = links.first() {
        bodies.insert((*first).to_owned(), 0);
        robot.warnings.push(format!(
            "no joint holds the model in the world: the link `{}` is the frame",
            shown(first)
        ));
    }
    let mut used = vec![false; joints.len()];
    // In the order of the file, as far as a joint has one end on a body that is known.
    while let Some((index, ends)) = joints.iter().enumerate().find(|(index, ends)| {
        let known =
            |link: &Option<String>| link.as_ref().is_none_or(|link| bodies.contains_key(link));
        !used[*index] && known(&ends.parent) != known(&ends.child)
    }) {
        used[index] = true;
        let body = |link: &Option<String>| match link {
            None => Some(0),
            Some(link) => bodies.get(link).copied(),
        };
        let (on, link, is_forward) = match (body(&ends.parent), &ends.child, &ends.parent) {
            (Some(on), Some(child), _) => (on, child, true),
            (_, _, Some(parent)) => (body(&ends.child).unwrap_or_default(), parent, false),
            (_, _, None) => continue,
        };
        let added = add_joint(robot, ends.element, frames, on, link, is_forward)?;
        bodies.insert(link.clone(), added);
    }
    for (ends, is_used) in joints.iter().zip(&used) {
        if !is_used {
            let body = |link: &Option<String>| match link {
                None => Some(0),
                Some(link) => bodies.get(link).copied(),
            };
            match [body(&ends.parent), body(&ends.child)] {
                [Some(parent), Some(child)] => {
                    close(robot, ends.element, frames, [child, parent])?;
                }
                _ => robot.warnings.push(format!(
                    "the joint `{}` joins links that nothing joins to the frame: it is left out",
                    shown(name_of(ends.element)?)
                )),
            }
        }
    }
    for link in links {
        if !bodies.contains_key(link) {
            robot.warnings.push(format!(
                "the link `{}` is joined to nothing: it is left out",
                shown(link)
            ));
        }
    }
    Ok(bodies)
}
