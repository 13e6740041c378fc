//! The summary of a cycle: limits and stroke, extreme velocities and accelerations, dwells, time
//! ratio, transmission angle, margin, and the type of a four-bar by Grashof's rule.
//!
//! A [`Curve`] follows a quantity and its derivatives over the range of the input. All places where
//! the quantity or a derivative is stationary are roots of the exact derivative above it, and so
//! are found to the last digits. [`minimise`] searches for the smallest value of a figure without
//! derivatives, such as the margin; [`grashof`] compares lengths.

mod band;
mod cascade;
mod crossings;
mod curve;
mod defined_intervals;
mod dwell;
mod dwell_between_limits;
mod error;
mod events;
mod extremes;
mod figures;
mod grashof;
mod interval;
mod minimise;
mod monotone_pieces;
mod print;
mod ratio;
mod source;
mod transmission;
mod zero_threshold;

pub use crossings::Crossing;
pub use curve::Curve;
pub use defined_intervals::positions;
pub use dwell::Dwell;
pub use error::SummaryError;
pub(crate) use events::{CurveEvent, CurveEventKind};
pub use extremes::{Extreme, Extremes, Kind};
pub use grashof::{FourBar, Grashof, grashof};
pub use interval::Interval;
pub use minimise::{Minimum, minimise};
pub use ratio::TimeRatio;
pub use transmission::Transmission;
