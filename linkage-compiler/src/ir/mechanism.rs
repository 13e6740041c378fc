//! The compiled mechanism: its signature, its groups and all its programs.

use std::collections::BTreeSet;

use linkage_core::Level;
use linkage_core::range_check::{self, Driven};
use linkage_symbolic::program::{Instruction, Program, Source};

use crate::model::COMPONENTS;

use super::function::{Body, Function};
use super::group::{Coupled, Group, Placed, ShownNumber, Surveyed};
use super::picture::Picture;
use super::signature::{Argument, ContinuousAngle, Input, Parameter, Scalar, Unknown};

/// A mechanism after lowering.
#[derive(Clone, Debug, Default)]
pub struct CompiledMechanism {
    /// Its doc comment, line by line as written.
    pub documentation: String,
    /// The unit of all lengths: `mm`, `m`, ...
    pub length: &'static str,
    /// The parameters, in order.
    pub parameters: Vec<Parameter>,
    /// The driving coordinates, in order.
    pub inputs: Vec<Input>,
    /// The arguments that functions may take after the inputs: speeds, accelerations, loads.
    pub arguments: Vec<Argument>,
    /// The unknowns of the model, in order.
    pub unknowns: Vec<Unknown>,
    /// The unknown angles whose values some program uses; centres and windings count these.
    pub angles: Vec<ContinuousAngle>,
    /// In the order in which they are solved.
    pub groups: Vec<Group>,
    /// Inputs + unknowns - equations.
    pub mobility: usize,
    /// The length that counts like a radian in comparisons of assemblies with estimates, in the
    /// mechanism's unit.
    pub longest: f64,
    /// Computes all prepared slots in `assemble()`: loads parameters, modes, centres and windings;
    /// output `k` is slot `k`.
    pub prepare: Program,
    /// For each group in order, the amount by which it misses closing at given inputs: a length (or
    /// a number for an angle relation), positive if the group cannot be assembled, at most 0 if it
    /// can. Loads prepared slots and inputs (all inputs of the mechanism).
    pub gaps: Program,
    /// For each continuous angle `a`: outputs `2 a` and `2 a + 1` are its cosine and sine. Loads
    /// prepared slots and inputs. The centre and winding of angle `a` are not needed for its own
    /// outputs, only for later ones.
    pub directions: Program,
    /// For each phase of each continuous angle: two outputs, the vector where all inputs are 0.
    /// Loads parameters and modes.
    pub bearings: Program,
    /// The smallest margin of all groups, then the slack of each (1 for a coupled one), then the
    /// numbers that distinguish assemblies: cosine and sine, or length, of every unknown that a
    /// group finds. Loads prepared slots and inputs.
    pub survey: Program,
    /// The unknowns in the order of their numbers in the survey.
    pub surveyed: Vec<Surveyed>,
    /// The number of continuous angles, the first ones, that must be followed before the survey can
    /// be run.
    pub surveying: usize,
    /// The data that `assemble()` prepares of the coupled groups, in order.
    pub coupled: Vec<Coupled>,
    /// One for each function of the `impl` block, in order.
    pub functions: Vec<Function>,
    /// The picture of the function that requests one.
    pub picture: Option<Picture>,
}

/// A name as it is read: `loop` for `r#loop`.
pub fn plain(name: &str) -> &str {
    name.strip_prefix("r#").unwrap_or(name)
}

impl CompiledMechanism {
    /// The scalars of all parameters, as programs count them.
    pub fn scalars(&self) -> impl Iterator<Item = &Scalar> {
        self.parameters
            .iter()
            .flat_map(|parameter| &parameter.scalars)
    }

    /// Returns the program that prepares the slots that another program loads, and these slots: for
    /// sweeps over mechanisms.
    pub fn preparing(&self, body: &Program) -> (Program, Vec<usize>) {
        let slots: BTreeSet<usize> = body.prepared_slots().collect();
        let slots: Vec<usize> = slots.into_iter().collect();
        (self.prepare.part(slots.iter().copied()), slots)
    }

