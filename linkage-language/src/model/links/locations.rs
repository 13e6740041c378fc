//! Joints in the axes of their body: the first joint of the link that leads it is the origin, the
//! second one is on the x axis.

use proc_macro2::Ident;

use super::drawing::{Drawing, nominal};
use super::linkage::{FRAME, Link, Linkage};
use super::nodes::{call, difference, ident, name, negative, number, pair, quantity, sum};
use super::rigid_bodies::{Bodies, Body};
use crate::diagnostic::{Diagnostics, SourceSpan};
use crate::model::types::Function;
use crate::syntax::{Expr, Item, ItemName, NamedItem, ParamItem, Toleranced};

/// The index of a joint on a body.
enum Location {
    Origin,
    /// On the x axis.
    Axis(Expr),
    /// Anywhere.
    Vector(Expr),
}

/// The link that has the joint first, and its number there.
fn owner(linkage: &Linkage, body: &Body, joint: usize) -> (usize, usize) {
    let mut links = body.links.iter();
    let found = links.find_map(|link| {
        let mut joints = linkage.links[*link].joints.iter();
        Some((*link, joints.position(|other| *other == joint)?))
    });
    found.expect("the joint is one of the body")
}

fn location(linkage: &Linkage, body: &Body, joint: usize) -> Location {
    let (link, index) = owner(linkage, body, joint);
    let name = &linkage.links[link].name;
    if link == body.lead() && index == 0 {
        return Location::Origin;
    }
    if link == body.lead() && index == 1 {
        return Location::Axis(length(linkage, link));
    }
    Location::Vector(quantity(name, &linkage.joints[joint].name))
}

/// `link.length`
pub(super) fn length(linkage: &Linkage, link: usize) -> Expr {
    let link = &linkage.links[link];
    quantity(&link.name, &ident(link.length_word, link.name.span()))
}

/// `link.angle`
pub(super) fn angle(linkage: &Linkage, link: usize) -> Expr {
    let name = &linkage.links[link].name;
    quantity(name, &ident("angle", name.span()))
}

/// Returns the position of a joint of a moving body by that of another joint.
pub(super) fn position(linkage: &Linkage, body: &Body, from: (usize, Expr), joint: usize) -> Expr {
    let (from, base) = from;
    let turned = |vector: Expr| {
        let angle = angle(linkage, body.lead());
        call(Function::Rotate, vec![vector, angle])
    };
    let along = |length: Expr| {
        let angle = angle(linkage, body.lead());
        call(Function::Polar, vec![length, angle])
    };
    let places = [from, joint].map(|joint| location(linkage, body, joint));
    match places {
        [Location::Origin, Location::Origin] => base,
        [Location::Origin, Location::Axis(length)] => sum(base, along(length)),
        [Location::Origin, Location::Vector(vector)] => sum(base, turned(vector)),
        [Location::Axis(length), Location::Origin] => difference(base, along(length)),
        [Location::Vector(vector), Location::Origin] => difference(base, turned(vector)),
        [from, to] => sum(base, turned(difference(vector(to), vector(from)))),
    }
}

fn vector(location: Location) -> Expr {
    match location {
        Location::Origin => unreachable!("differences from the origin are simpler"),
        Location::Axis(length) => {
            let zero = number("0", "mm", length.span);
            pair(length, zero)
        }
        Location::Vector(vector) => vector,
    }
}

/// Returns the angle, in the axes of the body, of the line from one joint to another; `None` for
/// the x axis.
pub(super) fn angle_of_line(
    linkage: &Linkage,
    body: &Body,
    [first, second]: [usize; 2],
) -> Option<Expr> {
    let places = [first, second].map(|joint| location(linkage, body, joint));
    let angle = |vector: Expr| Some(call(Function::Angle, vec![vector]));
    match places {
        [Location::Origin, Location::Axis(_)] => None,
        [Location::Origin, Location::Vector(vector)] => angle(vector),
        [Location::Axis(length), Location::Origin] => Some(number("180", "deg", length.span)),
        [Location::Vector(vector), Location::Origin] => angle(negative(vector)),
        [from, to] => angle(difference(vector(to), vector(from))),
    }
}

