//! Clearances, phases and cyclograms of motions written by hand, against dense searches and differences.
#![cfg(feature = "tolerance")]

mod clearance;
mod cyclogram;
mod distance;
#[cfg(feature = "files")]
mod files;
mod lags;
mod motion;
mod phases;
mod setting;

pub(crate) const TAU: f64 = std::f64::consts::TAU;
pub(crate) const TURN: (f64, f64) = (0.0, TAU);
