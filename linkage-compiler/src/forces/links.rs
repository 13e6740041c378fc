//! Links that one cut joint holds at their other end: their own moment gives the part of that joint's reaction across them.

use crate::forces::freedom;
use crate::forces::wrench;
use linkage_symbolic::{Vector, Vn};

use crate::model::JointKind;

use super::Mechanics;
use super::system::{Equation, System};
use super::wrench::Wrench;

/// A cut joint whose reaction is open only along a link.
#[derive(Clone, Debug)]
pub(super) struct Axial {
    pub(super) joint: usize,
    pub(super) link: usize,
}

/// Links of large blocks that one cut joint holds, and all rods.
pub(super) fn links(mechanics: &Mechanics<'_, '_>, system: &System) -> Vec<Axial> {
    let mut links: Vec<Axial> = Vec::new();
    for &joint in &mechanics.forces.tree.closing {
        let declared = &mechanics.algebra.mechanism.joints[joint];
        let plane = mechanics.forces.geometry.is_plane();
        let kind = match plane {
            true => JointKind::Pin,
            false => JointKind::Ball,
        };
        if declared.kind != kind {
            continue;
        }
        let mut links_here = Vec::new();
        for end in [Some(declared.body), declared.on] {
            let tree = &mechanics.forces.tree;
            let up = std::iter::successors(end, |&body| tree.parent[body]);
            links_here.extend(up.filter(|&body| is_link(mechanics, system, body, joint, kind)));
        }
        let wanted = links_here.into_iter().find(|&body| match plane {
            true => system.in_large_block(joint, body),
            false => freedom::is_rod(mechanics, body),
        });
        links.extend(wanted.map(|link| Axial { joint, link }));
    }
    links
}

/// True if a body hangs by a pin (in space a ball joint), and one cut joint holds it and what hangs on it as if it were one body.
fn is_link(
    mechanics: &Mechanics<'_, '_>,
    system: &System,
    body: usize,
    joint: usize,
    kind: JointKind,
) -> bool {
    let mechanism = mechanics.algebra.mechanism;
    let own = &mechanism.joints[mechanism.bodies[body].joint];
    let tree = &mechanics.forces.tree;
    let hangs = |other: usize| tree.hangs_on(Some(other), body);
    let cuts = |other: &usize| {
        let declared = &mechanism.joints[*other];
        hangs(declared.body) || declared.on.is_some_and(hangs)
    };
    let mut cut = tree.closing.iter().filter(|other| cuts(other));
    let mut moves = system.equations.iter().filter_map(Equation::way);
    own.kind == kind
        && cut.all(|&other| other == joint)
        && wrench::joins(mechanics, joint, body) != 0
        && !moves.any(|way| way.body != body && hangs(way.body))
        && !(0..mechanism.bodies.len()).any(|other| hangs(other) && system.ties(other))
}

/// From a link's origin to the cut joint at its other end.
pub(super) fn link_vector<'m>(mechanics: &Mechanics<'_, 'm>, axial: &Axial) -> Vn<'m> {
    mechanics.arm(axial.link, mechanics.forces.geometry.points[axial.joint])
}

/// The part of a reaction that holds a link against its own loads: `-M perp(V) / V^2`, in space `(V x M) / V^2`.
pub(super) fn across_link<'m>(mechanics: &mut Mechanics<'_, 'm>, axial: &Axial) -> Wrench<'m> {
    // Without the reaction itself.
    let loads = wrench::wrench(mechanics, axial.link, &[axial.joint], &[]);
    let v = link_vector(mechanics, axial);
    let square = v.square();
    let across = match mechanics.forces.geometry.is_plane() {
        true => loads.moment.at(0) * Vn::from(Vector([v.at(1), -v.at(0)])),
        false => v.moment_of(loads.moment),
    };
    let force = across / square;
    Wrench {
        force: match wrench::joins(mechanics, axial.joint, axial.link) < 0 {
            true => -force,
            false => force,
        },
        ..wrench::zero_wrench(mechanics)
    }
}
