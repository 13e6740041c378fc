//! Do bodies and joints fit the motion? Velocities compared on numbers.

use linkage_symbolic::Vn;

use crate::algebra::Algebra;
use crate::diagnostic::{OriginId, Reporter};
use crate::forces::multibody::Multibody;
use crate::forces::positions::{EQUAL, Position, Positions, SLOW};
use crate::forces::speeds::{AngularVelocities, By};
use crate::forces::{geometry, motion, names, positions};
use crate::message_format::numbers;
use crate::model::{Between, ElementKind, Expr, Mechanism, Rotation};

/// Two velocities that must be equal.
struct Pair<'m> {
    input: usize,
    first: Vn<'m>,
    second: Vn<'m>,
    /// Along this direction they may differ.
    except: Option<Vn<'m>>,
    what: What,
}

/// The subject of a pair of velocities.
#[derive(Clone, Copy)]
enum What {
    /// A joint's point with its bodies.
    Joint(usize),
    /// Angular velocities of a joint's bodies.
    Turns(usize),
    /// A point that must stay with a body, and the same point of the body.
    Point(Point),
}

/// A point that moves with a body, the frame included.
#[derive(Clone, Copy)]
struct Point {
    what: &'static str,
    body: Option<usize>,
    origin: OriginId,
}

/// Reports each joint and point that does not move as declared, once.
pub(super) fn check_fit<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    positions: &Positions,
    reporter: &mut Reporter,
) {
    let mechanism = algebra.mechanism;
    let pairs = pairs(algebra, bodies, turns);
    let mut reported: Vec<OriginId> = Vec::new();
    for position in positions.iter() {
        for pair in &pairs {
            let origin = pair.what.origin(mechanism);
            if reported.contains(&origin) {
                continue;
            }
            if let Some(message) = pair.difference(mechanism, position) {
                reported.push(origin);
                reporter.error(origin, message);
            }
        }
    }
}

/// All that must move alike.
fn pairs<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
) -> Vec<Pair<'m>> {
    let mechanism = algebra.mechanism;
    let mut pairs = Vec::new();
    for input in 0..algebra.mechanism.inputs.len() {
        let by = By::Input(input);
        for joint in 0..mechanism.joints.len() {
            pairs.push(pair_of_points(algebra, bodies, turns, joint, input));
            pairs.extend(pair_of_turns(algebra, bodies, turns, joint, input));
        }
        for (what, at) in carried_points(mechanism) {
            let point = geometry::vector_of(algebra, at);
            pairs.push(Pair {
                input,
                first: motion::moved(algebra, point, by),
                second: motion::velocity_of(algebra, bodies, turns, what.body, point, by),
                except: None,
                what: What::Point(what),
            });
        }
    }
    pairs
}

fn pair_of_points<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    joint: usize,
    input: usize,
) -> Pair<'m> {
    let declared = &algebra.mechanism.joints[joint];
    let (point, by) = (bodies.geometry.points[joint], By::Input(input));
    let direction = bodies.geometry.directions[joint];
    Pair {
        input,
        first: motion::velocity_of(algebra, bodies, turns, Some(declared.body), point, by),
        second: motion::velocity_of(algebra, bodies, turns, declared.on, point, by),
        except: direction.filter(|_| declared.kind.slides()),
        what: What::Joint(joint),
    }
}

/// Nothing for a ball joint, and for a pin or roller of the plane.
fn pair_of_turns<'m>(
    algebra: &mut Algebra<'m>,
    bodies: &Multibody<'m>,
    turns: &mut AngularVelocities<'m>,
    joint: usize,
    input: usize,
) -> Option<Pair<'m>> {
    let declared = &algebra.mechanism.joints[joint];
    let except = match declared.kind.rotation() {
        Rotation::Not => None,
        Rotation::AboutAxis if bodies.geometry.is_plane() => return None,
        Rotation::AboutAxis => Some(bodies.geometry.directions[joint]?),
        Rotation::Freely => return None,
    };
    let by = By::Input(input);
    Some(Pair {
        input,
        first: motion::turn(algebra, bodies, turns, Some(declared.body), by),
        second: motion::turn(algebra, bodies, turns, declared.on, by),
        except,
        what: What::Turns(joint),
    })
}

