//! Courses: laws of motion from knot to knot, and splines.

pub(super) mod arguments;
pub(super) mod knots;
pub(super) mod motion_law_call;
pub(super) mod pieces;
pub(super) mod slope;
pub(super) mod spline;
