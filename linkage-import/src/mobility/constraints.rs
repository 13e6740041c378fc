//! The equations of a drawing: pins coincide, slots hold their pins, inputs have their values.

use crate::document::{Document, FRAME, InputKind, SlotPath};

/// Larger mechanisms get the range of the drawing alone.
const MOST_BODIES: usize = 80;

/// A pose: three numbers for each body, as parts of the size.
pub(super) type Pose = Vec<f64>;

/// A point of a body in the drawing, as parts of the size.
#[derive(Clone, Copy, Debug)]
struct BodyPoint {
    /// `None` for the frame.
    body: Option<usize>,
    point: [f64; 2],
}

#[derive(Clone, Debug)]
enum Equation {
    /// Two points coincide: two rows.
    Coincide(BodyPoint, BodyPoint),
    /// A point is on a line of the guide through the origin.
    Line {
        pin: BodyPoint,
        origin: BodyPoint,
        direction: f64,
    },
    /// A point keeps its drawn distance from another one.
    Arc(BodyPoint, BodyPoint),
    /// Sum of angles times factors, minus an input, is zero.
    Angles(Vec<(Option<usize>, f64)>, Option<usize>),
    /// A distance is the drawn one plus an input.
    Length(BodyPoint, BodyPoint, usize),
    /// A point has moved along a line by an input.
    Position {
        pin: BodyPoint,
        origin: BodyPoint,
        direction: f64,
        input: usize,
    },
}

/// The equations of a drawing with inputs. Lengths are parts of the size.
pub(crate) struct System {
    /// The points about which bodies turn.
    centres: Vec<[f64; 2]>,
    equations: Vec<Equation>,
    size: f64,
}

