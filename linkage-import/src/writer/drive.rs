//! An input as text: its names, its item and the comment above it.

use crate::document::{Document, InputKind};
use crate::names::{in_comment, shown};
use crate::number::plain;

/// An input, or a motor that runs with one, as text.
pub(super) struct Drive {
    pub(super) name: String,
    /// The item of the input, below a comment.
    pub(super) line: String,
    pub(super) kind: InputKind,
    /// The input that a motor runs with, and the part of its speed.
    pub(super) leader: Option<(String, f64)>,
    /// The expression of the clause `at` or `length` where the input is used.
    pub(super) clause: String,
    /// The joint that a crank points to from its pivot.
    pub(super) target: Option<usize>,
    /// The value in the drawing with its unit.
    pub(super) value: String,
}

pub(super) fn line(
    document: &Document,
    index: usize,
    name: &str,
    [value, low, high]: [f64; 3],
    unit: &str,
    about: &str,
) -> String {
    let [value, low, high] = [value, low, high].map(plain);
    let head = head(document, index, name, about);
    format!("{head}\n    input {name} = {value}{unit} in {low}{unit}..{high}{unit};")
}

/// The comment above an input.
pub(super) fn head(document: &Document, index: usize, name: &str, about: &str) -> String {
    let speed = document.inputs[index].speed.as_deref();
    let speed = speed.map_or_else(String::new, |speed| format!("; {}", shown_speed(speed)));
    format!("// {name}: {about}{speed}")
}

pub(super) fn shown_speed(speed: &str) -> String {
    let speed = in_comment(speed);
    if speed.len() > 80 {
        shown(&speed)
    } else {
        speed
    }
}

/// Rounds bounds inwards to a multiple of a quantum, but never past the value of the drawing.
pub(super) fn inside(low: f64, high: f64, value: f64, quantum: f64) -> (f64, f64) {
    let scale = 1.0 / quantum;
    let [low, high] = [(low * scale).ceil() / scale, (high * scale).floor() / scale];
    let [low, high] = [low, high].map(|bound| rounded(bound, quantum * 1e-6));
    (low.min(value), high.max(value))
}

/// Rounds to a power of ten.
pub(super) fn rounded(value: f64, quantum: f64) -> f64 {
    let scale = 10f64.powf((-quantum.log10()).round());
    let rounded = (value * scale).round() / scale;
    if rounded.is_finite() { rounded } else { value }
}
