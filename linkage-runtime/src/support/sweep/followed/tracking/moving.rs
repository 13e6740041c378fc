//! A mechanism whose dimensions change, as a traveller sees it.

use crate::columns::Columns;
use crate::support::CoupledGroup;
use crate::support::sweep::arguments::Arguments;

/// A mechanism whose inputs stay while its `P` dimensions change, on plain numbers. A row of `R`
/// numbers is the dimensions, all inputs, then for each coupled group its state and floor.
pub trait Moving<const P: usize, const R: usize> {
    /// The coupled groups in order.
    const GROUPS: &'static [CoupledGroup];

    /// The dimensions of the tables.
    fn dimensions(&self) -> [f64; P];

    /// One Newton step of a group for every row: the numbers of its state, the square of the step,
    /// the determinant before it.
    fn correct(&self, group: usize, rows: &impl Arguments<f64, R>, columns: &mut Columns<f64>);
}
