//! A solver that shares nothing with the library: coordinates of joints as unknowns, links as
//! rigid triangles, Newton steps with differences.

use crate::facts::{Facts, Input, Path};

/// The positions of all joints.
pub(crate) type Positions = Vec<[f64; 2]>;

/// The step of central differences, as a part of the size.
const DIFFERENCE: f64 = 1e-5;

pub(crate) struct Solver<'t> {
    facts: &'t Facts,
    drawn: Positions,
    /// The joints that move.
    free: Vec<usize>,
}

impl<'t> Solver<'t> {
    /// Returns a solver for positions that may be rounded.
    pub(crate) fn new(facts: &'t Facts, drawn: Positions) -> Self {
        let joints = 0..drawn.len();
        let free = joints.filter(|joint| !facts.fixed.contains(joint));
        Self {
            facts,
            drawn,
            free: free.collect(),
        }
    }

    /// Returns the positions for values of inputs, near other positions.
    pub(crate) fn solve(&self, start: &Positions, inputs: &[f64]) -> Option<Positions> {
        let mut positions = start.clone();
        let step = DIFFERENCE * self.facts.size;
        for _ in 0..30 {
            let errors = self.errors(&positions, inputs);
            let largest = errors
                .iter()
                .fold(0.0f64, |most, error| most.max(error.abs()));
            let columns: Vec<Vec<f64>> = (0..2 * self.free.len())
                .map(|unknown| {
                    let shifted = |by: f64| {
                        let mut shifted = positions.clone();
                        shifted[self.free[unknown / 2]][unknown % 2] += by;
                        self.errors(&shifted, inputs)
                    };
                    let (above, below) = (shifted(step), shifted(-step));
                    let pairs = above.iter().zip(&below);
                    pairs.map(|(a, b)| (a - b) / (2.0 * step)).collect()
                })
                .collect();
            let change = least_squares(&columns, &errors)?;
            for (unknown, change) in change.iter().enumerate() {
                positions[self.free[unknown / 2]][unknown % 2] -= change;
            }
            let change = change
                .iter()
                .fold(0.0f64, |most, value| most.max(value.abs()));
            if largest < 1e-12 * self.facts.size && change < 1e-11 * self.facts.size {
                return Some(positions);
            }
        }
        None
    }

    /// All errors as lengths.
    fn errors(&self, now: &Positions, inputs: &[f64]) -> Vec<f64> {
        let mut errors = Vec::new();
        for joints in self.facts.links.values() {
            let [first, second, ref others @ ..] = joints[..] else {
                continue;
            };
            errors.push(distance(now, first, second) - distance(&self.drawn, first, second));
            for other in others {
                let there = self.carried([first, second], self.drawn[*other], now);
                errors.extend([0, 1].map(|axis| there[axis] - now[*other][axis]));
            }
        }
        for slot in &self.facts.slots {
            self.slot(slot, now, &mut errors);
        }
        for (input, value) in self.facts.inputs.iter().zip(inputs) {
            errors.push(match *input {
                Input::Crank { pivot, other } => {
                    let [x, y] = offset(now, pivot, other);
                    y * value.cos() - x * value.sin()
                }
                Input::Length(first, second) => distance(now, first, second) - value,
            });
        }
        errors
    }

    fn slot(&self, slot: &crate::facts::Slot, now: &Positions, errors: &mut Vec<f64>) {
        let base = self
            .facts
            .links
            .get(&slot.guide)
            .map(|joints| [joints[0], joints[1]]);
        let at = |point: [f64; 2]| base.map_or(point, |base| self.carried(base, point, now));
        let pin = now[slot.pin];
        errors.push(match slot.path {
            Path::Joints(first, second) => {
                let along = offset(now, first, second);
                let to_pin = offset(now, first, slot.pin);
                let length = along[0].hypot(along[1]);
                (along[0] * to_pin[1] - along[1] * to_pin[0]) / length
            }
            Path::Direction(direction) => {
                let drawn = self.drawn[slot.pin];
                let other = [drawn[0] + direction.cos(), drawn[1] + direction.sin()];
                let [from, to] = [at(drawn), at(other)];
                let along = [to[0] - from[0], to[1] - from[1]];
                along[0] * (pin[1] - from[1]) - along[1] * (pin[0] - from[0])
            }
            Path::Arc(centre) => {
                let drawn = self.drawn[slot.pin];
                let radius = (drawn[0] - centre[0]).hypot(drawn[1] - centre[1]);
                let centre = at(centre);
                (pin[0] - centre[0]).hypot(pin[1] - centre[1]) - radius
            }
        });
        if let Some(block) = &slot.block {
            // The drawn direction of the block, carried by the guide, is still its direction.
            let joints = &self.facts.links[block];
            let [from, to] = [joints[0], joints[1]].map(|joint| self.drawn[joint]);
            let [from, to] = [at(from), at(to)];
            let along = [to[0] - from[0], to[1] - from[1]];
            let length = along[0].hypot(along[1]);
            let block = offset(now, joints[0], joints[1]);
            errors.push((along[0] * block[1] - along[1] * block[0]) / length);
        }
    }

    /// A drawn point of a body that two joints of it carry.
    fn carried(&self, base: [usize; 2], point: [f64; 2], now: &Positions) -> [f64; 2] {
        let [ax, ay] = offset(&self.drawn, base[0], base[1]);
        let from = self.drawn[base[0]];
        let [px, py] = [point[0] - from[0], point[1] - from[1]];
        let square = ax * ax + ay * ay;
        let (along, across) = ((px * ax + py * ay) / square, (py * ax - px * ay) / square);
        let [bx, by] = offset(now, base[0], base[1]);
        let from = now[base[0]];
        [
            from[0] + along * bx - across * by,
            from[1] + along * by + across * bx,
        ]
    }
}

fn offset(positions: &Positions, from: usize, to: usize) -> [f64; 2] {
    [0, 1].map(|axis| positions[to][axis] - positions[from][axis])
}

fn distance(positions: &Positions, first: usize, second: usize) -> f64 {
    let [x, y] = offset(positions, first, second);
    x.hypot(y)
}

/// The least squares solution by reflections; `None` if columns depend on each other.
fn least_squares(columns: &[Vec<f64>], right: &[f64]) -> Option<Vec<f64>> {
    let mut columns: Vec<Vec<f64>> = columns.to_vec();
    let mut right = right.to_vec();
    let count = columns.len();
    if right.len() < count {
        return None;
    }
    let mut diagonal = vec![0.0; count];
    for index in 0..count {
        let norm = columns[index][index..]
            .iter()
            .map(|value| value * value)
            .sum::<f64>()
            .sqrt();
        if norm < 1e-9 {
            return None;
        }
        let norm = norm.copysign(-columns[index][index]);
        let mut mirror = columns[index][index..].to_vec();
        mirror[0] -= norm;
        let square: f64 = mirror.iter().map(|value| value * value).sum();
        diagonal[index] = norm;
        let reflect = |values: &mut [f64]| {
            let product: f64 = mirror.iter().zip(&*values).map(|(a, b)| a * b).sum();
            for (value, part) in values.iter_mut().zip(&mirror) {
                *value -= 2.0 * product / square * part;
            }
        };
        for column in &mut columns[index + 1..] {
            reflect(&mut column[index..]);
        }
        reflect(&mut right[index..]);
    }
    let mut solution = vec![0.0; count];
    for index in (0..count).rev() {
        let known: f64 = (index + 1..count)
            .map(|other| columns[other][index] * solution[other])
            .sum();
        solution[index] = (right[index] - known) / diagonal[index];
    }
    Some(solution)
}
