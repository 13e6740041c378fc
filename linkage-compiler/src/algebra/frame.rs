//! Frames in space: axes from two directions, points and coordinates in them.

use crate::algebra::body_vectors;
use crate::algebra::scalar;
use crate::algebra::translate;
use linkage_symbolic::{Ex, V2, V3, Vector, Vn, numerically_equal_within};

use super::{Algebra, Value, coordinates};

/// What rounding may leave of a product that is zero.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Origin and axes: `X = x / |x|`, `Y = (z x X) / |z x X|`, `Z = X x Y`; of unknown frames what they are made of.
pub(super) fn frame<'m>(algebra: &mut Algebra<'m>, arguments: &[Value<'m>]) -> Value<'m> {
    match arguments {
        [origin, direction] => return plane_frame(algebra, origin, direction),
        [_, _, _, _] => return frame_of_axes(algebra, arguments),
        _ => {}
    }
    let [origin, x, z] = [0, 1, 2].map(|k| space_vector(algebra, &arguments[k]));
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

/// The direction of a vector. What an unknown frame carries is as long as its coordinates there are, which the derivatives of its length do not
/// know.
pub(super) fn unit_in_space<'m>(algebra: &mut Algebra<'m>, v: V3<'m>) -> V3<'m> {
    let Some((own, axes)) = coordinates_on_body(algebra, v) else {
        return v.unit();
    };
    let length = Vn::from(own).length();
    let [unit, own] = [v, own].map(|v| v.map(|x| x / length));
    unit.mark_unit();
    body_vectors::note_aboard(algebra, unit, own, axes);
    unit
}

/// Notes that an unknown frame carries a vector, if it does.
pub(crate) fn note_if_aboard<'m>(algebra: &mut Algebra<'m>, v: V3<'m>) {
    if let Some((own, axes)) = coordinates_on_body(algebra, v) {
        body_vectors::note_aboard(algebra, v, own, axes);
    }
}

/// The coordinates of a vector that one of the unknown frames carries as it is, if they are dimensions, along two of its axes and across these.
fn coordinates_on_body<'m>(algebra: &Algebra<'m>, v: V3<'m>) -> Option<(V3<'m>, [V3<'m>; 2])> {
    let bodies = algebra.mechanism.bodies_of_space().into_iter();
    let mut own = bodies.filter_map(|(_, parts)| {
        let axes = [parts[1], parts[2]].map(|axis| algebra.names.numbers_of(axis).try_into());
        let [Ok(first), Ok(second)] = axes else {
            return None;
        };
        let axes = [first, second].map(Vector);
        let own = coordinates(v, axes)?;
        own.is_fixed().then_some((own, axes))
    });
    own.next()
}

/// Origin and axes of an unknown frame, of which its own loops say that they are perpendicular and of length 1.
fn frame_of_axes<'m>(algebra: &mut Algebra<'m>, parts: &[Value<'m>]) -> Value<'m> {
    for axis in &parts[1..] {
        let axis = space_vector(algebra, axis);
        axis.mark_unit();
        note_if_aboard(algebra, axis);
    }
    Value::Array(parts.to_vec())
}

/// Origin, axes and angle of a frame of the plane, by the direction of its x axis or by its angle.
fn plane_frame<'m>(
    algebra: &mut Algebra<'m>,
    origin: &Value<'m>,
    direction: &Value<'m>,
) -> Value<'m> {
    let (x, angle) = match direction {
        Value::Scalar(angle) => (scalar::direction(algebra, angle), direction.clone()),
        other => {
            let x = plane_vector(translate::vector(algebra, other));
            (x.length_and_unit().1, x[1].atan2(x[0]).into())
        }
    };
    let axes = [x, x.perp()].map(|axis| Value::Vector(axis.into()));
    let parts = std::iter::once(origin.clone()).chain(axes);
    Value::Array(parts.chain([angle]).collect())
}

/// Origin and axes of a frame of the plane; `None` for one of space.
fn plane_parts<'m>(algebra: &Algebra<'m>, frame: &Value<'m>) -> Option<[V2<'m>; 3]> {
    let Value::Array(parts) = frame else {
        return None;
    };
    let is_plane = translate::vector(algebra, &parts[1]).len() == 2;
    is_plane.then(|| [0, 1, 2].map(|part| plane_vector(translate::vector(algebra, &parts[part]))))
}

/// `origin + a X + b Y + c Z`
pub(super) fn point_in<'m>(algebra: &mut Algebra<'m>, arguments: &[Value<'m>]) -> Value<'m> {
    if let Some([origin, x, y]) = plane_parts(algebra, &arguments[0]) {
        let local = translate::vector(algebra, &arguments[1]);
        let offset = local.at(0) * x + local.at(1) * y;
        return Value::Vector((origin + offset).into());
    }
    let [origin, axes @ ..] = frame_parts(algebra, &arguments[0]);
    let local = space_vector(algebra, &arguments[1]);
    let arm = Vector([0, 1, 2].map(|k| local.dot(Vector(axes.map(|axis| axis[k])))));
    note_if_aboard(algebra, arm);
    Value::Vector((origin + arm).into())
}

/// The projections of `point - origin` on the axes.
pub(super) fn coordinates_in<'m>(algebra: &Algebra<'m>, arguments: &[Value<'m>]) -> Value<'m> {
    if let Some([origin, axes @ ..]) = plane_parts(algebra, &arguments[0]) {
        let arm = plane_vector(translate::vector(algebra, &arguments[1])) - origin;
        return Value::Vector(Vector(axes.map(|axis| arm.dot(axis))).into());
    }
    let [origin, axes @ ..] = frame_parts(algebra, &arguments[0]);
    let arm = space_vector(algebra, &arguments[1]) - origin;
    let coordinates = axes.map(|axis| arm.dot(axis));
    Value::Vector(Vector(coordinates).into())
}

/// The vector by which a frame turns, from the derivatives of its parts: `(Y' . Z) X + (Z' . X) Y + (X' . Y) Z`.
pub(crate) fn turning_of_frame<'m>(
    algebra: &Algebra<'m>,
    frame: &Value<'m>,
    slope: &Value<'m>,
) -> Value<'m> {
    let [_, x, y, z] = frame_parts(algebra, frame);
    let [_, along_x, along_y, along_z] = frame_parts(algebra, slope);
    let about_x = along_y.dot(z) * x;
    let about_y = along_z.dot(x) * y;
    let about_z = along_x.dot(y) * z;
    Value::Vector((about_x + about_y + about_z).into())
}

pub(super) fn frame_parts<'m>(algebra: &Algebra<'m>, frame: &Value<'m>) -> [V3<'m>; 4] {
    match frame {
        Value::Array(parts) => [0, 1, 2, 3].map(|part| space_vector(algebra, &parts[part])),
        other => [space_vector(algebra, other); 4],
    }
}

pub(super) fn space_vector<'m>(algebra: &Algebra<'m>, value: &Value<'m>) -> V3<'m> {
    let vector = translate::vector(algebra, value);
    vector.in_space().unwrap_or_else(|| {
        let number = translate::number(algebra, value);
        Vector([number; 3])
    })
}

/// The two components of a plane vector.
fn plane_vector(v: Vn) -> V2 {
    Vector([v.at(0), v.at(1)])
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
    numerically_equal_within(x, x.number(0.0), ROUNDING)
}
