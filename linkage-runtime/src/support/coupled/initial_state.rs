//! The initial states of a coupled group.

use super::grid::CoupledGrid;
use super::lanes::Coupled;
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::Scalar;
use linkage_core::numeric::continuation::{Grid, Table};

/// The initial states of a coupled group for Newton's method, over the ranges of its inputs.
#[derive(Clone, Debug, PartialEq)]
pub enum InitialState {
    /// Nothing yet: every state is NaN.
    Nothing,
    /// Over one input.
    Table(Table),
    /// Over several inputs, or none.
    Grid(Grid),
}

impl InitialState {
    /// Writes the state at the group's inputs `x` as calls of generated code look it up, and
    /// returns the floor; NaN where there is none. With `FUSED` only on machines with fused
    /// multiply-add.
    ///
    /// # Panics
    ///
    /// If `state` is not as long as the states that were prepared.
    #[inline(always)]
    pub fn look_up<const FUSED: bool>(&self, x: &[f64], state: &mut [f64]) -> f64 {
        match self {
            Self::Nothing => {
                state.fill(f64::NAN);
                f64::NAN
            }
            Self::Table(table) => table.look_up::<FUSED>(x[0], state),
            Self::Grid(grid) => grid.look_up::<FUSED>(x, state),
        }
    }

    /// The state near the group's inputs `x`, and the floor.
    pub(super) fn state(&self, x: &[f64]) -> Vec<f64> {
        match self {
            Self::Nothing => Vec::new(),
            Self::Table(table) => {
                let mut state = vec![0.0; table.width()];
                table.state(x[0], &mut state);
                state
            }
            Self::Grid(grid) => {
                let mut state = vec![0.0; grid.width()];
                grid.state(x, &mut state);
                state
            }
        }
    }
}

impl<const S: usize> Coupled<S> {
    /// The tables of all lanes.
    pub fn of<'a, T: Scalar>(start: impl Fn(usize) -> &'a InitialState) -> Self {
        Self::new::<T>(|lane| match start(lane) {
            InitialState::Table(table) => table.lookup(),
            _ => None,
        })
    }
}

impl<const I: usize, const S: usize, const N: usize> CoupledGrid<I, S, N> {
    /// The grids of all lanes.
    pub fn of<'a, T: Scalar>(start: impl Fn(usize) -> &'a InitialState) -> Self {
        Self::new::<T>(|lane| match start(lane) {
            InitialState::Grid(grid) => grid.lookup(),
            _ => None,
        })
    }
}
