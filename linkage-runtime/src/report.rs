//! Reports for people: plots, drawings, data, an interactive page.
//!
//! A [`Report`] collects the data of a mechanism over its range: sweeps as
//! [`Table`](crate::Table)s, structure, dimensions with their tolerances, a summary. It
//! [writes](Report::write) all of it as a folder, or one item at a time: [`html`](Report::html),
//! [`json`](Report::json), [`csv`](Report::csv), a [`Plot`] of some columns, a [`Drawing`] to
//! scale.

mod accuracy;
mod atomic_file;
mod builder;
mod cam_profile;
mod check;
mod colour;
mod compare;
mod csv;
mod cyclogram;
mod downsample;
mod drawing;
mod error;
mod figures;
mod frame;
mod glyphs;
mod index;
mod joint_signs;
mod json;
mod machine;
mod missing;
mod mistake;
mod output_file;
mod outputs;
mod page;
mod palette;
mod panels;
mod plot;
mod plots;
#[cfg(feature = "png")]
mod png;
mod positioned_picture;
mod rates;
mod row;
mod summary;
mod svg;
mod tables;
mod tags;
mod units;
mod write;

pub use accuracy::BandKind;
#[doc(hidden)]
pub use atomic_file::AtomicFile;
pub use builder::Report;
pub use compare::{Aim, Compared, Comparison};
pub use csv::CsvStyle;
pub use drawing::Drawing;
pub use error::ReportError;
pub use index::Index;
pub use mistake::Mistake;
pub use plot::Plot;
pub use row::SummaryRow;
