//! The reactions of cut joints, group by group.

use linkage_symbolic::NodeId;

use super::Mechanics;
use super::system::{Equation, LARGEST_BLOCK, System, Unknown};
use super::wrench::Wrench;

impl Mechanics<'_, '_> {
    /// The reaction of a cut joint on its body; unknowns in `open` count as 0.
    pub(super) fn closing_wrench(&mut self, joint: usize, open: &[usize]) -> Wrench {
        let system = self.system();
        let mut sum = match system.axial.iter().find(|own| own.joint == joint) {
            Some(axial) => self.across_link(axial),
            None => {
                let geometry = &self.forces.geometry;
                let (dimensions, turns) = (geometry.dimensions, geometry.turns());
                Wrench {
                    force: self.algebra.zeros(dimensions),
                    moment: self.algebra.zeros(turns),
                }
            }
        };
        for (index, unknown) in system.unknowns.iter().enumerate() {
            let Unknown::Reaction(own) = unknown else {
                continue;
            };
            if own.joint != joint || open.contains(&index) {
                continue;
            }
            let size = self.solved(index);
            let part = self.algebra.times(size, &own.direction);
            match own.is_moment {
                true => sum.moment = self.algebra.plus(&sum.moment, &part),
                false => sum.force = self.algebra.plus(&sum.force, &part),
            }
        }
        sum
    }

    /// The value of an unknown.
    pub(super) fn solved(&mut self, unknown: usize) -> NodeId {
        self.loads();
        if let Some(&known) = self.case().solved.get(&unknown) {
            return known;
        }
        let system = self.system();
        let equation = system.matching.equation_of[unknown];
        let block = system
            .blocks
            .iter()
            .find(|block| equation.is_some_and(|e| block.contains(&e)));
        let Some(block) = block.filter(|block| block.len() <= LARGEST_BLOCK) else {
            // Reported by the check of bodies and joints.
            return self.algebra.graph.constant(f64::NAN);
        };
        let own: Vec<usize> = block
            .iter()
            .flat_map(|&equation| system.matching.coordinates_of[equation].clone())
            .collect();
        let right: Vec<NodeId> = block
            .iter()
            .map(|&equation| self.right_hand_side(&system, equation, &own))
            .collect();
        let matrix: Vec<Vec<NodeId>> = block
            .iter()
            .map(|&equation| own.iter().map(|&k| system.matrix[equation][k]).collect())
            .collect();
        let determinant = self.algebra.determinant(&matrix);
        let numerators = self.algebra.cofactor_products(&matrix, &right);
        // The determinant is known long before the loads.
        let one = self.algebra.graph.one();
        let factor = self.algebra.graph.div(one, determinant);
        for (&unknown, numerator) in own.iter().zip(numerators) {
            let value = self.algebra.graph.mul(numerator, factor);
            self.case().solved.insert(unknown, value);
        }
        self.case().solved[&unknown]
    }

    /// Minus what an equation says of all that is known before its block is solved.
    fn right_hand_side(&mut self, system: &System, equation: usize, block: &[usize]) -> NodeId {
        let contained = &system.incidence[equation];
        let is_open = |unknown: &usize| !contained.contains(unknown) || block.contains(unknown);
        let open: Vec<usize> = (0..system.unknowns.len()).filter(is_open).collect();
        let known = match &system.equations[equation] {
            Equation::Released(component) => {
                let wrench = self.closing_wrench(component.joint, &open);
                let own = if component.is_moment {
                    wrench.moment
                } else {
                    wrench.force
                };
                self.algebra.dot(&component.direction, &own)
            }
            Equation::Motion(way) => {
                let wrench = self.wrench(way.body, &[], &open);
                self.algebra.dot(&way.direction, wrench.along(way))
            }
        };
        self.algebra.graph.neg(known)
    }
}
