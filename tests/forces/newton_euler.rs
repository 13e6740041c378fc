//! Newton's and Euler's equations of all bodies at once, with every force and couple of every joint and drive as an unknown.
//!
//! What is known is plain: where each body is and how it moves, its mass, its inertia, and what acts on it. Mechanisms of the plane lie in the plane
//! z = 0 and have three rows for each body.

use nalgebra::{DMatrix, DVector};

use super::Vector;
use super::joint::Body;
use super::joint::{Joint, Kind};
use super::solution::Solution;

/// The mechanism at one instant.
#[derive(Clone, Debug)]
pub(crate) struct Instant {
    plane: bool,
    /// A typical length: makes moments and forces comparable.
    pub(crate) length: f64,
    /// Newtons per kilogram and unit of acceleration.
    newton: f64,
    gravity: Vector,
    pub(crate) bodies: Vec<Body>,
    pub(crate) joints: Vec<Joint>,
    /// Couples in fixed proportions on some bodies, of unknown size: gears.
    ties: Vec<Vec<(usize, Vector)>>,
    /// Forces and moments about the origin of space, by body.
    pub(crate) loads: Vec<[Vector; 2]>,
    /// What loads and elements do for each second.
    pub(crate) delivered: f64,
    pub(crate) dissipated: f64,
}

impl Instant {
    pub(crate) fn new(plane: bool, length: f64, newton: f64, gravity: Vector) -> Self {
        Self {
            plane,
            length,
            newton,
            gravity,
            bodies: Vec::new(),
            joints: Vec::new(),
            ties: Vec::new(),
            loads: Vec::new(),
            delivered: 0.0,
            dissipated: 0.0,
        }
    }

    pub(crate) fn body(&mut self, body: Body) -> usize {
        let weight = self.gravity * (body.mass * self.newton);
        self.loads.push([weight, body.centre.cross(&weight)]);
        self.bodies.push(body);
        self.bodies.len() - 1
    }

    /// A joint and the place of its forces in the solution.
    pub(crate) fn joint(
        &mut self,
        kind: Kind,
        body: usize,
        on: Option<usize>,
        point: Vector,
    ) -> usize {
        self.joints
            .push(Joint::new(kind, (body, on), point, self.plane));
        self.joints.len() - 1
    }

    /// A joint whose motion along or about its direction is driven.
    pub(crate) fn driven(
        &mut self,
        kind: Kind,
        body: usize,
        on: Option<usize>,
        point: Vector,
    ) -> usize {
        let joint = self.joint(kind, body, on, point);
        self.joints[joint].drive = kind.drive();
        joint
    }

    pub(crate) fn tie(&mut self, couples: &[(usize, f64)]) {
        let couples = couples
            .iter()
            .map(|&(body, part)| (body, Vector::z() * part));
        self.ties.push(couples.collect());
    }

    pub(crate) fn turn(&self, body: Option<usize>) -> Vector {
        body.map_or(Vector::zeros(), |body| self.bodies[body].turn)
    }

    pub(crate) fn velocity(&self, body: Option<usize>, at: Vector) -> Vector {
        body.map_or(Vector::zeros(), |body| self.bodies[body].velocity_of(at))
    }

    /// In newtons and the length unit.
    pub(crate) fn kinetic_energy(&self) -> f64 {
        let all = self.bodies.iter().map(Body::kinetic_energy);
        self.newton * all.sum::<f64>()
    }

    /// Minus the sums of the rates of momentum and of its moment about a point.
    pub(crate) fn shaking(&self, about: Vector) -> [Vector; 2] {
        let rates = self.bodies.iter().map(Body::rates);
        let zero = [Vector::zeros(); 2];
        let [force, moment] = rates.fold(zero, |sum, rate| [sum[0] - rate[0], sum[1] - rate[1]]);
        let force = force * self.newton;
        [force, moment * self.newton - about.cross(&force)]
    }

    /// Solves all equations. Those that repeat others, as of a rod's spin, must agree with them.
    pub(crate) fn solve(&self) -> Solution {
        let rows = if self.plane { 3 } else { 6 };
        let mut columns: Vec<DVector<f64>> = Vec::new();
        let size = rows * self.bodies.len();
        // The rows of a force and a moment about the origin, about the body's own origin.
        let put = |column: &mut DVector<f64>, body: usize, [force, moment]: [Vector; 2]| {
            let own = (moment - self.bodies[body].origin.cross(&force)) / self.length;
            let parts = match self.plane {
                true => vec![force.x, force.y, own.z],
                false => vec![force.x, force.y, force.z, own.x, own.y, own.z],
            };
            let start = rows * body;
            parts
                .into_iter()
                .enumerate()
                .for_each(|(k, x)| column[start + k] += x);
        };
        let mut unknown = |ends: &[(usize, [Vector; 2])]| {
            let mut column = DVector::zeros(size);
            ends.iter()
                .for_each(|&(body, wrench)| put(&mut column, body, wrench));
            columns.push(column);
        };
        for joint in &self.joints {
            for wrench in joint.wrenches(self.length) {
                let on = joint.on.map(|on| (on, wrench.map(|v| -v)));
                unknown(
                    &[Some((joint.body, wrench)), on]
                        .into_iter()
                        .flatten()
                        .collect::<Vec<_>>(),
                );
            }
        }
        for tie in &self.ties {
            let couples = tie
                .iter()
                .map(|&(body, v)| (body, [Vector::zeros(), v * self.length]));
            unknown(&couples.collect::<Vec<_>>());
        }
        let mut right = DVector::zeros(size);
        for (body, (own, load)) in self.bodies.iter().zip(&self.loads).enumerate() {
            let rates = own.rates().map(|v| v * self.newton);
            put(&mut right, body, [rates[0] - load[0], rates[1] - load[1]]);
        }
        let matrix = DMatrix::from_columns(&columns);
        let found = solution(matrix, &right);
        Solution::new(self, found.as_slice())
    }
}

/// Of a system with at least as many equations as unknowns.
fn solution(matrix: DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
    let (equations, unknowns) = matrix.shape();
    assert!(
        equations >= unknowns,
        "{equations} equations, {unknowns} unknowns"
    );
    if equations == unknowns {
        let solved = matrix.lu().solve(right);
        return solved.expect("equilibrium tells all forces");
    }
    let parts = matrix.clone().svd(true, true);
    let smallest = parts.singular_values.min();
    assert!(
        smallest > 1e-9,
        "equilibrium leaves forces open: {smallest}"
    );
    let found = parts.solve(right, 0.0).expect("both bases were asked for");
    let rest = (matrix * &found - right).norm();
    assert!(
        rest <= 1e-10 * found.norm(),
        "no forces hold this motion: {rest}"
    );
    found
}
