//! Reports of mechanisms that are compiled at run time.
//!
#![doc = include_str!("../README.md")]

mod derived_functions;
mod mechanism_report;

pub use derived_functions::{
    Missing, selections, with_drawings, with_functions, with_further_functions,
};
pub use mechanism_report::{PageContents, PageReport, columns, report};
