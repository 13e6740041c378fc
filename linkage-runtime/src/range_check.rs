//! The check of the declared range of an assembly: change points, dead points, gaps. The compiler
//! makes it for the default dimensions.

mod check;
mod print;
mod report;
mod search;
mod stretches;
#[cfg(test)]
mod tests;

pub use check::{check_range, check_range_of};
pub use linkage_core::range_check::Unchecked;
pub use print::RangeMessage;
pub use report::{RangeFinding, RangeFindingKind, RangeReport, Ranged};
pub(crate) use stretches::touches;
