//! Values, derivatives and inherent uncertainties of the outputs at one position, in high
//! precision.

use crate::solve::{Solution, solve};
use crate::{Big, Kind, Output, Plane, Position, System};
use std::collections::BTreeMap;

/// Differences use steps of this power of two, relative to the datum (1 for an angle): 7.9e-31.
pub(crate) const STEP: i32 = -100;
/// A difference below this, relative to the size of the output, is rounding of the reference and
/// counts as zero.
const NOISE: i32 = -470;

/// One solved position and everything about it that is asked for, each computed once.
pub struct Reference<'s> {
    pub(crate) system: &'s System,
    pub(crate) data: Vec<Big>,
    pub(crate) steps: Vec<Big>,
    pub(crate) weights: Vec<Big>,
    pub(crate) solution: Solution,
    pub(crate) outputs: Vec<Output>,
    sizes: Vec<Big>,
    base: Vec<Big>,
    tangents: Vec<Option<Vec<Big>>>,
    pub(crate) reaches: Vec<Big>,
    increments: BTreeMap<Vec<i8>, Vec<Big>>,
    derivatives: BTreeMap<Vec<usize>, Vec<Big>>,
}

impl<'s> Reference<'s> {
    /// Solves at the given data (all of them, taken as exact) from a guess for the unknowns; `None`
    /// without convergence.
    pub fn new(system: &'s System, data: &[f64], guess: &[f64]) -> Option<Self> {
        let size = system.size(data);
        let entries = || system.data.iter().zip(data);
        let step = |kind, x: f64| match kind {
            Kind::Length => x.abs().max(size * 2f64.powi(-30)),
            _ => x.abs().max(1.0),
        };
        let steps = entries().map(|(d, &x)| Big::from(step(d.kind, x)) * Big::power_of_two(STEP));
        let weight = |kind, x: f64| {
            if kind == Kind::Angle {
                x.abs() + 1.0
            } else {
                x.abs()
            }
        };
        let weights = entries().map(|(d, &x)| Big::from(weight(d.kind, x)));
        let (steps, weights) = (steps.collect(), weights.collect());
        let data: Vec<Big> = data.iter().map(|&x| Big::from(x)).collect();
        let solution = solve(system, &data, guess)?;
        let position = Position {
            system,
            data: &data,
            unknowns: &solution.unknowns,
        };
        let outputs = position.outputs();
        let magnitude = |output: &Output| match output {
            Output::Value(value) => value.abs() + size,
            Output::Number(_) | Output::Angle(_) => Big::one(),
        };
        let sizes = outputs.iter().map(magnitude).collect();
        let (base, tangents) = (solution.state(system), vec![None; data.len()]);
        Some(Self {
            system,
            data,
            steps,
            weights,
            solution,
            outputs,
            sizes,
            base,
            tangents,
            reaches: Vec::new(),
            increments: BTreeMap::new(),
            derivatives: BTreeMap::new(),
        })
    }

    /// The data, as given.
    pub(crate) fn given(&self) -> Vec<f64> {
        self.data.iter().map(Big::to_f64).collect()
    }

    /// Determinant of the equations, each column divided by its length. Its sign tells the assembly
    /// mode.
    pub fn determinant(&self) -> f64 {
        self.solution.determinant.to_f64()
    }

    /// How many outputs there are.
    pub fn outputs(&self) -> usize {
        self.outputs.len()
    }

    /// Whether an output is an angle.
    pub fn is_angle(&self, output: usize) -> bool {
        matches!(self.outputs[output], Output::Angle(_))
    }

    /// Whether an output is a length or a coordinate.
    pub fn is_length(&self, output: usize) -> bool {
        matches!(self.outputs[output], Output::Value(_))
    }

    /// The output as `f64`; an angle between -180 and 180 degrees.
    pub fn value(&self, output: usize) -> f64 {
        match &self.outputs[output] {
            Output::Value(value) | Output::Number(value) => value.to_f64(),
            Output::Angle(direction) => direction.y.to_f64().atan2(direction.x.to_f64()),
        }
    }

    /// How far a computed value lies from the output; full turns do not count for an angle.
    pub fn error(&self, output: usize, computed: f64) -> Big {
        match &self.outputs[output] {
            Output::Value(value) | Output::Number(value) => (value - &Big::from(computed)).abs(),
            Output::Angle(direction) => {
                let turned = direction.turned_back(&Plane::direction(&Big::from(computed)));
                if turned.x.is_negative() {
                    Big::one()
                } else {
                    small_angle(&turned).abs()
                }
            }
        }
    }

