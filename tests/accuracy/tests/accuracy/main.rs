//! Every kind of group against a reference of 154 digits; laws of motion, splines, cams and elementary
//! functions; identities of derivatives; other numbers than `f64`.
//!
//! The references are in the package `linkage-reference`: they need optimisation, which would take most of the time for the
//! generated code of hundreds of mechanisms here.

mod cams;
mod chain_of_ten;
mod chains;
mod coupled;
mod coupled_scalars;
mod cylinder;
mod driver;
mod dyads_rpr;
mod dyads_rrp;
mod dyads_rrr;
mod dyads_slides;
mod elementary;
mod laws;
mod other_dimensions;
mod quick_return;
mod reference;
mod scalar_loops;
mod scalars;
mod space;
mod true_motion;
mod two_inputs;
