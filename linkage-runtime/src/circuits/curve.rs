//! The curve of a coupled group's solutions over its input, followed along its own length: it turns
//! back where the input does.

use super::slab::Slab;
use alloc::vec;
use alloc::vec::Vec;
use linkage_core::math;
use linkage_core::numeric::continuation::Correction;
use linkage_core::numeric::roots::Variable;
use linkage_core::numeric::vector::dot;

/// The derivative by the parameter is a difference over this. Its error is divided by the
/// determinant, so it is short.
const DIFFERENCE: f64 = 1e-8;

/// Nearer to an end of the slab than the first number the difference is the second one: where that
/// is a turning point of another group, roots of rounding are in everything.
const BESIDE: [f64; 2] = [1e-3, 1e-5];

/// A correction that leaves nothing but rounding. Close to a turning point rounding is divided by a
/// small determinant: there, one that does not become smaller any more.
const SETTLED: f64 = 1e-10;
const ROUNDING: f64 = 1e-7;

/// Corrections of one node, at most, and how much smaller the second and each later one must be
/// than the one before: at a turning point the derivatives are exact on the curve only.
const CORRECTIONS: usize = 40;
const CONTRACTION: [f64; 2] = [0.3, 0.8];

/// A first correction must not be larger than this part of the step.
const ASIDE: f64 = 0.1;

/// The cosine of the angle by which the direction may change in a step, and the one below which
/// steps grow.
const TURN: f64 = 0.97;
const STRAIGHT: f64 = 0.996;

/// Directions that are nearer to a turning point have no side.
const UPRIGHT: f64 = 1e-7;

/// A place on the curve.
#[derive(Clone, Debug)]
pub(super) struct Node {
    /// The parameter of the input.
    pub(super) u: f64,
    pub(super) state: Vec<f64>,
    pub(super) determinant: f64,
    /// Change of parameter and coordinates along the curve, of length 1.
    pub(super) direction: Vec<f64>,
}

impl Node {
    /// The same place, looked at in the other direction.
    pub(super) fn turned(&self) -> Self {
        let direction = self.direction.iter().map(|x| -x).collect();
        Self {
            direction,
            ..self.clone()
        }
    }

    /// Orientation, which separates two neighbouring strands of a curve: this sign never changes
    /// along one of them.
    fn side(&self) -> f64 {
        if self.direction[0].abs() < UPRIGHT {
            return 0.0;
        }
        (self.determinant * self.direction[0]).signum()
    }
}

/// The curve within a slab.
pub(super) struct SolutionCurve<'a> {
    pub(super) correction: &'a mut dyn Correction,
    pub(super) variables: &'a [Variable],
    pub(super) slab: Slab,
    /// Newton steps that may still be made.
    pub(super) left: usize,
}

