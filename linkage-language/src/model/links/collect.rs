//! Names of joints and links to numbers. All mistakes in them are reported.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use super::linkage::{Arc, FRAME, Joint, LENGTH, Link, Linkage, Path, RADIUS, Slider, Wheels};
use super::nodes::ident;
use crate::diagnostic::Diagnostics;
use crate::diagnostic::text::nearest;
use crate::syntax::{
    DrawnJoint, Item, LinkItem, LinkedItem, MechanismDef, SlidePath, SliderItem, WheelsItem,
};

/// The numbers of joints and links.
struct Numbers {
    joints: BTreeMap<String, usize>,
    links: BTreeMap<String, usize>,
}

/// Returns the joints and links of a mechanism.
pub(super) fn collect<'a>(
    definition: &'a MechanismDef,
    diagnostics: &mut Diagnostics,
) -> Linkage<'a> {
    let items = definition.items.iter();
    let linked: Vec<&LinkedItem> = items
        .filter_map(|item| match item {
            Item::Linked(item) => Some(item),
            _ => None,
        })
        .collect();
    let mut linkage = Linkage {
        joints: Vec::new(),
        links: vec![frame(definition)],
        sliders: Vec::new(),
        arcs: Vec::new(),
        wheels: Vec::new(),
        welds: Vec::new(),
    };
    let mut numbers = Numbers {
        joints: BTreeMap::new(),
        links: BTreeMap::from([("frame".to_owned(), FRAME)]),
    };
    for item in &linked {
        if let LinkedItem::Joints(joints) = item {
            for joint in joints {
                add_joint(&mut linkage, &mut numbers, joint, diagnostics);
            }
        }
    }
    let points = points(definition);
    for item in &linked {
        if let LinkedItem::Link(item) = item {
            add_link(&mut linkage, &mut numbers, item, &points, diagnostics);
        }
    }
    for item in &linked {
        match item {
            LinkedItem::Joints(_) | LinkedItem::Link(_) => {}
            LinkedItem::Slider(item) => {
                add_slider(&mut linkage, &mut numbers, item, &points, diagnostics);
            }
            LinkedItem::Gears(item) => add_wheels(&mut linkage, &numbers, item, true, diagnostics),
            LinkedItem::Belt(item) => add_wheels(&mut linkage, &numbers, item, false, diagnostics),
            LinkedItem::Weld(item) => {
                let links = item.links.iter();
                let links: Vec<usize> = links
                    .filter_map(|name| numbers.link(name, diagnostics))
                    .collect();
                for pair in links.windows(2) {
                    if pair[0] == pair[1] {
                        let name = &linkage.links[pair[0]].name;
                        let fact = format!("the link `{name}` is welded to itself");
                        let help = "name another link";
                        diagnostics.error_with_help((&item.links[0]).into(), fact, help);
                    }
                    linkage.welds.push([pair[0], pair[1]]);
                }
            }
        }
    }
    refuse_lonely_joints(&linkage, diagnostics);
    linkage
}

fn frame(definition: &MechanismDef) -> Link<'_> {
    Link {
        name: ident("frame", definition.name.span()),
        joints: Vec::new(),
        coordinates: Vec::new(),
        at: None,
        about: None,
        length: None,
        length_word: LENGTH,
        masses: &[],
        inertias: &[],
    }
}

/// Returns the names of values that can be points: a link may hold on to one.
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

fn add_joint<'a>(
    linkage: &mut Linkage<'a>,
    numbers: &mut Numbers,
    joint: &'a DrawnJoint,
    diagnostics: &mut Diagnostics,
) {
    let number = linkage.joints.len();
    let text = joint.name.to_string();
    if let Some(first) = numbers.joints.get(&text) {
        let fact = format!("the joint `{text}` is drawn twice");
        let span = (&joint.name).into();
        diagnostics.error_with_help(span, fact, "choose another name");
        let first = (&linkage.joints[*first].name).into();
        diagnostics.error(first, format!("`{text}` is first drawn here"));
        return;
    }
    numbers.joints.insert(text, number);
    linkage.joints.push(Joint {
        name: joint.name.clone(),
        drawn: Some(&joint.position),
    });
}

/// Reports a link or a slider with the name of a joint: its quantities would hide the coordinates.
fn refuse_name_of_joint(numbers: &Numbers, name: &Ident, diagnostics: &mut Diagnostics) {
    if numbers.joints.contains_key(&name.to_string()) {
        let fact = format!("`{name}` is a joint already");
        diagnostics.error_with_help(name.into(), fact, "choose another name");
    }
}

