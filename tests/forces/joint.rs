//! Bodies, joints and loads of the equations by Newton and Euler, as plain data.

use super::Vector;
use super::newton_euler::Instant;
use nalgebra::Matrix3;

// Joints by what they transmit.

/// A joint: the directions of the forces and couples that it can transmit.
#[derive(Clone, Debug)]
pub(crate) struct Joint {
    pub(crate) body: usize,
    pub(crate) on: Option<usize>,
    pub(crate) point: Vector,
    pub(crate) forces: Vec<Vector>,
    pub(crate) couples: Vec<Vector>,
    /// A drive holds the motion along or about this direction; `true` for a force.
    pub(crate) drive: Option<(bool, Vector)>,
}

/// Which motions a joint leaves open.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kind {
    Fixed,
    /// About an axis.
    Pin(Vector),
    /// Along a direction.
    Slide(Vector),
    Cylinder(Vector),
    /// A pin of the plane that slides along a direction.
    Roller(Vector),
    Ball,
}

impl Kind {
    /// The direction of its drive; `true` for a force.
    pub(crate) fn drive(self) -> Option<(bool, Vector)> {
        match self {
            Kind::Pin(axis) => Some((false, axis.normalize())),
            Kind::Slide(way) | Kind::Roller(way) => Some((true, way.normalize())),
            Kind::Fixed | Kind::Cylinder(_) | Kind::Ball => None,
        }
    }
}

impl Joint {
    pub(crate) fn new(
        kind: Kind,
        (body, on): (usize, Option<usize>),
        point: Vector,
        plane: bool,
    ) -> Self {
        let (mut forces, mut couples) = match kind {
            Kind::Fixed => (all(), all()),
            Kind::Pin(axis) => (all(), across(axis)),
            Kind::Slide(way) => (across(way), all()),
            Kind::Cylinder(axis) => (across(axis), across(axis)),
            Kind::Roller(way) => (across(way), Vec::new()),
            Kind::Ball => (all(), Vec::new()),
        };
        if plane {
            forces.retain(|v| v.z.abs() < 0.5);
            couples.retain(|v| v.z.abs() > 0.5);
        }
        Self {
            body,
            on,
            point,
            forces,
            couples,
            drive: None,
        }
    }

    /// Force and moment about the origin for each unknown, in newtons: couples act on a lever of the typical length.
    pub(crate) fn wrenches(&self, length: f64) -> Vec<[Vector; 2]> {
        let force = |v: &Vector| [*v, self.point.cross(v)];
        let couple = |v: &Vector| [Vector::zeros(), v * length];
        let forces = self.forces.iter().map(force);
        let couples = self.couples.iter().map(couple);
        let drive = self.drive.iter().map(|(is_force, v)| match is_force {
            true => force(v),
            false => couple(v),
        });
        forces.chain(couples).chain(drive).collect()
    }
}

fn all() -> Vec<Vector> {
    vec![Vector::x(), Vector::y(), Vector::z()]
}

/// Two directions at right angles to one and to each other. For one in the plane, one of them is in the plane.
fn across(way: Vector) -> Vec<Vector> {
    let way = way.normalize();
    if way.z.abs() > 0.9 {
        let first = way.cross(&Vector::x()).normalize();
        return vec![first, way.cross(&first)];
    }
    let first = way.cross(&Vector::z()).normalize();
    vec![first, way.cross(&first)]
}

// What acts on bodies beside the joints' forces: by definition, with the power that it takes.

impl Instant {
    /// A force on a body at a point; its opposite acts on another.
    pub(crate) fn pair(&mut self, bodies: [Option<usize>; 2], at: Vector, force: Vector) {
        for (body, force) in bodies.into_iter().zip([force, -force]) {
            let Some(body) = body else { continue };
            self.loads[body][0] += force;
            self.loads[body][1] += at.cross(&force);
        }
    }

    /// A couple on a body; its opposite acts on another.
    pub(crate) fn couple(&mut self, bodies: [Option<usize>; 2], couple: Vector) {
        for (body, couple) in bodies.into_iter().zip([couple, -couple]) {
            let Some(body) = body else { continue };
            self.loads[body][1] += couple;
        }
    }

    /// An applied force, whose power the mechanism must provide.
    pub(crate) fn force(&mut self, bodies: [Option<usize>; 2], at: Vector, force: Vector) {
        let [own, other] = bodies.map(|body| self.velocity(body, at));
        self.delivered -= force.dot(&(own - other));
        self.pair(bodies, at, force);
    }

    pub(crate) fn torque(&mut self, bodies: [Option<usize>; 2], couple: Vector) {
        let [own, other] = bodies.map(|body| self.turn(body));
        self.delivered -= couple.dot(&(own - other));
        self.couple(bodies, couple);
    }

    /// A spring between points of two bodies, pulled apart by the part that is longer than `free`.
    pub(crate) fn spring(&mut self, ends: [(Option<usize>, Vector); 2], rate: f64, free: f64) {
        let between = ends[1].1 - ends[0].1;
        let pull = between.normalize() * (rate * (between.norm() - free));
        self.pair([ends[0].0, None], ends[0].1, pull);
        self.pair([ends[1].0, None], ends[1].1, -pull);
    }

    pub(crate) fn damper(&mut self, ends: [(Option<usize>, Vector); 2], rate: f64) {
        let way = (ends[1].1 - ends[0].1).normalize();
        let [start, end] = ends.map(|(body, at)| self.velocity(body, at));
        let speed = way.dot(&(end - start));
        self.pair([ends[0].0, None], ends[0].1, way * (rate * speed));
        self.pair([ends[1].0, None], ends[1].1, way * (-rate * speed));
        self.dissipated += rate * speed * speed;
    }

    /// A damper that brakes the turn of a body against another about an axis.
    pub(crate) fn turn_damper(&mut self, bodies: [Option<usize>; 2], axis: Vector, rate: f64) {
        let [own, other] = bodies.map(|body| self.turn(body));
        let speed = axis.dot(&(own - other));
        self.couple(bodies, axis * (-rate * speed));
        self.dissipated += rate * speed * speed;
    }

    /// A damper that brakes a body's point against another body along a guide.
    pub(crate) fn slide_damper(
        &mut self,
        bodies: [Option<usize>; 2],
        (at, way): (Vector, Vector),
        rate: f64,
    ) {
        let [own, other] = bodies.map(|body| self.velocity(body, at));
        let speed = way.dot(&(own - other));
        self.pair(bodies, at, way * (-rate * speed));
        self.dissipated += rate * speed * speed;
    }
}

// A rigid body at one instant.

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
