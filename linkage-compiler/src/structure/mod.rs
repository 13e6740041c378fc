//! The structural analysis: which unknowns can be solved together, in which order, and in which
//! form.
//!
//! Loops and unknowns form a bipartite graph. A maximum matching and the strongly connected
//! components of the directed matching graph (Dulmage and Mendelsohn; Tarjan) are the Assur groups,
//! in order. Each group is then brought to one of the [`Form`]s that have a closed solution, by
//! looking at its loops as polynomials in its unknowns.
//!
//! The files form floors, and each uses those of lower floors only:
//!
//! 1. data: `elements`, `coupled::group`, `form`, `group`, `scope`, `reductions`, `fault`;
//! 2. the two sides of the graph (`equations`) and its matching (`matching`);
//! 3. expressions in unknowns: `polynomials`, `distance`, `space`, `explicit`,
//!    `parallel_direction`;
//! 4. recognition: `classify`, `point`, `coupled`;
//! 5. reductions, one step of a coupled set towards known forms: `rewrite`, `double`, `circle`,
//!    `body`, `body_circle`, chosen by `eliminate`; `cancellation`, `set_unknowns`, `equation_difference`,
//!    `combination` and `separation`, which make a coupled set fall apart, and `triangle` and `crossing`
//!    above them;
//! 6. messages: `naming`, `closest_approach`, `simultaneous`, `loops_together`, `redundant`,
//!    `unknown_frame`, `overheld_frame`, `frames`, `link_faults`, `mobility_check`, `unsolved`;
//! 7. `analysis_state`, and `decompose`, the entry point.

mod analysis_state;
pub(crate) mod body;
pub(crate) mod body_circle;
pub(crate) mod cancellation;
pub(crate) mod circle;
pub(crate) mod classify;
pub(crate) mod closest_approach;
pub(crate) mod combination;
pub(crate) mod coupled;
pub(crate) mod crossing;
pub(crate) mod decompose;
pub(crate) mod distance;
pub(crate) mod double;
pub(crate) mod elements;
pub(crate) mod eliminate;
mod equation_difference;
pub(crate) mod equations;
pub(crate) mod explicit;
pub(crate) mod fault;
pub(crate) mod form;
pub(crate) mod frames;
pub(crate) mod group;
pub(crate) mod link_faults;
mod loops_together;
pub(crate) mod matching;
pub(crate) mod mobility_check;
pub(crate) mod naming;
mod nearly_redundant;
mod overheld_frame;
pub(crate) mod parallel_direction;
pub(crate) mod point;
pub(crate) mod polynomials;
pub(crate) mod reductions;
pub(crate) mod redundant;
pub(crate) mod rewrite;
pub(crate) mod scope;
pub(crate) mod separation;
pub(crate) mod set_unknowns;
pub(crate) mod simultaneous;
pub(crate) mod space;
pub(crate) mod triangle;
mod unknown_frame;
pub(crate) mod unsolved;

pub(crate) use coupled::group::{Block, Core, Coupled, Private, Product};
pub(crate) use coupled::solution_bound::SolutionBound;
pub(crate) use decompose::decompose;
pub(crate) use elements::{Plane, Rotor, SpaceLink, Sphere};
pub(crate) use form::Form;
pub(crate) use group::{Group, Structure};
pub(crate) use scope::Scope;
