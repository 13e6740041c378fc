//! The sum of squares as one number of six variables, with its gradient, and the notes of what a method found when.

use crate::mechanism::FourBar;
use crate::problems::{Problem, problems};
use linkage::design::Timing;
use std::cell::RefCell;
use std::time::{Duration, Instant};

/// How many variables there are: four lengths, and the place on the coupler.
pub(crate) const VARIABLES: usize = 6;
/// What a violated bound or condition costs, for each unit of its square.
const PENALTY: f64 = 10.0;
/// What a mechanism costs that does not assemble at a point.
const OPEN: f64 = 1e4;

/// Improvements of a method with their times.
pub(crate) struct Trace {
    improvements: Vec<(f64, f64)>,
}

impl Trace {
    /// The time to a relative error; infinite if it was not reached.
    pub(crate) fn time_to(&self, error: f64) -> f64 {
        let enough = self
            .improvements
            .iter()
            .find(|(_, sum)| *sum <= known() * (1.0 + error));
        enough.map_or(f64::INFINITY, |(time, _)| *time)
    }

    pub(crate) fn of(improvements: Vec<(f64, f64)>) -> Self {
        Self { improvements }
    }
}

/// The problem.
pub(crate) fn problem() -> Problem {
    let [_, timed, ..] = problems();
    timed
}

fn known() -> f64 {
    // The least sum to all of its digits, found by `linkage::design` from every seed; it agrees with the published one.
    7.415_751_306_78e-7
}

/// The function that the others minimise, with a clock.
pub(crate) struct Objective {
    pub(crate) points: &'static [[f64; 2]],
    pub(crate) angles: Vec<f64>,
    pub(crate) bounds: [[f64; 2]; VARIABLES],
    began: Instant,
    limit: Duration,
    notes: RefCell<Vec<(f64, f64)>>,
}

impl Objective {
    pub(crate) fn new(limit: Duration) -> Self {
        let problem = problem();
        let Timing::Given(angles) = problem.timing else {
            panic!("the problem has its angles");
        };
        let (length, arm) = (problem.lengths, [-problem.arm, problem.arm]);
        Self {
            points: problem.points,
            angles,
            bounds: [length, length, length, length, arm, arm],
            began: Instant::now(),
            limit,
            notes: RefCell::default(),
        }
    }

    pub(crate) fn is_over(&self) -> bool {
        self.began.elapsed() >= self.limit
    }

    pub(crate) fn trace(self) -> Trace {
        Trace::of(self.notes.into_inner())
    }

    /// Value and gradient.
    pub(crate) fn at(&self, x: &[f64]) -> (f64, [f64; VARIABLES]) {
        let [frame, crank, coupler, rocker] = [x[0], x[1], x[2], x[3]];
        let mechanism = FourBar {
            frame,
            crank,
            coupler,
            rocker,
            arm: [x[4], x[5]].into(),
            ..FourBar::default()
        };
        let mut gradient = [0.0; VARIABLES];
        let mut penalty = 0.0;
        for (j, [low, high]) in self.bounds.iter().enumerate() {
            let outside = (low - x[j]).max(0.0) - (x[j] - high).max(0.0);
            penalty += PENALTY * outside * outside;
            gradient[j] -= 2.0 * PENALTY * outside;
        }
        for signs in [
            [1.0, 1.0, -1.0, -1.0],
            [-1.0, 1.0, 1.0, -1.0],
            [-1.0, 1.0, -1.0, 1.0],
        ] {
            let over: f64 = signs
                .iter()
                .zip(x)
                .map(|(sign, x)| sign * x)
                .sum::<f64>()
                .max(0.0);
            penalty += PENALTY * over * over;
            signs
                .iter()
                .zip(&mut gradient)
                .for_each(|(sign, g)| *g += 2.0 * PENALTY * sign * over);
        }
        let Ok(assembly) = mechanism.assemble() else {
            return (OPEN + penalty, gradient);
        };
        let mut sum = 0.0;
        for (phi, point) in self.angles.iter().zip(self.points) {
            let path = assembly.path(*phi);
            let [dx, dy] = [path.tracer.x - point[0], path.tracer.y - point[1]];
            sum += dx * dx + dy * dy;
            for (g, s) in gradient.iter_mut().zip(&path.s) {
                *g += 2.0 * (dx * s.x + dy * s.y);
            }
        }
        if !sum.is_finite() {
            return (OPEN + penalty, [0.0; VARIABLES]);
        }
        if penalty == 0.0 {
            self.note(sum);
        }
        (sum + penalty, gradient)
    }

    fn note(&self, sum: f64) {
        let mut notes = self.notes.borrow_mut();
        if notes.last().is_none_or(|(_, least)| sum < *least) {
            notes.push((self.began.elapsed().as_secs_f64(), sum));
        }
    }
}
