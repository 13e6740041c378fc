//! Bodies of the plane that turn about a pin on the frame: their inertia is one number, known before
//! the call.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, NodeId, SymbolId, Vector, Vn, substitute};

use crate::algebra::Algebra;
use crate::forces::multibody::Multibody;
use crate::forces::{inertia, masses};

/// The moment of inertia of a body about its pin on the frame. `None` for a body with another joint,
/// or if it is not known before the call.
pub(super) fn inertia_about_pin<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    body: usize,
) -> Option<Ex<'m>> {
    if !bodies.turns_about_fixed_pin(algebra.mechanism, body) {
        return None;
    }
    let turn = Vector([algebra.one()]).into();
    let mut sum = inertia::inertia_times(algebra, &bodies.geometry, body, None, turn).at(0);
    for (mass, point) in masses::masses(algebra, body) {
        sum += mass * constant_square(algebra, bodies.arm(body, point))?;
    }
    sum.is_fixed().then_some(sum)
}

/// The square of an arm that turns with its body, which has checked ends. It is the same at all
/// angles, so it is that at the angle 0 if the arm depends on one unknown angle alone.
fn constant_square<'m>(algebra: &Algebra<'m>, arm: Vn<'m>) -> Option<Ex<'m>> {
    let square = arm.square();
    if square.is_fixed() {
        return Some(square);
    }
    let (graph, ids) = (algebra.graph, arm.iter().map(Ex::id));
    let symbols = graph.symbols_of(&ids.collect::<Vec<NodeId>>());
    let is_in_arm = |symbol: &SymbolId| symbols.contains(symbol);
    let angles = algebra.names.angles.iter();
    let angles: Vec<_> = angles
        .filter(|angle| angle.symbols().iter().any(is_in_arm))
        .collect();
    let [angle] = angles[..] else { return None };
    let mut at_zero = Map::default();
    at_zero.insert(angle.cos, algebra.one());
    at_zero.insert(angle.sin, algebra.zero());
    let components: Vec<Ex> = arm.iter().collect();
    let components = substitute(&components, &at_zero).into_iter();
    let square = components.fold(algebra.zero(), |sum, x| sum + x.square());
    square.is_fixed().then_some(square)
}
