//! Coupled groups: loops that must be solved together.

pub(crate) mod class;
pub(crate) mod classify_coupled;
pub(crate) mod core_unknowns;
pub(crate) mod distance_polynomials;
pub(crate) mod group;
pub(crate) mod scalar_product;
pub(crate) mod solution_bound;
