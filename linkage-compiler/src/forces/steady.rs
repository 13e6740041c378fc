//! What only numbers tell of the motion: joints that move at a steady rate, rods that keep their length.

use linkage_symbolic::NodeId;

use crate::formulate::Reference;
use crate::model::JointKind;

use super::Mechanics;

/// Rates that differ by a smaller share are equal.
const EQUAL: f64 = 1e-7;

impl Mechanics<'_, '_> {
    /// Looks at some positions; those that do not close count for nothing.
    pub(super) fn look_at_motion(&mut self, reference: &Reference, places: &[Vec<f64>]) {
        for body in 0..self.algebra.mechanism.bodies.len() {
            let joint = self.algebra.mechanism.bodies[body].joint;
            let is_ball = self.algebra.mechanism.joints[joint].kind == JointKind::Ball;
            for way in self.ways(body) {
                let rates: Vec<NodeId> = (0..self.drives())
                    .map(|input| self.driven_rate(&way, input))
                    .collect();
                let values = self.values(&rates, reference, places);
                let moves = values.iter().flatten().any(|rate| rate.abs() > EQUAL);
                if moves && all_alike(&values) {
                    self.forces.steady.push((body, way.slides));
                }
                if !moves && !values.is_empty() && !is_ball {
                    self.forces.still.push((body, way.slides));
                }
            }
            if let Some(along) = self.forces.geometry.rod(body) {
                let square = self.algebra.sum_of_squares(&along);
                let mut lengths = vec![square];
                lengths
                    .extend((0..self.drives()).map(|input| self.algebra.by_input(square, input)));
                let values = self.values(&lengths, reference, places);
                let keeps =
                    |values: &Vec<f64>| values[1..].iter().all(|x| x.abs() < EQUAL * values[0]);
                if !values.is_empty() && values.iter().all(keeps) {
                    self.forces.rigid_rods.push(body);
                }
            }
        }
    }

    /// Values at the places where the mechanism closes.
    pub(super) fn values(
        &self,
        nodes: &[NodeId],
        reference: &Reference,
        places: &[Vec<f64>],
    ) -> Vec<Vec<f64>> {
        let graph = &self.algebra.graph;
        let at = |place: &Vec<f64>| reference.machine.evaluate(graph, nodes, place);
        let values = places.iter().map(at);
        values
            .filter(|values| values.iter().all(|x| x.is_finite()))
            .collect()
    }
}

/// True if there are several and they do not differ.
fn all_alike(values: &[Vec<f64>]) -> bool {
    let Some((first, others)) = values.split_first() else {
        return false;
    };
    let like = |(a, b): (&f64, &f64)| (a - b).abs() <= EQUAL * b.abs().max(1e-3);
    !others.is_empty()
        && others
            .iter()
            .all(|values| values.iter().zip(first).all(like))
}
