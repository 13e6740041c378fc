//! Pages of reports in a real browser.
//!
//! [`Page::open`] starts Chromium, or says why there is none; the samples are mechanisms computed by hand.

mod chromium;
mod input;
mod page;
mod pdf;
mod processor;
pub mod samples;
mod sight;

pub use chromium::{find, required};
pub use input::{Button, Key};
pub use page::{Entry, entries, folder, some};
pub use page::{Page, REPORT};
pub use pdf::accessible;
pub use pdf::printed_words;
pub use processor::processor_times;
pub use sight::{DESKTOP, PHONE, SMALL_PHONE, Screen};
