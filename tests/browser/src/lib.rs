//! Pages of reports in a real browser.
//!
//! [`Page::open`] starts Chromium, or says why there is none; the samples are mechanisms computed by hand.

mod access;
mod chromium;
mod devtools;
mod gallery;
mod held;
mod input;
mod page;
mod pdf;
mod processor;
pub mod samples;
mod sight;

pub use access::accessible;
pub use chromium::{find, required};
pub use gallery::{Entry, entries, folder, some};
pub use input::{Button, Key};
pub use page::{Page, REPORT};
pub use pdf::printed_words;
pub use processor::processor_times;
pub use sight::{DESKTOP, PHONE, SMALL_PHONE, Screen};
