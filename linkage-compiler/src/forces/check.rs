//! Do bodies and joints fit the motion? Compared on numbers, at the reference and some other positions.

use linkage_symbolic::NodeId;

use crate::algebra::{Algebra, Nominal};
use crate::diagnostic::{Diagnostics, Origins};
use crate::formulate::{Reference, Words, numbers};
use crate::model::{Dimension, EvaluatorDef, JointKind, Mechanism, OriginId};

use super::ends::{end_body, end_name, end_origin};
use super::freedom::Way;
use super::geometry::{slides_along, turns_about};
use super::system::Equation;
use super::{Forces, Mechanics};

/// Velocities that differ by a smaller share are equal.
const EQUAL: f64 = 1e-7;

/// Places in the declared ranges beside the reference, as shares.
const PLACES: [f64; 4] = [0.137, 0.391, 0.642, 0.871];

/// Two velocities that must be equal.
pub(super) struct Pair {
    input: usize,
    first: Vec<NodeId>,
    second: Vec<NodeId>,
    /// Along this direction they may differ.
    except: Option<Vec<NodeId>>,
    is_turn: bool,
    what: What,
}

#[derive(Clone, Copy)]
pub(super) enum What {
    Joint(usize),
    Mass(usize, usize),
    /// Where a spring or damper begins (0) or ends (1).
    End(usize, usize),
}

/// Reports joints whose bodies move apart, centres of mass and ends of springs that leave their bodies, motions that nothing holds and reactions
/// that nothing tells.
pub(crate) fn check(
    algebra: &mut Algebra,
    forces: &mut Forces,
    (reference, nominal): (&Reference, &Nominal),
    origins: &Origins,
    diagnostics: &mut Diagnostics,
) {
    let mechanism = algebra.mechanism;
    if mechanism.bodies.is_empty() {
        return;
    }
    let mut mechanics = forces.at(algebra, &[], false);
    let pairs = mechanics.pairs();
    let before = diagnostics.len();
    let mut reported: Vec<OriginId> = Vec::new();
    let places = places(nominal, mechanism, reference.longest);
    for inputs in &places {
        for pair in &pairs {
            let origin = pair.what.origin(mechanism);
            if reported.contains(&origin) {
                continue;
            }
            let Some(message) = mechanics.difference(pair, reference, inputs) else {
                continue;
            };
            reported.push(origin);
            diagnostics.error(origins.span(origin), message);
        }
    }
    let mut each = places.iter();
    each.find(|inputs| mechanics.check_lengths((reference, inputs), origins, diagnostics));
    mechanics.look_at_motion(reference, &places);
    if diagnostics.len() == before
        && mechanism
            .evaluators
            .iter()
            .any(EvaluatorDef::asks_for_reactions)
    {
        mechanics.check_system(origins, diagnostics);
    }
}

/// The reference and other positions.
fn places(nominal: &Nominal, mechanism: &Mechanism, longest: f64) -> Vec<Vec<f64>> {
    let mut places = vec![nominal.inputs.clone()];
    for share in PLACES {
        let inputs = nominal.inputs.iter().zip(&nominal.ranges).enumerate();
        let place = inputs.map(|(k, (&at, range))| match range {
            // Near the reference, where it surely closes.
            None => {
                let unit = match mechanism.inputs[k].dimension.fits(Dimension::LENGTH) {
                    true => longest,
                    false => 1.0,
                };
                at + 0.02 * unit * (share * (k + 1) as f64).fract()
            }
            // Several inputs do not move in step.
            Some((low, high)) => low + (share * (k + 1) as f64).fract() * (high - low),
        });
        places.push(place.collect());
    }
    places
}

impl What {
    fn origin(self, mechanism: &Mechanism) -> OriginId {
        match self {
            What::Joint(joint) => mechanism.joints[joint].origin,
            What::Mass(body, mass) => mechanism.bodies[body].masses[mass].1.origin,
            What::End(element, end) => end_origin(mechanism, element, end),
        }
    }
}

