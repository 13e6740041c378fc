//! Joints and links of space: hinges, rods between ball joints, and bodies that ball joints hold.

use super::drawing::{Drawing, nominal};
use super::inventory::closed_joint;
use super::linkage::{FRAME, Link, Linkage};
use super::locations::{angle, length, parameter, point};
use super::nodes::{call, difference, equation, ident, name, quantity, sum};
use crate::diagnostic::Diagnostics;
use crate::diagnostic::text::list;
use crate::model::types::Function;
use crate::syntax::{Expr, Item, ItemName, LinkLoop, NamedItem, Toleranced, UnknownItem};

/// The sine of an angle between lines below which they are one line: rounding of coordinates.
const ON_LINE: f64 = 1e-9;

/// A link that is reached: the turns of its hinge and of those before it, the last one first.
type Turns = Vec<(Expr, Expr)>;

/// What is written so far.
struct Progress<'a> {
    linkage: &'a Linkage<'a>,
    drawing: &'a Drawing,
    /// The link that carries each joint whose position is written.
    seats: Vec<Option<usize>>,
    /// The turns of each hinged link that is written.
    turns: Vec<Option<Turns>>,
    items: Vec<Item>,
}

/// Returns the items of a linkage of space.
pub(super) fn items(
    linkage: &Linkage,
    drawing: &Drawing,
    fixed: Vec<Item>,
    diagnostics: &mut Diagnostics,
) -> Vec<Item> {
    refuse_items_of_the_plane(linkage, diagnostics);
    let mut progress = Progress {
        linkage,
        drawing,
        seats: vec![None; linkage.joints.len()],
        turns: vec![None; linkage.links.len()],
        items: fixed,
    };
    for (index, joint) in linkage.joints.iter().enumerate() {
        if joint.drawn.is_none() || linkage.links[FRAME].joints.contains(&index) {
            progress.seats[index] = Some(FRAME);
        }
    }
    progress.turns[FRAME] = Some(Vec::new());
    let mut open: Vec<usize> = (FRAME + 1..linkage.links.len()).collect();
    let hinged = |progress: &Progress, link: usize| {
        let item = &linkage.links[link];
        let seat = progress.seats[item.joints[0]];
        item.about.is_some() && seat.is_some_and(|seat| progress.turns[seat].is_some())
    };
    while let Some(next) = open.iter().position(|link| hinged(&progress, *link)) {
        write_hinge(&mut progress, open.remove(next), diagnostics);
    }
    // Ends of rods are points of bodies, so that a body on rods has no unknowns but its frame.
    open.sort_by_key(|link| linkage.links[*link].joints.len() < 3);
    for &link in &open {
        let item = &linkage.links[link];
        let name = &item.name;
        if item.about.is_some() || item.at.is_some() {
            let fact = format!("the hinge of the link `{name}` is in no joint that is reached");
            let help = "its first joint is on the hinge: let it be one of the frame or of a hinged \
                        link before, and give the axis by `about (0, 0, 1)`";
            diagnostics.error_with_help(name.into(), fact, help);
        } else if item.joints.len() < 2 {
            let fact = format!("the link `{name}` has one joint");
            let help = "name its other joints, or give its hinge an axis: `about (0, 0, 1)`";
            diagnostics.error_with_help(name.into(), fact, help);
        } else if item.joints.len() == 2 {
            write_rod(&mut progress, link, diagnostics);
        } else {
            write_body(&mut progress, link, diagnostics);
        }
    }
    progress.items
}

fn refuse_items_of_the_plane(linkage: &Linkage, diagnostics: &mut Diagnostics) {
    let sliders = linkage.sliders.iter().map(|slider| &slider.name);
    let wheels = linkage.wheels.iter().map(|pair| &pair.item.wheels[0]);
    let welds = linkage
        .welds
        .iter()
        .map(|pair| &linkage.links[pair[0]].name);
    for name in sliders.chain(wheels).chain(welds) {
        let fact = "sliders, gears, belts and welds belong to the plane";
        let help = "write them in space as a `loop`, beside joints and links";
        diagnostics.error_with_help(name.into(), fact, help);
    }
    for link in &linkage.links {
        if !link.masses.is_empty() || !link.inertias.is_empty() {
            let fact = "links of space have no masses";
            let help = format!(
                "write `body {} = ball on frame at ..., mass ...`",
                link.name
            );
            diagnostics.error_with_help((&link.name).into(), fact, help);
        }
    }
}

