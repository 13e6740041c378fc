//! Work of loads in the motion of one input.

use linkage_symbolic::Ex;

use crate::algebra::Algebra;
use crate::forces::body_loads::Loads;
use crate::forces::motion;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, By};

/// The work of loads per motion of an input: `sum F . p' + sum M . w`.
pub(super) fn work<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    loads: &Loads<'m>,
    input: usize,
) -> Ex<'m> {
    let input = By::Input(input);
    let mut work = algebra.zero();
    for (body, body_loads) in loads.bodies.iter().enumerate() {
        for load in &body_loads.forces {
            let moved = match load.mass {
                Some(_) => motion::moved(algebra, load.point, input),
                None => motion::velocity_of(algebra, bodies, turns, Some(body), load.point, input),
            };
            work += load.force.dot(moved);
        }
        for couple in &body_loads.couples {
            work += couple.dot(motion::turn(algebra, bodies, turns, Some(body), input));
        }
    }
    work
}
