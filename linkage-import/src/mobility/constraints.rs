//! The equations of a drawing: pins coincide, slots hold their pins, inputs have their values.

/// A pose: three numbers for each body, as parts of the size.
pub(super) type Pose = Vec<f64>;

/// A point of a body in the drawing, as parts of the size.
#[derive(Clone, Copy, Debug)]
pub(super) struct BodyPoint {
    /// `None` for the frame.
    pub(super) body: Option<usize>,
    pub(super) point: [f64; 2],
}

/// An equation of one row or two.
#[derive(Clone, Debug)]
pub(super) enum Equation {
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
    pub(super) centres: Vec<[f64; 2]>,
    pub(super) equations: Vec<Equation>,
    pub(super) size: f64,
}

impl System {
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
