//! Frames in space: axes from two directions, points and coordinates in them.

use linkage_symbolic::NodeId;
use linkage_symbolic::program::Unary;

use super::{Algebra, Value};

impl Algebra<'_> {
    /// Origin and axes: `X = x / |x|`, `Y = (z x X) / |z x X|`, `Z = X x Y`.
    pub(super) fn frame(&mut self, arguments: &[Value]) -> Value {
        let [origin, x, z] = [0, 1, 2].map(|k| self.space_vector(&arguments[k]));
        let x = self.unit_vector(x);
        let projection = self.dot(&z, &x);
        let (y, z) = if self.graph.is_zero(projection) {
            // Perpendicular by construction, as an axis of rotation often is: nothing to project.
            let z = self.unit_vector(z);
            (self.space_cross(z, x), z)
        } else {
            let across = self.space_cross(z, x);
            let y = self.unit_vector(across);
            (y, self.space_cross(x, y))
        };
        Value::Array(
            [origin, x, y, z]
                .map(|v| Value::Vector(v.to_vec()))
                .to_vec(),
        )
    }

    /// `origin + a X + b Y + c Z`
    pub(super) fn point_in(&mut self, arguments: &[Value]) -> Value {
        let [origin, axes @ ..] = self.frame_parts(&arguments[0]);
        let local = self.space_vector(&arguments[1]);
        let point = [0, 1, 2].map(|k| {
            let along = axes.map(|axis| axis[k]);
            let offset = self.dot(&local, &along);
            self.graph.add(origin[k], offset)
        });
        Value::Vector(point.to_vec())
    }

    /// The projections of `point - origin` on the axes.
    pub(super) fn coordinates_in(&mut self, arguments: &[Value]) -> Value {
        let [origin, axes @ ..] = self.frame_parts(&arguments[0]);
        let point = self.space_vector(&arguments[1]);
        let arm = [0, 1, 2].map(|k| self.graph.sub(point[k], origin[k]));
        let coordinates = axes.map(|axis| self.dot(&arm, &axis));
        Value::Vector(coordinates.to_vec())
    }

    /// The vector divided by its length; NaN for one that is known to be zero. What is zero is left out, so that a unit vector of a
    /// coordinate plane is known as one.
    pub(crate) fn unit_vector(&mut self, v: [NodeId; 3]) -> [NodeId; 3] {
        let rest: Vec<NodeId> = v.into_iter().filter(|&x| !self.graph.is_zero(x)).collect();
        let length = match rest[..] {
            [] => return [self.graph.constant(f64::NAN); 3],
            [x] => self.graph.unary(Unary::Abs, x),
            [x, y] if self.is_unit([x, y]) => return v,
            _ => self.length(&rest),
        };
        v.map(|x| self.graph.div(x, length))
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

    fn space_cross(&mut self, a: [NodeId; 3], b: [NodeId; 3]) -> [NodeId; 3] {
        [(1, 2), (2, 0), (0, 1)].map(|(i, j)| self.cross([a[i], a[j]], [b[i], b[j]]))
    }
}
