//! The motion of mechanisms under forces: integration in time, events, steady state, motors.
//!
//! Users reach all items through the facade crate `linkage`, in its module `dynamics`.
#![cfg_attr(docsrs, feature(doc_cfg))]

mod dead_point;
mod energy;
mod equations;
mod equilibrium;
mod error;
mod event;
mod machine;
mod motion;
mod motor;
mod observer;
mod phase;
mod problem;
mod recorder;
mod run_up;
mod steady;
mod step;
mod stepper;
#[cfg(test)]
mod tests;
mod turn;

pub use energy::{Conservative, NoMotion};
pub use equations::{Equations, Fault, FromAccelerations, FromReduced, Reduced};
pub use equilibrium::{Equilibrium, NaturalMode, equilibria, natural_modes};
pub use error::{Cause, Interrupted};
pub use event::Event;
pub use machine::Machine;
pub use motion::{Ended, Motion, Occurrence, State};
pub use motor::{Motor, MotorError};
pub use problem::Problem;
pub use run_up::{NotReached, RunUp, Stop, brake, run_up};
pub use steady::{Flywheel, NotSteady, SteadyState, flywheel, steady_state};
pub use stepper::Method;
