//! The wrench that the bodies beyond a joint carry, and the reactions of cut joints, which need
//! each other.
//!
//! The reactions of cut joints count if one of the two bodies hangs on that body and the other does
//! not.

use linkage_symbolic::{Ex, Vector, Vn};

use crate::algebra::{Algebra, cofactors};
use crate::forces::context::Memo;
use crate::forces::loading::Loading;
use crate::forces::multibody::Multibody;
use crate::forces::system::{Axial, Equation, LARGEST_BLOCK, System, Unknown};
use crate::forces::wrench::{Carried, Wrench};
use crate::forces::{assemble, body_wrench, cut_joints, links, loads};
use crate::model::Mechanism;

/// The part of a reaction that holds a link against its own loads: `-M perp(V) / V^2`, in space
/// `(V x M) / V^2`.
pub(super) fn across_link<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    axial: &Axial,
) -> Wrench<'m> {
    // Without the reaction itself.
    let loads = wrench(
        algebra,
        bodies,
        memo,
        loading,
        axial.link,
        &[axial.joint],
        &[],
    );
    let v = links::link_vector(bodies, axial);
    let square = v.square();
    let across = if bodies.geometry.is_plane() {
        loads.moment.at(0) * Vn::from(Vector([v.at(1), -v.at(0)]))
    } else {
        v.moment_of(loads.moment)
    };
    let force = across / square;
    Wrench {
        force: if cut_joints::joins(algebra.mechanism, &bodies.tree, axial.joint, axial.link) < 0 {
            -force
        } else {
            force
        },
        ..Wrench::zero(algebra.graph, &bodies.geometry)
    }
}

/// The reaction of a cut joint on its body; unknowns in `open` count as 0.
pub(super) fn closing_wrench<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    joint: usize,
    open: &[usize],
) -> Wrench<'m> {
    let system = assemble::system(algebra, bodies, memo);
    let mut sum = match system.axial.iter().find(|link| link.joint == joint) {
        Some(axial) => across_link(algebra, bodies, memo, loading, axial),
        None => Wrench::zero(algebra.graph, &bodies.geometry),
    };
    for (index, unknown) in system.unknowns.iter().enumerate() {
        let Unknown::Reaction(component) = unknown else {
            continue;
        };
        if component.joint != joint || open.contains(&index) {
            continue;
        }
        let part = solved(algebra, bodies, memo, loading, index) * component.direction;
        if component.is_moment {
            sum.moment = sum.moment + part
        } else {
            sum.force = sum.force + part
        }
    }
    sum
}

/// The value of an unknown.
pub(super) fn solved<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    unknown: usize,
) -> Ex<'m> {
    if let Some(&known) = loads::case(algebra, bodies, memo, loading)
        .solved
        .get(&unknown)
    {
        return known;
    }
    let system = assemble::system(algebra, bodies, memo);
    let equation = system.matching.equation_of[unknown];
    let block = system
        .blocks
        .iter()
        .find(|block| equation.is_some_and(|e| block.contains(&e)));
    let Some(block) = block.filter(|block| block.len() <= LARGEST_BLOCK) else {
        // Reported by the check of bodies and joints.
        return algebra.graph.number(f64::NAN);
    };
    let found_here = system.unknowns_of(block);
    let right: Vec<Ex> = block
        .iter()
        .map(|&equation| {
            -known(
                algebra,
                bodies,
                memo,
                loading,
                &system,
                equation,
                &found_here,
            )
        })
        .collect();
    let matrix = system.matrix_of(block);
    let known = bodies.loop_values.determinant(block);
    let determinant = known.unwrap_or_else(|| cofactors::determinant(algebra.graph, &matrix));
    let numerators = cofactors::cofactor_products(algebra.graph, &matrix, &right);
    // The determinant is known long before the loads.
    let factor = 1.0 / determinant;
    for (&unknown, numerator) in found_here.iter().zip(numerators) {
        let value = numerator * factor;
        loads::case(algebra, bodies, memo, loading)
            .solved
            .insert(unknown, value);
    }
    loads::case(algebra, bodies, memo, loading).solved[&unknown]
}

