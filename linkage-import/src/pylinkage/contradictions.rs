//! Facts of joints that their positions contradict: the positions are taken, and each is named.

use serde_json::Value;

use crate::document::Document;
use crate::names::shown;
use crate::number::plain;

/// Differences up to this part of the size are rounding.
const CLOSE: f64 = 1e-6;

/// Names a slide that is beside the line of the file, at an angle through `line_point`.
pub(super) fn name_line(document: &mut Document, value: &Value, joint: usize, angle: f64) {
    let point = value.get("line_point").and_then(Value::as_array);
    let point: Vec<f64> = point
        .into_iter()
        .flatten()
        .filter_map(Value::as_f64)
        .collect();
    let [x, y] = point[..] else {
        return;
    };
    let [at_x, at_y] = document.joints[joint].position;
    let [dx, dy] = [at_x - x, at_y - y];
    let beside = (dy * angle.cos() - dx * angle.sin()).abs();
    if beside > CLOSE * dx.hypot(dy).max(1.0) {
        document.warnings.push(format!(
            "the joint `{}` is {} beside the line through its `line_point`: the line through its \
             position is taken",
            shown(&document.joints[joint].name),
            short(beside)
        ));
    }
}

/// Names a tracker whose position has another distance from its first reference joint, or another
/// angle from the line of both.
pub(super) fn name_tracker(
    document: &mut Document,
    value: &Value,
    joint: usize,
    [first, second]: [usize; 2],
) {
    let number = |name: &str| value.get(name).and_then(Value::as_f64);
    let (Some(distance), Some(angle)) = (number("distance"), number("angle")) else {
        return;
    };
    let angle = document.direction(first, second) + angle;
    let [x, y] = document.joints[first].position;
    let [at_x, at_y] = document.joints[joint].position;
    let apart = (x + distance * angle.cos() - at_x).hypot(y + distance * angle.sin() - at_y);
    if apart > CLOSE * distance.abs().max(1.0) {
        document.warnings.push(format!(
            "the tracker `{}` is {} beside its `distance` and `angle`: its position is taken",
            shown(&document.joints[joint].name),
            short(apart)
        ));
    }
}

/// Returns a length with six decimals.
fn short(length: f64) -> String {
    plain((length * 1e6).round() / 1e6)
}
