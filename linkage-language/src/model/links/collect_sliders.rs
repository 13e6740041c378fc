//! Sliders with numbers instead of names, and mistakes in them.

use proc_macro2::Ident;

use super::linkage::{Arc, FRAME, Link, Linkage, Path, RADIUS, Slider};
use super::names::Names;
use crate::diagnostic::Diagnostics;
use crate::diagnostic::text::list;
use crate::syntax::{ExprKind, SlidePath, SliderItem, Toleranced};

/// Adds a slider to a linkage. The joints of all links are known.
pub(super) fn add_slider<'a>(
    linkage: &mut Linkage<'a>,
    names: &mut Names,
    item: &'a SliderItem,
    diagnostics: &mut Diagnostics,
) {
    names.refuse_name_of_joint(&item.name, diagnostics);
    let pin = names.joint(linkage, &item.pin, diagnostics);
    let guide = names.link(&item.guide, diagnostics);
    let block = item.block.as_ref();
    let block = block.and_then(|name| names.link(name, diagnostics));
    let (Some(pin), Some(guide)) = (pin, guide) else {
        return;
    };
    if linkage.links[guide].joints.contains(&pin) {
        let fact = format!(
            "`{}` is a joint of `{}`, and cannot slide on it",
            item.pin, item.guide
        );
        let help = "name the joint of the link that slides, or leave it out of the guide";
        diagnostics.error_with_help((&item.pin).into(), fact, help);
        return;
    }
    if refuse_path_through_pin(item, diagnostics)
        || refuse_line_of_one_joint(names, item, diagnostics)
    {
        return;
    }
    let mut joint = |name: &Ident| joint_of_guide(linkage, names, item, guide, name, diagnostics);
    let path = match &item.path {
        SlidePath::Line([first, second]) => {
            let [Some(first), Some(second)] = [joint(first), joint(second)] else {
                return;
            };
            Path::Line([first, second])
        }
        SlidePath::Direction { angle, through } => {
            let given = through.as_ref().map(&mut joint);
            if given.is_some_and(|through| through.is_none()) {
                return;
            }
            let through = given.flatten();
            if through.is_none() && guide != FRAME {
                let fact = format!(
                    "the line of `{}` has no place on `{}`",
                    item.name, item.guide
                );
                let help = "write `along ANGLE through JOINT`, or `along JOINT, JOINT`";
                diagnostics.error_with_help((&item.name).into(), fact, help);
            }
            Path::Direction(angle, through)
        }
        SlidePath::Arc { centre, radius } => {
            if let Some(centre) = joint(centre) {
                add_arc(
                    linkage,
                    names,
                    item,
                    [pin, centre, guide],
                    radius,
                    diagnostics,
                );
            }
            return;
        }
    };
    if refuse_pin_of_no_link(linkage, item, pin, block, diagnostics) {
        return;
    }
    linkage.sliders.push(Slider {
        name: item.name.clone(),
        pin,
        guide,
        path,
        block,
        at: item.at.as_ref(),
    });
}

/// Reports a joint in place of a direction. Returns true if there is one.
fn refuse_line_of_one_joint(
    names: &Names,
    item: &SliderItem,
    diagnostics: &mut Diagnostics,
) -> bool {
    let SlidePath::Direction { angle, .. } = &item.path else {
        return false;
    };
    let ExprKind::Name(joint) = &angle.kind else {
        return false;
    };
    if !names.is_joint(&joint.to_string()) {
        return false;
    }
    let fact = format!("`along {joint}` names one joint, but a line leads through two");
    let help = format!("write `along {joint}, JOINT`, or `along ANGLE through {joint}`");
    diagnostics.error_with_help(angle.span, fact, help);
    true
}

/// Returns the number of a joint that the path of a slider names. On the frame it stays where it is
/// drawn.
fn joint_of_guide(
    linkage: &mut Linkage,
    names: &mut Names,
    item: &SliderItem,
    guide: usize,
    name: &Ident,
    diagnostics: &mut Diagnostics,
) -> Option<usize> {
    let number = names.joint(linkage, name, diagnostics)?;
    let joints = &linkage.links[guide].joints;
    if joints.contains(&number) {
        return Some(number);
    }
    if guide == FRAME {
        if refuse_moving_joint(linkage, item, number, name, diagnostics) {
            return None;
        }
        linkage.links[FRAME].joints.push(number);
        linkage.links[FRAME].coordinates.push(None);
        return Some(number);
    }
    // The missing joint can be one that has a mistake.
    if diagnostics.is_empty() {
        let fact = format!("`{name}` is no joint of the link `{}`", item.guide);
        let help = format!("add it to the joints of `{}`", item.guide);
        diagnostics.error_with_help(name.into(), fact, help);
    }
    None
}