    /// Returns the way in which a number of a coupled group is shown and measured.
    pub fn shown(&self, placed: &Placed) -> ShownNumber<'_> {
        let unknown = &self.unknowns[placed.unknown];
        ShownNumber {
            name: match placed.component {
                None => unknown.name.clone(),
                Some(k) => format!("{}.{}", unknown.name, COMPONENTS[k]),
            },
            unit: match placed.angle {
                true => "",
                false => &unknown.unit,
            },
            scale: if unknown.is_number { 1.0 } else { self.longest },
        }
    }

    /// The assembly modes that the start estimates choose, in order; true for `+1`.
    pub fn modes(&self) -> Vec<bool> {
        let groups = self.groups.iter();
        let mut modes: Vec<(usize, bool)> = groups
            .filter_map(|group| Some((group.mode?, group.plus)))
            .collect();
        modes.sort_unstable();
        modes.into_iter().map(|(_, plus)| plus).collect()
    }

    /// Returns the assemblies that each group has.
    pub fn levels(&self) -> Vec<Level> {
        let mut next = 0..;
        let level = |group: &Group| match (group.mode, group.coupled) {
            (Some(mode), _) => Level::Modes(mode),
            (None, true) => Level::Coupled(next.next().unwrap_or_default()),
            (None, false) => Level::Single,
        };
        self.groups.iter().map(level).collect()
    }

    /// Returns true if whole turns of an angle are alike: nothing is prepared over a range, and no
    /// group depends on the value of an angle.
    pub fn repeats(&self) -> bool {
        self.coupled.is_empty() && self.surveying == 0
    }

    /// Returns the slack of each group, without the rest of the survey. For a coupled group it is
    /// the first number of its state, which is none if nothing is prepared.
    pub fn slacks(&self) -> Program {
        let mut slacks = self.survey.clone();
        let outputs = self.survey.outputs.iter().skip(1).copied();
        slacks.outputs = outputs.take(self.groups.len()).collect();
        for (number, coupled) in self.coupled.iter().enumerate() {
            let state = slacks.push(Instruction::Load(Source::State(number, 0)));
            // A unit of single programs has no survey.
            if let Some(output) = slacks.outputs.get_mut(coupled.group) {
                *output = state;
            }
        }
        slacks.without_unused()
    }

    /// Returns the input whose range is checked at run time, and the range: the only one that is
    /// declared, or a turn about the reference of the only input if that is an angle and nothing is
    /// prepared over ranges. `None` if nothing is checked.
    pub fn checked(&self) -> Option<(usize, (f64, f64))> {
        if self.groups.is_empty() {
            return None;
        }
        let inputs = self.inputs.iter().map(|input| Driven {
            angle: input.angle,
            reference: input.reference,
            range: input.range,
        });
        range_check::checked(inputs, !self.coupled.is_empty()).ok()
    }

    /// Returns the number of slots that `assemble()` prepares.
    pub fn slots(&self) -> usize {
        self.prepare.outputs.len()
    }

    /// Returns the programs that the calls of all functions run, to be changed.
    pub(crate) fn bodies_mut(&mut self) -> impl Iterator<Item = &mut Body> {
        self.functions.iter_mut().flat_map(Function::bodies_mut)
    }

    /// Every program, to be changed.
    pub(crate) fn programs_mut(&mut self) -> impl Iterator<Item = &mut Program> {
        let functions = self.functions.iter_mut().flat_map(Function::bodies_mut);
        let functions = functions.map(|body| &mut body.program);
        let groups = self.coupled.iter_mut().flat_map(Coupled::programs_mut);
        let whole = [
            &mut self.prepare,
            &mut self.gaps,
            &mut self.directions,
            &mut self.bearings,
            &mut self.survey,
        ];
        functions.chain(groups).chain(whole)
    }
}
