//! Mechanisms compiled at run time: text in, numbers out.
//!
//! A text in the language of the macro `linkage::mechanism!` becomes a [`Mechanism`], for programs
//! that do not know their mechanisms at build time: an editor, a web service, a binding to another
//! language. The compiler of the macro reads it, so that the language and all messages are the
//! same. Values come from an interpreter of its programs and are equal to those of the macro's code
//! on the same machine, to the last bit.
//!
#![doc = include_str!("../README.md")]
//!
//! | to | call |
//! |---|---|
//! | compile a text | [`Mechanism::compile`], [`compile`] for several mechanisms |
//! | compile a text whose ranges are refused | [`compile_in_any_range`], for assemblies and circuits |
//! | close the loops | [`Mechanism::assemble`], [`Mechanism::assemblies`] |
//! | keep an assembly of other dimensions | [`Mechanism::assemble_from`] |
//! | search the range of the input | [`Mechanism::circuits`], [`Assembly::check_range`] |
//! | compute one position | [`Assembly::call`], [`Assembly::results`] by names |
//! | compute many positions | [`Assembly::sweep`], [`Assembly::sweep_parallel_into`] |
//! | compute many mechanisms | [`Assembly::sweep_sets`] |
//! | compute parts of a sweep | [`Assembly::sweep_in_parts`], [`Assembly::sweep_sets_in_parts`] |
//! | go from position to position | [`Assembly::follower`] |
//! | see effects of tolerances | [`Mechanism::sensitive_quantities`] |
//! | draw mechanisms within their tolerances | `RandomStudy::new` (feature `monte-carlo`) |
//! | move under forces | [`Mechanism::driven`], with `linkage::dynamics` |
//! | find dimensions for a path or a law | `Mechanism::design` (feature `design`) |
//! | name, unit and meaning of results | [`Mechanism::headings`]; [`Columns`] is a [`Table`] |
//!
//! Numbers are `f64`, lengths in the unit of the mechanism, angles in radians.
//!
//! A mechanism takes a compiler's work of some milliseconds; an assembly some microseconds; a
//! position of a sweep some ten nanoseconds. Names and descriptions of a compiled mechanism, a few
//! kilobytes, stay in memory until the process ends, as those of generated code do; equal ones of
//! several mechanisms are stored once.

#[cfg(doctest)]
#[doc = include_str!("../../docs/engine.md")]
mod page {}

mod assembled;
mod assembly_follower;
mod columns;
mod compiled;
#[cfg(feature = "design")]
mod design;
mod driven;
mod error;
mod kinematics;
mod mechanism;
mod messages;
mod normal;
mod numbers;
mod operations;
#[cfg(feature = "monte-carlo")]
mod random_results;
#[cfg(feature = "monte-carlo")]
mod random_study;
mod results;
mod source;
mod sweep;
mod tolerance_effects;

pub use assembly_follower::Follower;
pub use columns::Columns;
pub use compiled::Assembly;
#[cfg(feature = "design")]
pub use design::{DesignProblem, Designs, Variable};
pub use driven::{Driven, DrivenInput};
#[cfg(feature = "design")]
pub use error::DesignError;
pub use error::{CompileError, NotDriven, SourceError, ToleranceError, UnknownFunction};
pub use linkage_runtime::{
    AssemblyError, AssemblyMode, Branch, BranchEnd, Circuits, Estimate, Heading, Input,
    NotFollowed, Parameter, RangeReport, Structure, Table,
};
pub use mechanism::{Mechanism, compile, compile_in_any_range};
pub use messages::{rendered, rendered_warning};
pub use normal::normal_form;
#[cfg(feature = "monte-carlo")]
pub use random_results::{ExtremeMechanism, RandomResults};
#[cfg(feature = "monte-carlo")]
pub use random_study::{RandomStudy, StudyPlan};
pub use results::Results;
pub use source::{MechanismCall, Source};
pub use sweep::parts::Sweep;
pub use tolerance_effects::{SensitiveQuantity, ToleranceEffects};
