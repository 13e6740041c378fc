//! Groups without a closed form, with the states that are prepared of them.

use linkage_compiler::ir::{CompiledMechanism, Coupled, PreparedTable};
use linkage_core::numeric::continuation::{Axis, GridLayout, TableLayout};

/// A group without a closed form.
#[derive(Debug)]
pub struct CoupledDeclaration<'a> {
    /// Its programs.
    pub group: &'a Coupled,
    /// The names of its unknowns: `theta, psi`.
    pub unknowns: String,
    /// The names of its inputs.
    pub inputs: String,
    /// Its states over the ranges of its inputs; `None` if it is closed nowhere.
    pub states: Option<PreparedStates<'a>>,
    table: Option<&'a PreparedTable>,
}

/// The prepared states of a group.
#[derive(Debug)]
pub enum PreparedStates<'a> {
    /// Over one input.
    Table(TableLayout<'a>),
    /// Over several inputs, or none.
    Grid(GridLayout<'a>),
}

impl PreparedStates<'_> {
    /// The ranges of the inputs.
    pub fn axes(&self) -> &[Axis] {
        match self {
            Self::Table(table) => std::slice::from_ref(&table.axis),
            Self::Grid(grid) => &grid.axes,
        }
    }
}

impl<'a> CoupledDeclaration<'a> {
    /// All groups of a mechanism that have no closed form.
    pub(crate) fn all(unit: &'a CompiledMechanism) -> Vec<Self> {
        let one = |group: &'a Coupled| {
            let inputs = group.inputs.iter();
            let inputs: Vec<&str> = inputs.map(|&input| &unit.inputs[input].name[..]).collect();
            Self {
                group,
                unknowns: unit.groups[group.group].unknowns.join(", "),
                inputs: inputs.join(", "),
                states: group.start.as_ref().map(|start| match start {
                    PreparedTable::Table(table) => PreparedStates::Table(table.layout()),
                    PreparedTable::Grid(grid) => PreparedStates::Grid(grid.layout()),
                }),
                table: group.start.as_ref(),
            }
        };
        unit.coupled.iter().map(one).collect()
    }

    /// Returns the state at these inputs of the group, and half of a determinant near it.
    pub fn state(&self, inputs: &[f64]) -> (Vec<f64>, f64) {
        let mut state = vec![f64::NAN; self.group.size];
        let floor = match self.table {
            Some(PreparedTable::Table(table)) => table.state(inputs[0], &mut state),
            Some(PreparedTable::Grid(grid)) => grid.state(inputs, &mut state),
            None => f64::NAN,
        };
        (state, floor)
    }
}
