//! Which motions are driven, where what they depend on does not tell: as many equations are needed as there are unknowns.

use super::Mechanics;
use super::system::{Equation, System};
use crate::forces::motion;
use crate::forces::system;

/// A motion that the loops make steady may be driven, too: the length of a leg to a point that is an unknown. As long as motions
/// lack a reaction, such ones are taken for driven.
pub(super) fn drive_steady<'m>(mechanics: &mut Mechanics<'_, 'm>, system: &mut System<'m>) {
    for (body, slides) in mechanics.forces.steady.clone() {
        let is_this = |equation: &Equation| {
            let way = equation.way();
            way.is_some_and(|way| (way.body, way.slides) == (body, slides))
        };
        let place = system.equations.iter().position(is_this);
        let Some(place) = place.filter(|_| system.found() < system.equations.len()) else {
            continue;
        };
        let before = system.clone();
        let removed = system.equations.remove(place);
        system.incidence.remove(place);
        system.matrix.remove(place);
        system.order();
        match removed {
            Equation::Motion(way) if system.found() == before.found() => {
                system.driven.push(way);
            }
            Equation::Motion(_) | Equation::Released(_) => *system = before,
        }
    }
}

/// A motion that depends on inputs alone need not be driven: the block of a Scotch yoke turns against the crank by minus its angle, and the
/// yoke's slot holds it. As long as a reaction lacks an equation, such motions are taken for held, those farthest from the frame first.
pub(super) fn release_held<'m>(mechanics: &mut Mechanics<'_, 'm>, system: &mut System<'m>) {
    let mut candidates = system.driven.clone();
    candidates.sort_by_key(|way| (mechanics.forces.tree.depth(way.body), way.body));
    while system.lacks_equations() && system.driven.len() > motion::drives(mechanics) {
        let Some(way) = candidates.pop() else { return };
        let before = system.clone();
        system::add(mechanics, system, Equation::Motion(way));
        system.order();
        match system.found() > before.found() {
            true => system.driven.retain(|own| *own != way),
            false => *system = before,
        }
    }
}
