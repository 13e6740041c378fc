//! An observer of the data that the middle phases hand to each other.

use linkage_symbolic::program::Program;

use crate::algebra::{Algebra, Nominal};
use crate::solve::Formulation;
use crate::structure::Structure;

/// Receives the data between the phases. Nothing is made unless the observer requests it.
pub(crate) trait PhaseObserver {
    /// The groups, before they are solved.
    fn structure(&mut self, _: &Algebra, _: &Structure) {}

    /// Every unknown expressed, before any output is requested.
    fn formulated<'m>(&mut self, _: &mut Algebra<'m>, _: &Formulation<'m>, _: &Nominal) {}

    /// A function, by its number, as a pass left it.
    fn pass(&mut self, _name: &'static str, _function: usize, _program: &dyn Fn() -> Program) {}
}

impl PhaseObserver for () {}
