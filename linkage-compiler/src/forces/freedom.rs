//! The motions of the tree's joints that nothing drives: in each, no work may be done.
//!
//! A joint is driven if its motion depends on inputs alone: the drive holds it, with a couple (or a
//! force along the guide) that is no unknown here. Gears tie the turns of several bodies, by
//! couples that are unknowns of their own.

use linkage_core::numeric::rank::combination;
use linkage_symbolic::{Ex, Graph, Vector};

use crate::algebra::{Algebra, derivatives::partial};
use crate::forces::geometry::Geometry;
use crate::forces::joint_motion::{JointMotion, Motions, Tie};
use crate::forces::motion;
use crate::forces::multibody::Multibody;
use crate::forces::speeds::{AngularVelocities, By};
use crate::model::{Mechanism, Rotation, Variable};

/// Rates of turns that differ by less are equal. They are ratios of gears, numbers near 1 that
/// rounding alone changes.
const RATIO: f64 = 1e-9;

/// All motions. `held` is the number of them that reactions of cut joints can hold in the plane:
/// the others are tied by gears.
pub(super) fn motions<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    held: usize,
) -> Motions<'m> {
    let unknowns = unknown_variables(algebra);
    let mut motions = Motions::default();
    for body in bodies.tree.order.clone() {
        for way in ways(algebra.mechanism, algebra.graph, &bodies.geometry, body) {
            let is_held = unknowns.iter().all(|&unknown| {
                let rate = relative_rate(algebra, bodies, turns, &way, unknown);
                algebra.vanishes(rate)
            });
            if is_held {
                motions.driven.push(way)
            } else {
                motions.free.push(way)
            }
        }
    }
    if bodies.geometry.is_plane() && motions.free.len() > held {
        // A drive whose motion depends on an unknown is among the free motions and is no gear.
        let undriven = undriven_inputs(algebra, bodies, turns, &motions.driven).len();
        let count = (motions.free.len() - held).saturating_sub(undriven);
        motions.ties = ties(algebra, bodies, turns, &motions.free, count, &unknowns);
    }
    motions
}

/// The inputs that move none of these joints, like the length of a cylinder whose rod is pinned to
/// a point of another link.
pub(super) fn undriven_inputs<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    driven: &[JointMotion<'m>],
) -> Vec<usize> {
    let inputs = 0..algebra.mechanism.inputs.len();
    let undriven = inputs.filter(|&input| {
        !driven.iter().any(|way| {
            let rate = relative_rate(algebra, bodies, turns, way, By::Input(input));
            !algebra.vanishes(rate)
        })
    });
    undriven.collect()
}

/// Up to `count` turns that are determined by others, all of them against the frame. Bodies that
/// turn as another because of their joints are no case for gears.
fn ties<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    free: &[JointMotion<'m>],
    count: usize,
    unknowns: &[By],
) -> Vec<Tie> {
    let alike = alike(algebra.mechanism);
    let mut seen = vec![alike[bodies.tree.parent.len()]];
    let mut basis: Vec<(usize, Vec<f64>)> = Vec::new();
    let mut ties = Vec::new();
    for way in free.iter().filter(|way| !way.slides) {
        if ties.len() == count || seen.contains(&alike[way.body]) {
            continue;
        }
        seen.push(alike[way.body]);
        // No gear turns a body that never turns: a joint that holds it is missing.
        if never_turns(algebra, bodies, turns, way.body, unknowns) {
            continue;
        }
        let Some(rates) = constant_rates(algebra, bodies, turns, way.body, unknowns) else {
            continue;
        };
        let known: Vec<&[f64]> = basis.iter().map(|(_, rates)| &rates[..]).collect();
        let Some(shares) = combination(&known, &rates, RATIO) else {
            basis.push((way.body, rates));
            continue;
        };
        let others = basis.iter().zip(shares).filter(|(_, share)| *share != 0.0);
        let others = others.map(|((body, _), share)| (*body, -share));
        ties.push(Tie {
            couples: std::iter::once((way.body, 1.0)).chain(others).collect(),
        });
    }
    ties
}