impl Pair<'_> {
    /// Describes the difference of a pair at a position.
    fn difference(&self, mechanism: &Mechanism, position: Position) -> Option<String> {
        let [first, second] = [self.first, self.second].map(|v| positions::vector(position, v));
        let mut apart: Vec<f64> = first.iter().zip(&second).map(|(a, b)| a - b).collect();
        if let Some(except) = self.except {
            let direction = positions::vector(position, except);
            let along: f64 = apart.iter().zip(&direction).map(|(x, d)| x * d).sum();
            let pairs = apart.iter_mut().zip(&direction);
            pairs.for_each(|(x, d)| *x -= along * d);
        }
        let unit = match self.what {
            What::Turns(_) => 1.0,
            What::Joint(_) | What::Point(_) => positions::longest(position),
        };
        let scale = positions::size(&first) + positions::size(&second) + SLOW * unit;
        // Where the mechanism does not close there is nothing to compare.
        (positions::size(&apart) > EQUAL * scale).then(|| {
            let at = positions::described(position, mechanism);
            self.message(mechanism, &at, [&first, &second].map(|v| vector_words(v)))
        })
    }

    fn message(&self, mechanism: &Mechanism, at: &str, [a, b]: [String; 2]) -> String {
        let by = &mechanism.inputs[self.input].name;
        match self.what {
            What::Joint(joint) => {
                let [name, body, on] = joint_names(mechanism, joint);
                let across = match &self.except {
                    Some(_) => ", which differ across the guide, too",
                    None => "",
                };
                format!(
                    "{name} comes apart: {at}its point moves by {a} per unit of `{by}` with {body}, by {b} with {on}{across}\n\
                     help: check the point, the two bodies, and what they turn with"
                )
            }
            What::Turns(joint) => {
                let [name, body, on] = joint_names(mechanism, joint);
                let across = match &self.except {
                    Some(_) => ", and not about the joint's axis alone",
                    None => "",
                };
                format!(
                    "{name} cannot hold: {at}{body} turns by {a} per unit of `{by}`, {on} by {b}{across}\n\
                     help: check what both bodies turn with, and the kind of the joint"
                )
            }
            What::Point(Point { what, body, .. }) => {
                let help = match body {
                    Some(_) => {
                        "write the point from the body's origin and with what the body turns with"
                    }
                    None => "write a point that stays, or name the body that it belongs to",
                };
                let body = names::body_name(mechanism, body);
                format!(
                    "{what} leaves {body}: {at}its point moves by {a} per unit of `{by}`, as a point of {body} by {b}\n\
                     help: {help}"
                )
            }
        }
    }
}

impl What {
    fn origin(self, mechanism: &Mechanism) -> OriginId {
        match self {
            What::Joint(joint) | What::Turns(joint) => mechanism.joints[joint].origin,
            What::Point(point) => point.origin,
        }
    }
}

/// A joint and its bodies.
fn joint_names(mechanism: &Mechanism, joint: usize) -> [String; 3] {
    let declared = &mechanism.joints[joint];
    [
        names::joint_name(mechanism, joint),
        names::body_name(mechanism, Some(declared.body)),
        names::body_name(mechanism, declared.on),
    ]
}

/// `(0, 1)`, or a number alone.
fn vector_words(v: &[f64]) -> String {
    let words = numbers(v);
    match &words[..] {
        [number] => number.clone(),
        _ => format!("({})", words.join(", ")),
    }
}

/// Points that move with a body, the frame included: of masses, of moments of inertia, of the ends
/// of springs and dampers.
fn carried_points(mechanism: &Mechanism) -> Vec<(Point, &Expr)> {
    let point = |what, body, at: &Expr| Point {
        what,
        body,
        origin: at.origin,
    };
    let mut points = Vec::new();
    for (body, declared) in mechanism.bodies.iter().enumerate() {
        let body = Some(body);
        let masses = declared.masses.iter();
        points.extend(masses.map(|(_, at)| (point("the mass", body, at), at)));
        let about = declared.inertias.iter().filter_map(|(_, at)| at.as_ref());
        points.extend(about.map(|at| (point("the point of the inertia", body, at), at)));
    }
    for element in &mechanism.elements {
        let what = match element.kind {
            ElementKind::Spring => "the spring's end",
            ElementKind::Damper => "the damper's end",
        };
        if let Between::Points(ends) = &element.between {
            points.extend(ends.iter().map(|(body, at)| (point(what, *body, at), at)));
        }
    }
    points
}
