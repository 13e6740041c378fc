//! Centres and windings of continuous angles.

use linkage_runtime::AssemblyMode;
use linkage_runtime::support::{InitialState, pairs, wind_one};

use crate::mechanism::Mechanism;
use crate::numbers::{Numbers, States};
use crate::operations::{by_build, by_machine};
use crate::revolutions::Revolutions;

/// A mechanism in some modes, whose angles are to be followed.
#[derive(Clone, Copy)]
pub(crate) struct Winding<'a> {
    pub(crate) mechanism: &'a Mechanism,
    pub(crate) dimensions: &'a [f64],
    pub(crate) modes: &'a [AssemblyMode],
    pub(crate) starts: &'a [InitialState],
}

impl Winding<'_> {
    /// The revolutions of the first `count` angles, from the reference or, where it does not
    /// assemble there, from `at`; or the name of the first one that cannot be followed.
    pub(crate) fn wind(self, count: usize, at: &[f64]) -> Result<Revolutions, &'static str> {
        let reference = self.mechanism.reference();
        match self.wind_from(count, &reference) {
            Err(_) if at != reference => self.wind_from(count, at),
            result => result,
        }
    }

    fn wind_from(self, count: usize, start: &[f64]) -> Result<Revolutions, &'static str> {
        let unit = &self.mechanism.compiled;
        let mut revolutions = Revolutions::at_estimates(self.mechanism);
        let multiply_adds = self.mechanism.multiply_adds;
        let bearings = by_build(multiply_adds, &unit.bearings, |source| {
            self.numbers(&revolutions, &[], start, &[]).load(source)
        });
        let bearings = pairs(&bearings);
        let mut phases = &bearings[..];
        for (index, angle) in self.mechanism.angles.iter().enumerate().take(count) {
            let (angle_phases, rest) = phases.split_at(angle.phases.len());
            phases = rest;
            let prepared = self.prepare(&revolutions);
            let direction = |x: &Vec<f64>| {
                let states = States {
                    mechanism: self.mechanism,
                    starts: self.starts,
                    inputs: x,
                };
                let states = states.by_build();
                let numbers = self.numbers(&revolutions, &prepared, x, &states);
                let all = by_build(multiply_adds, &unit.directions, |source| {
                    numbers.load(source)
                });
                [all[2 * index], all[2 * index + 1]]
            };
            let found = wind_one(angle, angle_phases, &start.to_vec(), direction);
            let (centre, windings) = found.ok_or(angle.unknown)?;
            revolutions.centres[index] = centre;
            revolutions.windings[index] = windings;
        }
        Ok(revolutions)
    }

    /// All prepared slots.
    pub(crate) fn prepare(self, revolutions: &Revolutions) -> Vec<f64> {
        let numbers = self.numbers(revolutions, &[], &[], &[]);
        let Mechanism {
            compiled,
            multiply_adds,
            ..
        } = self.mechanism;
        by_machine(*multiply_adds, &compiled.prepare, |source| {
            numbers.load(source)
        })
    }

    fn numbers<'b>(
        &'b self,
        revolutions: &'b Revolutions,
        prepared: &'b [f64],
        inputs: &'b [f64],
        states: &'b [Vec<f64>],
    ) -> Numbers<'b> {
        Numbers {
            dimensions: self.dimensions,
            modes: self.modes,
            revolutions,
            prepared,
            inputs,
            states,
        }
    }
}