impl System {
    /// Returns the equations, or `None` for mechanisms that are too large.
    pub(crate) fn new(document: &Document, inputs: &[InputKind]) -> Option<Self> {
        let size = document.largest_distance()?.2;
        if size <= 0.0 || document.links.len() > MOST_BODIES {
            return None;
        }
        let mut builder = Builder {
            document,
            size,
            bodies: vec![None; document.links.len()],
            system: Self {
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

    pub(crate) fn unknowns(&self) -> usize {
        3 * self.centres.len()
    }

    /// Returns the length that is one.
    pub(crate) fn size(&self) -> f64 {
        self.size
    }

    /// Returns the pose of the drawing.
    pub(crate) fn drawn(&self) -> Pose {
        vec![0.0; self.unknowns()]
    }

    /// Returns the derivatives of all equations by the pose, and the negative errors behind them.
    pub(crate) fn rows(&self, pose: &Pose, values: &[f64]) -> Vec<Vec<f64>> {
        let mut rows = Vec::new();
        for equation in &self.equations {
            self.add_rows(equation, pose, values, &mut rows);
        }
        rows
    }

    fn add_rows(&self, equation: &Equation, pose: &Pose, values: &[f64], rows: &mut Vec<Vec<f64>>) {
        let unknowns = self.unknowns();
        let mut row = Coefficients(vec![0.0; unknowns + 1]);
        match equation {
            Equation::Coincide(a, b) => {
                for axis in 0..2 {
                    let mut row = Coefficients(vec![0.0; unknowns + 1]);
                    let mut along = [0.0; 2];
                    along[axis] = 1.0;
                    let a = self.moved(*a, pose);
                    let b = self.moved(*b, pose);
                    row.0[unknowns] = b.point[axis] - a.point[axis];
                    row.add(a, along, 1.0);
                    row.add(b, along, -1.0);
                    rows.push(row.0);
                }
                return;
            }
            Equation::Line {
                pin,
                origin,
                direction,
            } => self.along(&mut row, pose, [*pin, *origin], direction + QUARTER, 0.0),
            Equation::Position {
                pin,
                origin,
                direction,
                input,
            } => {
                let drawn = [0, 1].map(|axis| pin.point[axis] - origin.point[axis]);
                let drawn = drawn[0] * direction.cos() + drawn[1] * direction.sin();
                let wanted = drawn + values[*input];
                self.along(&mut row, pose, [*pin, *origin], *direction, wanted);
            }
            Equation::Arc(a, b) => self.distance(&mut row, pose, [*a, *b], 0.0),
            Equation::Length(a, b, input) => {
                self.distance(&mut row, pose, [*a, *b], values[*input]);
            }
            Equation::Angles(terms, input) => {
                let mut sum = -input.map_or(0.0, |input| values[input]);
                for (body, factor) in terms {
                    if let Some(body) = body {
                        sum += factor * pose[3 * body + 2];
                        row.0[3 * body + 2] += factor;
                    }
                }
                row.0[unknowns] = -sum;
            }
        }
        rows.push(row.0);
    }

    /// The difference of two points along a direction of the second one's body.
    fn along(
        &self,
        row: &mut Coefficients,
        pose: &Pose,
        points: [BodyPoint; 2],
        direction: f64,
        wanted: f64,
    ) {
        let guide = points[1].body;
        let angle = direction + guide.map_or(0.0, |body| pose[3 * body + 2]);
        let along = [angle.cos(), angle.sin()];
        let [pin, origin] = points.map(|point| self.moved(point, pose));
        let offset = [0, 1].map(|axis| pin.point[axis] - origin.point[axis]);
        row.add(pin, along, 1.0);
        row.add(origin, along, -1.0);
        if let Some(body) = guide {
            row.0[3 * body + 2] += offset[1] * along[0] - offset[0] * along[1];
        }
        let last = row.0.len() - 1;
        row.0[last] = wanted - offset[0] * along[0] - offset[1] * along[1];
    }

    /// The distance of two points minus the drawn one and a change.
    fn distance(&self, row: &mut Coefficients, pose: &Pose, points: [BodyPoint; 2], change: f64) {
        let [a, b] = points;
        let drawn = (b.point[0] - a.point[0]).hypot(b.point[1] - a.point[1]);
        let [a, b] = points.map(|point| self.moved(point, pose));
        let offset = [0, 1].map(|axis| b.point[axis] - a.point[axis]);
        let distance = offset[0].hypot(offset[1]).max(1e-12);
        let along = offset.map(|value| value / distance);
        row.add(b, along, 1.0);
        row.add(a, along, -1.0);
        let last = row.0.len() - 1;
        row.0[last] = drawn + change - distance;
    }

    fn moved(&self, point: BodyPoint, pose: &Pose) -> MovedPoint {
        let Some(body) = point.body else {
            return MovedPoint {
                body: None,
                point: point.point,
                arm: [0.0; 2],
            };
        };
        let centre = self.centres[body];
        let [x, y, angle] = [0, 1, 2].map(|index| pose[3 * body + index]);
        let drawn = [0, 1].map(|axis| point.point[axis] - centre[axis]);
        let (sine, cosine) = angle.sin_cos();
        let arm = [
            cosine * drawn[0] - sine * drawn[1],
            sine * drawn[0] + cosine * drawn[1],
        ];
        MovedPoint {
            body: Some(body),
            point: [centre[0] + x + arm[0], centre[1] + y + arm[1]],
            arm,
        }
    }
}

const QUARTER: f64 = std::f64::consts::FRAC_PI_2;

/// A point of a body in a pose, and its arm from the centre of the body.
#[derive(Clone, Copy)]
struct MovedPoint {
    body: Option<usize>,
    point: [f64; 2],
    arm: [f64; 2],
}

/// A row of coefficients with the right side at its end.
struct Coefficients(Vec<f64>);

impl Coefficients {
    /// Adds the derivatives of a point along a direction.
    fn add(&mut self, point: MovedPoint, along: [f64; 2], factor: f64) {
        if let Some(body) = point.body {
            self.0[3 * body] += factor * along[0];
            self.0[3 * body + 1] += factor * along[1];
            let turned = point.arm[0] * along[1] - point.arm[1] * along[0];
            self.0[3 * body + 2] += factor * turned;
        }
    }
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