impl Mechanics<'_, '_> {
    /// All that must move alike.
    fn pairs(&mut self) -> Vec<Pair> {
        let mechanism = self.algebra.mechanism;
        let mut pairs = Vec::new();
        for input in 0..self.drives() {
            for (joint, declared) in mechanism.joints.iter().enumerate() {
                let what = What::Joint(joint);
                let point = self.forces.geometry.points[joint].clone();
                let direction = self.forces.geometry.directions[joint].clone();
                let (body, on) = (Some(declared.body), declared.on);
                let slides = slides_along(declared.kind);
                pairs.push(Pair {
                    input,
                    first: self.velocity_of(body, &point, input),
                    second: self.velocity_of(on, &point, input),
                    except: direction.clone().filter(|_| slides),
                    is_turn: false,
                    what,
                });
                let turns = turns_about(declared.kind);
                let free = declared.kind == JointKind::Ball || turns && direction.is_none();
                if !free {
                    pairs.push(Pair {
                        input,
                        first: self.turn(body, input),
                        second: self.turn(on, input),
                        except: direction.filter(|_| turns),
                        is_turn: true,
                        what,
                    });
                }
            }
            for body in 0..mechanism.bodies.len() {
                for (mass, (_, point)) in self.masses(body).into_iter().enumerate() {
                    pairs.push(self.stays(Some(body), &point, input, What::Mass(body, mass)));
                }
            }
            pairs.extend(self.ends_of_elements(input));
        }
        pairs
    }

    /// A point that stays on its body.
    pub(super) fn stays(
        &mut self,
        body: Option<usize>,
        point: &[NodeId],
        input: usize,
        what: What,
    ) -> Pair {
        let moved = point.iter().map(|&x| self.algebra.by_input(x, input));
        Pair {
            input,
            first: moved.collect(),
            second: self.velocity_of(body, point, input),
            except: None,
            is_turn: false,
            what,
        }
    }

    /// What is wrong with a pair at a position.
    fn difference(&self, pair: &Pair, reference: &Reference, inputs: &[f64]) -> Option<String> {
        let graph = &self.algebra.graph;
        let evaluate = |v: &[NodeId]| reference.machine.evaluate(graph, v, inputs);
        let (first, second) = (evaluate(&pair.first), evaluate(&pair.second));
        let mut apart: Vec<f64> = first.iter().zip(&second).map(|(a, b)| a - b).collect();
        if let Some(except) = &pair.except {
            let direction = evaluate(except);
            let along: f64 = apart.iter().zip(&direction).map(|(x, d)| x * d).sum();
            apart
                .iter_mut()
                .zip(&direction)
                .for_each(|(x, d)| *x -= along * d);
        }
        let size = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
        let unit = if pair.is_turn { 1.0 } else { reference.longest };
        let scale = size(&first) + size(&second) + 1e-3 * unit;
        // Where the mechanism does not close there is nothing to compare.
        (size(&apart) > EQUAL * scale).then(|| self.apart(pair, &first, &second, inputs))
    }

    fn apart(&self, pair: &Pair, first: &[f64], second: &[f64], inputs: &[f64]) -> String {
        let mechanism = self.algebra.mechanism;
        let at = place(mechanism, inputs);
        let by = &mechanism.inputs[pair.input].name;
        let vector = |v: &[f64]| match v {
            [x] => numbers(&[*x])[0].clone(),
            _ => format!("({})", numbers(v).join(", ")),
        };
        let (a, b) = (vector(first), vector(second));
        match pair.what {
            What::Joint(joint) => {
                let declared = &mechanism.joints[joint];
                let name = joint_name(mechanism, joint);
                let body = body_name(mechanism, Some(declared.body));
                let on = body_name(mechanism, declared.on);
                match pair.is_turn {
                    true => format!(
                        "{name} cannot hold: {at}{body} turns by {a} per unit of `{by}`, {on} by {b}{}\n\
                         help: check what both bodies turn with, and the kind of the joint",
                        match &pair.except {
                            Some(_) => ", and not about the joint's axis alone",
                            None => "",
                        }
                    ),
                    false => format!(
                        "{name} comes apart: {at}its point moves by {a} per unit of `{by}` with {body}, by {b} with {on}{}\n\
                         help: check the point, the two bodies, and what they turn with",
                        match &pair.except {
                            Some(_) => ", which differ across the guide, too",
                            None => "",
                        }
                    ),
                }
            }
            What::Mass(body, _) => format!(
                "the mass leaves {}: {at}its point moves by {a} per unit of `{by}`, as a point of the body by {b}\n\
                 help: write the point from the body's origin and with what the body turns with",
                body_name(mechanism, Some(body)),
            ),
            What::End(element, end) => format!(
                "{} leaves {}: {at}its point moves by {a} per unit of `{by}`, as a point of the body by {b}\n\
                 help: check the point and its body",
                end_name(mechanism, element),
                body_name(mechanism, end_body(mechanism, element, end)),
            ),
        }
    }

