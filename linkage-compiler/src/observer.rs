//! Who looks at what the middle phases hand to each other.

use linkage_symbolic::program::Program;

use crate::algebra::{Algebra, Nominal};
use crate::solve::Formulation;
use crate::structure::Structure;

/// Is shown what stands between the phases. Nothing is made for it unless it asks.
pub(crate) trait PhaseObserver {
    /// The groups, before they are solved.
    fn structure(&mut self, _: &Algebra, _: &Structure) {}

    /// Every unknown expressed, before anything is asked for.
    fn formulated<'m>(&mut self, _: &mut Algebra<'m>, _: &Formulation<'m>, _: &Nominal) {}

    /// A function, by its number, as a pass left it.
    fn pass(&mut self, _name: &'static str, _function: usize, _program: &dyn Fn() -> Program) {}
}

impl PhaseObserver for () {}
