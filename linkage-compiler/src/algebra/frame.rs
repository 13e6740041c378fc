//! Frames in space: axes from two directions, points and coordinates in them.

use linkage_symbolic::{NodeId, agree_within};

use super::{Algebra, Value};

/// What rounding may leave of a product that is zero.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl Algebra<'_> {
    /// Origin and axes: `X = x / |x|`, `Y = (z x X) / |z x X|`, `Z = X x Y`.
    pub(super) fn frame(&mut self, arguments: &[Value]) -> Value {
        let [origin, x, z] = [0, 1, 2].map(|k| self.space_vector(&arguments[k]));
        let x = self.unit_vector(x);
        let projection = self.dot(&z, &x);
        let (y, z) = if self.vanishes(projection) {
            // Perpendicular by their formulas, as axes of rotation often are: nothing to project.
            let z = self.unit_vector(z);
            (self.sparse_cross(z, x), z)
        } else {
            let across = self.sparse_cross(z, x);
            let y = match across
                .iter()
                .all(|&component| self.graph.is_zero(component))
            {
                true => [self.graph.constant(f64::NAN); 3],
                false => self.unit_vector(across),
            };
            (y, self.sparse_cross(x, y))
        };
        self.mark_unit(&y);
        self.mark_unit(&z);
        let parts = [origin, x, y, z].map(|part| Value::Vector(part.to_vec()));
        Value::Array(parts.to_vec())
    }

    /// `origin + a X + b Y + c Z`
    pub(super) fn point_in(&mut self, arguments: &[Value]) -> Value {
        let [origin, axes @ ..] = self.frame_parts(&arguments[0]);
        let local = self.space_vector(&arguments[1]);
        let point = [0, 1, 2].map(|k| {
            let offset = self.dot(&local, &axes.map(|axis| axis[k]));
            self.graph.add(origin[k], offset)
        });
        Value::Vector(point.to_vec())
    }

    /// The projections of `point - origin` on the axes.
    pub(super) fn coordinates_in(&mut self, arguments: &[Value]) -> Value {
        let [origin, axes @ ..] = self.frame_parts(&arguments[0]);
        let point = self.space_vector(&arguments[1]);
        let arm = self.difference(&point, &origin);
        let coordinates = axes.map(|axis| self.dot(&arm, &axis));
        Value::Vector(coordinates.to_vec())
    }

    /// `a x b`; components that are zero by their formulas are constants.
    fn sparse_cross(&mut self, a: [NodeId; 3], b: [NodeId; 3]) -> [NodeId; 3] {
        self.cross3(a, b)
            .map(|component| match self.vanishes(component) {
                true => self.graph.zero(),
                false => component,
            })
    }

    /// True if a node is zero wherever it is evaluated.
    pub(crate) fn vanishes(&mut self, node: NodeId) -> bool {
        let zero = self.graph.zero();
        agree_within(&self.graph, node, zero, ROUNDING)
    }

    fn frame_parts(&mut self, frame: &Value) -> [[NodeId; 3]; 4] {
        match frame {
            Value::Array(parts) => [0, 1, 2, 3].map(|part| self.space_vector(&parts[part])),
            other => [self.space_vector(other); 4],
        }
    }

    fn space_vector(&mut self, value: &Value) -> [NodeId; 3] {
        match self.components(value)[..] {
            [x, y, z] => [x, y, z],
            _ => [self.as_node(value); 3],
        }
    }
}
