//! The joints and links of a mechanism, with numbers instead of names. All mistakes in the names are
//! reported.

use super::collect_sliders::add_slider;
use super::linkage::{FRAME, Joint, LENGTH, Link, Linkage, Wheels};
use super::names::{FRAME_NAME, Names};
use super::nodes::ident;
use crate::diagnostic::Diagnostics;
use crate::syntax::{DrawnJoint, Item, LinkItem, LinkedItem, MechanismDef, WeldItem, WheelsItem};

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
    let mut names = Names::new(definition);
    for item in &linked {
        if let LinkedItem::Joints(joints) = item {
            for joint in joints {
                add_joint(&mut linkage, &mut names, joint, diagnostics);
            }
        }
    }
    for item in &linked {
        if let LinkedItem::Link(item) = item {
            add_link(&mut linkage, &mut names, item, diagnostics);
        }
    }
    for item in &linked {
        match item {
            // A lost item is a mistake, after which nothing is collected.
            LinkedItem::Joints(_) | LinkedItem::Link(_) | LinkedItem::Lost(_) => {}
            LinkedItem::Slider(item) => {
                add_slider(&mut linkage, &mut names, item, diagnostics);
            }
            LinkedItem::Gears(item) => add_wheels(&mut linkage, &names, item, true, diagnostics),
            LinkedItem::Belt(item) => add_wheels(&mut linkage, &names, item, false, diagnostics),
            LinkedItem::Weld(item) => add_weld(&mut linkage, &names, item, diagnostics),
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

fn add_joint<'a>(
    linkage: &mut Linkage<'a>,
    names: &mut Names,
    joint: &'a DrawnJoint,
    diagnostics: &mut Diagnostics,
) {
    let number = linkage.joints.len();
    let text = joint.name.to_string();
    if let Some(first) = names.joints.get(&text) {
        let fact = format!("the joint `{text}` is drawn twice");
        let span = (&joint.name).into();
        diagnostics.error_with_help(span, fact, "choose another name");
        let first = (&linkage.joints[*first].name).into();
        let related = diagnostics.error(first, format!("`{text}` is first drawn here"));
        related.is_related = true;
        return;
    }
    names.joints.insert(text, number);
    linkage.joints.push(Joint {
        name: joint.name.clone(),
        drawn: Some(&joint.position),
    });
}

fn add_link<'a>(
    linkage: &mut Linkage<'a>,
    names: &mut Names,
    item: &'a LinkItem,
    diagnostics: &mut Diagnostics,
) {
    let mut joints = Vec::new();
    let mut coordinates = Vec::new();
    for joint in &item.joints {
        let Some(number) = names.joint(linkage, &joint.name, diagnostics) else {
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
    if text == FRAME_NAME {
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
    names.refuse_name_of_joint(&item.name, diagnostics);
    if names.links.contains_key(&text) {
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
    names.links.insert(text, linkage.links.len());
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

fn add_wheels<'a>(
    linkage: &mut Linkage<'a>,
    names: &Names,
    item: &'a WheelsItem,
    reverses: bool,
    diagnostics: &mut Diagnostics,
) {
    if item
        .wheels
        .iter()
        .all(|name| names.is_joint(&name.to_string()))
    {
        refuse_joints_as_wheels(names, item, reverses, diagnostics);
        return;
    }
    let wheels = [&item.wheels[0], &item.wheels[1]].map(|name| names.link(name, diagnostics));
    let carrier = match &item.carrier {
        Some(name) => names.link(name, diagnostics),
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

/// Reports wheels that are named by their pivots.
fn refuse_joints_as_wheels(
    names: &Names,
    item: &WheelsItem,
    reverses: bool,
    diagnostics: &mut Diagnostics,
) {
    let [one, other] = &item.wheels;
    let word = if reverses { "gears" } else { "belt" };
    let wheels = match item.wheels.each_ref().map(|joint| {
        let joint = joint.to_string();
        match names.links_with(&joint)[..] {
            [link] => Some(link.to_owned()),
            _ => None,
        }
    }) {
        [Some(one), Some(other)] => format!("{one}, {other}"),
        _ => "LINK, LINK".to_owned(),
    };
    let fact = format!("`{one}` and `{other}` are joints, but wheels are links");
    let help = format!("name the links that turn there: `{word} {wheels} teeth 20, 40;`");
    diagnostics.error_with_help(one.into(), fact, help);
}

fn add_weld(linkage: &mut Linkage, names: &Names, item: &WeldItem, diagnostics: &mut Diagnostics) {
    let links = item.links.iter();
    let links: Vec<usize> = links
        .filter_map(|name| names.link(name, diagnostics))
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
