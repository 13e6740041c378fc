//! Tasks of the repository. Tests that need their results call them as functions.

mod playground;

pub use playground::{Playground, playground};
