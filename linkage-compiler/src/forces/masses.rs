//! The masses of bodies and the field of gravity.

use linkage_symbolic::{Ex, Vn};

use crate::algebra::{Algebra, Translate};
use crate::forces::geometry;

/// The field of gravity, if there is one.
pub(super) fn gravity<'m>(algebra: &mut Algebra<'m>) -> Option<Vn<'m>> {
    let gravity = algebra.mechanism.gravity.as_ref()?;
    Some(geometry::vector_of(algebra, gravity))
}

/// A body's masses and where they are.
pub(super) fn masses<'m>(algebra: &mut Algebra<'m>, body: usize) -> Vec<(Ex<'m>, Vn<'m>)> {
    let masses = algebra.mechanism.bodies[body].masses.iter();
    masses
        .map(|(mass, at)| {
            let mass = algebra.translate_number(mass);
            (mass, geometry::vector_of(algebra, at))
        })
        .collect()
}