impl SolutionCurve<'_> {
    /// The node at a known solution, towards higher inputs.
    pub(super) fn node(&mut self, u: f64, state: &[f64]) -> Option<Node> {
        let mut plane = vec![0.0; 1 + self.coordinates()];
        plane[0] = 1.0;
        self.solve(u, state.to_vec(), &plane, f64::INFINITY)
    }

    /// The node at about this length of curve from another one.
    pub(super) fn step_along(&mut self, node: &Node, length: f64) -> Option<Node> {
        let steps: Vec<f64> = node.direction.iter().map(|x| length * x).collect();
        let state = self.moved(&node.state, &steps[1..]);
        let u = node.u + steps[0];
        if u.abs() > 1.0 {
            return None;
        }
        let next = self.solve(u, state, &node.direction, ASIDE * length.abs())?;
        self.continues(node, &next).then_some(next)
    }

    /// The node at this parameter, seen from another one near it.
    pub(super) fn land(&mut self, node: &Node, u: f64) -> Option<Node> {
        let length = (u - node.u) / node.direction[0];
        let steps: Vec<f64> = node.direction.iter().map(|x| length * x).collect();
        let state = self.moved(&node.state, &steps[1..]);
        let mut plane = vec![0.0; steps.len()];
        plane[0] = node.direction[0].signum();
        let next = self.solve(u, state, &plane, ASIDE * length.abs())?;
        self.continues(node, &next).then_some(next)
    }

    /// Returns true if the curve has turned by little, and is still the same.
    fn continues(&self, node: &Node, next: &Node) -> bool {
        let sides = node.side() * next.side();
        dot(&node.direction, &next.direction) >= TURN && sides >= 0.0
    }

    /// The factor for the length of the next step after a success.
    pub(super) fn growth(node: &Node, next: &Node) -> f64 {
        if dot(&node.direction, &next.direction) > STRAIGHT {
            1.6
        } else {
            1.0
        }
    }

    /// Newton's method across a plane through the start.
    fn solve(&mut self, mut u: f64, mut state: Vec<f64>, plane: &[f64], most: f64) -> Option<Node> {
        let mut allowed = most.max(SETTLED);
        for index in 0..CORRECTIONS {
            // The displacement at a fixed input is beyond all bounds at a turning point; times the
            // determinant it is smooth.
            let (here, determinant) = self.displacement(u, &state)?;
            let aside = if 1.0 - u.abs() < BESIDE[0] {
                -u.signum() * BESIDE[1]
            } else {
                -u.signum() * DIFFERENCE
            };
            let (there, other) = self.displacement(u + aside, &state)?;
            let pairs = there.iter().zip(&here);
            let rates: Vec<f64> = pairs
                .map(|(there, here)| (other * there - determinant * here) / aside)
                .collect();
            let across = plane[0] * determinant + dot(&plane[1..], &rates);
            let forward = -determinant * dot(&plane[1..], &here) / across;
            let pairs = here.iter().zip(&rates);
            let steps: Vec<f64> = pairs
                .map(|(here, rate)| here + forward * (rate / determinant))
                .collect();
            let size = math::double::sqrt(forward * forward + dot(&steps, &steps));
            let stays = size > allowed && size <= ROUNDING;
            if !(size <= allowed || stays) {
                return None;
            }
            u = (u + forward).clamp(-1.0, 1.0);
            state = self.moved(&state, &steps);
            if size <= SETTLED || stays {
                let length = determinant * determinant + dot(&rates, &rates);
                let length = math::double::sqrt(length) * across.signum();
                let mut direction = vec![determinant / length];
                direction.extend(rates.iter().map(|rate| rate / length));
                return Some(Node {
                    u,
                    state,
                    determinant,
                    direction,
                });
            }
            allowed = (CONTRACTION[index.min(1)] * size).max(SETTLED);
        }
        None
    }

    /// The number of coordinates of a state: one for each variable.
    fn coordinates(&self) -> usize {
        self.variables.len()
    }

    /// Newton's displacement of the coordinates at a fixed input, and the determinant.
    fn displacement(&mut self, u: f64, state: &[f64]) -> Option<(Vec<f64>, f64)> {
        self.left = self.left.checked_sub(1)?;
        let mut next = state.to_vec();
        let step = self.correction.correct(&[self.slab.x(u)], &mut next);
        let displacement = self.difference(state, &next);
        let finite = displacement.iter().all(|x| x.is_finite()) && step.determinant.is_finite();
        finite.then_some((displacement, step.determinant))
    }

    /// Differences from one state to another near it, one for each variable. For a unit vector it
    /// is the sine of the angle, by which a Newton step turns it.
    pub(super) fn difference(&self, from: &[f64], to: &[f64]) -> Vec<f64> {
        let mut differences = Vec::with_capacity(self.coordinates());
        let mut number = 0;
        for variable in self.variables {
            match variable {
                Variable::Unit => {
                    differences.push(from[number] * to[number + 1] - from[number + 1] * to[number]);
                    number += 2;
                }
                Variable::Length | Variable::Number | Variable::Point | Variable::Conjugate => {
                    differences.push(to[number] - from[number]);
                    number += 1;
                }
            }
        }
        differences
    }

    /// The state at these differences of the coordinates.
    fn moved(&self, state: &[f64], steps: &[f64]) -> Vec<f64> {
        let mut state = state.to_vec();
        let mut number = 0;
        for (variable, step) in self.variables.iter().zip(steps) {
            match variable {
                Variable::Unit => {
                    let [cos, sin] = [state[number], state[number + 1]];
                    let (c, s) = (cos - sin * step, sin + cos * step);
                    let length = math::double::sqrt(c * c + s * s);
                    (state[number], state[number + 1]) = (c / length, s / length);
                    number += 2;
                }
                Variable::Length | Variable::Number | Variable::Point | Variable::Conjugate => {
                    state[number] += step;
                    number += 1;
                }
            }
        }
        state
    }
}
