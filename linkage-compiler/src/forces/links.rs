//! Links that one cut joint holds at their other end: their own moment gives the part of that
//! joint's reaction across them.

use linkage_symbolic::Vn;

use crate::forces::cut_joints;
use crate::forces::multibody::Multibody;
use crate::forces::system::{Axial, Equation, System};
use crate::model::Mechanism;

/// Links of large blocks that one cut joint holds, and all rods.
pub(super) fn links(mechanism: &Mechanism, bodies: &Multibody, system: &System) -> Vec<Axial> {
    let mut links: Vec<Axial> = Vec::new();
    for &joint in &bodies.tree.closing {
        let declared = &mechanism.joints[joint];
        let plane = bodies.geometry.is_plane();
        if !declared.kind.transmits_no_moment(plane) {
            continue;
        }
        let mut links_here = Vec::new();
        for end in [Some(declared.body), declared.on] {
            let tree = &bodies.tree;
            let up = std::iter::successors(end, |&body| tree.parent[body]);
            links_here.extend(up.filter(|&body| is_link(mechanism, bodies, system, body, joint)));
        }
        let wanted = links_here.into_iter().find(|&body| {
            if plane {
                system.in_large_block(joint, body)
            } else {
                bodies.geometry.rod(body).is_some()
            }
        });
        links.extend(wanted.map(|link| Axial { joint, link }));
    }
    links
}

/// True if the own joint of a body transmits no moment, and one cut joint holds the body and its
/// descendants as if they were one body.
fn is_link(
    mechanism: &Mechanism,
    bodies: &Multibody,
    system: &System,
    body: usize,
    joint: usize,
) -> bool {
    let body_joint = &mechanism.joints[mechanism.bodies[body].joint];
    let tree = &bodies.tree;
    let hangs = |other: usize| tree.hangs_on(Some(other), body);
    let cuts = |other: &usize| {
        let declared = &mechanism.joints[*other];
        hangs(declared.body) || declared.on.is_some_and(hangs)
    };
    let mut cut = tree.closing.iter().filter(|other| cuts(other));
    let mut moves = system.equations.iter().filter_map(Equation::motion);
    body_joint
        .kind
        .transmits_no_moment(bodies.geometry.is_plane())
        && cut.all(|&other| other == joint)
        && cut_joints::joins(mechanism, &bodies.tree, joint, body) != 0
        && !moves.any(|way| way.body != body && hangs(way.body))
        && !(0..mechanism.bodies.len()).any(|other| hangs(other) && system.ties(other))
}

/// The vector from a link's origin to the cut joint at its other end.
pub(super) fn link_vector<'m>(bodies: &Multibody<'m>, axial: &Axial) -> Vn<'m> {
    bodies.arm(axial.link, bodies.geometry.points[axial.joint])
}
