//! Group after group: where it can be assembled given the groups before it, and in which ways.

use super::branch::Undetermined;
use super::coupled::{self, Followed};
use super::leaf::{End, GroupAssembly, Leaf};
use super::levels::{Chosen, Levels, Searched};
use super::stretches::{Border, Slack, stretches};
use super::trace::CurveEnd;
use super::undetermined::{self, is_folded};
use crate::data::AssemblyMode;
use crate::error::AssemblyError;
use crate::support::{CoupledGroup, CoupledPrograms, InitialState, prepared};
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::{Cycle, Level};

/// Places at which the slack of a group is sampled for every place at which coupled groups are
/// listed, and the least number of them. Without bounds the slack is known there alone.
const SAMPLES: f64 = 0.85;
const LEAST_SAMPLES: usize = 48;

/// Parameters at which a coupled group is listed in every slab, however short it is. They lead to
/// assemblies that turn back shortly before an end.
const ALWAYS: [f64; 5] = [-1.0, 1.0, -0.6, 0.05, 0.7];

/// More modes than this are not searched.
const MOST_MODES: usize = 16;

/// The search through all groups.
pub(super) struct LevelSearch<'a, M> {
    pub(super) mechanism: &'a M,
    searched: Searched,
    pub(super) cycle: Cycle,
    pub(super) leaves: Vec<Leaf>,
    pub(super) undetermined: Vec<Undetermined>,
    pub(super) error: Option<AssemblyError>,
    turning: usize,
}

impl<'a, M: Levels> LevelSearch<'a, M> {
    pub(super) fn run(mechanism: &'a M, cycle: Cycle) -> Result<Self, AssemblyError> {
        let searched = mechanism.searched();
        let modes = searched.modes;
        if modes > MOST_MODES {
            return Err(AssemblyError::TooManyAssemblies {
                mechanism: searched.name,
                modes,
            });
        }
        let mut search = Self {
            mechanism,
            searched,
            cycle,
            leaves: Vec::new(),
            undetermined: Vec::new(),
            error: None,
            turning: 0,
        };
        let root = Leaf {
            chosen: Chosen {
                modes: vec![AssemblyMode::Plus; modes],
                starts: vec![InitialState::Nothing; searched.coupled],
            },
            ways: Vec::new(),
            inputs: [cycle.low, cycle.high],
            ends: [End::Range; 2],
            known: None,
        };
        search.level(0, root);
        Ok(search)
    }

    /// All assemblies of the groups from `group` on, given those before it.
    fn level(&mut self, group: usize, before: Leaf) {
        let Some(level) = self.searched.levels.get(group) else {
            self.leaves.push(before);
            return;
        };
        match *level {
            Level::Single => self.closed_form(group, &before, None),
            Level::Modes(mode) => self.closed_form(group, &before, Some(mode)),
            Level::Coupled(number) => self.coupled(group, number, &before),
        }
    }

    fn closed_form(&mut self, group: usize, before: &Leaf, mode: Option<usize>) {
        let slab = before.slab();
        let share = (slab.high - slab.low) / (self.cycle.high - self.cycle.low);
        let samples = SAMPLES * self.cycle.samples as f64 * share;
        let samples = (samples as usize).max(LEAST_SAMPLES);
        let middle = before.known.unwrap_or_else(|| slab.x(0.0));
        let surveyor = self.mechanism.surveyor(&before.chosen, middle);
        let mechanism = self.mechanism;
        let at = |x: f64| mechanism.slack(&surveyor, group, x);
        let over = if before.is_coupled() {
            None
        } else {
            mechanism.bounds(&surveyor, group)
        };
        let slack = Slack {
            at: &at,
            over: over.as_deref(),
            single: mode.is_none(),
            served: before.known.is_none(),
            smooth: before.ends == [End::Range; 2],
        };
        let kind = self.searched.slacks.get(group);
        if mode.is_some() && is_folded(kind, &slab, samples, &at) {
            let found = undetermined::described(mechanism, &surveyor, group, before);
            self.undetermined.push(found);
            return;
        }
        for borders in stretches(&slab, samples, &slack) {
            let mut next = before.clone();
            for (side, border) in borders.into_iter().enumerate() {
                match border {
                    Border::Slab => {}
                    Border::Root(x) => {
                        next.ends[side] = End::Turning {
                            number: self.turning,
                            group,
                        };
                        next.inputs[side] = x;
                        self.turning += 1;
                    }
                    Border::Broken(x) => {
                        next.ends[side] = End::Lost;
                        next.inputs[side] = x;
                    }
                }
            }
            let Some(mode) = mode else {
                self.level(group + 1, next);
                continue;
            };
            for way in [AssemblyMode::Plus, AssemblyMode::Minus] {
                let mut next = next.clone();
                next.chosen.modes[mode] = way;
                next.ways.push((group, GroupAssembly::Mode(way)));
                self.level(group + 1, next);
            }
        }
    }

