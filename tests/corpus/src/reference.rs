//! The programs of a mechanism on the runtime's numbers, as generated Rust runs them where multiply-adds are not fused.

use linkage_compiler::ir::{
    CompiledMechanism, ContinuousAngle, Function, Generated, PreparedTable,
};
use linkage_runtime::Scalar;
use linkage_runtime::numeric::winding::{Centre, follow, uniform};
use linkage_symbolic::interpret::run_by;
use linkage_symbolic::program::{Program, Source};

/// Runs a program.
pub fn run<T: Scalar>(program: &Program, load: impl Fn(Source) -> T) -> Vec<T> {
    run_by::<Generated<T, false>>(program, load)
}

/// An assembled mechanism.
pub struct Assembled<'a, T> {
    unit: &'a CompiledMechanism,
    dimensions: Vec<T>,
    centres: Vec<f64>,
    windings: Vec<Vec<f64>>,
    prepared: Vec<T>,
    steps: usize,
}

impl<'a, T: Scalar> Assembled<'a, T> {
    /// Assembles a mechanism; `None` where that does not go.
    pub fn new(unit: &'a CompiledMechanism, dimensions: &[T]) -> Option<Self> {
        let at: Vec<f64> = unit.inputs.iter().map(|own| own.reference).collect();
        // Turns are counted in double precision.
        let plain: Vec<f64> = dimensions.iter().map(|x| x.lane(0)).collect();
        let (centres, windings) = Assembled::<f64>::unturned(unit, plain).turns(&at)?;
        let mut own = Assembled::unturned(unit, dimensions.to_vec());
        (own.centres, own.windings) = (centres, windings);
        own.prepare();
        let at: Vec<T> = at.into_iter().map(T::from_f64).collect();
        let gaps = run(&unit.gaps, |source| own.load(source, &at));
        gaps.iter().all(|gap| gap.lane(0) <= 0.0).then_some(own)
    }

    fn unturned(unit: &'a CompiledMechanism, dimensions: Vec<T>) -> Self {
        let mut own = Self {
            unit,
            dimensions,
            centres: unit.angles.iter().map(|own| own.estimate).collect(),
            windings: vec![vec![0.0; unit.inputs.len()]; unit.angles.len()],
            prepared: Vec::new(),
            steps: 0,
        };
        own.prepare();
        own
    }

    fn prepare(&mut self) {
        self.prepared = run(&self.unit.prepare, |source| self.load(source, &[]));
    }

    /// The same, with so many more steps of Newton's method from the tables of coupled groups: generated Rust makes one, which leaves the square of what
    /// the table is wrong by.
    #[must_use]
    pub fn stepped(mut self, steps: usize) -> Self {
        self.steps = steps;
        self
    }

    /// The results of a function at its arguments.
    pub fn call(&self, function: &Function, arguments: &[T]) -> Vec<T> {
        let mut all =
            vec![T::from_f64(f64::NAN); self.unit.inputs.len() + self.unit.arguments.len()];
        for (&place, &x) in function.arguments.iter().zip(arguments) {
            all[place] = x;
        }
        run(&function.called.program, |source| self.load(source, &all))
    }

    /// The state of a coupled group, and the floor.
    fn state(&self, group: usize, inputs: &[T]) -> Vec<f64> {
        let coupled = &self.unit.coupled[group];
        let own = coupled.inputs.iter().map(|&input| inputs[input].lane(0));
        let own: Vec<f64> = own.collect();
        let mut state = vec![0.0; coupled.size];
        let floor = match &coupled.start {
            Some(PreparedTable::Table(table)) => table.state(own[0], &mut state),
            Some(PreparedTable::Grid(grid)) => grid.state(&own, &mut state),
            None => unreachable!("it is closed"),
        };
        for _ in 0..self.steps {
            let next = run(&coupled.correct, |source| match source {
                Source::State(own, component) if own == group => T::from_f64(state[component]),
                other => self.load(other, inputs),
            });
            let next = next.iter().take(coupled.size).map(|x| x.lane(0));
            state = next.collect();
        }
        state.push(floor);
        state
    }

    fn load(&self, source: Source, inputs: &[T]) -> T {
        match source {
            Source::Parameter(index) => self.dimensions[index],
            Source::Input(index) => inputs[index],
            Source::Mode(index) => T::from_f64(if self.unit.modes()[index] { 1.0 } else { -1.0 }),
            Source::Centre(angle) => T::from_f64(self.centres[angle]),
            Source::Winding(angle, input) => T::from_f64(self.windings[angle][input]),
            Source::Prepared(slot) => self.prepared[slot],
            Source::State(group, component) => T::from_f64(self.state(group, inputs)[component]),
            Source::Limit => T::from_f64(T::CORRECTION_LIMIT),
            Source::Carried(_) => unreachable!("programs are whole"),
        }
    }
}

/// Inputs that the closed form of turns is tried for here, at most.
const INPUTS: usize = 4;

impl Assembled<'_, f64> {
    /// Centres and windings of all angles.
    fn turns(mut self, at: &[f64]) -> Option<(Vec<f64>, Vec<Vec<f64>>)> {
        let vectors = run(&self.unit.bearings, |source| self.load(source, &[]));
        let (vectors, _) = vectors.as_chunks::<2>();
        let mut vectors = vectors;
        for (index, angle) in self.unit.angles.iter().enumerate() {
            let (own, rest) = vectors.split_at(angle.phases.len());
            vectors = rest;
            self.prepare();
            let [cosine, sine] = self.direction(index, at);
            let here = f64::angle_near_with::<false>(sine, cosine, angle.estimate);
            if !here.is_finite() {
                return None;
            }
            let (centre, windings) = closed_form(own, angle, at, here)
                .or_else(|| self.followed(index, angle, at, here))?;
            self.centres[index] = centre;
            self.windings[index] = windings[..at.len()].to_vec();
        }
        Some((self.centres, self.windings))
    }

    fn direction(&self, angle: usize, at: &[f64]) -> [f64; 2] {
        let all = run(&self.unit.directions, |source| self.load(source, at));
        [all[2 * angle], all[2 * angle + 1]]
    }

    fn followed(
        &self,
        index: usize,
        angle: &ContinuousAngle,
        at: &[f64],
        here: f64,
    ) -> Option<(f64, Vec<f64>)> {
        let mut windings = vec![0.0; at.len()];
        let mut centre = Centre::new(here);
        for &input in &angle.inputs {
            let (low, high) = self.unit.inputs[input].followed;
            let x = at[input];
            let (low, high) = (low.min(x), high.max(x));
            if low == high {
                continue;
            }
            let rates = &self.unit.inputs[input].rates;
            let along = follow(low, high, x, here, rates, |x| {
                let mut there = at.to_vec();
                there[input] = x;
                self.direction(index, &there)
            })?;
            windings[input] = along.turns;
            centre.add(along, x);
        }
        Some((centre.value(), windings))
    }
}

fn closed_form(
    vectors: &[[f64; 2]],
    angle: &ContinuousAngle,
    at: &[f64],
    here: f64,
) -> Option<(f64, Vec<f64>)> {
    let padded = |own: &[f64]| std::array::from_fn(|k| own.get(k).copied().unwrap_or(0.0));
    let turns = angle
        .phases
        .iter()
        .map(|own| own.turns.as_deref().map(padded));
    let turns: Vec<Option<[f64; INPUTS]>> = turns.collect();
    let (centre, windings) = uniform(vectors, &turns, &padded(at), here)?;
    Some((centre, windings.to_vec()))
}
