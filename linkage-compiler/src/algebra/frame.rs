//! Frames in space: axes from two directions, points and coordinates in them.

use linkage_symbolic::{V2, V3, Vector, Vn};

use crate::algebra::names::Names;
use crate::algebra::value::Value;
use crate::algebra::{body_vectors, scalar, vanish};

/// Returns origin and axes: `X = x / |x|`, `Y = (z x X) / |z x X|`, `Z = X x Y`. An unknown frame
/// consists of its parts.
pub(crate) fn frame<'m>(names: &mut Names<'m>, arguments: &[Value<'m>]) -> Value<'m> {
    match arguments {
        [origin, direction] => return plane_frame(names, origin, direction),
        [_, _, _, _] => return frame_of_axes(names, arguments),
        _ => {}
    }
    let [origin, x, z] = [0, 1, 2].map(|k| space_vector(names, &arguments[k]));
    let x = x.unit();
    let (y, z) = if vanish::vanishes(z.dot(x)) {
        // Perpendicular by their formulas, as axes of rotation often are: nothing to project.
        let z = z.unit();
        (sparse_cross(z, x), z)
    } else {
        let across = sparse_cross(z, x);
        let y = if across.is_zero() {
            across.map(|zero| zero.number(f64::NAN))
        } else {
            across.unit()
        };
        (y, sparse_cross(x, y))
    };
    y.mark_unit();
    z.mark_unit();
    let parts = [origin, x, y, z].map(|part| Value::Vector(part.into()));
    Value::Array(parts.to_vec())
}

/// Returns the direction of a vector. A vector on an unknown frame is as long as its coordinates
/// there are, which the derivatives of its length do not know.
pub(crate) fn unit_in_space<'m>(names: &mut Names<'m>, v: V3<'m>) -> V3<'m> {
    let Some((local, axes)) = body_vectors::coordinates_on_body(names, v) else {
        return v.unit();
    };
    let length = Vn::from(local).length();
    let [unit, local] = [v, local].map(|v| v.map(|x| x / length));
    unit.mark_unit();
    body_vectors::note_body_vector(names, unit, local, axes);
    unit
}

/// Origin and axes of an unknown frame, of which its own loops say that they are perpendicular and
/// of length 1.
fn frame_of_axes<'m>(names: &mut Names<'m>, parts: &[Value<'m>]) -> Value<'m> {
    for axis in &parts[1..] {
        let axis = space_vector(names, axis);
        axis.mark_unit();
        body_vectors::note_if_on_body(names, axis);
    }
    Value::Array(parts.to_vec())
}

/// Origin, axes and angle of a frame of the plane, by the direction of its x axis or by its angle.
fn plane_frame<'m>(names: &mut Names<'m>, origin: &Value<'m>, direction: &Value<'m>) -> Value<'m> {
    let (x, angle) = match direction {
        Value::Scalar(angle) => (scalar::direction(names, angle), direction.clone()),
        other => {
            let x = plane_vector(scalar::vector(names, other));
            (x.length_and_unit().1, x[1].atan2(x[0]).into())
        }
    };
    let axes = [x, x.perp()].map(|axis| Value::Vector(axis.into()));
    let parts = std::iter::once(origin.clone()).chain(axes);
    Value::Array(parts.chain([angle]).collect())
}

/// Origin and axes of a frame of the plane; `None` for one of space.
fn plane_parts<'m>(names: &Names<'m>, frame: &Value<'m>) -> Option<[V2<'m>; 3]> {
    let Value::Array(parts) = frame else {
        return None;
    };
    let is_plane = scalar::vector(names, &parts[1]).len() == 2;
    is_plane.then(|| [0, 1, 2].map(|part| plane_vector(scalar::vector(names, &parts[part]))))
}

/// `origin + a X + b Y + c Z`
pub(crate) fn point_in<'m>(names: &mut Names<'m>, arguments: &[Value<'m>]) -> Value<'m> {
    if let Some([origin, x, y]) = plane_parts(names, &arguments[0]) {
        let local = scalar::vector(names, &arguments[1]);
        let offset = local.at(0) * x + local.at(1) * y;
        return Value::Vector((origin + offset).into());
    }
    let [origin, axes @ ..] = frame_parts(names, &arguments[0]);
    let local = space_vector(names, &arguments[1]);
    let arm = Vector([0, 1, 2].map(|k| local.dot(Vector(axes.map(|axis| axis[k])))));
    body_vectors::note_if_on_body(names, arm);
    Value::Vector((origin + arm).into())
}

/// The projections of `point - origin` on the axes.
pub(crate) fn coordinates_in<'m>(names: &Names<'m>, arguments: &[Value<'m>]) -> Value<'m> {
    if let Some([origin, axes @ ..]) = plane_parts(names, &arguments[0]) {
        let arm = plane_vector(scalar::vector(names, &arguments[1])) - origin;
        return Value::Vector(Vector(axes.map(|axis| arm.dot(axis))).into());
    }
    let [origin, axes @ ..] = frame_parts(names, &arguments[0]);
    let arm = space_vector(names, &arguments[1]) - origin;
    let coordinates = axes.map(|axis| arm.dot(axis));
    Value::Vector(Vector(coordinates).into())
}

/// The vector by which a frame turns, from the derivatives of its parts: `(Y' . Z) X + (Z' . X) Y +
/// (X' . Y) Z`.
pub(crate) fn turning_of_frame<'m>(
    names: &Names<'m>,
    frame: &Value<'m>,
    slope: &Value<'m>,
) -> Value<'m> {
    let [_, x, y, z] = frame_parts(names, frame);
    let [_, along_x, along_y, along_z] = frame_parts(names, slope);
    let about_x = along_y.dot(z) * x;
    let about_y = along_z.dot(x) * y;
    let about_z = along_x.dot(y) * z;
    Value::Vector((about_x + about_y + about_z).into())
}

pub(crate) fn frame_parts<'m>(names: &Names<'m>, frame: &Value<'m>) -> [V3<'m>; 4] {
    match frame {
        Value::Array(parts) => [0, 1, 2, 3].map(|part| space_vector(names, &parts[part])),
        other => [space_vector(names, other); 4],
    }
}

pub(crate) fn space_vector<'m>(names: &Names<'m>, value: &Value<'m>) -> V3<'m> {
    let vector = scalar::vector(names, value);
    vector.in_space().unwrap_or_else(|| {
        let number = scalar::number(names, value);
        Vector([number; 3])
    })
}

/// The two components of a plane vector.
fn plane_vector(v: Vn) -> V2 {
    Vector([v.at(0), v.at(1)])
}

/// `a x b`; components that are zero by their formulas are constants.
fn sparse_cross<'m>(a: V3<'m>, b: V3<'m>) -> V3<'m> {
    a.cross(b).map(|component| {
        if vanish::vanishes(component) {
            component.number(0.0)
        } else {
            component
        }
    })
}
