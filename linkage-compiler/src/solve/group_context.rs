//! The facts about one group that its closed form reads.

use linkage_core::numeric::continuation::Terms;

use crate::algebra::Nominal;
use crate::model::Dimension;
use crate::solve::contour::EarlierGroups;

/// A group while its closed form is built.
pub(super) struct GroupContext<'a, 'm> {
    /// The mechanism with the values that the user declares.
    pub(super) nominal: &'a Nominal,
    /// Index of the group's solution.
    pub(super) index: usize,
    /// Index of the group's mode, if the group has one.
    pub(super) mode: usize,
    /// Index among the coupled groups, if the group is coupled.
    pub(super) number: usize,
    /// The dimension of the group's loop.
    pub(super) dimension: Option<Dimension>,
    pub(super) earlier: &'a EarlierGroups<'m>,
    /// The terms that grids over two inputs store in a cell.
    pub(super) in_cells: Terms,
}
