//! Bodies, joints and loads.

mod bodies;
mod clauses;
mod declare;
mod friction;
mod inertia;
pub(super) mod items;
mod joints;
mod loads;
mod part_bodies;
