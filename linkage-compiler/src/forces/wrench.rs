//! What a body and all that hang on it carry together: a force, and a moment about the body's origin.
//!
//! The reactions of cut joints count if one of the two bodies hangs on that body and the other does not.

use linkage_symbolic::NodeId;

use super::Mechanics;
use super::freedom::Way;
use super::system::Unknown;

#[derive(Clone, Debug)]
pub(super) struct Wrench {
    pub(super) force: Vec<NodeId>,
    pub(super) moment: Vec<NodeId>,
}

impl Wrench {
    /// What does work in a motion.
    pub(super) fn along(&self, way: &Way) -> &[NodeId] {
        if way.slides {
            &self.force
        } else {
            &self.moment
        }
    }
}

impl Mechanics<'_, '_> {
    /// Of a body and those that hang on it. Cut joints in `inside` join two of them and cancel; the unknowns in `open` count as 0.
    pub(super) fn wrench(&mut self, body: usize, inside: &[usize], open: &[usize]) -> Wrench {
        let closing = self.forces.tree.closing.clone();
        let (within, others): (Vec<usize>, Vec<usize>) = closing
            .into_iter()
            .filter(|&joint| self.is_inside(joint, body) || self.joins(joint, body) != 0)
            .partition(|&joint| self.is_inside(joint, body) || inside.contains(&joint));
        let system = self.system();
        let touches = |unknown: &&usize| match &system.unknowns[**unknown] {
            Unknown::Reaction(own) => others.contains(&own.joint),
            Unknown::Spin { .. } => false,
            Unknown::Tie(tie) => {
                let mut bodies = tie.couples.iter();
                bodies.any(|(own, _)| self.forces.tree.hangs_on(Some(*own), body))
            }
        };
        let open: Vec<usize> = open.iter().filter(touches).copied().collect();
        self.loads();
        let key = (body, within.clone(), open.clone());
        if let Some(known) = self.case().wrenches.get(&key) {
            return known.clone();
        }
        let mut sum = self.own_wrench(body);
        for joint in others {
            let sign = self.at_ends(joint, body);
            if sign == 0 {
                continue;
            }
            let mut reaction = self.closing_wrench(joint, &open);
            if sign < 0 {
                reaction = self.opposite_wrench(&reaction);
            }
            let point = self.forces.geometry.points[joint].clone();
            sum = self.add_at(body, sum, &point, &reaction);
        }
        for (index, unknown) in system.unknowns.iter().enumerate() {
            let Unknown::Tie(tie) = unknown else { continue };
            let own = tie.couples.iter().find(|(own, _)| *own == body);
            let Some((_, share)) = own.filter(|_| !open.contains(&index)) else {
                continue;
            };
            let size = self.solved(index);
            let share = self.algebra.graph.constant(*share);
            let couple = self.algebra.graph.mul(share, size);
            sum.moment = self.algebra.plus(&sum.moment, &[couple]);
        }
        for child in self.forces.tree.children[body].clone() {
            let carried = self.wrench(child, &within, &open);
            let point = self.forces.geometry.origins[child].clone();
            sum = self.add_at(body, sum, &point, &carried);
        }
        self.case().wrenches.insert(key, sum.clone());
        sum
    }

    /// The loads on a body alone.
    fn own_wrench(&mut self, body: usize) -> Wrench {
        let loads = self.loads().bodies[body].clone();
        let geometry = &self.forces.geometry;
        let (dimensions, turns) = (geometry.dimensions, geometry.turns());
        let mut sum = Wrench {
            force: self.algebra.zeros(dimensions),
            moment: self.algebra.zeros(turns),
        };
        for load in &loads.forces {
            let force = Wrench {
                force: load.force.clone(),
                moment: self.algebra.zeros(turns),
            };
            sum = self.add_at(body, sum, &load.point, &force);
        }
        for couple in &loads.couples {
            sum.moment = self.algebra.plus(&sum.moment, couple);
        }
        sum
    }

    /// Adds a wrench about a point to one about a body's origin.
    fn add_at(&mut self, body: usize, sum: Wrench, point: &[NodeId], part: &Wrench) -> Wrench {
        let arm = self.arm(body, point);
        let lever = self.algebra.moment_of(&arm, &part.force);
        let moment = self.algebra.plus(&part.moment, &lever);
        Wrench {
            force: self.algebra.plus(&sum.force, &part.force),
            moment: self.algebra.plus(&sum.moment, &moment),
        }
    }

    pub(super) fn opposite_wrench(&mut self, wrench: &Wrench) -> Wrench {
        Wrench {
            force: self.algebra.opposite(&wrench.force),
            moment: self.algebra.opposite(&wrench.moment),
        }
    }

    /// 1 if the reaction of a cut joint acts on what hangs on a body, -1 if its opposite does, 0 if neither or both.
    pub(super) fn joins(&self, joint: usize, body: usize) -> i32 {
        let declared = &self.algebra.mechanism.joints[joint];
        let tree = &self.forces.tree;
        i32::from(tree.hangs_on(Some(declared.body), body))
            - i32::from(tree.hangs_on(declared.on, body))
    }

    /// The same for the body alone.
    fn at_ends(&self, joint: usize, body: usize) -> i32 {
        let declared = &self.algebra.mechanism.joints[joint];
        i32::from(declared.body == body) - i32::from(declared.on == Some(body))
    }

    /// True if both bodies of a cut joint hang on a body.
    fn is_inside(&self, joint: usize, body: usize) -> bool {
        let declared = &self.algebra.mechanism.joints[joint];
        let tree = &self.forces.tree;
        tree.hangs_on(Some(declared.body), body) && tree.hangs_on(declared.on, body)
    }
}
