//! The motions that are driven, if their dependence does not determine it: as many equations are
//! needed as there are unknowns.

use linkage_symbolic::Graph;

use crate::forces::equations;
use crate::forces::multibody::Multibody;
use crate::forces::system::{Equation, System};
use crate::model::Mechanism;

/// A motion that the loops make steady may be driven, too: the length of a leg to a point that is
/// an unknown. As long as motions lack a reaction, such ones are taken for driven.
pub(super) fn drive_steady<'m>(steady: &[(usize, bool)], system: &mut System<'m>) {
    for (body, slides) in steady.iter().copied() {
        let is_this = |equation: &Equation| {
            let way = equation.motion();
            way.is_some_and(|way| (way.body, way.slides) == (body, slides))
        };
        let index = system.equations.iter().position(is_this);
        let Some(index) = index.filter(|_| system.lacks_unknowns()) else {
            continue;
        };
        let before = system.clone();
        let removed = system.equations.remove(index);
        system.incidence.remove(index);
        system.matrix.remove(index);
        system.order();
        match removed {
            Equation::Motion(way) if system.found() == before.found() => {
                system.driven.push(way);
            }
            Equation::Motion(_) | Equation::Released(_) => *system = before,
        }
    }
}

/// A motion that depends on inputs alone need not be driven: the block of a Scotch yoke turns
/// against the crank by minus its angle, and the yoke's slot holds it. As long as a reaction lacks
/// an equation, such motions are taken for held, those farthest from the frame first.
pub(super) fn release_held<'m>(
    mechanism: &Mechanism,
    graph: &'m Graph,
    bodies: &Multibody<'m>,
    system: &mut System<'m>,
) {
    let mut candidates = system.driven.clone();
    candidates.sort_by_key(|way| (bodies.tree.depth(way.body), way.body));
    while system.lacks_equations() && system.driven.len() > mechanism.inputs.len() {
        let Some(way) = candidates.pop() else { return };
        let before = system.clone();
        equations::add(mechanism, graph, bodies, system, Equation::Motion(way));
        system.order();
        if system.found() > before.found() {
            system.driven.retain(|driven| *driven != way)
        } else {
            *system = before
        }
    }
}
