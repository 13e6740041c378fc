//! Coupled groups: loops that must be solved together, class III and higher.
//!
//! `group` has the data. `classify_coupled` finds private and core unknowns, with `core_unknowns`
//! for the kinds of the latter, `scalar_product` for rows in space and `class` for the names of
//! the plane. `distance_polynomials` prepares distances in space, and `solution_bound` bounds the
//! number of solutions.

pub(crate) mod class;
pub(crate) mod classify_coupled;
pub(crate) mod core_unknowns;
pub(crate) mod distance_polynomials;
pub(crate) mod group;
pub(crate) mod scalar_product;
pub(crate) mod solution_bound;
