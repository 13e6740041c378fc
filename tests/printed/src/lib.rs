//! A library with a mechanism whose generated code is checked in: `linkage rust` has printed it.
//! `UPDATE=1 cargo test -p linkage-cli --test commands rust` prints it anew.

/// The slider-crank of `linkage new`.
#[rustfmt::skip]
pub mod slider_crank;