/// Writes a link that turns about an axis in its first joint.
fn write_hinge(progress: &mut Progress, link: usize, diagnostics: &mut Diagnostics) {
    let Progress {
        linkage, drawing, ..
    } = *progress;
    let item = &linkage.links[link];
    let origin = item.joints[0];
    let Some(axis) = item.about.cloned() else {
        return;
    };
    let components = drawing.components(&axis);
    if components.is_some_and(|axis| axis.iter().all(|component| *component == 0.0)) {
        let fact = format!(
            "the hinge of `{}` has no axis: `about` has no direction",
            item.name
        );
        let help = "write a direction such as `(0, 0, 1)`, of any length";
        diagnostics.error_with_help(axis.span, fact, help);
        return;
    }
    let turn = ItemName::of_link(item.name.clone(), ident("angle", item.name.span()));
    progress.items.push(match item.at {
        // The drawing shows the link at the reference.
        Some(at) => Item::Let(NamedItem {
            name: turn,
            value: difference(at.clone(), drawing.at_reference(at)),
        }),
        None => Item::Unknown(UnknownItem {
            name: turn,
            estimate: Some(super::nodes::number("0", "deg", (&item.name).into())),
        }),
    });
    let seat = progress.seats[origin].unwrap_or(FRAME);
    let mut turns = progress.turns[seat].clone().unwrap_or_default();
    turns.insert(0, (axis, angle(linkage, link)));
    for (index, &joint) in item.joints.iter().enumerate().skip(1) {
        let vector = vector_on_link(item, index, drawing.vector(origin, joint));
        let (parameter, vector) = on_link(linkage, link, joint, vector);
        progress.items.extend(parameter);
        let turned = turns.iter().fold(vector, |vector, (axis, angle)| {
            call(Function::Turn, vec![vector, axis.clone(), angle.clone()])
        });
        let position = sum(point(linkage, origin), turned);
        put(progress, link, joint, position);
    }
    progress.turns[link] = Some(turns);
}

/// Returns the given or the drawn vector of a joint.
fn vector_on_link(item: &Link, index: usize, drawn: Option<Expr>) -> Option<Toleranced> {
    let drawn = drawn.map(|nominal| Toleranced::Single {
        nominal,
        tolerance: None,
    });
    item.coordinates[index].cloned().or(drawn)
}

/// Returns the parameter that a place on a link is, and its name as an expression.
fn on_link(
    linkage: &Linkage,
    link: usize,
    joint: usize,
    vector: Option<Toleranced>,
) -> (Option<Item>, Expr) {
    let (link, joint) = (&linkage.links[link].name, &linkage.joints[joint].name);
    let parameter = vector.map(|vector| parameter(link, joint, vector));
    (parameter, quantity(link, joint))
}

/// Writes the position of a joint by a link, or a loop if it has one.
fn put(progress: &mut Progress, link: usize, joint: usize, position: Expr) {
    let name = progress.linkage.joints[joint].name.clone();
    let item = match progress.seats[joint] {
        None => {
            progress.seats[joint] = Some(link);
            Item::Let(NamedItem {
                name: name.into(),
                value: position,
            })
        }
        Some(_) => {
            let item = &progress.linkage.links[link];
            equation(
                point(progress.linkage, joint),
                position,
                closed_joint(progress.linkage, link, &item.joints, joint),
                (&item.name).into(),
            )
        }
    };
    progress.items.push(item);
}

