//! Vectors and rotations of space.

/// A vector.
pub(super) type Vector = [f64; 3];

/// A rotation: the rows of its matrix.
pub(super) type Rotation = [[f64; 3]; 3];

/// The rotation that turns nothing.
pub(super) const IDENTITY: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The vector without length.
pub(super) const ZERO: Vector = [0.0; 3];

/// The axes of coordinates.
pub(super) const AXES: [Vector; 3] = IDENTITY;

pub(super) fn sum(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub(super) fn difference(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn scaled(a: Vector, factor: f64) -> Vector {
    a.map(|component| component * factor)
}

pub(super) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: Vector, b: Vector) -> Vector {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

pub(super) fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}

/// The vector of length 1; not finite for a vector without length.
pub(super) fn unit(a: Vector) -> Vector {
    scaled(a, 1.0 / length(a))
}

/// A unit vector across a unit vector.
pub(super) fn across(a: Vector) -> Vector {
    let least = |index: &usize| a.map(f64::abs)[*index];
    let index = (0..3).min_by(|i, j| least(i).total_cmp(&least(j)));
    unit(cross(a, AXES[index.unwrap_or_default()]))
}

pub(super) fn turned(rotation: &Rotation, a: Vector) -> Vector {
    rotation.map(|row| dot(row, a))
}

/// The vector that the rotation turns into `a`.
pub(super) fn turned_back(rotation: &Rotation, a: Vector) -> Vector {
    turned(&transposed(rotation), a)
}

pub(super) fn transposed(a: &Rotation) -> Rotation {
    [0, 1, 2].map(|i| [a[0][i], a[1][i], a[2][i]])
}

pub(super) fn product(a: &Rotation, b: &Rotation) -> Rotation {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}

/// The rotation about a unit vector.
pub(super) fn about(axis: Vector, angle: f64) -> Rotation {
    let (sine, cosine) = angle.sin_cos();
    let columns = AXES.map(|a| {
        let along = scaled(axis, dot(axis, a) * (1.0 - cosine));
        sum(sum(scaled(a, cosine), along), scaled(cross(axis, a), sine))
    });
    transposed(&columns)
}

/// The rotation whose columns are three axes.
pub(super) fn from_axes(axes: &[Vector; 3]) -> Rotation {
    transposed(axes)
}

/// The shortest rotation from one unit vector to another; not finite if they are opposite.
pub(super) fn between(from: Vector, to: Vector) -> Rotation {
    let axis = cross(from, to);
    let factor = 1.0 / (1.0 + dot(from, to));
    let columns = AXES.map(|a| {
        // Rodrigues, with the sine in the length of the axis.
        let first = cross(axis, a);
        sum(sum(a, first), scaled(cross(axis, first), factor))
    });
    transposed(&columns)
}

/// The angle of a rotation about a unit vector, from minus half a turn to half a turn.
pub(super) fn angle_about(rotation: &Rotation, axis: Vector) -> f64 {
    let start = across(axis);
    let end = turned(rotation, start);
    dot(cross(start, end), axis).atan2(dot(start, end))
}

/// The angles about x, then the turned y, then the turned z axis.
pub(super) fn angles_of(rotation: &Rotation) -> [f64; 3] {
    let r = rotation;
    [
        (-r[1][2]).atan2(r[2][2]),
        r[0][2].atan2(r[0][0].hypot(r[0][1])),
        (-r[0][1]).atan2(r[0][0]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn is_near(a: &Rotation, b: &Rotation) -> bool {
        let pairs = a.iter().flatten().zip(b.iter().flatten());
        pairs.into_iter().all(|(a, b)| (a - b).abs() < 1e-14)
    }

    #[test]
    fn angles_are_those_of_three_hinges() {
        let angles = [0.3, -1.1, 2.4];
        let [x, y, z] = [0, 1, 2].map(|axis| about(AXES[axis], angles[axis]));
        let found = angles_of(&product(&product(&x, &y), &z));
        assert!(found.iter().zip(angles).all(|(a, b)| (a - b).abs() < 1e-14));
    }

    #[test]
    fn the_shortest_rotation_leaves_what_is_across() {
        let [from, to] = [unit([1.0, 2.0, -0.5]), unit([0.3, -1.0, 2.0])];
        let rotation = between(from, to);
        let axis = unit(cross(from, to));
        let angle = dot(from, to).acos();
        assert!(is_near(&rotation, &about(axis, angle)));
        assert!((angle_about(&rotation, axis) - angle).abs() < 1e-14);
    }
}
