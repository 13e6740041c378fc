//! Items of space while they are written, and joints on links.

use super::drawing::Drawing;
use super::inventory::closed_joint;
use super::linkage::{Link, Linkage};
use super::locations::{parameter, point};
use super::nodes::{equation, quantity};
use crate::syntax::{Expr, Item, NamedItem, Toleranced};

/// A link that is reached: the turns of its hinge and of those before it, the last one first.
pub(super) type TurnSequence = Vec<(Expr, Expr)>;

/// What is written so far.
pub(super) struct Progress<'a> {
    pub(super) linkage: &'a Linkage<'a>,
    pub(super) drawing: &'a Drawing,
    /// The link that carries each joint whose position is written.
    pub(super) seats: Vec<Option<usize>>,
    /// The turns of each hinged link that is written.
    pub(super) turns: Vec<Option<TurnSequence>>,
    pub(super) items: Vec<Item>,
}

/// Returns the given or the drawn vector of a joint.
pub(super) fn vector_on_link(item: &Link, index: usize, drawn: Option<Expr>) -> Option<Toleranced> {
    let drawn = drawn.map(|nominal| Toleranced::Single {
        nominal,
        tolerance: None,
    });
    item.coordinates[index].cloned().or(drawn)
}

/// Returns the parameter that a place on a link is, and its name as an expression.
pub(super) fn on_link(
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
pub(super) fn put(progress: &mut Progress, link: usize, joint: usize, position: Expr) {
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
