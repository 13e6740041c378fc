//! The groups of a mechanism with their solutions.

use linkage_core::numeric::continuation::Terms;
use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::{Algebra, derivatives::dependence};
use crate::model::{Dimension, Mechanism};
use crate::solve::closed::{ClosedForm, GapIn};
use crate::solve::coupled::prepared::Prepared;
use crate::structure::Group;

/// A group with its solution.
#[derive(Clone, Debug)]
pub(crate) struct Solved<'m> {
    pub(crate) group: Group<'m>,
    pub(crate) closed: ClosedForm<'m>,
    /// Index among the assembly modes.
    pub(crate) mode: Option<usize>,
    /// For a coupled group.
    pub(crate) prepared: Option<Prepared<'m>>,
}

impl Solved<'_> {
    /// The dimension of the group's gap.
    pub(crate) fn gap_dimension(&self, mechanism: &Mechanism) -> Dimension {
        let dimension = match self.closed.gap_in {
            GapIn::Loop => self.group.loop_dimension(mechanism),
            GapIn::Unknown => self.group.unknown_dimension(mechanism),
            GapIn::Link => self.group.link_dimension(mechanism),
        };
        dimension.unwrap_or(Dimension::LENGTH)
    }
}

/// The mechanism with every unknown expressed.
#[derive(Debug, Default)]
pub(crate) struct Formulation<'m> {
    pub(crate) groups: Vec<Solved<'m>>,
    /// The group that a symbol belongs to.
    pub(crate) group_of: Map<SymbolId, usize>,
    pub(crate) mobility: usize,
}

impl<'m> Formulation<'m> {
    /// The terms that grids over two inputs store in their cells.
    pub(crate) fn in_cells(&self) -> Terms {
        let mut over_two = self
            .prepared()
            .filter(|prepared| prepared.inputs.len() == 2);
        if over_two.any(|prepared| prepared.in_cells == Terms::Slopes) {
            Terms::Slopes
        } else {
            Terms::Polynomials
        }
    }

    pub(crate) fn modes(&self) -> usize {
        self.groups
            .iter()
            .filter(|group| group.mode.is_some())
            .count()
    }

    /// The prepared states of the coupled groups, in order.
    pub(crate) fn prepared(&self) -> impl Iterator<Item = &Prepared<'m>> {
        self.groups
            .iter()
            .filter_map(|group| group.prepared.as_ref())
    }

    /// The last group that finds an unknown.
    pub(crate) fn last_group_with(&self, unknown: usize) -> Option<usize> {
        self.groups
            .iter()
            .rposition(|solved| solved.group.unknowns.contains(&unknown))
    }

    /// Angles in the order in which their groups are solved.
    pub(crate) fn in_order(&self, algebra: &Algebra<'m>, mut angles: Vec<usize>) -> Vec<usize> {
        angles.sort_by_key(|&angle| self.group_of.get(&algebra.names.angles[angle].cos));
        angles
    }

    /// The groups that expressions are computed from, in order.
    pub(crate) fn groups_of(&self, algebra: &Algebra<'m>, expressions: &[Ex<'m>]) -> Vec<usize> {
        let symbols = dependence::symbols_below(algebra.graph, expressions);
        let mut groups: Vec<usize> = symbols
            .iter()
            .filter_map(|symbol| self.group_of.get(symbol).copied())
            .collect();
        groups.sort_unstable();
        groups.dedup();
        groups
    }
}
