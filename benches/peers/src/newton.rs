//! Newton-Raphson on the loop equations, for any mechanism of links with an angle each: a list of
//! vectors, nalgebra's LU decomposition, a fixed number of iterations from the position before.

mod mechanisms;

pub use mechanisms::{K1, K2};

use crate::{Motion, Position};
use nalgebra::{Const, DimMin, SMatrix, SVector};

/// What the length of a vector is.
#[derive(Clone, Copy, Debug)]
enum Length {
    Dimension(usize),
    Unknown(usize),
}

/// The angle of a vector: a sum.
#[derive(Clone, Copy, Debug, Default)]
struct Angle {
    unknown: Option<usize>,
    dimension: Option<usize>,
    input: f64,
    constant: f64,
}

/// A vector of a loop, or of the path to the point; subtracted for a negative sign.
#[derive(Clone, Copy, Debug)]
struct Link {
    row: usize,
    sign: f64,
    length: Length,
    angle: Angle,
    placed: Placed,
}

/// Length and direction of a link at the last position, the direction with the link's sign.
#[derive(Clone, Copy, Debug, Default)]
struct Placed {
    length: f64,
    cos: f64,
    sin: f64,
}

/// How input, dimensions and unknowns move.
struct Path<const N: usize> {
    input: f64,
    dimension: Option<usize>,
    first: SVector<f64, N>,
    second: SVector<f64, N>,
}

impl<const N: usize> Default for Path<N> {
    fn default() -> Self {
        Self {
            input: 0.0,
            dimension: None,
            first: SVector::zeros(),
            second: SVector::zeros(),
        }
    }
}

impl<const N: usize> Path<N> {
    fn moves(&self, dimension: usize) -> f64 {
        if self.dimension == Some(dimension) {
            1.0
        } else {
            0.0
        }
    }
}

/// A mechanism of `N` unknowns and `P` dimensions, at the position that it was last asked for.
#[derive(Clone, Debug)]
pub struct Newton<const N: usize, const P: usize> {
    dimensions: [f64; P],
    loops: Vec<Link>,
    path: Vec<Link>,
    iterations: usize,
    unknowns: SVector<f64, N>,
}

impl<const N: usize, const P: usize> Newton<N, P>
where
    Const<N>: DimMin<Const<N>, Output = Const<N>>,
{
    /// The same with another number of iterations.
    #[must_use]
    pub fn with_iterations(mut self, iterations: usize) -> Self {
        self.iterations = iterations;
        self
    }

    /// Goes to a position from afar.
    pub fn start(&mut self, phi: f64) {
        for _ in 0..30 {
            self.iterate(phi);
        }
    }

    /// The point.
    pub fn point(&mut self, phi: f64) -> Position {
        for _ in 0..self.iterations {
            self.iterate(phi);
        }
        place(
            &mut self.path,
            self.unknowns.as_slice(),
            &self.dimensions,
            phi,
        );
        let mut point = [0.0; 2];
        for Placed { length, cos, sin } in self.path.iter().map(|link| link.placed) {
            point[0] += length * cos;
            point[1] += length * sin;
        }
        point
    }

    /// The point with both derivatives by the input.
    pub fn motion(&mut self, phi: f64) -> Motion {
        let [x, y] = self.point(phi);
        let jacobian = self.equations(phi).1.lu();
        let solve = |rows: SVector<f64, N>| jacobian.solve(&-rows).unwrap_or(rows * f64::NAN);
        let mut path = Path {
            input: 1.0,
            ..Path::default()
        };
        path.first = solve(rates(&self.loops, &path)[0]);
        path.second = solve(rates(&self.loops, &path)[1]);
        let [v, a] = rates::<2, N>(&self.path, &path);
        [x, y, v[0], v[1], a[0], a[1]]
    }

    /// The point, then its derivatives by every dimension.
    pub fn accuracy<const W: usize>(&mut self, phi: f64) -> [f64; W] {
        let mut row = [0.0; W];
        [row[0], row[1]] = self.point(phi);
        let jacobian = self.equations(phi).1.lu();
        for (index, cells) in row[2..].chunks_exact_mut(2).enumerate() {
            let mut path = Path {
                dimension: Some(index),
                ..Path::default()
            };
            let rows = rates(&self.loops, &path)[0];
            path.first = jacobian.solve(&-rows).unwrap_or(rows * f64::NAN);
            let [change, _] = rates::<2, N>(&self.path, &path);
            cells.copy_from_slice(change.as_slice());
        }
        row
    }

    fn iterate(&mut self, phi: f64) {
        let (residual, jacobian) = self.equations(phi);
        if let Some(step) = jacobian.lu().solve(&residual) {
            self.unknowns -= step;
        }
    }

    /// The loops' sums, and their derivatives by the unknowns.
    fn equations(&mut self, phi: f64) -> (SVector<f64, N>, SMatrix<f64, N, N>) {
        place(
            &mut self.loops,
            self.unknowns.as_slice(),
            &self.dimensions,
            phi,
        );
        let mut residual = SVector::zeros();
        let mut jacobian = SMatrix::zeros();
        for link in &self.loops {
            let Placed { length, cos, sin } = link.placed;
            residual[link.row] += length * cos;
            residual[link.row + 1] += length * sin;
            if let Some(column) = link.angle.unknown {
                jacobian[(link.row, column)] -= length * sin;
                jacobian[(link.row + 1, column)] += length * cos;
            }
            if let Length::Unknown(column) = link.length {
                jacobian[(link.row, column)] += cos;
                jacobian[(link.row + 1, column)] += sin;
            }
        }
        (residual, jacobian)
    }
}

/// Lengths and directions at a position.
fn place(links: &mut [Link], unknowns: &[f64], dimensions: &[f64], phi: f64) {
    for link in links {
        let length = match link.length {
            Length::Dimension(index) => dimensions[index],
            Length::Unknown(index) => unknowns[index],
        };
        let a = &link.angle;
        let angle = a.input * phi
            + a.constant
            + a.unknown.map_or(0.0, |index| unknowns[index])
            + a.dimension.map_or(0.0, |index| dimensions[index]);
        let (sin, cos) = angle.sin_cos();
        link.placed = Placed {
            length,
            cos: link.sign * cos,
            sin: link.sign * sin,
        };
    }
}

/// First and second derivative of sums of links along a path.
fn rates<const R: usize, const N: usize>(links: &[Link], path: &Path<N>) -> [SVector<f64, R>; 2] {
    let (mut first, mut second) = (SVector::zeros(), SVector::zeros());
    for link in links {
        let Placed { length, cos, sin } = link.placed;
        let (growth, growth_second) = match link.length {
            Length::Dimension(index) => (path.moves(index), 0.0),
            Length::Unknown(index) => (path.first[index], path.second[index]),
        };
        let a = &link.angle;
        let turn = a.input * path.input
            + a.unknown.map_or(0.0, |index| path.first[index])
            + a.dimension.map_or(0.0, |index| path.moves(index));
        let turn_second = a.unknown.map_or(0.0, |index| path.second[index]);
        let add = |rows: &mut SVector<f64, R>, along: f64, across: f64| {
            rows[link.row] += along * cos - across * sin;
            rows[link.row + 1] += along * sin + across * cos;
        };
        add(&mut first, growth, length * turn);
        add(
            &mut second,
            growth_second - length * turn * turn,
            2.0 * growth * turn + length * turn_second,
        );
    }
    [first, second]
}
