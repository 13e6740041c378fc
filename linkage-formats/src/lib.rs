//! File formats of `linkage`: SVG, DXF, CSV and PNG, for analyses and reports.
//!
//! [`CsvStyle`] is the format of numbers and cells of CSV. The hidden modules write pictures and
//! files. Files are replaced in one step. [`ReportError`] is the error of everything that writes
//! files, and [`Mistake`] the reason if contents do not fit together. Nothing here depends on a
//! mechanism.
//!
//! Users reach all items through the facade crate `linkage`, in its module `report`.
//!
//! Feature: `png` (pictures as PNG).
#![cfg_attr(docsrs, feature(doc_cfg))]

mod atomic_file;
#[doc(hidden)]
pub mod characters;
#[doc(hidden)]
pub mod colour;
mod csv_style;
#[doc(hidden)]
pub mod error;
mod mistake;
#[doc(hidden)]
pub mod output_file;
#[cfg(feature = "png")]
mod png;
#[doc(hidden)]
pub mod svg;
#[doc(hidden)]
pub mod tags;
#[doc(hidden)]
pub mod ticks;
#[doc(hidden)]
pub mod units;

#[doc(hidden)]
pub use atomic_file::AtomicFile;
pub use csv_style::CsvStyle;
pub use error::ReportError;
pub use mistake::Mistake;
