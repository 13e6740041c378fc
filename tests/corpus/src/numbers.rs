//! What programs are run on: the reference, positions near it, positions out of reach, and numbers that are none.

use std::collections::BTreeMap;

use linkage_compiler::ir::{CompiledMechanism, Coupled};
use linkage_random::Random;
use linkage_runtime::Scalar;
use linkage_symbolic::program::{Program, Source};

use crate::reference::run;

/// Zeros, infinities, NaN, subnormal numbers, and numbers whose squares are none.
pub const SPECIAL: &[f64] = &[
    0.0,
    -0.0,
    1.0,
    -1.0,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::from_bits(1),
    -f64::from_bits(0x000f_0000_0000_0001),
    f64::MIN_POSITIVE,
    1e-200,
    -1e200,
    f64::MAX,
];

/// Rounds of one mechanism.
pub const ROUNDS: usize = 16;

/// Starts of Newton's method for a coupled group, and steps from each.
const STARTS: usize = 20;
const STEPS: usize = 30;

/// Numbers for all that programs load.
pub struct Numbers(BTreeMap<Source, f64>);

impl Numbers {
    /// The numbers of a round: the reference first, then half of the rounds near it, then others.
    pub fn new(
        unit: &CompiledMechanism,
        layout: &[Source],
        round: usize,
        random: &mut Random,
    ) -> Self {
        let mut own = Self(BTreeMap::new());
        for &source in layout {
            own.0.insert(source, reference(unit, source));
        }
        if round > 0 {
            let far = round > ROUNDS / 2 && round.is_multiple_of(2);
            own.0
                .iter_mut()
                .for_each(|(source, x)| *x = moved(unit, *source, *x, far, random));
        }
        let special = round > ROUNDS / 2 && !round.is_multiple_of(2);
        if special {
            own.spoil(layout, random);
        }
        own.prepare(unit, random);
        if special && round.is_multiple_of(3) {
            // Now among the prepared numbers, too.
            own.spoil(layout, random);
        }
        own
    }

    /// What `assemble()` prepares.
    fn prepare(&mut self, unit: &CompiledMechanism, random: &mut Random) {
        for (slot, x) in self.run(&unit.prepare).into_iter().enumerate() {
            self.0.insert(Source::Prepared(slot), x);
        }
        for (number, group) in unit.coupled.iter().enumerate() {
            let state = (0..STARTS).find_map(|_| self.state(number, group, random));
            let state = state.unwrap_or_default();
            for (component, x) in state.into_iter().enumerate() {
                self.0.insert(Source::State(number, component), x);
            }
        }
    }

    /// A state near a solution and half the determinant there: where Newton's steps come to rest, if they do.
    fn state(&mut self, number: usize, group: &Coupled, random: &mut Random) -> Option<Vec<f64>> {
        let mut state: Vec<f64> = (0..group.size).map(|_| random.between(-1.0, 1.0)).collect();
        for _ in 0..STEPS {
            for (component, &x) in state.iter().enumerate() {
                self.0.insert(Source::State(number, component), x);
            }
            let step = self.run(&group.correct);
            let (next, rest) = step.split_at(group.size);
            state = next.to_vec();
            if rest[0] < 1e-18 {
                state.push(rest[1] / 2.0);
                return Some(state);
            }
        }
        None
    }

    fn spoil(&mut self, layout: &[Source], random: &mut Random) {
        for _ in 0..=random.below(2) {
            self.0.insert(*random.pick(layout), *random.pick(SPECIAL));
        }
    }

    fn run(&self, program: &Program) -> Vec<f64> {
        run(program, |source| self.load(source))
    }

    /// One of them.
    pub fn load(&self, source: Source) -> f64 {
        match source {
            Source::Limit => <f64 as Scalar>::CORRECTION_LIMIT,
            other => self.0[&other],
        }
    }
}

fn reference(unit: &CompiledMechanism, source: Source) -> f64 {
    match source {
        Source::Parameter(index) => unit.scalars().nth(index).map_or(f64::NAN, |p| p.nominal),
        // What follows the inputs are speeds, accelerations, loads.
        Source::Input(index) => unit.inputs.get(index).map_or(1.5, |input| input.reference),
        Source::Mode(index) => match unit.modes()[index] {
            true => 1.0,
            false => -1.0,
        },
        Source::Centre(angle) => unit.angles[angle].estimate,
        Source::Winding(..) => 0.0,
        // Comes later, or is no part of the struct.
        Source::State(..) | Source::Prepared(_) | Source::Carried(_) | Source::Limit => f64::NAN,
    }
}

fn moved(unit: &CompiledMechanism, source: Source, x: f64, far: bool, random: &mut Random) -> f64 {
    let part = if far { 2.0 } else { 0.05 };
    match source {
        Source::Parameter(_) => x * (1.0 + random.between(-part, part)),
        Source::Input(index) => match unit.inputs.get(index) {
            Some(input) if input.angle => x + random.between(-20.0, 20.0) * part,
            Some(_) => x + random.between(-2.0, 2.0) * part * unit.longest,
            None => random.load(10.0),
        },
        Source::Mode(_) if random.chance(0.2) => -x,
        Source::Winding(..) => *random.pick(&[-1.0, 0.0, 0.0, 0.5, 1.0]),
        Source::Centre(_) => x + random.between(-1.0, 1.0),
        Source::Mode(_)
        | Source::State(..)
        | Source::Prepared(_)
        | Source::Carried(_)
        | Source::Limit => x,
    }
}
