//! Elementary functions without branch or call, so that loops over them become vector code. Only
//! the sines of single calls use a table.
//!
//! `FUSED` says that the surrounding machine code has a fused multiply-add: a constant, since
//! `cfg!(target_feature)` does not see the features of a single function.

mod atan2;
mod ends;
mod multiply;
mod sin_cos;
mod sin_cos_single;

pub use sin_cos::directions;

/// The functions of `f64`.
pub(crate) mod double {
    pub(crate) use super::atan2::double as atan2;
    pub(crate) use super::multiply::double as mul_add;
    pub(crate) use super::sin_cos::{sin_cos, sin_cos_shortest};
}

/// The functions of `f32`.
pub(crate) mod single {
    pub(crate) use super::atan2::single as atan2;
    pub(crate) use super::multiply::single as mul_add;
    // Fewer digits need no table.
    pub(crate) use super::sin_cos_single::{sin_cos, sin_cos as sin_cos_shortest};
}
