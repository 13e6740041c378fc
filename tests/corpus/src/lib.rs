//! Random mechanisms that assemble by construction, and the compiler's results for them on plain numbers.
//!
//! A configuration is chosen first; dimensions and start estimates follow from it. The tests compare the expression
//! graph, the programs and the engine; the package `linkage-command` compares the engine with generated code. What is printed in another language is compared with the same [`programs`] on the runtime's [`numbers`]:
//! those of the random mechanisms and of those that are [`given`].

mod builder;
mod case;
mod functions;
pub mod given;
mod groups;
pub mod numbers;
pub mod operations;
pub mod programs;
pub mod quotients;
pub mod reference;
mod scalars;
mod space;
mod spatial;
mod subject;

pub use builder::Unknown;
pub use case::Case;
pub use case::{COUNT, Sample, sample};
pub use functions::{Entry, Function, Kind, Variable};
pub use subject::{Position, Subject, unit};