    /// The partial derivative of every output by the data with the given indices (up to four of
    /// them).
    pub fn derivative(&mut self, by: &[usize]) -> Vec<Big> {
        let mut by = by.to_vec();
        by.sort_unstable();
        if let Some(known) = self.derivatives.get(&by) {
            return known.clone();
        }
        let mut sum = vec![Big::zero(); self.outputs.len()];
        for signs in 0..1usize << by.len() {
            let mut offset = vec![0i8; self.data.len()];
            let mut minus = false;
            for (bit, &index) in by.iter().enumerate() {
                let down = signs >> bit & 1 == 1;
                offset[index] += if down { -1 } else { 1 };
                minus ^= down;
            }
            for (sum, change) in sum.iter_mut().zip(self.increment(offset)) {
                *sum = if minus {
                    &*sum - change
                } else {
                    &*sum + change
                };
            }
        }
        let divisor = by
            .iter()
            .fold(Big::one(), |p, &index| p * &self.steps[index] * 2.0);
        let clean = |(s, size): (Big, &Big)| {
            let noise = size * Big::power_of_two(NOISE);
            if s.abs() < noise {
                Big::zero()
            } else {
                s / &divisor
            }
        };
        let result: Vec<Big> = sum.into_iter().zip(&self.sizes).map(clean).collect();
        self.derivatives.insert(by, result.clone());
        result
    }

    /// By how much the outputs change when every datum moves by so many steps.
    fn increment(&mut self, offset: Vec<i8>) -> &[Big] {
        if !self.increments.contains_key(&offset) {
            let change = self.solve_at(&offset);
            self.increments.insert(offset.clone(), change);
        }
        &self.increments[&offset]
    }

    fn solve_at(&mut self, offset: &[i8]) -> Vec<Big> {
        let state = self.start_at(offset);
        let data = self.moved_data(offset);
        let state = self.solution.moved(self.system, &data, state);
        let unknowns = self.solution.unknowns_in(self.system, &state);
        self.changes(&data, &unknowns)
    }

    /// By how much the outputs differ from those of this position.
    pub(crate) fn changes(&self, data: &[Big], unknowns: &[Plane]) -> Vec<Big> {
        let position = Position {
            system: self.system,
            data,
            unknowns,
        };
        let outputs = position.outputs();
        let change = |(after, before): (&Output, &Output)| match (after, before) {
            (Output::Value(after), Output::Value(before))
            | (Output::Number(after), Output::Number(before)) => after - before,
            (Output::Angle(after), Output::Angle(before)) => {
                small_angle(&after.turned_back(before))
            }
            _ => unreachable!("the kind of an output is fixed"),
        };
        outputs.iter().zip(&self.outputs).map(change).collect()
    }

    fn moved_data(&self, offset: &[i8]) -> Vec<Big> {
        let moved = |i: usize| &self.data[i] + &self.steps[i] * f64::from(offset[i]);
        (0..self.data.len()).map(moved).collect()
    }

    /// The unknowns at an offset to first order, as a start for the iteration.
    fn start_at(&mut self, offset: &[i8]) -> Vec<Big> {
        let mut state = self.base.clone();
        for (index, &steps) in offset.iter().enumerate().filter(|(_, steps)| **steps != 0) {
            for (x, tangent) in state.iter_mut().zip(self.tangent(index)) {
                *x = &*x + tangent * f64::from(steps);
            }
        }
        state
    }

    /// By how much the unknowns change when one datum moves by one step.
    fn tangent(&mut self, index: usize) -> &[Big] {
        if self.tangents[index].is_none() {
            let mut offset = vec![0; self.data.len()];
            offset[index] = 1;
            let data = self.moved_data(&offset);
            let state = self.solution.moved(self.system, &data, self.base.clone());
            let tangent = state
                .iter()
                .zip(&self.base)
                .map(|(after, before)| after - before);
            self.tangents[index] = Some(tangent.collect());
        }
        self.tangents[index]
            .as_deref()
            .expect("it was computed just now")
    }
}

/// The angle of a vector near the first axis, by the series of the arc tangent.
fn small_angle(v: &Plane) -> Big {
    let t = &v.y / &v.x;
    let square = &t * &t;
    let rest = (&square * 3.0 - 5.0) / Big::from(15.0);
    &t + &t * &square * rest
}
