//! Derivatives of numbers that depend on the solutions of groups.
//!
//! A symbol with a definition is differentiated by a rule ([`DerivativeRule`]), an unknown of a
//! group by the group's equations. The square root of a closed form is never differentiated. The
//! files are listed in the order in which they are used: each uses files above it only. Their data
//! are in `memo`, `systems`, `rules` and `equations` of `algebra`.
//!
//! Total derivatives, by inputs and, forward, by parameters:
//!
//! | file | purpose |
//! |---|---|
//! | `by_rule` | the derivative of each rule; traits of the recursive steps |
//! | `rotation_variation` | turns of bodies of coupled groups, and vectors on bodies |
//! | `written_rows` | right-hand sides from the written loops: links, arms on bodies |
//! | `elimination` | the linear system of a coupled group, by its core |
//! | `partial` | partial derivatives, while all other unknowns and rates are held |
//! | `links` | shorter second derivatives of links and rods, by products that are known |
//! | `implicit` | the rates of a group, by the implicit function theorem |
//!
//! Derivatives by parameters, backwards:
//!
//! | file | purpose |
//! |---|---|
//! | `mentioned` | the unknowns and rates that expressions and systems mention |
//! | `acting` | the parameters that act on expressions and systems |
//! | `adjoint` | multipliers of all systems, from results or unknowns backwards |
//! | `preaccumulation` | the same through few intermediates, each swept once |
//! | `reverse` | one sweep through all operations of a formula, its loops and rates |
//! | `gradient` | derivatives by parameters from such a sweep |
//! | `direction` | the entry point: the derivative of a number in a given direction |
//!
//! `dependence` finds the symbols and inputs below expressions. It differentiates nothing, and
//! shows which derivatives vanish.
//!
//! [`DerivativeRule`]: crate::algebra::rules::DerivativeRule

pub(crate) mod acting;
pub(crate) mod adjoint;
pub(crate) mod by_rule;
pub(crate) mod dependence;
pub(crate) mod direction;
pub(crate) mod elimination;
pub(crate) mod gradient;
pub(crate) mod implicit;
pub(crate) mod links;
pub(crate) mod mentioned;
pub(crate) mod partial;
pub(crate) mod preaccumulation;
pub(crate) mod reverse;
pub(crate) mod rotation_variation;
pub(crate) mod written_rows;
