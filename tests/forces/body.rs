//! A rigid body at one instant.

use nalgebra::Matrix3;

use super::Vector;

/// A body at one instant, without mass until `add_mass`.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    pub(crate) origin: Vector,
    /// Velocity and acceleration of the origin.
    pub(crate) velocity: Vector,
    pub(crate) gain: Vector,
    /// Angular velocity and acceleration.
    pub(crate) turn: Vector,
    pub(crate) turn_gain: Vector,
    pub(crate) mass: f64,
    pub(crate) centre: Vector,
    /// About the centre of mass, in fixed axes.
    inertia: Matrix3<f64>,
}

impl Body {
    pub(crate) fn new(
        [origin, velocity, gain]: [Vector; 3],
        [turn, turn_gain]: [Vector; 2],
    ) -> Self {
        Self {
            origin,
            velocity,
            gain,
            turn,
            turn_gain,
            mass: 0.0,
            centre: origin,
            inertia: Matrix3::zeros(),
        }
    }

    /// Adds a point mass: the centre moves, the inertia grows by what both are apart.
    pub(crate) fn add_mass(mut self, mass: f64, at: Vector) -> Self {
        let all = self.mass + mass;
        let apart = at - self.centre;
        self.inertia += of_point(apart) * (self.mass * mass / all);
        self.centre += apart * (mass / all);
        self.mass = all;
        self
    }

    /// Adds an inertia about the centre of mass.
    pub(crate) fn add_inertia(mut self, inertia: Matrix3<f64>) -> Self {
        self.inertia += inertia;
        self
    }

    /// Replaces the inertia, which is given about another point, masses included.
    pub(crate) fn inertia_about(mut self, inertia: Matrix3<f64>, point: Vector) -> Self {
        self.inertia = inertia - of_point(self.centre - point) * self.mass;
        self
    }

    pub(crate) fn velocity_of(&self, point: Vector) -> Vector {
        self.velocity + self.turn.cross(&(point - self.origin))
    }

    fn gain_of(&self, point: Vector) -> Vector {
        let arm = point - self.origin;
        self.gain + self.turn_gain.cross(&arm) + self.turn.cross(&self.turn.cross(&arm))
    }

    pub(crate) fn kinetic_energy(&self) -> f64 {
        let of_centre = self.velocity_of(self.centre).norm_squared();
        (self.mass * of_centre + self.turn.dot(&(self.inertia * self.turn))) / 2.0
    }

    /// Rates of the momentum and of the moment of momentum about the origin of space.
    pub(crate) fn rates(&self) -> [Vector; 2] {
        let force = self.gain_of(self.centre) * self.mass;
        let spin = self.inertia * self.turn_gain + self.turn.cross(&(self.inertia * self.turn));
        [force, self.centre.cross(&force) + spin]
    }
}

/// The inertia of a unit mass about a point that far away.
fn of_point(arm: Vector) -> Matrix3<f64> {
    Matrix3::identity() * arm.norm_squared() - arm * arm.transpose()
}
