//! Moments of inertia and what they do when a body turns.
//!
//! A body with a frame is looked at in its own axes, where its inertia does not change and nothing is turned to and fro.

use linkage_symbolic::NodeId;

use crate::model::{Expr, Inertia};

use super::Mechanics;
use super::geometry::Turning;

/// How a body turns: the angular velocity and its gain, in the body's own axes if it has any.
struct Turned {
    axes: Option<[Vec<NodeId>; 3]>,
    velocity: Vec<NodeId>,
    gain: Vec<NodeId>,
}

impl Mechanics<'_, '_> {
    /// How fast the moment of momentum of a body grows beyond that of its masses as points: `I alpha`, in space `I alpha + omega x I omega`.
    pub(super) fn inertia_couple(&mut self, body: usize) -> Option<Vec<NodeId>> {
        if self.algebra.mechanism.bodies[body].inertias.is_empty() {
            return None;
        }
        let turned = self.turned(body);
        let couple = self.inertia_times(body, &turned, &turned.gain);
        if self.forces.geometry.dimensions == 2 {
            return Some(couple);
        }
        let momentum = self.inertia_times(body, &turned, &turned.velocity);
        let gyroscopic = self.algebra.moment_of(&turned.velocity, &momentum);
        let couple = self.algebra.plus(&couple, &gyroscopic);
        Some(match &turned.axes {
            Some(axes) => self.out_of_axes(axes, &couple),
            None => couple,
        })
    }

    /// Twice the energy of a body's turning beyond that of its masses as points.
    pub(super) fn twice_turning_energy(&mut self, body: usize) -> NodeId {
        if self.algebra.mechanism.bodies[body].inertias.is_empty() {
            return self.algebra.graph.zero();
        }
        let turned = self.turned(body);
        let momentum = self.inertia_times(body, &turned, &turned.velocity);
        self.algebra.dot(&turned.velocity, &momentum)
    }

    fn turned(&mut self, body: usize) -> Turned {
        match self.forces.geometry.turning[body].clone() {
            Turning::Frame(axes) => {
                // Components: y' . z and so on; y" . z - w_y w_z and so on.
                let velocity: Vec<NodeId> = (0..3)
                    .map(|k| {
                        let moved = self.point_velocity(&axes[(k + 1) % 3]);
                        self.algebra.dot(&moved, &axes[(k + 2) % 3])
                    })
                    .collect();
                let gain = (0..3).map(|k| {
                    let (next, after) = ((k + 1) % 3, (k + 2) % 3);
                    let gained = self.point_acceleration(&axes[next]);
                    let along = self.algebra.dot(&gained, &axes[after]);
                    let product = self.algebra.graph.mul(velocity[next], velocity[after]);
                    self.algebra.graph.sub(along, product)
                });
                Turned {
                    gain: gain.collect(),
                    velocity,
                    axes: Some(axes),
                }
            }
            Turning::Rod(along) => {
                // (V x V" - 2 (V . V') w) / V^2
                let velocity = self.angular_velocity(body);
                let gained = self.point_acceleration(&along);
                let mut across = self.algebra.moment_of(&along, &gained);
                if !self.forces.rigid_rods.contains(&body) {
                    let moved = self.point_velocity(&along);
                    let product = self.algebra.dot(&along, &moved);
                    let two = self.algebra.graph.constant(2.0);
                    let factor = self.algebra.graph.mul(two, product);
                    let part = self.algebra.times(factor, &velocity);
                    across = self.algebra.difference(&across, &part);
                }
                let square = self.algebra.sum_of_squares(&along);
                let graph = &mut self.algebra.graph;
                Turned {
                    gain: across.into_iter().map(|x| graph.div(x, square)).collect(),
                    velocity,
                    axes: None,
                }
            }
            _ => Turned {
                gain: self.angular_acceleration(body),
                velocity: self.angular_velocity(body),
                axes: None,
            },
        }
    }

    fn out_of_axes(&mut self, axes: &[Vec<NodeId>; 3], own: &[NodeId]) -> Vec<NodeId> {
        let zero = self.algebra.zeros(3);
        own.iter().zip(axes).fold(zero, |sum, (&along, axis)| {
            let part = self.algebra.times(along, axis);
            self.algebra.plus(&sum, &part)
        })
    }

    /// A body's inertia, without that of its masses as points, times a turn.
    fn inertia_times(&mut self, body: usize, turned: &Turned, turn: &[NodeId]) -> Vec<NodeId> {
        let mechanism = self.algebra.mechanism;
        let mut sum = self.algebra.zeros(turn.len());
        for (inertia, about) in &mechanism.bodies[body].inertias {
            let product = match inertia {
                Inertia::Scalar(inertia) => self.scalar_inertia(body, inertia, turn),
                Inertia::Tensor(rows) => rows
                    .iter()
                    .map(|row| {
                        let row: Vec<NodeId> =
                            row.iter().map(|x| self.algebra.number_of(x)).collect();
                        self.algebra.dot(&row, turn)
                    })
                    .collect(),
            };
            sum = self.algebra.plus(&sum, &product);
            if let Some(about) = about {
                let points = match (inertia, self.forces.geometry.turning[body].clone()) {
                    // The number says nothing of the masses' products of inertia.
                    (Inertia::Scalar(_), Turning::About(_, axis)) => {
                        let turn = self.algebra.along(&axis, turn);
                        let points = self.points_about(body, about, turned, &turn);
                        self.algebra.along(&axis, &points)
                    }
                    _ => self.points_about(body, about, turned, turn),
                };
                sum = self.algebra.difference(&sum, &points);
            }
        }
        sum
    }

    /// What the masses as points have about a point, times a turn.
    fn points_about(
        &mut self,
        body: usize,
        about: &Expr,
        turned: &Turned,
        turn: &[NodeId],
    ) -> Vec<NodeId> {
        let about = self.algebra.vector_of(about);
        let mut sum = self.algebra.zeros(turn.len());
        for (mass, point) in self.masses(body) {
            let mut arm = self.algebra.difference(&point, &about);
            if let Some(axes) = &turned.axes {
                arm = axes
                    .iter()
                    .map(|axis| self.algebra.dot(axis, &arm))
                    .collect();
            }
            let part = match turn {
                [turn] => {
                    let square = self.algebra.sum_of_squares(&arm);
                    vec![self.algebra.graph.mul(square, *turn)]
                }
                _ => {
                    let swept = self.algebra.swept(turn, &arm);
                    self.algebra.moment_of(&arm, &swept)
                }
            };
            let part = self.algebra.times(mass, &part);
            sum = self.algebra.plus(&sum, &part);
        }
        sum
    }

    /// In space a scalar is that of a sphere, of a rod across its line, or about the axis of a body that turns about one.
    fn scalar_inertia(&mut self, body: usize, inertia: &Expr, turn: &[NodeId]) -> Vec<NodeId> {
        let inertia = self.algebra.number_of(inertia);
        match self.forces.geometry.turning[body].clone() {
            Turning::About(_, axis) => {
                let along = self.algebra.along(&axis, turn);
                self.algebra.times(inertia, &along)
            }
            _ => self.algebra.times(inertia, turn),
        }
    }
}
