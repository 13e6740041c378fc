//! In which ways unknowns can still move, in words, and what holds them too often: the null vectors of the loops, whether these close or not.
//!
//! A body counts as a whole: its loops are differentiated by shifts and turns, not by the unknowns that it consists of.

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
