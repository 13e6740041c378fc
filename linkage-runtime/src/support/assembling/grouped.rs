//! A compiled mechanism whose groups are assembled one after the other.

use alloc::boxed::Box;
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::range_check::Slack;
use linkage_core::{Cycle, Enclosure, Level, Scalar};

use super::compiled::{Compiled, CoreOf, DataOf, RevolutionsOf};
use super::list::List;
use super::preparation::prepared;
use super::winding::{at_estimates, set_from};
use crate::support::assembly_data::{AssemblyData, Core};
use crate::support::coupled::{CoupledGroup, InitialState};

/// Bounds of a number as a function of the inputs.
pub type Bounds<'a> = Box<dyn Fn(Enclosure) -> Enclosure + 'a>;

/// An unknown whose numbers are surveyed.
#[derive(Clone, Copy, Debug)]
pub struct SurveyedUnknown {
    /// Its name.
    pub name: &'static str,
    /// Unit of a length; empty for a number.
    pub unit: &'static str,
    /// True for an angle: its numbers are cosine and sine.
    pub angle: bool,
    /// The number of its numbers.
    pub numbers: usize,
}

/// An unknown whose numbers are surveyed.
#[must_use]
pub const fn surveyed(
    name: &'static str,
    unit: &'static str,
    angle: bool,
    numbers: usize,
) -> SurveyedUnknown {
    SurveyedUnknown {
        name,
        unit,
        angle,
        numbers,
    }
}

/// The data of a mechanism that searches for assemblies need.
#[derive(Clone, Copy, Debug)]
pub struct GroupData {
    /// The groups in order.
    pub levels: &'static [Level],
    /// The kind of slack of each group.
    pub slacks: &'static [Slack],
    /// The groups without a closed form, in order.
    pub coupled: &'static [CoupledGroup],
    /// The number of angles on which surveys depend.
    pub surveying: usize,
    /// The unknowns in the order of their numbers in a survey.
    pub unknowns: &'static [SurveyedUnknown],
    /// True if whole turns of an angle are alike: nothing is prepared over the range.
    pub repeats: bool,
    /// The range of the only input.
    pub cycle: Option<Cycle>,
}

/// A mechanism whose groups are assembled one after the other. Of assemblies that are searched only
/// the first groups are chosen; the modes and initial states of later groups mean nothing.
pub trait Grouped: Compiled {
    /// True if some group can have no closed form.
    const COUPLED: bool;

    /// The initial states of coupled groups in one lane.
    type Lane: List<InitialState>;
    /// The least margin of all groups, the slack of every group, the numbers of the unknowns.
    type Survey: AsRef<[Self::Scalar]>;

    /// The data that searches need.
    fn group_data(&self) -> &GroupData;

    /// The initial states of all lanes.
    fn states(&self, lanes: &[Self::Lane]) -> Self::States;

    /// Surveys an assembly. With `SLACKS` only the slacks are asked for, and the other numbers mean
    /// nothing.
    fn survey<const SLACKS: bool>(core: &CoreOf<Self>, x: Self::Arguments) -> Self::Survey;

    /// The state of a coupled group among arguments.
    fn state_mut(_x: &mut Self::Arguments, _number: usize) -> &mut [Self::Scalar] {
        &mut []
    }
}

/// The programs of a coupled group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GroupProgram {
    /// The coefficients of the polynomial system.
    System,
    /// A Newton step.
    Correct,
    /// The unknowns with start estimates.
    Placed,
    /// The state where the unknowns are estimated.
    Estimate,
    /// The sides of loops, by component.
    Missed,
}

/// A mechanism in plain numbers, whose coupled groups can be prepared.
pub trait PlainGroups: Grouped<Scalar = f64, Plain = Self> {
    /// Runs a program of a coupled group; there are no outputs where the group has no such program.
    fn run<R>(
        _core: &CoreOf<Self>,
        _number: usize,
        _program: GroupProgram,
        _x: Self::Arguments,
        read: impl FnOnce(&[f64]) -> R,
    ) -> R {
        read(&[])
    }

    /// The residuals of a coupled group over a box of its state.
    fn residuals(
        _core: &CoreOf<Self>,
        _number: usize,
        _x: Self::Arguments,
        _state: &[Enclosure],
    ) -> Vec<Enclosure> {
        Vec::new()
    }

    /// Bounds of the slack of a group over inputs, of a mechanism with one input. Those of groups
    /// after a coupled one are not known.
    fn bounds(_data: &DataOf<Self>, _group: usize) -> Option<Bounds<'static>> {
        None
    }
}

/// The survey of a mechanism of which only the slacks are known.
#[inline(always)]
pub fn slacks<T: Scalar, const G: usize, const N: usize>(slacks: [T; G]) -> [T; N] {
    let mut survey = [T::from_f64(f64::NAN); N];
    survey[1..=G].copy_from_slice(&slacks);
    survey
}

/// Bounds of the slack of a group by the programs of `enclosed`, the same mechanism over intervals.
pub fn bounds<C, E>(enclosed: E, data: &DataOf<C>, group: usize) -> Bounds<'static>
where
    C: PlainGroups,
    E: Grouped<Scalar = Enclosure, Modes = C::Modes, Lane = C::Lane> + 'static,
    CoreOf<E>: 'static,
    E::States: 'static,
{
    let from = AssemblyData::core(data);
    let lanes = no_states(&enclosed);
    let states = enclosed.states(&lanes);
    let mut revolutions = at_estimates(&enclosed);
    set_from::<E, C>(
        &mut revolutions,
        &from.revolutions,
        |enclosures, numbers| {
            for (enclosure, number) in enclosures.iter_mut().zip(numbers) {
                *enclosure = Enclosure::from_f64(*number);
            }
        },
    );
    let core = prepared_core(&enclosed, &from.modes, revolutions);
    Box::new(move |x| {
        let x = core.dimensions.arguments(&states, &List::list(1, |_| x));
        E::survey::<true>(&core, x).as_ref()[1 + group]
    })
}

/// The data of an assembly with these revolutions.
pub(super) fn prepared_core<C: Compiled>(
    mechanism: &C,
    modes: &C::Modes,
    revolutions: RevolutionsOf<C>,
) -> CoreOf<C> {
    Core {
        dimensions: mechanism.clone(),
        modes: modes.clone(),
        prepared: prepared(mechanism, modes, &revolutions),
        revolutions,
    }
}

/// Nothing prepared, in every lane.
pub(super) fn no_states<C: Grouped>(mechanism: &C) -> Vec<C::Lane> {
    let count = mechanism.group_data().coupled.len();
    let nothing = C::Lane::list(count, |_| InitialState::Nothing);
    vec![nothing; C::Scalar::LANES]
}
