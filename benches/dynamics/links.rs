//! Links of the plane as other solvers see them: a coordinate for each body, and equations for the closed loops.
//!
//! `M(q) q'' + h(q, q') + G(q)^T lambda = Q(q)` with `g(q) = 0`. Coordinates are angles against the frame and
//! displacements of slides, which keeps the mass matrix and its derivatives as sparse as they can be.

use nalgebra::{DMatrix, DVector};

/// Two coordinates in the kinetic energy: `moment cos(q1 - q2 - shift) q1' q2'`.
pub(crate) struct Coupling {
    pub(crate) coordinates: [usize; 2],
    pub(crate) moment: f64,
    pub(crate) shift: f64,
}

/// A coordinate's part of a loop.
pub(crate) enum Part {
    /// `length (cos, sin)` of the angle and a shift.
    Arm { length: f64, shift: f64 },
    /// A displacement along the x axis, times a factor.
    Slide(f64),
}

/// A sum of vectors that is zero.
pub(crate) struct Loop {
    pub(crate) constant: [f64; 2],
    /// Coordinates with their parts.
    pub(crate) parts: Vec<(usize, Part)>,
}

/// A spring from a fixed point to a point of a link on a fixed pivot.
pub(crate) struct Spring {
    pub(crate) coordinate: usize,
    /// From the pivot to the point of the link: length, and angle against that of the link.
    pub(crate) arm: [f64; 2],
    /// From the fixed point to the pivot.
    pub(crate) base: [f64; 2],
    pub(crate) stiffness: f64,
    pub(crate) free: f64,
}

/// A mechanism.
pub(crate) struct Links {
    /// Diagonal of the mass matrix.
    pub(crate) inertias: Vec<f64>,
    pub(crate) couplings: Vec<Coupling>,
    pub(crate) loops: Vec<Loop>,
    /// Constant moments on coordinates.
    pub(crate) moments: Vec<f64>,
    /// Weights times distances: the moment is `-weight cos q`.
    pub(crate) weights: Vec<f64>,
    pub(crate) spring: Option<Spring>,
}

/// A coordinate's part of a loop at a position: the derivatives of its vector with respect to the coordinate.
pub(crate) struct Column {
    /// First equation of the loop.
    pub(crate) equation: usize,
    pub(crate) coordinate: usize,
    pub(crate) slope: [f64; 2],
    pub(crate) bend: [f64; 2],
    pub(crate) third: [f64; 2],
}

impl Links {
    pub(crate) fn coordinates(&self) -> usize {
        self.inertias.len()
    }

    /// Number of equations of the loops.
    pub(crate) fn equations(&self) -> usize {
        2 * self.loops.len()
    }

    pub(crate) fn columns(&self, q: &[f64]) -> impl Iterator<Item = Column> {
        self.loops
            .iter()
            .enumerate()
            .flat_map(move |(index, closed)| {
                closed.parts.iter().map(move |(coordinate, part)| {
                    let [slope, bend, third] = match part {
                        Part::Arm { length, shift } => {
                            let (sin, cos) = (q[*coordinate] + shift).sin_cos();
                            let (x, y) = (length * cos, length * sin);
                            [[-y, x], [-x, -y], [y, -x]]
                        }
                        Part::Slide(factor) => [[*factor, 0.0], [0.0, 0.0], [0.0, 0.0]],
                    };
                    Column {
                        equation: 2 * index,
                        coordinate: *coordinate,
                        slope,
                        bend,
                        third,
                    }
                })
            })
    }

    /// Writes the residuals of the loops.
    pub(crate) fn closure(&self, q: &[f64], out: &mut [f64]) {
        for (Loop { constant, parts }, out) in self.loops.iter().zip(out.chunks_exact_mut(2)) {
            out.copy_from_slice(constant);
            for (coordinate, part) in parts {
                let vector = match part {
                    Part::Arm { length, shift } => {
                        let (sin, cos) = (q[*coordinate] + shift).sin_cos();
                        [length * cos, length * sin]
                    }
                    Part::Slide(factor) => [factor * q[*coordinate], 0.0],
                };
                out[0] += vector[0];
                out[1] += vector[1];
            }
        }
    }

    /// Writes the rates of the loops.
    pub(crate) fn closure_rate(&self, q: &[f64], v: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for column in self.columns(q) {
            for axis in 0..2 {
                out[column.equation + axis] += column.slope[axis] * v[column.coordinate];
            }
        }
    }

    /// Writes the second rates of the loops.
    pub(crate) fn closure_acceleration(&self, q: &[f64], v: &[f64], w: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for column in self.columns(q) {
            let i = column.coordinate;
            for axis in 0..2 {
                out[column.equation + axis] +=
                    column.slope[axis] * w[i] + column.bend[axis] * v[i] * v[i];
            }
        }
    }

