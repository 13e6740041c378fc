//! Do bodies and joints fit the motion? Velocities compared on numbers.

use linkage_symbolic::NodeId;

use crate::diagnostic::{Diagnostics, Origins};
use crate::formulate::{Reference, numbers};
use crate::model::{Between, ElementKind, Expr, JointKind, Mechanism, OriginId};

use super::Mechanics;
use super::ends::place;
use super::geometry::{slides_along, turns_about};
use super::print::{body_name, joint_name};

/// Velocities that differ by a smaller share are equal.
const EQUAL: f64 = 1e-7;

/// Two velocities that must be equal.
struct Pair {
    input: usize,
    first: Vec<NodeId>,
    second: Vec<NodeId>,
    /// Along this direction they may differ.
    except: Option<Vec<NodeId>>,
    is_turn: bool,
    what: What,
}

#[derive(Clone, Copy)]
enum What {
    Joint(usize),
    /// A point that must stay with a body: what leaves it, and where it is written.
    Point(&'static str, Option<usize>, OriginId),
}

impl What {
    fn origin(self, mechanism: &Mechanism) -> OriginId {
        match self {
            What::Joint(joint) => mechanism.joints[joint].origin,
            What::Point(_, _, origin) => origin,
        }
    }
}

impl Mechanics<'_, '_> {
    /// Reports each joint and point that does not move as declared, once.
    pub(super) fn check_fit(
        &mut self,
        reference: &Reference,
        places: &[Vec<f64>],
        origins: &Origins,
        diagnostics: &mut Diagnostics,
    ) {
        let mechanism = self.algebra.mechanism;
        let pairs = self.pairs();
        let mut reported: Vec<OriginId> = Vec::new();
        for inputs in places {
            for pair in &pairs {
                let origin = pair.what.origin(mechanism);
                if reported.contains(&origin) {
                    continue;
                }
                let Some(message) = self.difference(pair, reference, inputs) else {
                    continue;
                };
                reported.push(origin);
                diagnostics.error(origins.span(origin), message);
            }
        }
    }

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
            for (what, body, at) in carried_points(mechanism) {
                let point = self.algebra.vector_of(at);
                let moved = point.iter().map(|&x| self.algebra.by_input(x, input));
                pairs.push(Pair {
                    input,
                    first: moved.collect(),
                    second: self.velocity_of(body, &point, input),
                    except: None,
                    is_turn: false,
                    what: What::Point(what, body, at.origin),
                });
            }
        }
        pairs
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
            What::Point(what, body, _) => {
                let (body, help) = (
                    body_name(mechanism, body),
                    match body {
                        Some(_) => {
                            "write the point from the body's origin and with what the body turns with"
                        }
                        None => "write a point that stays, or name the body that it belongs to",
                    },
                );
                format!(
                    "{what} leaves {body}: {at}its point moves by {a} per unit of `{by}`, as a point of {body} by {b}\n\
                     help: {help}"
                )
            }
        }
    }
}

/// Points that move with a body, the frame included: of masses, of moments of inertia, of the ends of springs and dampers.
fn carried_points(mechanism: &Mechanism) -> Vec<(&'static str, Option<usize>, &Expr)> {
    let mut points = Vec::new();
    for (index, body) in mechanism.bodies.iter().enumerate() {
        let masses = body.masses.iter().map(|(_, at)| ("the mass", at));
        let inertias = body.inertias.iter().filter_map(|(_, at)| at.as_ref());
        let inertias = inertias.map(|at| ("the point of the inertia", at));
        points.extend(
            masses
                .chain(inertias)
                .map(|(what, at)| (what, Some(index), at)),
        );
    }
    for element in &mechanism.elements {
        let what = match element.kind {
            ElementKind::Spring => "the spring's end",
            ElementKind::Damper => "the damper's end",
        };
        if let Between::Points(ends) = &element.between {
            points.extend(ends.iter().map(|(body, at)| (what, *body, at)));
        }
    }
    points
}
