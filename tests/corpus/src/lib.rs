//! Random mechanisms that assemble by construction, and the compiler's results for them on plain numbers.
//!
//! A configuration is chosen first; dimensions and start estimates follow from it. The tests compare the expression
//! graph, the programs and the generated code.

mod builder;
mod case;
mod code;
mod functions;
mod groups;
mod plane;
mod sample;
mod scalars;
mod space;
mod spatial;
mod subject;

pub use builder::Unknown;
pub use case::Case;
pub use code::code;
pub use functions::{Entry, Function, Kind, Variable};
pub use sample::{Sample, sample};
pub use subject::{Position, Subject, unit};
