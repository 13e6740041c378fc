//! Solvers of the crate `ivp` on the equations of links: Radau on differential-algebraic equations, and DOP853 on
//! accelerations from a linear system.

use crate::links::{Links, Slope};
use ivp::dense::StepInterpolant;
use ivp::ivp::FirstOrderSystem;
use ivp::matrix::{Matrix, MatrixStorage};
use ivp::methods::{DOP853, RADAU, Tolerance};
use ivp::solout::{ControlFlag, SolOut};
use ivp::status::Status;

/// The equation of the loops that replaces the others: its derivative determines the index.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Level {
    /// Index 3.
    Position,
    /// Index 2.
    Speed,
    /// Index 1.
    Acceleration,
}

/// `q' = v`, `v' = w`, the balance of forces and the loops: coordinates, speeds, accelerations, multipliers.
struct Descriptor<'a> {
    links: &'a Links,
    level: Level,
}

impl FirstOrderSystem for Descriptor<'_> {
    fn derivative(&self, _time: f64, y: &[f64], rate: &mut [f64]) {
        let n = self.links.coordinates();
        let [q, v, w] = [&y[..n], &y[n..2 * n], &y[2 * n..3 * n]];
        rate[..2 * n].copy_from_slice(&y[n..3 * n]);
        let (balance, loops) = rate[2 * n..].split_at_mut(n);
        self.links.balance(q, v, w, &y[3 * n..], balance);
        match self.level {
            Level::Position => self.links.closure(q, loops),
            Level::Speed => self.links.closure_rate(q, v, loops),
            Level::Acceleration => self.links.closure_acceleration(q, v, w, loops),
        }
    }

    fn jac(&self, _time: f64, y: &[f64], out: &mut Matrix) {
        let n = self.links.coordinates();
        let [q, v, w] = [&y[..n], &y[n..2 * n], &y[2 * n..3 * n]];
        out.fill(0.0);
        for i in 0..2 * n {
            out[(i, n + i)] = 1.0;
        }
        self.links
            .mass(q, |i, j, value| out[(2 * n + i, 2 * n + j)] += value);
        self.links
            .balance_slopes(q, v, w, &y[3 * n..], |slope, value| match slope {
                Slope::Position(i, j) => out[(2 * n + i, j)] += value,
                Slope::Speed(i, j) => out[(2 * n + i, n + j)] += value,
            });
        for column in self.links.columns(q) {
            let i = column.coordinate;
            for axis in 0..2 {
                let row = 3 * n + column.equation + axis;
                let [slope, bend, third] =
                    [column.slope, column.bend, column.third].map(|vector| vector[axis]);
                out[(2 * n + i, row)] += slope;
                match self.level {
                    Level::Position => out[(row, i)] += slope,
                    Level::Speed => {
                        out[(row, i)] += bend * v[i];
                        out[(row, n + i)] += slope;
                    }
                    Level::Acceleration => {
                        out[(row, i)] += bend * w[i] + third * v[i] * v[i];
                        out[(row, n + i)] += 2.0 * bend * v[i];
                        out[(row, 2 * n + i)] += slope;
                    }
                }
            }
        }
    }

    fn mass(&self, out: &mut Matrix) {
        for i in 0..2 * self.links.coordinates() {
            out[(i, i)] = 1.0;
        }
    }
}

/// `q' = v`, `v'` from the linear system.
struct Reduced<'a>(&'a Links);

impl FirstOrderSystem for Reduced<'_> {
    fn derivative(&self, _time: f64, y: &[f64], rate: &mut [f64]) {
        let n = self.0.coordinates();
        let (q, v) = y.split_at(n);
        rate[..n].copy_from_slice(v);
        rate[n..].copy_from_slice(&self.0.accelerations(q, v).as_slice()[..n]);
    }
}

/// The first coordinate after the last step.
struct Last(f64);

impl SolOut for Last {
    fn solout(
        &mut self,
        _from: f64,
        _to: &mut f64,
        y: &mut [f64],
        _dense: Option<&StepInterpolant<'_>>,
    ) -> ControlFlag {
        self.0 = y[0];
        ControlFlag::Continue
    }
}

/// Returns the first coordinate at the end by Radau; nothing if the method gives up.
pub(crate) fn radau(
    links: &Links,
    level: Level,
    (q, v): (&[f64], &[f64]),
    end: f64,
    tolerance: f64,
) -> Option<f64> {
    let (n, m) = (links.coordinates(), links.equations());
    let mut y = [q, v].concat();
    y.extend_from_slice(links.accelerations(q, v).as_slice());
    let (nind2, nind3) = match level {
        Level::Position => (n, n + m),
        Level::Speed => (n + m, 0),
        Level::Acceleration => (0, 0),
    };
    let method = RADAU {
        nind2: Some(nind2),
        nind3: Some(nind3),
        jac_storage: MatrixStorage::Full,
        mass_storage: MatrixStorage::Full,
        dense_output: false,
        ..RADAU::default()
    };
    let list = || Tolerance::Vector(vec![tolerance; y.len()]);
    let mut last = Last(f64::NAN);
    let result = method.solve(
        &Descriptor { links, level },
        0.0,
        &y,
        end,
        list(),
        list(),
        Some(&mut last),
    );
    result
        .is_ok_and(|result| result.status == Status::Success)
        .then_some(last.0)
}

/// Returns the first coordinate at the end by DOP853; nothing if the method gives up.
pub(crate) fn dop853(
    links: &Links,
    (q, v): (&[f64], &[f64]),
    end: f64,
    tolerance: f64,
) -> Option<f64> {
    let y = [q, v].concat();
    let method = DOP853 {
        dense_output: false,
        ..DOP853::default()
    };
    let list = || Tolerance::Vector(vec![tolerance; y.len()]);
    let mut last = Last(f64::NAN);
    let result = method.solve(
        &Reduced(links),
        0.0,
        &y,
        end,
        list(),
        list(),
        Some(&mut last),
    );
    result
        .is_ok_and(|result| result.status == Status::Success)
        .then_some(last.0)
}
