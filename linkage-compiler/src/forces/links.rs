//! Links that one cut joint holds at their other end: their own moment gives the part of that joint's reaction across them.

use linkage_symbolic::NodeId;

use crate::model::JointKind;

use super::Mechanics;
use super::system::System;
use super::wrench::Wrench;

/// A cut joint whose reaction is open only along a link.
#[derive(Clone, Debug)]
pub(super) struct Axial {
    pub(super) joint: usize,
    pub(super) link: usize,
}

impl Mechanics<'_, '_> {
    /// Links of large blocks that one cut joint holds, and all rods.
    pub(super) fn links(&self, system: &System) -> Vec<Axial> {
        let mut links: Vec<Axial> = Vec::new();
        for &joint in &self.forces.tree.closing {
            let declared = &self.algebra.mechanism.joints[joint];
            let plane = self.forces.geometry.dimensions == 2;
            let kind = if plane {
                JointKind::Pin
            } else {
                JointKind::Ball
            };
            if declared.kind != kind {
                continue;
            }
            let ends = [Some(declared.body), declared.on].into_iter().flatten();
            let mut links_here =
                ends.filter(|&body| self.is_link(body, joint, kind) && !system.ties(body));
            let wanted = match plane {
                true => links_here.find(|&body| system.in_large_block(joint, body)),
                false => links_here.find(|&body| self.is_rod(body)),
            };
            links.extend(wanted.map(|link| Axial { joint, link }));
        }
        links
    }

    /// True if a body hangs by a pin (in space a ball joint), nothing hangs on it, and one cut joint holds it.
    fn is_link(&self, body: usize, joint: usize, kind: JointKind) -> bool {
        let mechanism = self.algebra.mechanism;
        let own = &mechanism.joints[mechanism.bodies[body].joint];
        let mut closing = self.forces.tree.closing.iter();
        own.kind == kind
            && self.forces.tree.children[body].is_empty()
            && closing.all(|&other| other == joint || self.joins(other, body) == 0)
    }

    /// From a link's origin to the cut joint at its other end.
    pub(super) fn link_vector(&mut self, axial: &Axial) -> Vec<NodeId> {
        let point = self.forces.geometry.points[axial.joint].clone();
        self.arm(axial.link, &point)
    }

    /// The part of a reaction that holds a link against its own loads: `-M perp(V) / V^2`, in space `(V x M) / V^2`.
    pub(super) fn across_link(&mut self, axial: &Axial) -> Wrench {
        let loads = self.own_wrench(axial.link);
        let along = self.link_vector(axial);
        let square = self.algebra.sum_of_squares(&along);
        let across = match loads.moment[..] {
            [moment] => {
                let across = [along[1], self.algebra.graph.neg(along[0])];
                self.algebra.times(moment, &across)
            }
            _ => self.algebra.moment_of(&along, &loads.moment),
        };
        let graph = &mut self.algebra.graph;
        let mut force: Vec<NodeId> = across.into_iter().map(|x| graph.div(x, square)).collect();
        if self.algebra.mechanism.joints[axial.joint].body != axial.link {
            force = self.algebra.opposite(&force);
        }
        let turns = self.forces.geometry.turns();
        Wrench {
            force,
            moment: self.algebra.zeros(turns),
        }
    }
}