    fn coupled(&mut self, group: usize, number: usize, before: &Leaf) {
        let slab = before.slab();
        let middle = before.known.unwrap_or_else(|| slab.x(0.0));
        let programs = match self.mechanism.coupled(&before.chosen, number, middle) {
            Some(Ok(programs)) => programs,
            Some(Err(error)) => {
                self.error.get_or_insert(error);
                return;
            }
            None => return,
        };
        let (description, mut programs) = programs;
        let made = match description.inputs {
            [] => self.constant(group, number, before, description, &mut programs),
            _ => self.strands(group, number, before, description, &mut programs),
        };
        match made {
            Ok(leaves) => leaves
                .into_iter()
                .for_each(|next| self.level(group + 1, next)),
            Err(error) => {
                self.error.get_or_insert(error);
            }
        }
    }

    /// The assemblies of a group that does not depend on the input.
    fn constant(
        &mut self,
        group: usize,
        number: usize,
        before: &Leaf,
        description: &CoupledGroup,
        programs: &mut M::Programs,
    ) -> Result<Vec<Leaf>, AssemblyError> {
        let solutions = match crate::support::list_solutions(description, programs, &[]) {
            Err(error) if error.is_a_miss() => Vec::new(),
            listed => listed?,
        };
        let leaf = |state: Vec<f64>| {
            let mut next = before.clone();
            next.chosen.starts[number] = prepared(description, programs, &[], &state, &[])?;
            next.ways
                .push((group, GroupAssembly::States([state.clone(), state])));
            Ok(next)
        };
        solutions
            .into_iter()
            .map(|solution| solution.state)
            .map(leaf)
            .collect()
    }

    /// The assemblies of a coupled group over the input.
    fn strands(
        &mut self,
        group: usize,
        number: usize,
        before: &Leaf,
        description: &CoupledGroup,
        programs: &mut dyn CoupledPrograms,
    ) -> Result<Vec<Leaf>, AssemblyError> {
        let slab = before.slab();
        let inner = (0..self.cycle.samples).map(|index| sample(&self.cycle, index));
        let inner = inner.filter(|&x| slab.covers(x)).map(|x| slab.parameter(x));
        let samples: Vec<f64> = inner.chain(ALWAYS).collect();
        let Followed { strands, turning } = coupled::follow(description, programs, slab, &samples)?;
        let mut leaves = Vec::new();
        for strand in strands {
            let mut next = before.clone();
            let inputs = strand.inputs(&slab);
            for (side, x) in inputs.into_iter().enumerate() {
                match strand.ends[side] {
                    CurveEnd::Slab => continue,
                    CurveEnd::Turning(turning_point) => {
                        let number = self.turning + turning_point;
                        next.ends[side] = End::Turning { number, group };
                    }
                    CurveEnd::Lost => next.ends[side] = End::Lost,
                }
                next.inputs[side] = x;
            }
            let best = strand.best();
            let x = slab.x(best.u);
            let range = next.range(description.inputs[0].range);
            match prepared(description, programs, &[x], &best.state, &[range]) {
                Ok(start) => next.chosen.starts[number] = start,
                Err(error) => {
                    self.error.get_or_insert(error);
                    continue;
                }
            }
            next.known = Some(x);
            next.ways.push((
                group,
                GroupAssembly::States([0, 1].map(|end| strand.state(end).to_vec())),
            ));
            leaves.push(next);
        }
        self.turning += turning;
        Ok(leaves)
    }
}

/// The input of a sample.
pub(super) fn sample(cycle: &Cycle, index: usize) -> f64 {
    let last = cycle.samples.max(2) - 1;
    if index == last {
        return cycle.high;
    }
    cycle.low + (cycle.high - cycle.low) * (index as f64 / last as f64)
}
