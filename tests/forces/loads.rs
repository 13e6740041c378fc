//! What acts on bodies beside the joints' forces: by definition, with the power that it takes.

use super::Vector;
use super::newton_euler::Instant;

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
