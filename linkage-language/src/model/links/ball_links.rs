//! Links of space that ball joints hold: rods and bodies.

use super::drawing::{Drawing, nominal};
use super::linkage::{Link, Linkage};
use super::locations::{length, parameter, point};
use super::nodes::{call, equation, ident, name};
use super::space_progress::{Progress, on_link, put, vector_on_link};
use crate::diagnostic::Diagnostics;
use crate::diagnostic::text::list;
use crate::model::types::Function;
use crate::syntax::{Item, ItemName, LinkLoop, NamedItem, Toleranced, UnknownItem};

/// The sine of an angle between lines below which they are one line: rounding of coordinates.
const ON_LINE: f64 = 1e-9;

/// Writes a rod between two ball joints: a distance.
pub(super) fn write_rod(progress: &mut Progress, link: usize, diagnostics: &mut Diagnostics) {
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

/// Writes a body that ball joints hold: an unknown frame.
pub(super) fn write_body(progress: &mut Progress, link: usize, diagnostics: &mut Diagnostics) {
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