fn add_link<'a>(
    linkage: &mut Linkage<'a>,
    numbers: &mut Numbers,
    item: &'a LinkItem,
    points: &[String],
    diagnostics: &mut Diagnostics,
) {
    let mut joints = Vec::new();
    let mut coordinates = Vec::new();
    for joint in &item.joints {
        let Some(number) = numbers.joint(linkage, &joint.name, points, diagnostics) else {
            continue;
        };
        if joints.contains(&number) {
            let fact = format!(
                "the link `{}` has the joint `{}` twice",
                item.name, joint.name
            );
            let help = "leave one of them out";
            diagnostics.error_with_help((&joint.name).into(), fact, help);
            continue;
        }
        joints.push(number);
        coordinates.push(joint.coordinates.as_ref());
    }
    let text = item.name.to_string();
    if text == "frame" {
        let given = coordinates.iter().flatten().next().is_some();
        if given || item.at.is_some() || item.length.is_some() {
            let fact = "the frame does not move: its joints stay where they are drawn";
            let help = "write its joints only: `link frame: a, d;`";
            diagnostics.error_with_help((&item.name).into(), fact, help);
        }
        let frame = &mut linkage.links[FRAME];
        joints.retain(|joint| !frame.joints.contains(joint));
        frame.coordinates.extend(joints.iter().map(|_| None));
        frame.joints.extend(joints);
        return;
    }
    refuse_name_of_joint(numbers, &item.name, diagnostics);
    if numbers.links.contains_key(&text) {
        let fact = format!("the link `{text}` is declared twice");
        let help = "write all of its joints in one place, or choose another name";
        diagnostics.error_with_help((&item.name).into(), fact, help);
        return;
    }
    // A hinge of space needs no axis from joint to joint.
    let axis = if item.about.is_some() { 1 } else { 2 };
    if coordinates.iter().take(axis).any(Option::is_some) {
        let fact = format!(
            "the first two joints of `{text}` are its axis: the first one is its origin, the second one is on its x axis"
        );
        let help = "give `length`, and coordinates of the other joints";
        diagnostics.error_with_help((&item.name).into(), fact, help);
    }
    if item.length.is_some() && joints.len() < 2 {
        let fact = format!("the link `{text}` has one joint, and no length");
        diagnostics.error_with_help((&item.name).into(), fact, "name its second joint");
    }
    numbers.links.insert(text, linkage.links.len());
    linkage.links.push(Link {
        name: item.name.clone(),
        joints,
        coordinates,
        at: item.at.as_ref(),
        about: item.about.as_ref(),
        length: item.length.as_ref(),
        length_word: LENGTH,
        masses: &item.masses,
        inertias: &item.inertias,
    });
}

