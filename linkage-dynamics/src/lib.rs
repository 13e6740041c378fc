//! The motion of mechanisms under forces: integration in time, events, steady state, motors.
//!
//! Users reach all items through the facade crate `linkage`, in its module `dynamics`. Its page has
//! the questions, the methods, and the comparison of integrators.
//!
//! [`Problem`] integrates equations of motion over time and records a [`Motion`], with each
//! [`Event`]. Functions of a [`Machine`], which has one input, integrate over the input instead
//! ([`steady_state`], [`flywheel`]). [`Conservative`] needs no integrator.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod computed_motion;
mod dead_point;
mod energy;
mod equations_of_motion;
mod equilibrium;
mod error;
mod event;
mod flywheel;
mod gauss;
mod machine;
mod motion_problem;
mod motor;
mod no_motion;
mod observer;
mod phase;
mod recorder;
mod run_up;
mod self_locking;
mod sign_changes;
mod state;
mod steady;
mod step;
mod stepper;
#[cfg(test)]
mod tests;
mod turn;

pub use computed_motion::{Ended, Motion, Occurrence};
pub use energy::Conservative;
pub use equations_of_motion::{Equations, Fault, FromAccelerations, FromReduced, Reduced};
pub use equilibrium::{Equilibrium, NaturalMode, equilibria, natural_modes};
pub use error::{Cause, Interrupted};
pub use event::Event;
pub use flywheel::{Flywheel, flywheel};
pub use machine::Machine;
pub use motion_problem::Problem;
pub use motor::{Motor, MotorError};
pub use no_motion::NoMotion;
pub use run_up::{NotReached, RunUp, Stop, brake, run_up};
pub use self_locking::{LockedRange, self_locking};
pub use state::State;
pub use steady::{NotSteady, SteadyState, steady_state};
pub use stepper::Method;
