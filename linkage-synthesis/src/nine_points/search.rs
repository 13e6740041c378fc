//! Continuation of all stored solutions, and classification of their ends.

use super::super::ARCS;
use super::super::ball::{Ball, Bound};
use super::super::certificate::{self, Evaluated, Point, System};
use super::super::error::Unsolved;
use super::super::long::Long;
use super::super::path::Pace;
use super::super::task::Shift;
use super::cognates::{Mark, cognate, exchanged};
use super::equations::{self, ALL, Shifts, Unknowns};
use super::path::{self, ParameterPath};
use super::stored_solutions;
use super::task::Task;
use linkage_core::numeric::complex::{Complex, ONE, ZERO};
use linkage_core::numeric::double_double::DoubleDouble;
use linkage_design::Progress;
use linkage_design::internals::in_parallel;
use std::collections::{BTreeMap, BTreeSet};
use std::vec::Vec;

pub(super) type Certificate = certificate::Certificate<ALL>;

/// A solution that is shown to be one.
pub(super) type FoundSolution = (Certificate, Mark);

/// Ends of paths by their numbers, as followed along the first arc; `None` where there is no end.
pub(super) type Ends = BTreeMap<usize, Option<FoundSolution>>;

/// Solutions, each shown to differ from the others, also as a cognate.
#[derive(Default)]
pub(super) struct SolutionSearch {
    pub(super) found: Vec<FoundSolution>,
    /// For each of them, the start whose path came there first on this way.
    origins: Vec<Option<usize>>,
}

/// The number of attempts for a path without an end of its own on each arc, in ever shorter steps.
const ATTEMPTS: usize = 3;
/// Paths of a block: some dozen reports in all, and enough for many threads.
const BLOCK: usize = 64;
const STEPS: usize = 5;
/// The arc and the attempt that parts of a search have.
const FIRST: (usize, usize) = (0, 0);

impl SolutionSearch {
    pub(super) fn run(
        task: &Task,
        starts: &[Unknowns<Complex>],
        known: &Ends,
        report: &mut impl FnMut(Progress) -> bool,
    ) -> Result<Self, Unsolved> {
        let (from, data) = (stored_solutions::shifts(), Data::new(&task.shifts));
        let mut search = Self::default();
        let mut count = starts.len();
        let mut done = 0;
        report_progress(report, done, count)?;
        for (arc, angle) in ARCS.into_iter().enumerate() {
            let way = ParameterPath {
                from: &from,
                to: &data.plain,
                arc: Complex::polar(angle),
            };
            search.origins.fill(None);
            let mut left: Vec<usize> = (0..starts.len()).collect();
            for attempt in 0..ATTEMPTS {
                let pace = Pace::of_attempt(attempt);
                let mut again = BTreeSet::new();
                for block in left.chunks(BLOCK) {
                    let ends = in_parallel(block, |&i| {
                        match known.get(&i).filter(|_| (arc, attempt) == FIRST) {
                            Some(end) => end.clone(),
                            // Many digits take as long as the path: used only where nothing else
                            // decides.
                            None if attempt + 1 == ATTEMPTS => {
                                data.end_long(&starts[i], &way, pace)
                            }
                            None => data.end(&starts[i], &way, pace),
                        }
                    });
                    for (&i, end) in block.iter().zip(ends) {
                        again.extend(search.doubtful(i, end));
                    }
                    done += block.len();
                    report_progress(report, done, count)?;
                }
                if search.found.len() >= starts.len() {
                    return Ok(search);
                }
                count += again.len();
                left = again.into_iter().collect();
            }
            count += starts.len();
        }
        Ok(search)
    }

    /// The starts whose paths must be followed again: this one if it has no end, and both of two
    /// with one end, of which one has come off its path.
    fn doubtful(&mut self, start: usize, end: Option<FoundSolution>) -> Vec<usize> {
        let Some(end) = end else {
            return [start].into();
        };
        let index = self.index_of(end);
        let origin = *self.origins[index].get_or_insert(start);
        if origin == start {
            Vec::new()
        } else {
            [origin, start].into()
        }
    }

    /// Returns the index of a solution among those found, the last one if it is new.
    pub(super) fn index_of(&mut self, end: FoundSolution) -> usize {
        let known = self
            .found
            .iter()
            .position(|(_, other)| !end.1.is_apart_from(other));
        known.unwrap_or_else(|| {
            self.found.push(end);
            self.origins.push(None);
            self.found.len() - 1
        })
    }
}

