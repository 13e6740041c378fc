//! The four-bar in arael-sym.

// Of the generated code.
#![allow(unused_variables, clippy::all)]

include!(concat!(env!("OUT_DIR"), "/four_bar.rs"));
