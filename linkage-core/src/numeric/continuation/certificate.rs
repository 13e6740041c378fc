//! Limits of steps from another position or other dimensions: the same for evaluators, for their
//! preparation and for continuation.

/// The largest first correction, in radians or scaled lengths: a larger one might lead to another
/// assembly than a gradual change would.
pub const FIRST_CORRECTION: f64 = 0.05;

/// The largest ratio of a correction to the one before. Where Newton's method is certain to find
/// the nearest solution, each correction is below a quarter of the one before. The preparation of
/// states allows less, so that nothing between two prepared states is refused.
pub const ALLOWED_CONTRACTION: f64 = 0.25;

/// Newton steps from where the solution is known about: from the centre of a cell of a grid, and
/// from tables for other dimensions, derivatives or digits than theirs.
pub const STEPS_BESIDE: usize = 4;
