//! What steps from another position or other dimensions must keep to: the same for evaluators, for
//! what prepares them, and for what follows.

/// The largest first correction, in radians or scaled lengths: what moves the solution by more
/// might lead to another assembly than a gradual change would.
pub const FIRST_CORRECTION: f64 = 0.05;

/// A correction over the one before, at most. Where Newton's method is certain to find the nearest
/// solution, each correction is below a quarter of the one before. What prepares states asks for
/// less, so that nothing is refused that lies between them.
pub const ALLOWED_CONTRACTION: f64 = 0.25;

/// Newton steps from where the solution is known about: from the centre of a cell of a grid, and
/// from tables for other dimensions, derivatives or digits than theirs.
pub const STEPS_BESIDE: usize = 4;
