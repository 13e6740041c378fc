//! The summary of a cycle: limits and stroke, extreme velocities and accelerations, dwells, time ratio, transmission angle,
//! margin, and what a four-bar is by Grashof's rule.
//!
//! A [`Course`] follows a quantity and its derivatives over the range of the input. All places where the quantity or a derivative stands still are roots of the
//! exact derivative above it, and so are found to the last digits. [`least`] searches for the smallest value of a
//! figure without derivatives, such as the margin; [`grashof`] compares lengths.

mod between;
mod cascade;
mod course;
mod dwell;
mod error;
mod extremes;
mod figures;
mod grashof;
mod interval;
mod least;
mod marks;
mod noise;
mod passages;
mod print;
mod ratio;
mod root;
mod source;
mod stations;
mod stretch;
mod transmission;
mod within;

pub use course::Course;
pub use dwell::Dwell;
pub use error::SummaryError;
pub use extremes::{Extreme, Extremes, Kind};
pub use grashof::{FourBar, Grashof, grashof};
pub use interval::Interval;
pub use least::{Least, least};
pub(crate) use marks::{Mark, Sign};
pub use passages::Passage;
pub use ratio::TimeRatio;
pub use stretch::positions;
pub use transmission::Transmission;