/// Follows paths along the first arc, until the progress is answered by `false`.
pub(super) fn follow(
    task: &Task,
    starts: &[Unknowns<Complex>],
    numbers: &[usize],
    report: &mut impl FnMut(Progress) -> bool,
) -> Ends {
    let (from, data) = (stored_solutions::shifts(), Data::new(&task.shifts));
    let (arc, attempt) = FIRST;
    let way = ParameterPath {
        from: &from,
        to: &data.plain,
        arc: Complex::polar(ARCS[arc]),
    };
    let pace = Pace::of_attempt(attempt);
    let mut ends = Ends::new();
    for block in numbers.chunks(BLOCK) {
        if report_progress(report, ends.len(), numbers.len()).is_err() {
            return ends;
        }
        let found = in_parallel(block, |&i| data.end(&starts[i], &way, pace));
        ends.extend(block.iter().copied().zip(found));
    }
    // Nothing is left that a receiver could stop.
    let _ = report_progress(report, ends.len(), numbers.len());
    ends
}

fn report_progress(
    report: &mut impl FnMut(Progress) -> bool,
    done: usize,
    count: usize,
) -> Result<(), Unsolved> {
    let stopped = Unsolved::Stopped { done, count };
    let progress = Progress {
        done,
        count,
        least: f64::INFINITY,
    };
    report(progress).then_some(()).ok_or(stopped)
}

/// The points against the first one in the numbers that are needed.
pub(super) struct Data {
    pub(super) plain: Shifts<Complex>,
    pub(super) wide: Shifts<Complex<DoubleDouble>>,
    pub(super) discs: Shifts<Ball>,
}

impl Data {
    pub(super) fn new(shifts: &[Shift; 8]) -> Self {
        let wide = shifts.map(Shift::wide);
        Self {
            plain: wide.map(|pair| pair.map(Complex::narrow)),
            wide,
            discs: shifts.map(Shift::discs),
        }
    }

    /// Returns the end of a path, as a certificate of the cognate that has one.
    pub(super) fn end(
        &self,
        start: &Unknowns<Complex>,
        way: &ParameterPath<'_>,
        pace: Pace,
    ) -> Option<FoundSolution> {
        let all = self.cognates(start, way, pace)?;
        all.iter().find_map(|unknowns| self.shown(unknowns))
    }

    /// The same with more digits where those of `end` are not enough.
    fn end_long(
        &self,
        start: &Unknowns<Complex>,
        way: &ParameterPath<'_>,
        pace: Pace,
    ) -> Option<FoundSolution> {
        let all = self.cognates(start, way, pace)?;
        let shown = all.iter().find_map(|unknowns| self.shown(unknowns));
        shown.or_else(|| all.iter().find_map(|unknowns| self.shown_long(unknowns)))
    }

    fn cognates(
        &self,
        start: &Unknowns<Complex>,
        way: &ParameterPath<'_>,
        pace: Pace,
    ) -> Option<[Unknowns<Complex>; 3]> {
        let end = path::follow(start, way, pace)?;
        let second = cognate(&end, &self.plain);
        let third = cognate(&exchanged(&end), &self.plain);
        Some([end, second, third])
    }

    /// A certificate where those of fewer digits fail.
    pub(super) fn shown_long(&self, unknowns: &Unknowns<Complex>) -> Option<FoundSolution> {
        let certificate = certificate::certify_long(unknowns, self)?;
        let mark = Mark::new(&certificate.discs)?;
        Some((certificate, mark))
    }

    /// A certificate near these unknowns.
    pub(super) fn shown(&self, unknowns: &Unknowns<Complex>) -> Option<FoundSolution> {
        let refined = self.refined(unknowns)?;
        let certificate = certificate::certify(&refined, self)?;
        let mark = Mark::new(&certificate.discs)?;
        Some((certificate, mark))
    }

    /// Newton's steps with residuals of twice the digits.
    fn refined(&self, start: &Unknowns<Complex>) -> Option<Point<ALL>> {
        let values = |unknowns: &_| {
            let (values, _) = equations::all(unknowns, &self.wide, [ZERO, ONE].map(Complex::wide));
            values.map(Complex::narrow)
        };
        let matrix = |unknowns: &_| equations::all(unknowns, &self.plain, [ZERO, ONE]).1;
        certificate::refined(start, STEPS, values, matrix).ok()
    }
}

impl System<ALL> for Data {
    fn values(&self, point: &Point<ALL>) -> [Ball; ALL] {
        let (values, _) = equations::all(point, &self.wide, [ZERO, ONE].map(Complex::wide));
        let shifts = self.wide.map(|pair| pair.map(Bound::from_wide));
        let (sizes, _) = equations::all(
            &point.map(Bound::from_wide),
            &shifts,
            [Bound(0.0), Bound(1.0)],
        );
        core::array::from_fn(|i| sizes[i].around(values[i]))
    }

    fn matrix(&self, discs: &[Ball; ALL]) -> [[Ball; ALL]; ALL] {
        equations::all(discs, &self.discs, [Ball::ZERO, Ball::exact(ONE)]).1
    }

    fn long(&self, discs: &[Ball<Long>; ALL]) -> Option<Evaluated<ALL>> {
        let shifts = self.wide.map(|pair| pair.map(Ball::from));
        Some(equations::all(discs, &shifts, [0.0.into(), 1.0.into()]))
    }
}
