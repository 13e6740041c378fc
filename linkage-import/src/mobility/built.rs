//! The equations of a document: pins of links, slots, wheels and inputs.

use crate::document::{Document, FRAME, InputKind, SlotPath};

use super::constraints::{BodyPoint, Equation, System};

/// Larger mechanisms get the range of the drawing alone.
const MOST_BODIES: usize = 80;

/// Returns the equations, or `None` for mechanisms that are too large.
pub(super) fn system(document: &Document, inputs: &[InputKind]) -> Option<System> {
    let size = document.largest_distance()?.2;
    if size <= 0.0 || document.links.len() > MOST_BODIES {
        return None;
    }
    let mut builder = Builder {
        document,
        size,
        bodies: vec![None; document.links.len()],
        system: System {
            centres: Vec::new(),
            equations: Vec::new(),
            size,
        },
    };
    let cylinders: Vec<usize> = document
        .inputs
        .iter()
        .map(|input| input.kind)
        .chain(inputs.iter().copied())
        .filter_map(|kind| match kind {
            InputKind::Length { link } => Some(link),
            _ => None,
        })
        .collect();
    for (index, link) in document.links.iter().enumerate() {
        if index != FRAME && !cylinders.contains(&index) {
            builder.bodies[index] = Some(builder.system.centres.len());
            if link.is_held {
                let body = Some(builder.system.centres.len());
                let angle = Equation::Angles(vec![(body, 1.0)], None);
                builder.system.equations.push(angle);
            }
            let centre = link.joints.first().map(|joint| builder.scaled(*joint));
            builder.system.centres.push(centre.unwrap_or_default());
        }
    }
    let points: Vec<Option<usize>> = builder.points();
    builder.slots(&points);
    builder.gears();
    builder.inputs(inputs, &points);
    Some(builder.system)
}

struct Builder<'t> {
    document: &'t Document,
    size: f64,
    /// The bodies of links; `None` for the frame and for cylinders.
    bodies: Vec<Option<usize>>,
    system: System,
}

impl Builder<'_> {
    fn scaled(&self, joint: usize) -> [f64; 2] {
        self.document.joints[joint]
            .position
            .map(|value| value / self.size)
    }

    /// Joins the links of each joint. Returns the bodies that have the joints, `None` for the
    /// frame. Joints that no body has get their own one, which does not turn.
    fn points(&mut self) -> Vec<Option<usize>> {
        let mut points = Vec::new();
        for joint in 0..self.document.joints.len() {
            let links = self.document.links_of(joint);
            let is_body = |link: &usize| *link == FRAME || self.bodies[*link].is_some();
            let links: Vec<usize> = links.into_iter().filter(is_body).collect();
            let position = self.scaled(joint);
            let Some((first, others)) = links.split_first() else {
                let body = self.system.centres.len();
                self.system.centres.push(position);
                let angle = Equation::Angles(vec![(Some(body), 1.0)], None);
                self.system.equations.push(angle);
                points.push(Some(body));
                continue;
            };
            let first = self.bodies[*first];
            for other in others {
                let pair = [first, self.bodies[*other]].map(|body| BodyPoint {
                    body,
                    point: position,
                });
                self.system
                    .equations
                    .push(Equation::Coincide(pair[0], pair[1]));
            }
            points.push(first);
        }
        points
    }

    fn point(&self, joint: usize, body: Option<usize>) -> BodyPoint {
        BodyPoint {
            body,
            point: self.scaled(joint),
        }
    }

    fn slots(&mut self, points: &[Option<usize>]) {
        for slot in &self.document.slots {
            let guide = self.bodies[slot.guide];
            let pin = self.point(slot.pin, points[slot.pin]);
            let equation = match slot.path {
                SlotPath::Joints(first, second) => Equation::Line {
                    pin,
                    origin: self.point(first, guide),
                    direction: self.document.direction(first, second),
                },
                SlotPath::Direction(direction, ..) => Equation::Line {
                    pin,
                    origin: self.point(slot.pin, guide),
                    direction,
                },
                SlotPath::Arc { centre, .. } => Equation::Arc(pin, self.point(centre, guide)),
            };
            self.system.equations.push(equation);
            if let Some(block) = slot.block {
                let terms = vec![(self.bodies[block], 1.0), (guide, -1.0)];
                self.system.equations.push(Equation::Angles(terms, None));
            }
        }
    }

    fn gears(&mut self) {
        for pair in &self.document.gears {
            let [first, second] = pair.sizes;
            let second = if pair.is_chain { -second } else { second };
            let sum = first + second;
            let scale = first.abs() + second.abs();
            let terms = vec![
                (self.bodies[pair.wheels[0]], first / scale),
                (self.bodies[pair.wheels[1]], second / scale),
                (self.bodies[pair.arm], -sum / scale),
            ];
            self.system.equations.push(Equation::Angles(terms, None));
        }
    }

    fn inputs(&mut self, inputs: &[InputKind], points: &[Option<usize>]) {
        for (input, kind) in inputs.iter().enumerate() {
            let equation = match *kind {
                InputKind::Crank { link, base, .. } => Equation::Angles(
                    vec![(self.bodies[link], 1.0), (self.bodies[base], -1.0)],
                    Some(input),
                ),
                InputKind::Length { link } => {
                    let [first, second] = self.document.links[link].joints[..] else {
                        continue;
                    };
                    let ends = [first, second].map(|joint| self.point(joint, points[joint]));
                    Equation::Length(ends[0], ends[1], input)
                }
                InputKind::Position { slot } => {
                    let slot = &self.document.slots[slot];
                    let guide = self.bodies[slot.guide];
                    let (origin, direction) = match slot.path {
                        SlotPath::Joints(first, second) => {
                            (first, self.document.direction(first, second))
                        }
                        SlotPath::Direction(direction, ..) => (slot.pin, direction),
                        SlotPath::Arc { .. } => continue,
                    };
                    Equation::Position {
                        pin: self.point(slot.pin, points[slot.pin]),
                        origin: self.point(origin, guide),
                        direction,
                        input,
                    }
                }
            };
            self.system.equations.push(equation);
        }
    }
}
