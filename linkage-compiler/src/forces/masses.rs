//! The masses of bodies and the field of gravity.

use crate::algebra::Translate;
use crate::forces::context::Mechanics;
use crate::forces::geometry;
use linkage_symbolic::Ex;
use linkage_symbolic::Vn;

/// The field of gravity, if there is one.
pub(super) fn gravity<'m>(mechanics: &mut Mechanics<'_, 'm>) -> Option<Vn<'m>> {
    let gravity = mechanics.algebra.mechanism.gravity.as_ref()?;
    Some(geometry::vector_of(mechanics.algebra, gravity))
}

/// A body's masses and where they are.
pub(super) fn masses<'m>(mechanics: &mut Mechanics<'_, 'm>, body: usize) -> Vec<(Ex<'m>, Vn<'m>)> {
    let masses = mechanics.algebra.mechanism.bodies[body].masses.iter();
    masses
        .map(|(mass, at)| {
            let mass = mechanics.algebra.translate_number(mass);
            (mass, geometry::vector_of(mechanics.algebra, at))
        })
        .collect()
}