    /// Writes `M w + h - Q + G^T lambda`.
    pub(crate) fn balance(&self, q: &[f64], v: &[f64], w: &[f64], lambda: &[f64], out: &mut [f64]) {
        for i in 0..self.coordinates() {
            out[i] = self.inertias[i] * w[i] - self.moments[i] + self.weights[i] * q[i].cos();
        }
        for Coupling {
            coordinates: [i, j],
            moment,
            shift,
        } in &self.couplings
        {
            let (sin, cos) = (q[*i] - q[*j] - shift).sin_cos();
            out[*i] += moment * (cos * w[*j] + sin * v[*j] * v[*j]);
            out[*j] += moment * (cos * w[*i] - sin * v[*i] * v[*i]);
        }
        if let Some(spring) = &self.spring {
            out[spring.coordinate] -= spring.moment(q)[0];
        }
        for column in self.columns(q) {
            for axis in 0..2 {
                out[column.coordinate] += column.slope[axis] * lambda[column.equation + axis];
            }
        }
    }

    /// Accelerations and multipliers, by a linear system.
    pub(crate) fn accelerations(&self, q: &[f64], v: &[f64]) -> DVector<f64> {
        let (n, m) = (self.coordinates(), self.equations());
        let mut matrix = DMatrix::zeros(n + m, n + m);
        let mut right = DVector::zeros(n + m);
        let zero = [0.0; 16];
        self.balance(q, v, &zero[..n], &zero[..m], &mut right.as_mut_slice()[..n]);
        self.closure_acceleration(q, v, &zero[..n], &mut right.as_mut_slice()[n..]);
        self.mass(q, |i, j, value| matrix[(i, j)] += value);
        for column in self.columns(q) {
            for axis in 0..2 {
                matrix[(column.coordinate, n + column.equation + axis)] += column.slope[axis];
                matrix[(n + column.equation + axis, column.coordinate)] += column.slope[axis];
            }
        }
        right.neg_mut();
        assert!(matrix.lu().solve_mut(&mut right), "a regular position");
        right
    }

    /// Adds the entries of the mass matrix.
    pub(crate) fn mass(&self, q: &[f64], mut add: impl FnMut(usize, usize, f64)) {
        for (i, inertia) in self.inertias.iter().enumerate() {
            add(i, i, *inertia);
        }
        for Coupling {
            coordinates: [i, j],
            moment,
            shift,
        } in &self.couplings
        {
            let value = moment * (q[*i] - q[*j] - shift).cos();
            add(*i, *j, value);
            add(*j, *i, value);
        }
    }

    /// Adds the derivatives of the balance with respect to positions and to speeds.
    pub(crate) fn balance_slopes(
        &self,
        q: &[f64],
        v: &[f64],
        w: &[f64],
        lambda: &[f64],
        mut add: impl FnMut(Slope, f64),
    ) {
        for (i, (weight, angle)) in self.weights.iter().zip(q).enumerate() {
            add(Slope::Position(i, i), -weight * angle.sin());
        }
        for Coupling {
            coordinates: [i, j],
            moment,
            shift,
        } in &self.couplings
        {
            let (i, j) = (*i, *j);
            let (sin, cos) = (q[i] - q[j] - shift).sin_cos();
            let first = moment * (cos * v[j] * v[j] - sin * w[j]);
            let second = moment * (-cos * v[i] * v[i] - sin * w[i]);
            add(Slope::Position(i, i), first);
            add(Slope::Position(i, j), -first);
            add(Slope::Position(j, i), second);
            add(Slope::Position(j, j), -second);
            add(Slope::Speed(i, j), 2.0 * moment * sin * v[j]);
            add(Slope::Speed(j, i), -2.0 * moment * sin * v[i]);
        }
        if let Some(spring) = &self.spring {
            add(
                Slope::Position(spring.coordinate, spring.coordinate),
                -spring.moment(q)[1],
            );
        }
        for column in self.columns(q) {
            let i = column.coordinate;
            for axis in 0..2 {
                add(
                    Slope::Position(i, i),
                    column.bend[axis] * lambda[column.equation + axis],
                );
            }
        }
    }
}

/// A derivative of the balance: its row, and the coordinate.
pub(crate) enum Slope {
    /// With respect to a position.
    Position(usize, usize),
    /// With respect to a speed.
    Speed(usize, usize),
}

impl Spring {
    /// Its moment on the coordinate, and the slope of that.
    fn moment(&self, q: &[f64]) -> [f64; 2] {
        let [length, shift] = self.arm;
        let (sin, cos) = (q[self.coordinate] + shift).sin_cos();
        let along = [length * cos, length * sin];
        let across = [-length * sin, length * cos];
        let span = [0, 1].map(|axis| self.base[axis] + along[axis]);
        let distance = f64::hypot(span[0], span[1]);
        // Half the slope of the squared distance.
        let rate = self.base[0] * across[0] + self.base[1] * across[1];
        let bend = -self.base[0] * along[0] - self.base[1] * along[1];
        let factor = self.stiffness * (1.0 - self.free / distance);
        let factor_slope = self.stiffness * self.free * rate / distance.powi(3);
        [-factor * rate, -factor * bend - factor_slope * rate]
    }
}