/// Returns the parameters that joints and lengths of moving bodies are, and derived quantities for
/// lengths that are computed.
pub(super) fn items(
    linkage: &Linkage,
    bodies: &Bodies,
    drawing: &Drawing,
    diagnostics: &mut Diagnostics,
) -> Vec<Item> {
    let mut items = Vec::new();
    for body in &bodies.list[FRAME + 1..] {
        for &link in &body.links {
            let lead = &linkage.links[body.lead()];
            let item = &linkage.links[link];
            if let [_, second, ..] = item.joints[..]
                && link == body.lead()
            {
                items.extend(length_item(linkage, link, second, drawing, diagnostics));
            }
            for (index, &joint) in item.joints.iter().enumerate() {
                let is_new = owner(linkage, body, joint) == (link, index);
                let in_axes = link == body.lead() && index < 2;
                if !is_new || in_axes {
                    continue;
                }
                let joint_name = &linkage.joints[joint].name;
                let drawn = || in_axes_of(lead.joints.as_slice(), joint, drawing);
                let value = match item.coordinates[index] {
                    Some(given) => Some(given.clone()),
                    None => drawn().map(|nominal| Toleranced::Single {
                        nominal,
                        tolerance: None,
                    }),
                };
                let Some(value) = value else {
                    let fact = format!(
                        "the index of `{joint_name}` on the link `{}` is not known",
                        item.name
                    );
                    let help = format!("give its coordinates: `{joint_name} = (x, y)`");
                    diagnostics.error_with_help(joint_name.into(), fact, help);
                    continue;
                };
                items.push(parameter(&item.name, joint_name, value));
            }
        }
    }
    items
}

/// Returns the coordinates of a joint as drawn, in the axes that two joints give.
fn in_axes_of(axes: &[usize], joint: usize, drawing: &Drawing) -> Option<Expr> {
    let vector = drawing.vector(*axes.first()?, joint)?;
    let Some(second) = axes.get(1) else {
        return Some(vector);
    };
    let axis = drawing.vector(axes[0], *second)?;
    let angle = call(Function::Angle, vec![axis]);
    Some(call(Function::Rotate, vec![vector, negative(angle)]))
}

fn length_item(
    linkage: &Linkage,
    link: usize,
    second: usize,
    drawing: &Drawing,
    diagnostics: &mut Diagnostics,
) -> Option<Item> {
    let item = &linkage.links[link];
    let word = ident(item.length_word, item.name.span());
    let Some(given) = item.length else {
        let Some(axis) = drawing.vector(item.joints[0], second) else {
            let fact = format!("the length of the link `{}` is not known", item.name);
            let help = format!("write `{word} 50mm` after its joints");
            diagnostics.error_with_help((&item.name).into(), fact, help);
            return None;
        };
        let nominal = call(Function::Norm, vec![axis]);
        let value = Toleranced::Single {
            nominal,
            tolerance: None,
        };
        return Some(parameter(&item.name, &word, value));
    };
    let nominal = nominal(given);
    if drawing.is_constant(&nominal) {
        return Some(parameter(&item.name, &word, given.clone()));
    }
    Some(Item::Let(NamedItem {
        name: ItemName::of_link(item.name.clone(), word),
        value: nominal,
    }))
}

pub(super) fn parameter(link: &Ident, quantity: &Ident, value: Toleranced) -> Item {
    Item::Param(ParamItem {
        attributes: Vec::new(),
        name: ItemName::of_link(link.clone(), quantity.clone()),
        value,
    })
}

/// Returns true for a link whose length is an input or computed.
pub(super) fn is_cylinder(link: &Link, drawing: &Drawing) -> bool {
    let length = link.length.map(nominal);
    length.is_some_and(|length| !drawing.is_constant(&length))
}

/// The expression of a joint by its name.
pub(super) fn point(linkage: &Linkage, joint: usize) -> Expr {
    name(&linkage.joints[joint].name)
}

/// The direction of a link as drawn, `0deg` for a link of one joint.
pub(super) fn drawn_angle(linkage: &Linkage, link: usize, drawing: &Drawing) -> Option<Expr> {
    let item = &linkage.links[link];
    match item.joints[..] {
        [first, second, ..] => {
            let axis = drawing.vector(first, second)?;
            Some(call(Function::Angle, vec![axis]))
        }
        _ => Some(number("0", "deg", SourceSpan::from(&item.name))),
    }
}
