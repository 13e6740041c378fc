//! Texts about the ways in which unknowns can still move, and about loops that hold them too often:
//! the null vectors of the loops, closed or not.
//!
//! A body counts as a whole: its loops are differentiated by shifts and turns, not by the unknowns
//! that it consists of.

pub(crate) mod freedom;
pub(crate) mod line;
pub(crate) mod loops;
pub(crate) mod motion;
pub(crate) mod nearest;
pub(crate) mod null_space;
pub(crate) mod overconstrained;
pub(crate) mod position;
pub(crate) mod rows;

pub(crate) use loops::difference;
pub(crate) use nearest::Nearest;
pub(crate) use position::Position;
