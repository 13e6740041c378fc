//! A force and a moment about a point.

use std::ops::{Add, Neg};

use linkage_symbolic::{Ex, Graph, Vn};

use crate::forces::geometry::Geometry;
use crate::forces::joint_motion::JointMotion;

/// A force and a moment about a point.
#[derive(Clone, Copy, Debug)]
pub(super) struct Wrench<'m> {
    pub(super) force: Vn<'m>,
    pub(super) moment: Vn<'m>,
}

/// The parts that a wrench was made of.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Carried {
    pub(super) body: usize,
    /// Cut joints that cancel.
    pub(super) inside: Vec<usize>,
    /// Unknowns that count as 0.
    pub(super) open: Vec<usize>,
}

impl<'m> Wrench<'m> {
    /// Neither force nor moment.
    pub(super) fn zero(graph: &'m Graph, geometry: &Geometry<'m>) -> Self {
        Self {
            force: geometry.zero_vector(graph),
            moment: geometry.zero_turn(graph),
        }
    }

    /// About a point from which the force has an arm: `F`, `M + r x F`.
    pub(super) fn with_arm(self, arm: Vn<'m>) -> Self {
        Self {
            force: self.force,
            moment: self.moment + arm.moment_of(self.force),
        }
    }

    /// The component that does work in a motion.
    pub(super) fn along(self, way: &JointMotion<'m>) -> Ex<'m> {
        way.direction
            .dot(if way.slides { self.force } else { self.moment })
    }
}

impl Add for Wrench<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self {
            force: self.force + other.force,
            moment: self.moment + other.moment,
        }
    }
}

impl Neg for Wrench<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            force: -self.force,
            moment: -self.moment,
        }
    }
}
