//! Lengths of the drawing in comments, with the bands in which the rounding leaves them.

use std::f64::consts::SQRT_2;
use std::fmt::Write;

use crate::document::{Document, Slot, SlotPath};
use crate::number::{WIDE, banded, plain, short};
use crate::wrapped::comment;

use super::spelling::Spelling;

/// A pin misses its slot if it is further away than this part of the size.
const MISS: f64 = 1e-9;

/// Explains the comments behind links.
pub(super) fn about(document: &Document, text: &mut String) {
    let words = if document.band > 0.0 {
        "Links: lengths are those of the drawing. The comments have them with the bands of their \
         rounding, and whole numbers within: the designer may have meant these."
    } else {
        "Links: lengths are those of the drawing, with all digits of the file."
    };
    comment(text, "    // ", words);
}

/// Adds the distances of a link's joints from the first one.
pub(super) fn of_link(
    document: &Document,
    spelling: &Spelling,
    joints: &[usize],
    text: &mut String,
) {
    let unit = document.unit.name();
    let Some((first, others)) = joints.split_first() else {
        return;
    };
    for other in others {
        let length = document.distance(*first, *other);
        let [from, to] = [first, other].map(|joint| &spelling.joints[*joint]);
        let _ = write!(text, "    //   {from} to {to} ");
        let band = band(document, *first, *other);
        let _ = writeln!(text, "{}", banded(length, band, unit));
    }
}

/// The largest error of a distance: both ends may be off by the band in both coordinates.
fn band(document: &Document, first: usize, second: usize) -> f64 {
    let length = document.distance(first, second);
    if length == 0.0 {
        return 2.0 * SQRT_2 * document.band;
    }
    let direction = document.direction(first, second);
    2.0 * document.band * (direction.cos().abs() + direction.sin().abs())
}

/// Adds how far a pin is drawn from its slot, and the radius of an arc.
pub(super) fn of_slot(document: &Document, slot: &Slot, text: &mut String) {
    let unit = document.unit.name();
    let size = document.largest_distance().map_or(0.0, |largest| largest.2);
    let miss = match slot.path {
        SlotPath::Joints(first, second) => {
            let direction = document.direction(first, second);
            let to_pin = document.direction(first, slot.pin);
            document.distance(first, slot.pin) * (to_pin - direction).sin()
        }
        SlotPath::Direction(..) => 0.0,
        SlotPath::Arc { centre, radius } => {
            let _ = writeln!(
                text,
                "    //   the radius in the file is {}{unit}",
                short_radius(radius)
            );
            document.distance(centre, slot.pin) - radius
        }
    };
    if miss.abs() > MISS * size {
        let _ = writeln!(
            text,
            "    //   the pin is drawn {}{unit} beside its slot",
            short(miss.abs())
        );
    }
}

/// Returns the whole numbers that coordinates may have been, unless they are these.
pub(super) fn whole_position(document: &Document, position: [f64; 2]) -> Option<[f64; 2]> {
    let whole = position.map(f64::round);
    let is_within = |axis: usize| (position[axis] - whole[axis]).abs() <= document.band;
    let is_near = is_within(0) && is_within(1) && document.band < WIDE;
    (is_near && whole != position).then_some(whole)
}

fn short_radius(radius: f64) -> String {
    plain(format!("{radius:.9}").parse().unwrap_or(radius))
}
