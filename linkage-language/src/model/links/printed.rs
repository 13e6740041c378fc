//! Numbers of a drawing in messages.

/// Returns a number with six digits after the point at most.
pub(super) fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// Returns metres as millimetres with four digits after the point at most.
pub(super) fn in_millimetres(metres: f64) -> f64 {
    (metres * 1e7).round() / 1e4
}
