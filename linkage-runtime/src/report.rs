//! What a mechanism does, for people: plots, drawings, data, an interactive page.
//!
//! A [`Report`] collects what there is about a mechanism over its range: sweeps as [`Table`](crate::Table)s, structure,
//! dimensions with their tolerances, a summary. It [writes](Report::write) all of it as a folder, or one thing at a time:
//! [`html`](Report::html), [`json`](Report::json), [`csv`](Report::csv), a [`Plot`] of some columns, a [`Drawing`] to
//! scale.

mod accuracy;
mod builder;
mod check;
mod colour;
mod course;
mod csv;
mod drawing;
mod error;
mod json;
mod page;
mod plot;
mod plots;
#[cfg(feature = "png")]
mod png;
mod rates;
mod shown;
mod svg;
mod tables;
mod units;
mod write;

pub use accuracy::BandKind;
pub use builder::{Report, SummaryRow};
pub use drawing::Drawing;
pub use error::{Mistake, ReportError};
pub use plot::Plot;
