//! A task as all solvers get it, and the solvers of `ivp` on its equations.

use crate::comparison::{Method, Run};
use crate::links::Links;
use crate::solvers::{Level, dop853, radau};
use crate::timing::best;
use linkage_peers::timing::only_tested;
use std::hint::black_box;

/// A mechanism with its start, and the first coordinate at the end.
pub(crate) struct Task {
    pub(crate) links: Links,
    pub(crate) positions: Vec<f64>,
    pub(crate) speeds: Vec<f64>,
    pub(crate) end: f64,
    pub(crate) solution: f64,
}

impl Task {
    /// Returns the run of a method that returns the first coordinate at the end; nothing if it gives up.
    pub(crate) fn run(&self, method: impl Fn(f64) -> Option<f64>) -> Option<Run> {
        let error = (method(self.end)? - self.solution).abs();
        let seconds = best(|| {
            black_box(method(black_box(self.end)));
        });
        Some(Run { error, seconds })
    }

    /// Returns the methods of `ivp` on the equations of the links: Radau of all three indices, and DOP853.
    pub(crate) fn others(&self) -> Vec<Method> {
        let start = (&self.positions[..], &self.speeds[..]);
        let most = if only_tested() { 4 } else { 13 };
        let sweep = |name: &str, solve: &dyn Fn(f64, f64) -> Option<f64>| {
            let tolerances = (3..=most).map(|digits| 10_f64.powi(-digits));
            let runs = tolerances.filter_map(|tolerance| self.run(|end| solve(end, tolerance)));
            Method {
                name: name.to_owned(),
                is_ours: false,
                runs: runs.collect(),
            }
        };
        let levels = [
            ("Radau (ivp), DAE of index 3", Level::Position),
            ("Radau (ivp), DAE of index 2", Level::Speed),
            ("Radau (ivp), DAE of index 1", Level::Acceleration),
        ];
        let mut methods: Vec<Method> = levels
            .into_iter()
            .map(|(name, level)| {
                sweep(name, &|end, tolerance| {
                    radau(&self.links, level, start, end, tolerance)
                })
            })
            .collect();
        methods.push(sweep("DOP853 (ivp), linear system", &|end, tolerance| {
            dop853(&self.links, start, end, tolerance)
        }));
        methods
    }
}