    /// Are there as many reactions as motions to be held, and is each in its place?
    fn check_system(&mut self, origins: &Origins, diagnostics: &mut Diagnostics) {
        let mechanism = self.algebra.mechanism;
        let system = self.system();
        for (equation, found) in system.matching.coordinates_of.iter().enumerate() {
            let Equation::Motion(way) = &system.equations[equation] else {
                continue;
            };
            if found.is_empty() {
                let body = &mechanism.bodies[way.body];
                diagnostics.error(
                    origins.span(body.origin),
                    format!(
                        "nothing holds {}: reactions cannot be found\n\
                         help: declare the joint that closes its loop, like `pin NAME = {} on BODY at POINT;`",
                        against(mechanism, way),
                        body.name
                    ),
                );
            }
        }
        for way in &system.driven {
            if self.is_moved(way) || self.is_rod(way.body) {
                continue;
            }
            diagnostics.error(
                origins.span(mechanism.bodies[way.body].origin),
                format!(
                    "nothing holds {}, where nothing moves it: reactions cannot be found\n\
                     help: choose a kind of joint that holds it",
                    against(mechanism, way)
                ),
            );
        }
        let mut joints: Vec<usize> = Vec::new();
        for (unknown, equation) in system.matching.equation_of.iter().enumerate() {
            let joint = system.unknowns[unknown].joint();
            let joint = joint.filter(|joint| equation.is_none() && !joints.contains(joint));
            if let Some(joint) = joint {
                joints.push(joint);
                let name = joint_name(mechanism, joint);
                diagnostics.error(
                    origins.span(mechanism.joints[joint].origin),
                    format!(
                        "equilibrium does not tell the reaction of {name}: there are {} components of reactions in the joints that \
                         close loops, and {} motions that they hold\n\
                         help: leave out a joint that holds what others hold already, or let one of them move more freely",
                        system.unknowns.len(),
                        system.equations.len(),
                    ),
                );
            }
        }
        if let (true, Some(block)) = (joints.is_empty(), system.too_large().next()) {
            let joints = block
                .iter()
                .flat_map(|&e| &system.matching.coordinates_of[e]);
            let mut joints: Vec<usize> =
                joints.filter_map(|&u| system.unknowns[u].joint()).collect();
            joints.dedup();
            let first = joints.first();
            let origin = first.map_or(mechanism.origin, |&joint| mechanism.joints[joint].origin);
            diagnostics.error(
                origins.span(origin),
                format!(
                    "the reactions of {} can only be found together: {} equations, more than {}\n\
                     help: ask for the torque and the energies only",
                    joints
                        .iter()
                        .map(|&j| joint_name(mechanism, j))
                        .collect::<Vec<_>>()
                        .join(", "),
                    block.len(),
                    super::system::LARGEST_BLOCK,
                ),
            );
        }
    }

    /// Whether an input moves a body in this way.
    fn is_moved(&mut self, way: &Way) -> bool {
        (0..self.drives()).any(|input| {
            let rate = self.driven_rate(way, input);
            !self.algebra.vanishes(rate)
        })
    }
}

/// `at phi = 30deg `; nothing without inputs.
pub(super) fn place(mechanism: &Mechanism, inputs: &[f64]) -> String {
    let all: Vec<usize> = (0..inputs.len()).collect();
    match inputs.len() {
        0 => String::new(),
        _ => format!("at {} ", Words::new(mechanism).inputs(inputs, &all)),
    }
}

/// The motion that something should hold.
fn against(mechanism: &Mechanism, way: &Way) -> String {
    let body = &mechanism.bodies[way.body];
    let how = if way.slides {
        "sliding along"
    } else {
        "turning in"
    };
    let joint = joint_name(mechanism, body.joint);
    format!("`{}` against {how} {joint}", body.name)
}

pub(super) fn joint_name(mechanism: &Mechanism, joint: usize) -> String {
    let declared = &mechanism.joints[joint];
    match &declared.name {
        Some(name) => format!("`{name}`"),
        None => format!("the joint of `{}`", mechanism.bodies[declared.body].name),
    }
}

fn body_name(mechanism: &Mechanism, body: Option<usize>) -> String {
    match body {
        Some(body) => format!("`{}`", mechanism.bodies[body].name),
        None => "the frame".to_owned(),
    }
}