fn add_slider<'a>(
    linkage: &mut Linkage<'a>,
    numbers: &mut Numbers,
    item: &'a SliderItem,
    points: &[String],
    diagnostics: &mut Diagnostics,
) {
    refuse_name_of_joint(numbers, &item.name, diagnostics);
    let pin = numbers.joint(linkage, &item.pin, points, diagnostics);
    let guide = numbers.link(&item.guide, diagnostics);
    let block = item
        .block
        .as_ref()
        .and_then(|name| numbers.link(name, diagnostics));
    let mut joint = |name: &Ident| {
        let number = numbers.joint(linkage, name, points, diagnostics)?;
        let guide = guide?;
        if linkage.links[guide].joints.contains(&number) {
            return Some(number);
        }
        if guide == FRAME {
            linkage.links[FRAME].joints.push(number);
            linkage.links[FRAME].coordinates.push(None);
            return Some(number);
        }
        let fact = format!("`{name}` is no joint of the link `{}`", item.guide);
        let help = format!("add it to the joints of `{}`", item.guide);
        diagnostics.error_with_help(name.into(), fact, help);
        None
    };
    let path = match &item.path {
        SlidePath::Line([first, second]) => {
            let line = [joint(first), joint(second)];
            let [Some(first), Some(second)] = line else {
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
            if through.is_none() && guide.is_some_and(|guide| guide != FRAME) {
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
            let Some(centre) = joint(centre) else { return };
            let (Some(pin), Some(guide)) = (pin, guide) else {
                return;
            };
            if item.block.is_some() || item.at.is_some() {
                let fact = "`block` and `at` belong to a straight slot";
                let help = "join the links by another link, from the middle of the arc to the pin";
                diagnostics.error_with_help((&item.name).into(), fact, help);
            }
            linkage.arcs.push(Arc {
                link: linkage.links.len(),
                pin,
                centre,
                guide,
            });
            // A pin in the arc is as far from the middle as if a link joined both.
            numbers
                .links
                .insert(item.name.to_string(), linkage.links.len());
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
            return;
        }
    };
    let (Some(pin), Some(guide)) = (pin, guide) else {
        return;
    };
    let mut blocks = linkage.links.iter();
    let holds = |link: usize| linkage.links[link].joints.contains(&pin);
    if let (Some(link), Some(name)) = (block, &item.block)
        && !holds(link)
    {
        let fact = format!("`{}` is no joint of the link `{name}`", item.pin);
        let help = format!("the block has the joint that slides: add it to `{name}`");
        diagnostics.error_with_help(name.into(), fact, help);
        return;
    }
    if linkage.links[guide].joints.contains(&pin) {
        let fact = format!(
            "`{}` is a joint of `{}`, and cannot slide on it",
            item.pin, item.guide
        );
        let help = "name the joint of the link that slides, or leave it out of the guide";
        diagnostics.error_with_help((&item.pin).into(), fact, help);
        return;
    }
    if !blocks.any(|link| link.joints.contains(&pin)) {
        let fact = format!("`{}` slides, but belongs to no link", item.pin);
        let help = format!("add it to a link: `link NAME: ..., {};`", item.pin);
        diagnostics.error_with_help((&item.pin).into(), fact, help);
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

fn add_wheels<'a>(
    linkage: &mut Linkage<'a>,
    numbers: &Numbers,
    item: &'a WheelsItem,
    reverses: bool,
    diagnostics: &mut Diagnostics,
) {
    let wheels = [&item.wheels[0], &item.wheels[1]].map(|name| numbers.link(name, diagnostics));
    let carrier = match &item.carrier {
        Some(name) => numbers.link(name, diagnostics),
        None => Some(FRAME),
    };
    if let ([Some(first), Some(second)], Some(carrier)) = (wheels, carrier) {
        linkage.wheels.push(Wheels {
            wheels: [first, second],
            carrier,
            sizes: &item.sizes,
            reverses,
            item,
        });
    }
}

/// Reports joints that nothing moves.
fn refuse_lonely_joints(linkage: &Linkage, diagnostics: &mut Diagnostics) {
    if !diagnostics.is_empty() {
        return;
    }
    for (number, joint) in linkage.joints.iter().enumerate() {
        let mut links = linkage.links.iter();
        if !links.any(|link| link.joints.contains(&number)) {
            let name = &joint.name;
            let fact = format!("the joint `{name}` belongs to no link");
            let help = format!("add it to a link, or to the frame: `link frame: {name};`");
            diagnostics.error_with_help(name.into(), fact, help);
        }
    }
}

impl Numbers {
    /// Returns the joint of that name, a point of the ordinary language included.
    fn joint(
        &mut self,
        linkage: &mut Linkage,
        name: &Ident,
        points: &[String],
        diagnostics: &mut Diagnostics,
    ) -> Option<usize> {
        let text = name.to_string();
        if let Some(number) = self.joints.get(&text) {
            return Some(*number);
        }
        if points.contains(&text) {
            self.joints.insert(text, linkage.joints.len());
            linkage.joints.push(Joint {
                name: name.clone(),
                drawn: None,
            });
            return Some(linkage.joints.len() - 1);
        }
        let known = self.joints.keys().map(String::as_str);
        let help = match nearest(&text, known) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("write where it is drawn: `joint {text} = (x, y);`"),
        };
        diagnostics.error_with_help(name.into(), format!("unknown joint `{text}`"), help);
        None
    }

    fn link(&self, name: &Ident, diagnostics: &mut Diagnostics) -> Option<usize> {
        let text = name.to_string();
        if let Some(number) = self.links.get(&text) {
            return Some(*number);
        }
        let known = self.links.keys().map(String::as_str);
        let help = match nearest(&text, known) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("declare it: `link {text}: joint, joint;`"),
        };
        diagnostics.error_with_help(name.into(), format!("unknown link `{text}`"), help);
        None
    }
}
