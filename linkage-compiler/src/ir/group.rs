//! The groups of a mechanism: their description, and the data that is prepared of coupled ones.

use linkage_core::numeric::continuation::{Grid, Table, Terms};
use linkage_core::numeric::roots::Variable;
use linkage_core::range_check::Slack;
use linkage_symbolic::program::Program;

/// The description of a group.
#[derive(Clone, Debug)]
pub struct Group {
    /// 0 where the word does not apply (an angle relation).
    pub class: u8,
    /// 0 where the word does not apply.
    pub order: u8,
    /// `RRR`, `RRP`, ...
    pub kind: String,
    /// Numbers of its loops, the first loop of the mechanism being 1.
    pub loops: Vec<usize>,
    /// The joints and links that its loops stand for: ``joint `c` of `rocker` ``. Empty if all of
    /// them are written as loops.
    pub joints: String,
    /// Names of the unknowns that it finds.
    pub unknowns: Vec<String>,
    /// Index among the assembly modes; `None` for a group with one solution.
    pub mode: Option<usize>,
    /// True if its assemblies are listed and one is prepared.
    pub coupled: bool,
    /// The mode that the start estimates choose: true for `+1`.
    pub plus: bool,
    /// A sentence for `STRUCTURE`: which solution is used.
    pub method: String,
    /// `mm`, `rad`: the unit in which the group's gap is measured.
    pub gap_unit: String,
    /// The meaning of its slack in the survey.
    pub slack: Slack,
    /// The scalars of parameters that its solution needs and no earlier group.
    pub parameters: Vec<usize>,
}

/// The data that `assemble()` prepares of a coupled group.
#[derive(Clone, Debug)]
pub struct Coupled {
    /// Index among all groups.
    pub group: usize,
    /// The inputs that it depends on.
    pub inputs: Vec<usize>,
    /// Numbers in a state.
    pub size: usize,
    /// The terms that a grid over its inputs knows in a cell.
    pub in_cells: Terms,
    /// The kinds of the variables of its polynomials.
    pub variables: Vec<Variable>,
    /// True if the assembly is followed from the estimates: its solutions cannot be listed, and
    /// `terms` are none.
    pub followed: bool,
    /// Equation and exponents of each term of the polynomials.
    pub terms: Vec<(usize, Vec<i8>)>,
    /// Real and imaginary part of each term's coefficient.
    pub system: Program,
    /// The state where the unknowns are estimated, if it is followed from there: lengths grow with
    /// the links.
    pub estimate: Program,
    /// Computes from a state the residual of each equation of its core, if it is followed. A
    /// solution is proven by these residuals.
    pub residuals: Program,
    /// Computes from a state the state after one Newton step, the square of the correction, and the
    /// determinant before it.
    pub correct: Program,
    /// Computes from a state the cosine and sine, or length, of each of `unknowns`, then the reach
    /// of the links.
    pub placed: Program,
    /// Computes from a state the left side of each of `missed_loops` without the right one, by
    /// component, then those of the loops of its frames.
    pub missed: Program,
    /// The loops of a group that is followed, without those of its frames; none if they cannot be
    /// derived from a state.
    pub missed_loops: Vec<MissedLoop>,
    /// The reach of the default mechanism.
    pub reach: f64,
    /// The numbers that distinguish its assemblies.
    pub unknowns: Vec<Placed>,
    /// The number of continuous angles, the first ones, that must be followed before its programs
    /// can be run.
    pub turning: usize,
    /// The states of the default mechanism, from which Newton steps begin; `None` until its loops
    /// are closed.
    pub start: Option<PreparedTable>,
}

/// The data that is prepared of the states of a coupled group over the ranges of its inputs.
#[derive(Clone, Debug)]
pub enum PreparedTable {
    /// Over one input.
    Table(Table),
    /// Over several inputs, or none.
    Grid(Grid),
}

impl Coupled {
    /// Its programs, to be changed.
    pub(super) fn programs_mut(&mut self) -> impl Iterator<Item = &mut Program> {
        let ends = [&mut self.system, &mut self.estimate, &mut self.missed];
        let steps = [&mut self.correct, &mut self.residuals, &mut self.placed];
        ends.into_iter().chain(steps)
    }
}

/// A loop that measures how near to closing a group comes.
#[derive(Clone, Debug)]
pub struct MissedLoop {
    /// Its number, the first loop of the mechanism being 1.
    pub number: usize,
    /// The joint or link that it stands for; empty for a loop as it is written.
    pub joint: String,
    /// The number of components that its sides have.
    pub rows: usize,
    /// `mm`; nothing for a number.
    pub unit: String,
    /// The size that misses are compared with: the longest length, of squares of lengths its
    /// square; 1 for numbers.
    pub scale: f64,
}

/// A number that distinguishes assemblies.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Index in the model.
    pub unknown: usize,
    /// The component, for a point.
    pub component: Option<usize>,
    /// True if it is an angle.
    pub angle: bool,
    /// Start estimate at the reference inputs.
    pub estimate: f64,
}

/// The way in which a number that distinguishes assemblies is shown and measured.
#[derive(Clone, Debug)]
pub struct ShownNumber<'u> {
    /// `theta`, `p.x`
    pub name: String,
    /// `mm`; nothing for an angle.
    pub unit: &'u str,
    /// The size that it is compared with: the longest length, 1 for a plain number.
    pub scale: f64,
}

/// An unknown whose numbers are surveyed.
#[derive(Clone, Copy, Debug)]
pub struct Surveyed {
    /// Index in the model.
    pub unknown: usize,
    /// True if it is an angle, which has two numbers: cosine and sine.
    pub angle: bool,
    /// The count of its numbers.
    pub numbers: usize,
}
