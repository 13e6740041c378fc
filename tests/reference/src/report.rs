//! Error statistics and their limits.

use crate::Limits;
use crate::cases::wanted;
use core::fmt;
use std::collections::BTreeMap;

/// What was compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// Lengths and coordinates: error over the condition number. The raw error is over the size of
    /// the mechanism.
    Position,
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

/// Whose errors they are: a written form, computed with or without fused multiply-adds.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Program {
    pub(crate) form: &'static str,
    pub(crate) fused: bool,
}

impl fmt::Display for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}{}", self.form, if self.fused { " fused" } else { "" })
    }
}

/// One error in three units, each a multiple of the unit roundoff.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Errors {
    /// Of the size of the mechanism, or of the largest quantity of the same kind.
    pub(crate) raw: f64,
    /// As [`Measure`] says.
    pub(crate) conditioned: f64,
    /// Of the uncertainty of this quantity by itself.
    pub(crate) alone: f64,
}

#[derive(Clone, Debug, Default)]
struct Statistics {
    count: usize,
    raw_sum: f64,
    raw_largest: f64,
    sum: f64,
    largest: f64,
    largest_alone: f64,
    place: String,
}

impl Statistics {
    fn merge(&mut self, other: &Self) {
        self.count += other.count;
        self.raw_sum += other.raw_sum;
        self.raw_largest = self.raw_largest.max(other.raw_largest);
        self.sum += other.sum;
        self.largest = self.largest.max(other.largest);
        self.largest_alone = self.largest_alone.max(other.largest_alone);
    }
}

/// Errors of all forms of one mechanism.
#[derive(Clone, Debug, Default)]
pub struct Report {
    statistics: BTreeMap<(Measure, Program), Statistics>,
    failures: Vec<String>,
    failed: usize,
    pub(crate) system: &'static str,
    /// Positions compared.
    pub positions: usize,
    /// Positions that cannot be assembled, as the programs said too.
    pub apart: usize,
    /// Positions so near to a dead point that a change of some roundoffs decides.
    pub undecided: usize,
}

impl Report {
    pub(crate) fn of(system: &'static str) -> Self {
        Self {
            system,
            ..Self::default()
        }
    }

    /// Adds one error; `place` describes it if it is the largest conditioned one.
    pub(crate) fn add(
        &mut self,
        program: Program,
        measure: Measure,
        errors: Errors,
        place: impl FnOnce() -> String,
    ) {
        let entry = self.statistics.entry((measure, program)).or_default();
        let or_infinite = |x: f64| if x.is_nan() { f64::INFINITY } else { x };
        let error = or_infinite(errors.conditioned);
        entry.count += 1;
        entry.raw_sum += errors.raw;
        entry.raw_largest = entry.raw_largest.max(or_infinite(errors.raw));
        entry.sum += error;
        entry.largest_alone = entry.largest_alone.max(or_infinite(errors.alone));
        if entry.place.is_empty() || error > entry.largest {
            entry.largest = error;
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
        let of_measure = self.statistics.iter().filter(|((m, _), _)| *m == measure);
        of_measure.fold(0.0, |largest, (_, s)| f64::max(largest, s.largest))
    }

    /// The same as it is, however badly conditioned the position.
    pub fn largest_raw(&self, measure: Measure) -> f64 {
        let of_measure = self.statistics.iter().filter(|((m, _), _)| *m == measure);
        of_measure.fold(0.0, |largest, (_, s)| f64::max(largest, s.raw_largest))
    }

    /// The report, if that many positions were compared, where all geometries are tried.
    ///
    /// # Panics
    ///
    /// If there were fewer.
    #[must_use]
    pub fn at_least(self, positions: usize) -> Self {
        let (compared, wanted) = (self.positions, wanted(positions));
        assert!(
            compared >= wanted,
            "{}: {compared} positions of {wanted}",
            self.system
        );
        self
    }

    /// Prints the figures of this set of cases and panics if one is beyond its limit or something
    /// failed. `LINKAGE_FORMS=1` prints those of every written form too.
    pub fn check(&self, set: &str, limits: &Limits) {
        println!("{}, {set}: {self}", self.system);
        if std::env::var_os("LINKAGE_FORMS").is_some() {
            println!("{}", self.by_form());
        }
        let mut complaints = self.failures.clone();
        for ((measure, program), s) in &self.statistics {
            let allowed = limits.of(*measure);
            if s.largest > allowed {
                complaints.push(format!(
                    "{program}: {measure:?} {:.3e} > {allowed}: {}",
                    s.largest, s.place
                ));
            }
        }
        assert!(
            complaints.is_empty(),
            "{}, {set}: {} failures\n{}",
            self.system,
            self.failed,
            complaints.join("\n")
        );
        assert!(self.positions > 0, "nothing was compared");
    }

    /// A line for every form and measure.
    fn by_form(&self) -> String {
        let lines = self.statistics.iter().map(|((measure, program), s)| {
            let program = program.to_string();
            format!("{program:<28}{} {}\n", line(*measure, s), s.place)
        });
        lines.collect()
    }

    /// The figures of all forms together, without and with fused multiply-adds.
    fn summary(&self) -> BTreeMap<(Measure, bool), Statistics> {
        let mut summary: BTreeMap<_, Statistics> = BTreeMap::new();
        for ((measure, program), s) in &self.statistics {
            summary
                .entry((*measure, program.fused))
                .or_default()
                .merge(s);
        }
        summary
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "{} positions compared, {} apart, {} undecided",
            self.positions, self.apart, self.undecided
        )?;
        writeln!(
            f,
            "{:<8}{:<13}{:>8}{:>11}{:>11}{:>12}{:>11}{:>11}",
            "", "measure", "count", "raw mean", "raw max", "cond. mean", "cond. max", "alone max"
        )?;
        for ((measure, fused), s) in &self.summary() {
            let name = if *fused { "fused" } else { "plain" };
            writeln!(f, "{name:<8}{}", line(*measure, s))?;
        }
        Ok(())
    }
}

fn line(measure: Measure, s: &Statistics) -> String {
    let count = s.count as f64;
    format!(
        "{:<13}{:>8}{:>11}{:>11}{:>12}{:>11}{:>11}",
        format!("{measure:?}"),
        s.count,
        figure(s.raw_sum / count),
        figure(s.raw_largest),
        figure(s.sum / count),
        figure(s.largest),
        figure(s.largest_alone)
    )
}

/// A number of roundoffs, short.
fn figure(x: f64) -> String {
    if x < 1e4 {
        format!("{x:.3}")
    } else {
        format!("{x:.2e}")
    }
}
