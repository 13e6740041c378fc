//! Limits that certify numerical results, each defined here once.
//!
//! Evaluators, the preparation of groups at compile time and the engines of other languages keep to
//! the same limits. The printers of C and JavaScript write these numbers into the exported text.
//! Limits of the check of a range are in `range_check`.

/// Largest first correction of a Newton step, in radians or scaled lengths. A larger one may lead
/// to another assembly than a gradual change would.
pub const FIRST_CORRECTION: f64 = 0.05;

/// Largest ratio of a correction to the one before. Each correction is below a quarter of the one
/// before where Newton's method is certain to find the nearest solution. The preparation of states
/// uses a smaller ratio, so that evaluators accept every prepared state.
pub const ALLOWED_CONTRACTION: f64 = 0.25;

/// Newton steps from an approximate solution: from the centre of a cell of a grid, and from tables
/// for other dimensions, derivatives or digits than theirs.
pub const STEPS_BESIDE: usize = 4;

/// Largest correction of a prepared state of a coupled group from which results are computed: far
/// above the error of a table, far below the distance of another assembly.
pub const CORRECTION_LIMIT: f64 = 1e-7;

/// The same for numbers of single precision, whose rounding exceeds the error of tables.
pub const SINGLE_CORRECTION_LIMIT: f64 = 1e-4;

/// Largest last correction of a solution that is followed from position to position. Newton's
/// method squares it and multiplies the square by the curvature of the equations: for curvatures up
/// to ten thousand the rest is rounding of an `f64`.
pub const LAST_CORRECTION: f64 = 1e-10;

/// The same for numbers of single precision.
pub const SINGLE_LAST_CORRECTION: f64 = 1e-4;

/// Most corrections of one step to other dimensions.
pub const CORRECTIONS: usize = 8;

/// Correction of a step to other dimensions that leaves only rounding.
pub const SETTLED: f64 = 1e-9;

/// Scales of the lengths of a state that a step to other dimensions tries: powers of two, since
/// they change as links grow.
pub const SCALES: [f64; 3] = [1.0, 0.5, 2.0];

/// Roundings that the terms of a discriminant may have had, of their size each. The square root of
/// a value that is negative by no more is 0.
pub const ROUNDINGS: f64 = 8.0;

/// Half turns by which an angle should stray at most from the guide that counts its turns, so that
/// inputs a little outside the range are served too.
pub const COMFORTABLE_STRAY: f64 = 0.8;

/// Half turns by which an angle may stray at most from the guide that counts its turns.
pub const MOST_STRAY: f64 = 0.95;

/// Half turns of the largest sum of the middles of several inputs. A larger one leaves too little
/// of the half turn to the angle at the start.
pub const MOST_MIDDLE: f64 = 0.9;
