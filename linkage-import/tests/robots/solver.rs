//! An independent solver: bodies are points at fixed distances, moved by steps of Gauss and Newton.

/// A point of space.
pub(crate) type Point = [f64; 3];

/// A condition on points, by their indices.
#[derive(Clone, Debug)]
pub(crate) enum Condition {
    /// Two points keep their distance.
    Distance(usize, usize),
    /// A point keeps one coordinate, plus a part of the input.
    Coordinate(usize, usize, f64),
    /// Three points are on one line.
    Line(usize, usize, usize),
    /// A point turns about an axis through another one, by a multiple of the input.
    Turned {
        point: usize,
        pivot: Point,
        axis: Point,
        factor: f64,
    },
}

/// A mechanism of points where they are drawn.
#[derive(Clone, Debug, Default)]
pub(crate) struct Points {
    pub(crate) names: Vec<String>,
    pub(crate) drawn: Vec<Point>,
    pub(crate) is_fixed: Vec<bool>,
    pub(crate) conditions: Vec<Condition>,
}

pub(crate) fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(crate) fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Point, b: Point) -> Point {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn norm(a: Point) -> f64 {
    dot(a, a).sqrt()
}

/// A point turned about an axis, by the formula of Rodrigues.
pub(crate) fn turned(point: Point, pivot: Point, axis: Point, angle: f64) -> Point {
    let length = norm(axis);
    let k = axis.map(|component| component / length);
    let v = minus(point, pivot);
    let (sine, cosine) = angle.sin_cos();
    let (along, across) = (dot(k, v) * (1.0 - cosine), cross(k, v));
    let part = |i: usize| pivot[i] + v[i] * cosine + across[i] * sine + k[i] * along;
    [part(0), part(1), part(2)]
}

impl Points {
    /// Adds a point and returns its index.
    pub(crate) fn add(&mut self, name: &str, drawn: Point, is_fixed: bool) -> usize {
        self.names.push(name.to_owned());
        self.drawn.push(drawn);
        self.is_fixed.push(is_fixed);
        self.drawn.len() - 1
    }

    /// Makes points a rigid body.
    pub(crate) fn rigid(&mut self, points: &[usize]) {
        for (number, &a) in points.iter().enumerate() {
            for &b in &points[number + 1..] {
                self.conditions.push(Condition::Distance(a, b));
            }
        }
    }

    /// The errors of a condition.
    fn errors(&self, condition: &Condition, at: &[Point], input: f64) -> Vec<f64> {
        match condition {
            Condition::Distance(a, b) => {
                let drawn = norm(minus(self.drawn[*a], self.drawn[*b]));
                vec![norm(minus(at[*a], at[*b])) - drawn]
            }
            Condition::Coordinate(point, axis, factor) => {
                vec![at[*point][*axis] - self.drawn[*point][*axis] - factor * input]
            }
            Condition::Line(a, b, c) => {
                cross(minus(at[*b], at[*a]), minus(at[*c], at[*a])).to_vec()
            }
            Condition::Turned {
                point,
                pivot,
                axis,
                factor,
            } => {
                let wanted = turned(self.drawn[*point], *pivot, *axis, factor * input);
                minus(at[*point], wanted).to_vec()
            }
        }
    }

    fn all_errors(&self, at: &[Point], input: f64) -> Vec<f64> {
        let conditions = self.conditions.iter();
        conditions
            .flat_map(|condition| self.errors(condition, at, input))
            .collect()
    }

    /// Moves the points to a value of the input. Returns the largest error that is left.
    pub(crate) fn solve(&self, at: &mut [Point], input: f64) -> f64 {
        let size = self
            .drawn
            .iter()
            .fold(1e-9, |most: f64, p| most.max(norm(*p)));
        let free: Vec<usize> = (0..at.len()).filter(|i| !self.is_fixed[*i]).collect();
        let count = 3 * free.len();
        let mut last = f64::INFINITY;
        for _ in 0..40 {
            let errors = self.all_errors(at, input);
            last = errors
                .iter()
                .fold(0.0, |most: f64, error| most.max(error.abs()));
            if last < 1e-14 * size {
                break;
            }
            // Differences of both sides: their error only slows the convergence.
            let step = 1e-6 * size;
            let mut columns = Vec::with_capacity(count);
            for &point in &free {
                for axis in 0..3 {
                    let mut moved = |shift: f64| {
                        let before = at[point][axis];
                        at[point][axis] += shift;
                        let errors = self.all_errors(at, input);
                        at[point][axis] = before;
                        errors
                    };
                    let (ahead, behind) = (moved(step), moved(-step));
                    let slopes = ahead.iter().zip(&behind);
                    columns.push(
                        slopes
                            .map(|(a, b)| (a - b) / (2.0 * step))
                            .collect::<Vec<f64>>(),
                    );
                }
            }
            let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            let mut rows: Vec<Vec<f64>> = columns
                .iter()
                .map(|column| {
                    let mut row: Vec<f64> =
                        columns.iter().map(|other| product(column, other)).collect();
                    row.push(-product(column, &errors));
                    row
                })
                .collect();
            let changes = eliminate(&mut rows);
            for (number, &point) in free.iter().enumerate() {
                for axis in 0..3 {
                    at[point][axis] += changes[3 * number + axis];
                }
            }
        }
        last / size
    }
}

/// Solves linear equations; unknowns without an equation stay zero.
fn eliminate(rows: &mut [Vec<f64>]) -> Vec<f64> {
    let count = rows.len();
    for column in 0..count {
        let best = (column..count)
            .max_by(|i, j| rows[*i][column].abs().total_cmp(&rows[*j][column].abs()))
            .expect("a row");
        rows.swap(column, best);
        let pivot = rows[column].clone();
        if pivot[column].abs() < 1e-13 {
            continue;
        }
        for row in &mut rows[column + 1..] {
            let factor = row[column] / pivot[column];
            for (number, pivot) in row.iter_mut().zip(&pivot) {
                *number -= factor * pivot;
            }
        }
    }
    let mut solution = vec![0.0; count];
    for index in (0..count).rev() {
        let row = &rows[index];
        if row[index].abs() >= 1e-13 {
            let known: f64 = (index + 1..count).map(|k| row[k] * solution[k]).sum();
            solution[index] = (row[count] - known) / row[index];
        }
    }
    solution
}
