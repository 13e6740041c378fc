//! Sizes of symbols and letters on paper, in millimetres.

/// Length of guides beyond the slider, on paper.
pub(super) const BEYOND: f64 = 8.0;
/// Half the length and half the height of a slider.
pub(super) const BLOCK: [f64; 2] = [4.0, 2.3];
/// Width of outlines.
pub(super) const OUTLINE: f64 = 0.35;
/// Radius of a joint.
pub(super) const JOINT: f64 = 1.05;
/// Height and half the width of a pivot's foot.
pub(super) const FOOT: [f64; 2] = [4.2, 2.8];
/// Size of the letters of names and legends.
pub(super) const LETTER_SIZE: f64 = 3.2;
/// Average width of such a letter.
pub(super) const LETTER_WIDTH: f64 = 1.95;
