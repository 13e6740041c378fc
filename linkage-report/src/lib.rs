//! Reports of mechanisms for people: plots, drawings, data, an interactive page.
//!
//! A [`Report`] collects the data of a mechanism over its range: sweeps as
//! [`Table`](linkage_runtime::Table)s, structure, dimensions with their tolerances, a summary. It
//! [writes](Report::write) all of it as a folder, or one item at a time: [`html`](Report::html),
//! [`json`](Report::json), [`csv`](Report::csv), a [`Plot`] of some columns, a [`Drawing`] to
//! scale.
//!
//! Users reach all items through the facade crate `linkage`, in its module `report`.
//!
//! Feature: `png` (pictures as PNG).
#![cfg_attr(docsrs, feature(doc_cfg))]

mod accuracy;
mod arc_slot;
mod builder;
mod check;
mod compare;
mod csv;
mod downsample;
mod drawing;
mod driven_motion;
mod figures;
mod frame;
mod glyphs;
mod index;
mod joint_signs;
mod json;
mod machine;
mod missing;
mod outputs;
mod page;
mod palette;
mod panels;
mod plot;
mod plots;
mod positioned_picture;
mod rates;
mod row;
mod spaces;
mod summary;
mod tables;
mod traced_points;
mod version;
mod view;
mod write;

pub use accuracy::BandKind;
pub use builder::Report;
pub use compare::{Aim, Compared, Comparison};
pub use drawing::Drawing;
#[doc(hidden)]
pub use driven_motion::{DrivenMotion, MotionEnergy, MotionStop, MovingInput, Watched};
pub use index::Index;
#[doc(hidden)]
pub use linkage_formats::AtomicFile;
pub use linkage_formats::{CsvStyle, Mistake, ReportError};
pub use plot::Plot;
pub use row::SummaryRow;
pub use version::show_mistakes;
#[doc(hidden)]
pub use view::{PageView, page_view};