/// Reports a joint that cannot stay on the frame for a slider, because links are joined there or a
/// link that turns carries it. Returns true if it is one.
fn refuse_moving_joint(
    linkage: &Linkage,
    item: &SliderItem,
    joint: usize,
    name: &Ident,
    diagnostics: &mut Diagnostics,
) -> bool {
    let links = linkage.links[FRAME + 1..].iter();
    let holders: Vec<&Link> = links.filter(|link| link.joints.contains(&joint)).collect();
    let pivots = &linkage.links[FRAME].joints;
    let is_carried = |link: &&Link| {
        let mut joints = link.joints.iter();
        link.at.is_some() && joints.any(|other| pivots.contains(other))
    };
    if holders.len() < 2 && !holders.iter().any(is_carried) {
        return false;
    }
    let links: Vec<String> = holders.iter().map(|link| link.name.to_string()).collect();
    let links: Vec<&str> = links.iter().map(String::as_str).collect();
    let fact = format!(
        "`{name}` moves with {}, but the line of `{}` is fixed on the frame",
        list(&links),
        item.name
    );
    let help = format!(
        "name a joint of the frame, or another link after `on`; a pivot of the frame is in `link frame: {name}, ...;`"
    );
    diagnostics.error_with_help(name.into(), fact, help);
    true
}

/// Reports a path that the sliding joint gives its line or its middle. Returns true if it does.
fn refuse_path_through_pin(item: &SliderItem, diagnostics: &mut Diagnostics) -> bool {
    let (joints, line) = match &item.path {
        SlidePath::Line(line) => (line.iter().collect::<Vec<_>>(), "a line through itself"),
        SlidePath::Direction { through, .. } => (through.iter().collect(), "a line through itself"),
        SlidePath::Arc { centre, .. } => (vec![centre], "an arc about itself"),
    };
    let Some(same) = joints.into_iter().find(|joint| **joint == item.pin) else {
        return false;
    };
    let fact = format!("`{}` would slide on {line}", item.pin);
    let help = format!(
        "name a joint of `{}` here; `slider` begins with the joint of the other link",
        item.guide
    );
    diagnostics.error_with_help(same.into(), fact, help);
    true
}

/// Reports a sliding joint that no link or not the block has. Returns true if there is a mistake.
fn refuse_pin_of_no_link(
    linkage: &Linkage,
    item: &SliderItem,
    pin: usize,
    block: Option<usize>,
    diagnostics: &mut Diagnostics,
) -> bool {
    // The missing joint can be one that has a mistake.
    if !diagnostics.is_empty() {
        return true;
    }
    let name = &item.pin;
    if let (Some(link), Some(block)) = (block, &item.block)
        && !linkage.links[link].joints.contains(&pin)
    {
        let fact = format!("`{name}` is no joint of the link `{block}`");
        let help = format!("the block has the joint that slides: add it to `{block}`");
        diagnostics.error_with_help(block.into(), fact, help);
        return true;
    }
    let mut links = linkage.links.iter();
    if !links.any(|link| link.joints.contains(&pin)) {
        let fact = format!("`{name}` slides, but belongs to no link");
        let help = format!("add it to a link: `link NAME: ..., {name};`");
        diagnostics.error_with_help(name.into(), fact, help);
        return true;
    }
    false
}

/// Adds a slot that is an arc. A pin in it is as far from the middle as if a link joined both.
fn add_arc<'a>(
    linkage: &mut Linkage<'a>,
    names: &mut Names,
    item: &'a SliderItem,
    [pin, centre, guide]: [usize; 3],
    radius: &'a Option<Toleranced>,
    diagnostics: &mut Diagnostics,
) {
    if item.block.is_some() || item.at.is_some() {
        let fact = "`block` and `at` belong to a straight slot";
        let help = "join the links by another link, from the middle of the arc to the pin";
        diagnostics.error_with_help((&item.name).into(), fact, help);
    }
    let link = linkage.links.len();
    linkage.arcs.push(Arc {
        link,
        pin,
        centre,
        guide,
    });
    names.links.insert(item.name.to_string(), link);
    linkage.links.push(Link {
        name: item.name.clone(),
        joints: vec![centre, pin],
        coordinates: vec![None, None],
        at: None,
        about: None,
        length: radius.as_ref(),
        length_word: RADIUS,
        masses: &[],
        inertias: &[],
    });
}
