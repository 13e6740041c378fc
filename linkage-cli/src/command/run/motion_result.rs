//! A motion that has been computed, for all forms of output.

use linkage_dynamics::Motion;
use linkage_engine::{Assembly, Driven};

/// A motion and its equation.
pub(super) struct MotionResult<'a, const N: usize> {
    pub(super) driven: &'a Driven<'a>,
    pub(super) assembly: &'a Assembly<'a>,
    pub(super) motion: &'a Motion<N>,
}
