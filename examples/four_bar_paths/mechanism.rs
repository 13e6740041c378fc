//! The four-bar of the path problems.

include!("../../mechanisms/four_bar_paths.rs");