/// Writes a rod between two ball joints: a distance.
fn write_rod(progress: &mut Progress, link: usize, diagnostics: &mut Diagnostics) {
    let Progress {
        linkage, drawing, ..
    } = *progress;
    let item = &linkage.links[link];
    let ends = [item.joints[0], item.joints[1]];
    let drawn = drawing.vector(ends[0], ends[1]);
    let given = item.length.cloned();
    let value = given.or_else(|| {
        Some(Toleranced::Single {
            nominal: call(Function::Norm, vec![drawn?]),
            tolerance: None,
        })
    });
    let Some(value) = value else {
        let fact = format!("the length of the link `{}` is not known", item.name);
        let help = "write `length 50mm` after its joints";
        diagnostics.error_with_help((&item.name).into(), fact, help);
        return;
    };
    let word = ident(item.length_word, item.name.span());
    progress
        .items
        .push(if drawing.is_constant(&nominal(&value)) {
            parameter(&item.name, &word, value)
        } else {
            Item::Let(NamedItem {
                name: ItemName::of_link(item.name.clone(), word),
                value: nominal(&value),
            })
        });
    for joint in ends {
        write_free_joint(progress, joint, link);
    }
    let of = LinkLoop::Rod {
        link: item.name.to_string(),
        ends: ends.map(|joint| linkage.joints[joint].name.to_string()),
    };
    let ends = ends.map(|joint| point(linkage, joint));
    let distance = call(Function::Distance, ends.to_vec());
    let span = (&item.name).into();
    progress
        .items
        .push(equation(distance, length(linkage, link), of, span));
}

/// Writes a joint that rods alone hold: an unknown point.
fn write_free_joint(progress: &mut Progress, joint: usize, link: usize) {
    if progress.seats[joint].is_some() {
        return;
    }
    progress.seats[joint] = Some(link);
    progress.items.push(Item::Unknown(UnknownItem {
        name: progress.linkage.joints[joint].name.clone().into(),
        estimate: progress.drawing.positions[joint].clone(),
    }));
}

/// Returns a joint that is not on the line through the first two joints of a body; the third joint
/// if positions are not known as numbers.
fn joint_beside_line(item: &Link, drawing: &Drawing) -> Option<usize> {
    let vector = |joint: usize| {
        let vector = drawing.vector(item.joints[0], joint)?;
        <[f64; 3]>::try_from(drawing.components(&vector)?).ok()
    };
    let is_beside = |joint: usize| {
        let (Some([x, y, z]), Some([u, v, w])) = (vector(item.joints[1]), vector(joint)) else {
            return true;
        };
        let across = (y * w - z * v).hypot(z * u - x * w).hypot(x * v - y * u);
        let size = x.hypot(y).hypot(z) * u.hypot(v).hypot(w);
        across > ON_LINE * size
    };
    let mut others = item.joints[2..].iter().copied();
    others.find(|joint| is_beside(*joint))
}

fn report_joints_on_one_line(linkage: &Linkage, item: &Link, diagnostics: &mut Diagnostics) {
    let names = item.joints.iter();
    let names: Vec<String> = names
        .map(|joint| linkage.joints[*joint].name.to_string())
        .collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let fact = format!(
        "the joints {} of `{}` are on one line: nothing holds its turn about this line",
        list(&names),
        item.name
    );
    let help = "draw one of them beside the line; a rod has two joints";
    diagnostics.error_with_help((&item.name).into(), fact, help);
}

/// Writes a body that ball joints hold: an unknown frame.
fn write_body(progress: &mut Progress, link: usize, diagnostics: &mut Diagnostics) {
    let Progress {
        linkage, drawing, ..
    } = *progress;
    let item = &linkage.links[link];
    let [first, second] = [item.joints[0], item.joints[1]];
    let Some(third) = joint_beside_line(item, drawing) else {
        return report_joints_on_one_line(linkage, item, diagnostics);
    };
    let drawn = drawing.positions[first].clone().and_then(|origin| {
        let x = drawing.vector(first, second)?;
        let across = drawing.vector(first, third)?;
        let z = call(Function::Cross, vec![x.clone(), across]);
        Some(call(Function::Frame, vec![origin, x, z]))
    });
    progress.items.push(Item::Unknown(UnknownItem {
        name: item.name.clone().into(),
        estimate: drawn.clone(),
    }));
    for (index, &joint) in item.joints.iter().enumerate() {
        let coordinates = drawn.clone().and_then(|frame| {
            let position = drawing.positions[joint].clone()?;
            Some(call(Function::CoordinatesIn, vec![frame, position]))
        });
        let vector = vector_on_link(item, index, coordinates);
        let (parameter, vector) = on_link(linkage, link, joint, vector);
        progress.items.extend(parameter);
        let position = call(Function::PointIn, vec![name(&item.name), vector]);
        put(progress, link, joint, position);
    }
}
