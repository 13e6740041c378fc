//! The mechanism as algebra: its expressions as graph nodes, its unknowns as symbols.
//!
//! Shared by the phases below the model: `structure` recognises the loops as polynomials in the
//! unknowns, `solve` gives the unknowns their definitions, `outputs` differentiates.
//!
//! The files form floors, and each uses those of lower floors only:
//!
//! 1. data: `value`, `names`, `rules`, `equations`, `systems`, `solutions`, `memo`, and linear
//!    systems of expressions (`cofactors`, `positive_definite`, `pivots`, `bodies`);
//! 2. expressions of the language, which use [`Names`] alone: `scalar`, `body_vectors`, `frame`,
//!    `calls`, `motion_law`, and `translate` above them;
//! 3. numbers at the reference: `nominal`, `finite_numbers`, `constant_ratio`;
//! 4. vectors that turn, by [`Names`] and the rules in `solutions`: `turning_parts`,
//!    `angle_reference`, `rotating_frame`, `via_slider`;
//! 5. `context`: the struct [`Algebra`] that holds names, solutions and derivatives;
//! 6. `derivatives`, with a page of their own.

pub(crate) mod angle_reference;
pub(crate) mod bodies;
pub(crate) mod body_vectors;
pub(crate) mod calls;
pub(crate) mod cofactors;
pub(crate) mod constant_ratio;
pub(crate) mod context;
pub(crate) mod derivatives;
pub(crate) mod equations;
pub(crate) mod finite_numbers;
pub(crate) mod frame;
pub(crate) mod memo;
pub(crate) mod motion_law;
pub(crate) mod names;
pub(crate) mod nominal;
pub(crate) mod pivots;
pub(crate) mod positive_definite;
pub(crate) mod rotating_frame;
pub(crate) mod rules;
pub(crate) mod scalar;
pub(crate) mod solutions;
pub(crate) mod systems;
pub(crate) mod translate;
pub(crate) mod turning_parts;
pub(crate) mod value;
pub(crate) mod vanish;
pub(crate) mod via_slider;

pub(crate) use bodies::{Bodies, Body, Scheme};
pub(crate) use body_vectors::{coordinates, directions};
pub(crate) use constant_ratio::{ALIKE, ConstantRatio};
pub(crate) use context::Algebra;
pub(crate) use derivatives::direction::Direction;
pub(crate) use equations::{
    ArmOnBody, CoreRow, Distance, Elimination, Link, Links, PrivateColumn, Rod, Solution, Term,
    ViaSlider, WrittenRow,
};
pub(crate) use motion_law::clamped_curvatures;
pub(crate) use motion_law::zones::ends as ends_of_law;
pub(crate) use names::{Angle, AngleReference, Bound, Names, Phasor, StandsFor};
pub(crate) use nominal::Nominal;
pub(crate) use pivots::{InOrder, Order};
pub(crate) use rules::{AngleRule, DerivativeRule, RotatingFrame, TurnedVector};
pub(crate) use solutions::Shortcuts;
pub(crate) use translate::Translate;
pub(crate) use value::{Atom, Scalar, Value};