/// The part of an equation that is known before its block is solved.
pub(super) fn known<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    system: &System<'m>,
    equation: usize,
    block: &[usize],
) -> Ex<'m> {
    let contained = &system.incidence[equation];
    let is_open = |unknown: &usize| !contained.contains(unknown) || block.contains(unknown);
    let open: Vec<usize> = (0..system.unknowns.len()).filter(is_open).collect();
    match &system.equations[equation] {
        Equation::Released(component) => {
            let wrench = closing_wrench(algebra, bodies, memo, loading, component.joint, &open);
            component.direction.dot(if component.is_moment {
                wrench.moment
            } else {
                wrench.force
            })
        }
        Equation::Motion(way) => {
            wrench(algebra, bodies, memo, loading, way.body, &[], &open).along(way)
        }
    }
}

/// The wrench of a body and its descendants. Cut joints in `inside` join two of them and cancel;
/// the unknowns in `open` count as 0.
pub(super) fn wrench<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    memo: &mut Memo<'m>,
    loading: &Loading,
    body: usize,
    inside: &[usize],
    open: &[usize],
) -> Wrench<'m> {
    let closing = bodies.tree.closing.iter().copied();
    let (inside, crossing): (Vec<usize>, Vec<usize>) = closing
        .filter(|&joint| {
            cut_joints::is_inside(algebra.mechanism, &bodies.tree, joint, body)
                || cut_joints::joins(algebra.mechanism, &bodies.tree, joint, body) != 0
        })
        .partition(|&joint| {
            cut_joints::is_inside(algebra.mechanism, &bodies.tree, joint, body)
                || inside.contains(&joint)
        });
    let system = assemble::system(algebra, bodies, memo);
    let touches = |unknown: &&usize| match &system.unknowns[**unknown] {
        Unknown::Reaction(component) => crossing.contains(&component.joint),
        Unknown::Spin { .. } => false,
        Unknown::Tie(tie) => {
            let mut tied_bodies = tie.couples.iter();
            tied_bodies.any(|(tied, _)| bodies.tree.hangs_on(Some(*tied), body))
        }
    };
    let open: Vec<usize> = open.iter().filter(touches).copied().collect();
    let carried = Carried { body, inside, open };
    if let Some(&known) = loads::case(algebra, bodies, memo, loading)
        .wrenches
        .get(&carried)
    {
        return known;
    }
    let Carried { inside, open, .. } = &carried;
    let mut sum = body_wrench::own_wrench(algebra, bodies, memo, loading, body);
    for joint in crossing {
        let sign = cut_joints::at_ends(algebra.mechanism, joint, body);
        if sign == 0 {
            continue;
        }
        let reaction = closing_wrench(algebra, bodies, memo, loading, joint, open);
        let reaction = if sign < 0 { -reaction } else { reaction };
        let point = bodies.geometry.points[joint];
        sum = sum + reaction.with_arm(bodies.arm(body, point));
    }
    for (index, unknown) in system.unknowns.iter().enumerate() {
        let Unknown::Tie(tie) = unknown else { continue };
        let couple = tie.couples.iter().find(|(tied, _)| *tied == body);
        if let Some(&(_, share)) = couple.filter(|_| !open.contains(&index)) {
            let couple = Vector([share * solved(algebra, bodies, memo, loading, index)]);
            sum.moment = sum.moment + couple.into();
        }
    }
    for child in bodies.tree.children[body].clone() {
        let mut beyond = wrench(algebra, bodies, memo, loading, child, inside, open);
        if open.is_empty() && is_balanced(algebra.mechanism, bodies, &system, child, inside) {
            beyond.moment = bodies.geometry.zero_turn(algebra.graph);
        }
        let point = bodies.geometry.origins[child];
        sum = sum + beyond.with_arm(bodies.arm(body, point));
    }
    loads::case(algebra, bodies, memo, loading)
        .wrenches
        .insert(carried, sum);
    sum
}

/// True if equilibrium leaves no moment about a body's own pin in the plane: the reactions of all
/// cut joints beyond it count, and were found by that.
pub(super) fn is_balanced<'m>(
    mechanism: &Mechanism,
    bodies: &Multibody<'m>,
    system: &System<'m>,
    body: usize,
    inside: &[usize],
) -> bool {
    let mut ways = system.equations.iter().filter_map(Equation::motion);
    bodies.geometry.is_plane()
        && ways.any(|way| way.body == body && !way.slides)
        && inside
            .iter()
            .all(|&joint| cut_joints::joins(mechanism, &bodies.tree, joint, body) == 0)
}
