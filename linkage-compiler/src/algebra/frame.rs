//! Frames in space: axes from two directions, points and coordinates in them.

use linkage_symbolic::{Ex, V3, Vector, agree_within};

use super::{Algebra, Value};

/// What rounding may leave of a product that is zero.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl<'m> Algebra<'m> {
    /// Origin and axes: `X = x / |x|`, `Y = (z x X) / |z x X|`, `Z = X x Y`.
    pub(super) fn frame(&self, arguments: &[Value<'m>]) -> Value<'m> {
        let [origin, x, z] = [0, 1, 2].map(|k| self.space_vector(&arguments[k]));
        let x = x.unit();
        let (y, z) = if vanishes(z.dot(x)) {
            // Perpendicular by their formulas, as axes of rotation often are: nothing to project.
            let z = z.unit();
            (sparse_cross(z, x), z)
        } else {
            let across = sparse_cross(z, x);
            let y = match across.is_zero() {
                true => across.map(|zero| zero.number(f64::NAN)),
                false => across.unit(),
            };
            (y, sparse_cross(x, y))
        };
        y.mark_unit();
        z.mark_unit();
        let parts = [origin, x, y, z].map(|part| Value::Vector(part.into()));
        Value::Array(parts.to_vec())
    }

    /// `origin + a X + b Y + c Z`
    pub(super) fn point_in(&self, arguments: &[Value<'m>]) -> Value<'m> {
        let [origin, axes @ ..] = self.frame_parts(&arguments[0]);
        let local = self.space_vector(&arguments[1]);
        let point = [0, 1, 2].map(|k| {
            let offset = local.dot(Vector(axes.map(|axis| axis[k])));
            origin[k] + offset
        });
        Value::Vector(Vector(point).into())
    }

    /// The projections of `point - origin` on the axes.
    pub(super) fn coordinates_in(&self, arguments: &[Value<'m>]) -> Value<'m> {
        let [origin, axes @ ..] = self.frame_parts(&arguments[0]);
        let arm = self.space_vector(&arguments[1]) - origin;
        let coordinates = axes.map(|axis| arm.dot(axis));
        Value::Vector(Vector(coordinates).into())
    }

    fn frame_parts(&self, frame: &Value<'m>) -> [V3<'m>; 4] {
        match frame {
            Value::Array(parts) => [0, 1, 2, 3].map(|part| self.space_vector(&parts[part])),
            other => [self.space_vector(other); 4],
        }
    }

    fn space_vector(&self, value: &Value<'m>) -> V3<'m> {
        let vector = self.vector(value);
        vector.in_space().unwrap_or_else(|| {
            let number = self.number(value);
            Vector([number; 3])
        })
    }
}

/// `a x b`; components that are zero by their formulas are constants.
fn sparse_cross<'m>(a: V3<'m>, b: V3<'m>) -> V3<'m> {
    a.cross(b).map(|component| match vanishes(component) {
        true => component.number(0.0),
        false => component,
    })
}

/// True if an expression is zero wherever it is evaluated.
pub(super) fn vanishes(x: Ex) -> bool {
    agree_within(x, x.number(0.0), ROUNDING)
}
