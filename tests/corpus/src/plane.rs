//! Plane vectors of the chosen configuration.

/// A vector or point, millimetres.
pub(crate) type Vector = [f64; 2];

pub(crate) fn direction(angle: f64) -> Vector {
    [angle.cos(), angle.sin()]
}

/// `a + length (cos angle, sin angle)`
pub(crate) fn step(a: Vector, length: f64, angle: f64) -> Vector {
    let [c, s] = direction(angle);
    [a[0] + length * c, a[1] + length * s]
}

pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1]]
}

pub(crate) fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(crate) fn cross(a: Vector, b: Vector) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(crate) fn length(a: Vector) -> f64 {
    a[0].hypot(a[1])
}

pub(crate) fn angle(a: Vector) -> f64 {
    a[1].atan2(a[0])
}

/// A point in polar coordinates about `b`: `(cos, sin)` components of `a` along and across `guide`.
pub(crate) fn along_and_across(a: Vector, guide: f64) -> (f64, f64) {
    let g = direction(guide);
    (dot(g, a), cross(g, a))
}
