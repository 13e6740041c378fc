//! The mechanism in which functions are expressed.

use linkage_symbolic::Vn;

use crate::algebra::Algebra;
use crate::forces::Forces;
use crate::solve::Formulation;

/// A solved mechanism, in whose graph quantities of functions are expressed.
pub(crate) struct State<'a, 'm> {
    pub(crate) algebra: &'a mut Algebra<'m>,
    pub(crate) forces: &'a mut Forces<'m>,
    pub(crate) formulation: &'a Formulation<'m>,
    /// The vectors of `picture()`, once they have been found: points, then unit vectors.
    pub(crate) drawn: Vec<Vn<'m>>,
}
