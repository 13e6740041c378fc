//! Moments of inertia and what they do when a body turns.
//!
//! A body with a frame is looked at in its own axes, where its inertia does not change and nothing is turned to and fro.

use crate::forces::geometry;
use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::Translate;
use crate::model::{Expr, Inertia};

use super::Mechanics;
use super::geometry::Turning;

/// How a body turns: the angular velocity and its gain, in the body's own axes if it has any.
struct Turned<'m> {
    axes: Option<[Vn<'m>; 3]>,
    velocity: Vn<'m>,
    gain: Vn<'m>,
}

impl<'m> Mechanics<'_, 'm> {
    /// How fast the moment of momentum of a body grows beyond that of its masses as points: `I alpha`, in space `I alpha + omega x I omega`.
    pub(super) fn inertia_couple(&mut self, body: usize) -> Option<Vn<'m>> {
        if self.algebra.mechanism.bodies[body].inertias.is_empty() {
            return None;
        }
        let turned = self.turned(body);
        let couple = self.inertia_times(body, &turned, turned.gain);
        if self.forces.geometry.is_plane() {
            return Some(couple);
        }
        let momentum = self.inertia_times(body, &turned, turned.velocity);
        let couple = couple + turned.velocity.moment_of(momentum);
        Some(match &turned.axes {
            Some(axes) => self.out_of_axes(axes, couple),
            None => couple,
        })
    }

    /// Twice the energy of a body's turning beyond that of its masses as points: `omega . I omega`.
    pub(super) fn twice_turning_energy(&mut self, body: usize) -> Ex<'m> {
        if self.algebra.mechanism.bodies[body].inertias.is_empty() {
            return self.algebra.zero();
        }
        let turned = self.turned(body);
        let momentum = self.inertia_times(body, &turned, turned.velocity);
        turned.velocity.dot(momentum)
    }

    /// How a body turns at the speeds that are listed.
    fn turned(&mut self, body: usize) -> Turned<'m> {
        match self.forces.geometry.turning[body] {
            Turning::Frame(axes) => self.turned_in_axes(axes),
            Turning::Rod(along) => self.turned_rod(body, along),
            Turning::Along | Turning::Angle(_) | Turning::About(..) => Turned {
                gain: self.angular_acceleration(body),
                velocity: self.angular_velocity(body),
                axes: None,
            },
        }
    }

    /// Components `w_x = y' . z` and so on, and their gain: `y" . z - w_y w_z` and so on.
    fn turned_in_axes(&mut self, axes: [Vn<'m>; 3]) -> Turned<'m> {
        let velocity = [0, 1, 2].map(|k| {
            let [y, z] = [k + 1, k + 2].map(|k| axes[k % 3]);
            self.point_velocity(y).dot(z)
        });
        let gain = [0, 1, 2].map(|k| {
            let [y, z] = [k + 1, k + 2].map(|k| axes[k % 3]);
            let [w_y, w_z] = [k + 1, k + 2].map(|k| velocity[k % 3]);
            self.point_acceleration(y).dot(z) - w_y * w_z
        });
        Turned {
            axes: Some(axes),
            velocity: Vector(velocity).into(),
            gain: Vector(gain).into(),
        }
    }

    /// `w`, and `(V x V" - 2 (V . V') w) / V^2`, where a rod that keeps its length has no second term.
    fn turned_rod(&mut self, body: usize, v: Vn<'m>) -> Turned<'m> {
        let velocity = self.angular_velocity(body);
        let mut across = v.moment_of(self.point_acceleration(v));
        if !self.forces.rigid_rods.contains(&body) {
            let moved = self.point_velocity(v);
            across = across - (2.0 * v.dot(moved)) * velocity;
        }
        Turned {
            axes: None,
            velocity,
            gain: across / v.square(),
        }
    }

    /// `a x + b y + c z`
    fn out_of_axes(&self, axes: &[Vn<'m>; 3], own: Vn<'m>) -> Vn<'m> {
        let pairs = own.iter().zip(axes);
        pairs.fold(self.zero_turn(), |sum, (along, &axis)| sum + along * axis)
    }

    /// A body's inertia, without that of its masses as points, times a turn.
    fn inertia_times(&mut self, body: usize, turned: &Turned<'m>, turn: Vn<'m>) -> Vn<'m> {
        let mechanism = self.algebra.mechanism;
        let mut sum = self.zero_turn();
        for (inertia, about) in &mechanism.bodies[body].inertias {
            let whole = match inertia {
                Inertia::Scalar(inertia) => self.scalar_inertia(body, inertia, turn),
                Inertia::Tensor(rows) => self.tensor_inertia(rows, turn),
            };
            sum = sum + whole;
            let Some(about) = about else { continue };
            let points = match (inertia, self.forces.geometry.axis(body)) {
                // The number says nothing of the masses' products of inertia.
                (Inertia::Scalar(_), Some(axis)) => {
                    let turn = turn.along(axis);
                    self.points_about(body, about, turned, turn).along(axis)
                }
                (Inertia::Scalar(_), None) | (Inertia::Tensor(_), _) => {
                    self.points_about(body, about, turned, turn)
                }
            };
            sum = sum - points;
        }
        sum
    }

    /// What the masses as points have about a point, times a turn: `sum m r^2 w`, in space `sum m r x (w x r)`.
    fn points_about(
        &mut self,
        body: usize,
        about: &Expr,
        turned: &Turned<'m>,
        turn: Vn<'m>,
    ) -> Vn<'m> {
        let about = geometry::vector_of(self.algebra, about);
        let mut sum = self.zero_turn();
        for (mass, point) in self.masses(body) {
            let arm = point - about;
            let arm = match turned.axes {
                Some(axes) => Vector(axes.map(|axis| axis.dot(arm))).into(),
                None => arm,
            };
            let part = match self.forces.geometry.is_plane() {
                true => arm.square() * turn,
                false => arm.moment_of(turn.sweeping(arm)),
            };
            sum = sum + mass * part;
        }
        sum
    }

    /// In space a scalar is that of a sphere, of a rod across its line, or about the axis of a body that turns about one.
    fn scalar_inertia(&mut self, body: usize, inertia: &Expr, turn: Vn<'m>) -> Vn<'m> {
        let inertia = self.algebra.translate_number(inertia);
        match self.forces.geometry.axis(body) {
            Some(axis) => inertia * turn.along(axis),
            None => inertia * turn,
        }
    }

    /// In the axes of the body's frame.
    fn tensor_inertia(&mut self, rows: &[[Expr; 3]; 3], turn: Vn<'m>) -> Vn<'m> {
        let rows = rows.each_ref().map(|row| {
            let row = row.each_ref().map(|x| self.algebra.translate_number(x));
            Vn::from(Vector(row)).dot(turn)
        });
        Vector(rows).into()
    }
}
