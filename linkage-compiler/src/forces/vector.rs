//! Vectors of the plane and of space alike. A turn or a moment has one component in the plane and three in space.

use linkage_symbolic::NodeId;

use crate::algebra::Algebra;

impl Algebra<'_> {
    pub(super) fn plus(&mut self, a: &[NodeId], b: &[NodeId]) -> Vec<NodeId> {
        let pairs = a.iter().zip(b);
        pairs.map(|(&x, &y)| self.graph.add(x, y)).collect()
    }

    pub(super) fn times(&mut self, factor: NodeId, v: &[NodeId]) -> Vec<NodeId> {
        v.iter().map(|&x| self.graph.mul(factor, x)).collect()
    }

    pub(super) fn opposite(&mut self, v: &[NodeId]) -> Vec<NodeId> {
        v.iter().map(|&x| self.graph.neg(x)).collect()
    }

    pub(super) fn zeros(&mut self, count: usize) -> Vec<NodeId> {
        vec![self.graph.zero(); count]
    }

    /// `arm x force`
    pub(super) fn moment_of(&mut self, arm: &[NodeId], force: &[NodeId]) -> Vec<NodeId> {
        match (arm, force) {
            (&[a, b, c], &[x, y, z]) => self.cross3([a, b, c], [x, y, z]).to_vec(),
            _ => vec![self.cross([arm[0], arm[1]], [force[0], force[1]])],
        }
    }

    /// `turn x arm`: how the end of an arm moves when it turns.
    pub(super) fn swept(&mut self, turn: &[NodeId], arm: &[NodeId]) -> Vec<NodeId> {
        match (turn, arm) {
            (&[a, b, c], &[x, y, z]) => self.cross3([a, b, c], [x, y, z]).to_vec(),
            _ => {
                let across = [self.graph.neg(arm[1]), arm[0]];
                self.times(turn[0], &across)
            }
        }
    }

    /// The part of a vector along a unit vector.
    pub(super) fn along(&mut self, unit: &[NodeId], v: &[NodeId]) -> Vec<NodeId> {
        let along = self.dot(unit, v);
        self.times(along, unit)
    }

    /// The part of a vector across a unit vector.
    pub(super) fn across(&mut self, unit: &[NodeId], v: &[NodeId]) -> Vec<NodeId> {
        let along = self.along(unit, v);
        self.difference(v, &along)
    }
}
