//! Bodies, joints, loads, and quantities of functions about them.

mod bodies;
mod clause_values;
mod clauses;
mod declare;
mod dump;
mod find;
mod inertia;
mod items;
mod joints;
mod loads;
mod parts;
mod quantities;

pub(super) use dump::write_mechanics;
pub(super) use items::resolve_mechanics;
pub(super) use quantities::resolve_mechanics_quantity;
