//! The forces of all joints, and comparisons with them.

use super::Vector;
use super::joint::Joint;
use super::newton_euler::Instant;

/// All joint forces.
#[derive(Clone, Debug)]
pub(crate) struct Solution {
    joints: Vec<Joint>,
    pub(crate) forces: Vec<Vector>,
    couples: Vec<Vector>,
    drives: Vec<f64>,
    largest: f64,
    length: f64,
}

impl Solution {
    pub(crate) fn new(instant: &Instant, mut found: &[f64]) -> Self {
        let largest = found
            .iter()
            .fold(0.0_f64, |largest, x| largest.max(x.abs()));
        let mut take = |ways: &[Vector]| {
            let (own, rest) = found.split_at(ways.len());
            found = rest;
            let parts = ways.iter().zip(own);
            parts.map(|(way, x)| way * *x).sum::<Vector>()
        };
        let mut solution = Self {
            joints: instant.joints.clone(),
            forces: Vec::new(),
            couples: Vec::new(),
            drives: Vec::new(),
            largest,
            length: instant.length,
        };
        for joint in &instant.joints {
            solution.forces.push(take(&joint.forces));
            solution.couples.push(take(&joint.couples) * instant.length);
            solution.drives.push(match joint.drive {
                Some((true, way)) => take(&[way]).dot(&way),
                Some((false, axis)) => take(&[axis]).dot(&axis) * instant.length,
                None => 0.0,
            });
        }
        solution
    }

    /// The force or couple of the drive in a joint.
    pub(crate) fn drive(&self, joint: usize) -> f64 {
        self.drives[joint]
    }

    /// The couple of a joint.
    pub(crate) fn couple(&self, joint: usize) -> Vector {
        self.couples[joint]
    }

    /// The power of all drives.
    pub(crate) fn power(&self, instant: &Instant) -> f64 {
        let driven = self.joints.iter().zip(&self.drives);
        let powers = driven.map(|(joint, drive)| match joint.drive {
            None => 0.0,
            Some((true, way)) => {
                let own = instant.velocity(Some(joint.body), joint.point);
                drive * way.dot(&(own - instant.velocity(joint.on, joint.point)))
            }
            Some((false, axis)) => {
                drive * axis.dot(&(instant.turn(Some(joint.body)) - instant.turn(joint.on)))
            }
        });
        powers.sum()
    }

    #[track_caller]
    pub(crate) fn expect_force(&self, joint: usize, found: impl Into<Spatial>) {
        self.expect(self.forces[joint], found.into().0, self.largest);
    }

    /// The forces of the first joints, in their order.
    #[track_caller]
    pub(crate) fn expect_forces<const N: usize>(&self, found: [impl Into<Spatial>; N]) {
        for (joint, force) in found.into_iter().enumerate() {
            self.expect_force(joint, force);
        }
    }

    #[track_caller]
    pub(crate) fn expect_moment(&self, joint: usize, found: impl Into<Spatial>) {
        self.expect(
            self.couples[joint],
            found.into().0,
            self.largest * self.length,
        );
    }

    /// A torque, or anything of that dimension.
    #[track_caller]
    pub(crate) fn expect_torque(&self, expected: f64, found: f64) {
        let size = self.largest * self.length;
        self.expect(Vector::x() * expected, Vector::x() * found, size);
    }

    /// A force that is not a joint's.
    #[track_caller]
    pub(crate) fn expect_size(&self, expected: Vector, found: impl Into<Spatial>) {
        self.expect(expected, found.into().0, self.largest);
    }

    /// A power, at an input's speed.
    #[track_caller]
    pub(crate) fn expect_power(&self, expected: f64, found: f64, speed: f64) {
        let size = self.largest * self.length * speed.abs();
        self.expect(Vector::x() * expected, Vector::x() * found, size);
    }

    #[track_caller]
    fn expect(&self, expected: Vector, found: Vector, size: f64) {
        let apart = (expected - found).norm();
        let size = size.max(expected.norm());
        assert!(
            apart <= 1e-10 * size,
            "{found:?} instead of {expected:?}, of the largest size {:e}",
            apart / size
        );
    }
}

/// A vector of the plane or of space, or a moment of the plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spatial(pub(crate) Vector);

impl From<nalgebra::Vector2<f64>> for Spatial {
    fn from(v: nalgebra::Vector2<f64>) -> Self {
        Self(Vector::new(v.x, v.y, 0.0))
    }
}

impl From<Vector> for Spatial {
    fn from(v: Vector) -> Self {
        Self(v)
    }
}

impl From<f64> for Spatial {
    fn from(moment: f64) -> Self {
        Self(Vector::z() * moment)
    }
}
