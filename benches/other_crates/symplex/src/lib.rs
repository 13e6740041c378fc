//! The four-bar in symplex.

// Of the generated code.
#![allow(unused_parens, unused_variables, clippy::all)]

include!(concat!(env!("OUT_DIR"), "/four_bar.rs"));
