//! The loads on each body, as data.

use linkage_symbolic::{Ex, Vn};

/// For each body: forces at points, and couples.
#[derive(Clone, Debug)]
pub(super) struct Loads<'m> {
    pub(super) bodies: Vec<BodyLoads<'m>>,
}

#[derive(Clone, Debug, Default)]
pub(super) struct BodyLoads<'m> {
    pub(super) forces: Vec<PointForce<'m>>,
    pub(super) couples: Vec<Vn<'m>>,
}

#[derive(Clone, Debug)]
pub(super) struct PointForce<'m> {
    pub(super) point: Vn<'m>,
    pub(super) force: Vn<'m>,
    /// The mass at the point, for inertia and weight. Its expression moves with the body.
    pub(super) mass: Option<Ex<'m>>,
}

impl<'m> Loads<'m> {
    /// None on any of so many bodies.
    pub(super) fn none(bodies: usize) -> Self {
        Self {
            bodies: vec![BodyLoads::default(); bodies],
        }
    }

    /// A force at a point, or a couple.
    pub(super) fn add(&mut self, body: Option<usize>, point: Option<Vn<'m>>, value: Vn<'m>) {
        let Some(body) = body else { return };
        let loads = &mut self.bodies[body];
        match point {
            None => loads.couples.push(value),
            Some(point) => loads.forces.push(PointForce {
                point,
                force: value,
                mass: None,
            }),
        }
    }
}