/// True if a body of the plane turns with no unknown and no input.
fn never_turns<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    body: usize,
    unknowns: &[By],
) -> bool {
    let inputs = 0..algebra.mechanism.inputs.len();
    let inputs: Vec<By> = inputs
        .map(|input| By::Alone(algebra.variable(Variable::Input(input))))
        .collect();
    let mut variables = unknowns.iter().chain(&inputs);
    variables.all(|&by| {
        motion::turn(algebra, bodies, turns, Some(body), by)
            .at(0)
            .is_zero()
    })
}

/// For each body and, last, for the frame: a number that those share which slides and `fixed`
/// joints let turn alike only.
fn alike(mechanism: &Mechanism) -> Vec<usize> {
    let frame = mechanism.bodies.len();
    let mut alike: Vec<usize> = (0..=frame).collect();
    for joint in &mechanism.joints {
        if joint.kind.rotation() == Rotation::Not {
            let [first, other] = [joint.body, joint.on.unwrap_or(frame)].map(|k| alike[k]);
            for number in alike.iter_mut().filter(|number| **number == other) {
                *number = first;
            }
        }
    }
    alike
}

/// The rates at which a body of the plane turns with each unknown, if these are constants.
fn constant_rates<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    body: usize,
    unknowns: &[By],
) -> Option<Vec<f64>> {
    let rates = unknowns.iter().map(|&unknown| {
        let turn = motion::turn(algebra, bodies, turns, Some(body), unknown);
        turn.at(0).constant_value()
    });
    rates.collect()
}

/// The rate at which tied bodies would separate with an input if the unknowns stayed.
pub(super) fn tie_rate<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    tie: &Tie,
    input: usize,
) -> Ex<'m> {
    let input = By::Alone(algebra.variable(Variable::Input(input)));
    let couples = tie.couples.iter();
    couples.fold(algebra.zero(), |sum, &(body, share)| {
        sum + share * motion::turn(algebra, bodies, turns, Some(body), input).at(0)
    })
}

/// The ways in which a body's own joint lets it move.
pub(super) fn ways<'m>(
    mechanism: &Mechanism,
    graph: &'m Graph,
    geometry: &Geometry<'m>,
    body: usize,
) -> Vec<JointMotion<'m>> {
    let joint = mechanism.bodies[body].joint;
    let kind = mechanism.joints[joint].kind;
    let direction = geometry.directions[joint];
    let way = |slides, direction| JointMotion {
        body,
        slides,
        direction,
    };
    let mut ways = Vec::new();
    if kind.slides() {
        ways.extend(direction.map(|guide| way(true, guide)));
    }
    match kind.rotation() {
        Rotation::Not => {}
        Rotation::AboutAxis => {
            let in_plane = Vector([graph.number(1.0)]).into();
            let axis = direction.filter(|_| !geometry.is_plane());
            ways.push(way(false, axis.unwrap_or(in_plane)));
        }
        Rotation::Freely => {
            let axes = geometry.units(graph).into_iter();
            ways.extend(axes.map(|axis| way(false, axis)));
        }
    }
    ways
}

/// The rate at which a body moves in its own joint.
pub(super) fn relative_rate<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    way: &JointMotion<'m>,
    by: By,
) -> Ex<'m> {
    let on = bodies.tree.parent[way.body];
    let relative = if way.slides {
        let origin = bodies.geometry.origins[way.body];
        motion::moved(algebra, origin, by)
            - motion::velocity_of(algebra, bodies, turns, on, origin, by)
    } else {
        motion::turn(algebra, bodies, turns, Some(way.body), by)
            - motion::turn(algebra, bodies, turns, on, by)
    };
    way.direction.dot(relative)
}

/// All unknowns, each changing alone.
fn unknown_variables(algebra: &mut Algebra) -> Vec<By> {
    let groups = algebra.solutions.groups.iter();
    let counts: Vec<usize> = groups.map(|group| group.jacobian.len()).collect();
    let mut variables = Vec::new();
    for (group, count) in counts.into_iter().enumerate() {
        for position in 0..count {
            variables.push(By::Alone(partial::unknown_variable(
                algebra, group, position,
            )));
        }
    }
    variables
}
