//! The tree of bodies: each body is attached to its parent, and the frame is the root. The other
//! joints close loops.

use crate::model::Mechanism;

#[derive(Clone, Debug, Default)]
pub(super) struct Tree {
    /// `None` is the frame.
    pub(super) parent: Vec<Option<usize>>,
    pub(super) children: Vec<Vec<usize>>,
    /// The joints that close loops.
    pub(super) closing: Vec<usize>,
    /// Bodies, each behind the one that it hangs on.
    pub(super) order: Vec<usize>,
}

impl Tree {
    pub(super) fn new(mechanism: &Mechanism) -> Self {
        let bodies = &mechanism.bodies;
        let parent: Vec<_> = bodies
            .iter()
            .map(|body| mechanism.joints[body.joint].on)
            .collect();
        let mut children = vec![Vec::new(); bodies.len()];
        for (body, parent) in parent.iter().enumerate() {
            if let Some(parent) = *parent {
                children[parent].push(body);
            }
        }
        let is_body_joint = |joint: &usize| bodies.iter().any(|body| body.joint == *joint);
        let closing = (0..mechanism.joints.len())
            .filter(|joint| !is_body_joint(joint))
            .collect();
        let mut order: Vec<usize> = (0..bodies.len())
            .filter(|&body| parent[body].is_none())
            .collect();
        let mut next = 0;
        while next < order.len() {
            order.extend(&children[order[next]]);
            next += 1;
        }
        Self {
            parent,
            children,
            closing,
            order,
        }
    }

    /// The number of bodies between a body and the frame.
    pub(super) fn depth(&self, body: usize) -> usize {
        std::iter::successors(self.parent[body], |&next| self.parent[next]).count()
    }

    /// True if a body hangs on another, directly or by others, or is that body. The frame hangs on
    /// nothing.
    pub(super) fn hangs_on(&self, body: Option<usize>, on: usize) -> bool {
        let mut next = body;
        while let Some(body) = next {
            if body == on {
                return true;
            }
            next = self.parent[body];
        }
        false
    }
}
