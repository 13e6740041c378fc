//! Error statistics and their limits.

use core::fmt;
use std::collections::BTreeMap;

/// What was compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// Positions: error over roundoff and the size of the mechanism.
    Size,
    /// Positions: the same over the condition number.
    Condition,
    /// `margin()`: error over the inherent uncertainty. So are all that follow.
    Margin,
    /// Values, angles too (from here on the uncertainty is that of the unknowns taken together).
    Value,
    /// `velocity`.
    First,
    /// `acceleration`.
    Second,
    /// `jerk`.
    Third,
    /// `sensitivity`.
    Sensitivity,
    /// `sensitivity(velocity)`.
    Mixed,
    /// `sensitivity(acceleration)`.
    MixedSecond,
    /// `d(q, x, y)` for two parameters.
    Pair,
}

/// The largest errors that are accepted.
#[derive(Clone, Copy, Debug)]
pub struct Limits {
    /// For [`Measure::Condition`].
    pub condition: f64,
    /// For [`Measure::Value`] and [`Measure::Margin`].
    pub value: f64,
    /// For first derivatives.
    pub first: f64,
    /// For second and mixed derivatives.
    pub second: f64,
    /// For third derivatives.
    pub third: f64,
}

impl Limits {
    /// For mechanisms of extreme proportions: without a limit by the condition number, since a
    /// point on a long arm of a short link moves with that link's error, of which the condition
    /// number knows nothing (the inherent uncertainty does); and wider limits, ten times for
    /// derivatives, which are small differences where a mechanism all but turns as a whole.
    pub fn any_proportions(self) -> Self {
        let wider = self.times(10.0);
        Self {
            condition: f64::INFINITY,
            value: 2.0 * self.value,
            ..wider
        }
    }

    /// All limits times a factor, for a written form that does not fit the mechanism: an unknown
    /// point far from the origin at the end of a short link carries roundings of its distance.
    pub fn times(self, factor: f64) -> Self {
        Self {
            condition: factor * self.condition,
            value: factor * self.value,
            first: factor * self.first,
            second: factor * self.second,
            third: factor * self.third,
        }
    }

    fn of(&self, measure: Measure) -> f64 {
        match measure {
            Measure::Size => f64::INFINITY,
            Measure::Condition => self.condition,
            Measure::Value | Measure::Margin => self.value,
            Measure::First | Measure::Sensitivity => self.first,
            Measure::Second | Measure::Mixed | Measure::Pair => self.second,
            Measure::Third | Measure::MixedSecond => self.third,
        }
    }
}

#[derive(Clone, Debug, Default)]
struct Statistics {
    count: usize,
    sum: f64,
    largest: f64,
    largest_alone: f64,
    place: String,
}

/// Errors of all forms of one mechanism.
#[derive(Clone, Debug, Default)]
pub struct Report {
    statistics: BTreeMap<(&'static str, Measure), Statistics>,
    failures: Vec<String>,
    failed: usize,
    /// Positions compared.
    pub positions: usize,
    /// Positions that cannot be assembled, as the programs said too.
    pub apart: usize,
}

impl Report {
    /// Adds one error, in units of the joint uncertainty and in units of the quantity's own;
    /// `place` describes it if it is the largest in the first sense.
    pub fn add(
        &mut self,
        form: &'static str,
        measure: Measure,
        [error, alone]: [f64; 2],
        place: impl FnOnce() -> String,
    ) {
        let entry = self.statistics.entry((form, measure)).or_default();
        entry.count += 1;
        entry.sum += error;
        entry.largest_alone = entry.largest_alone.max(alone);
        if entry.place.is_empty() || error > entry.largest || error.is_nan() {
            entry.largest = if error.is_nan() { f64::INFINITY } else { error };
            entry.place = place();
        }
    }

    /// Adds something that is wrong altogether.
    pub fn fail(&mut self, message: impl FnOnce() -> String) {
        self.failed += 1;
        if self.failures.len() < 12 {
            self.failures.push(message());
        }
    }

    /// The largest error of a measure over all forms.
    pub fn largest(&self, measure: Measure) -> f64 {
        let of_measure = self.statistics.iter().filter(|((_, m), _)| *m == measure);
        of_measure.fold(0.0, |largest, (_, s)| f64::max(largest, s.largest))
    }

    /// Prints the figures and panics if one is beyond its limit or something failed.
    pub fn check(&self, limits: &Limits) {
        println!("{self}");
        let mut complaints = self.failures.clone();
        for ((form, measure), s) in &self.statistics {
            if s.largest > limits.of(*measure) {
                let allowed = limits.of(*measure);
                complaints.push(format!(
                    "{form}: {measure:?} {:.3e} > {allowed}: {}",
                    s.largest, s.place
                ));
            }
        }
        assert!(
            complaints.is_empty(),
            "{} failures\n{}",
            self.failed,
            complaints.join("\n")
        );
        assert!(self.positions > 0, "nothing was compared");
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} positions compared, {} apart",
            self.positions, self.apart
        )?;
        writeln!(
            f,
            "{:<20}{:<13}{:>8}{:>11}{:>11}{:>11}",
            "form", "measure", "count", "mean", "largest", "alone"
        )?;
        for ((form, measure), s) in &self.statistics {
            let mean = s.sum / s.count as f64;
            let name = format!("{measure:?}");
            writeln!(
                f,
                "{form:<20}{name:<13}{:>8}{:>11}{:>11}{:>11}",
                s.count,
                figure(mean),
                figure(s.largest),
                figure(s.largest_alone)
            )?;
        }
        Ok(())
    }
}

/// A number of roundoffs, short.
fn figure(x: f64) -> String {
    if x < 1e4 {
        format!("{x:.3}")
    } else {
        format!("{x:.2e}")
    }
}
