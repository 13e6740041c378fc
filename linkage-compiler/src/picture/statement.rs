//! The statement of the program that is drawn.

/// Names in derived quantities that no loop uses are behind all others.
pub(super) const ASIDE: u8 = 6;

/// A statement of the program, by its coordinates and the rank of its names.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Statement<'f> {
    /// The coordinates in which it is written; none are the drawing's.
    pub(super) frames: &'f [usize],
    /// Added to the ranks of names: those in loops are better.
    pub(super) remoteness: u8,
}

impl Statement<'_> {
    /// A statement of the same rank that is written in other coordinates.
    pub(super) fn within(self, frames: &[usize]) -> Statement<'_> {
        Statement { frames, ..self }
    }
}
