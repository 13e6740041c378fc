//! Reports of mechanisms that are compiled at run time.
//!
#![doc = include_str!("../README.md")]

mod derived_functions;
mod mechanism_report;
mod motion_functions;
mod motion_report;

pub use derived_functions::{
    Missing, selections, with_drawings, with_functions, with_further_functions,
};
pub use mechanism_report::{PageContents, PageReport, columns, report};
pub use motion_functions::{EnergyFunctions, MotionFunctions, with_motion_functions};
pub use motion_report::{MotionContents, MotionRows, motion_report};
