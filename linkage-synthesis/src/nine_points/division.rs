//! The search in parts, for several processes.

mod serial;

use super::super::error::Unsolved;
use super::equations::Unknowns;
use super::listing::listing;
use super::result::NinePoints;
use super::search::{Ends, SolutionSearch, follow};
use super::stored_solutions;
use super::task::Task;
use linkage_core::numeric::complex::Complex;
use linkage_design::Progress;
use linkage_design::internals::{WHOLE, missing, unite};
use std::boxed::Box;
use std::vec::Vec;

/// A search for all four-bars through nine points, whole or in parts.
///
/// ```
/// use linkage_synthesis::{NinePoints, NinePointsPart, NinePointsSearch, Unsolved};
///
/// // In each process: a part, as bytes.
/// type Points = [[f64; 2]; 9];
/// fn part(points: &Points, k: usize, of: usize) -> Result<Vec<u8>, Unsolved> {
///     Ok(NinePointsSearch::new(points)?.part(k, of).follow()?.to_bytes())
/// }
///
/// // In one of them: the four-bars, as of one search.
/// fn whole(points: &Points, parts: &[Vec<u8>]) -> Result<NinePoints, Unsolved> {
///     let mut search = NinePointsSearch::new(points)?;
///     for part in parts {
///         search = search.known(NinePointsPart::read(part)?);
///     }
///     search.run()
/// }
///
/// # let square = |k: usize| (k * k % 7) as f64;
/// # let points: Points = std::array::from_fn(|k| [k as f64, square(k)]);
/// // One of 1442 paths.
/// let bytes = part(&points, 0, 1442)?;
/// assert_eq!(NinePointsPart::read(&bytes)?.done(), 1);
/// # Ok::<(), Unsolved>(())
/// ```
pub struct NinePointsSearch<'a> {
    pub(super) points: [[f64; 2]; 9],
    pub(super) task: Task,
    /// The solutions whose paths are followed.
    pub(super) starts: Vec<Unknowns<Complex>>,
    /// The part of the paths, and the number of parts.
    part: [usize; 2],
    known: Vec<NinePointsPart>,
    report: Box<dyn FnMut(Progress) -> bool + 'a>,
}

impl<'a> NinePointsSearch<'a> {
    /// A search for four-bars with a coupler point that passes the points, in any order and on any
    /// circuit.
    ///
    /// # Errors
    ///
    /// `NotFinite`; `Equal` points; `OnCircle` or `OnLine` for more than six points on a circle or
    /// a line.
    pub fn new(points: &[[f64; 2]; 9]) -> Result<Self, Unsolved> {
        Ok(Self {
            points: *points,
            task: Task::new(points)?,
            starts: stored_solutions::solutions(),
            part: WHOLE,
            known: Vec::new(),
            report: Box::new(|_| true),
        })
    }

    /// Part `part` of `of`, counted from 0: some of the paths, nearly as many as each other part
    /// has. [`follow`](Self::follow) follows them.
    #[must_use]
    pub fn part(mut self, part: usize, of: usize) -> Self {
        self.part = [part, of];
        self
    }

    /// Takes paths of the same points from another process or a file; they are not followed again.
    /// `run` and `follow` return `OtherProblem` if they are of other points.
    #[must_use]
    pub fn known(mut self, part: NinePointsPart) -> Self {
        self.known.push(part);
        self
    }

    /// Calls `report` some dozen times; the search ends where it gives `false`.
    #[must_use]
    pub fn progress(mut self, report: impl FnMut(Progress) -> bool + 'a) -> Self {
        self.report = Box::new(report);
        self
    }

    /// Follows the paths of a [`part`](Self::part), for a search in several processes: each follows
    /// a part, and one of them takes all parts by [`known`](Self::known) and runs.
    ///
    /// A search that is ended by [`progress`](Self::progress) returns the paths that it has.
    ///
    /// # Errors
    ///
    /// `Part`, `OtherProblem`, `Repeated`.
    pub fn follow(mut self) -> Result<NinePointsPart, Unsolved> {
        let [part, of] = self.part;
        if part >= of {
            return Err(Unsolved::Part { part, of });
        }
        let mut paths = self.merged()?;
        let missing = missing(&paths.ends, self.part, self.starts.len());
        let ends = follow(&self.task, &self.starts, &missing, &mut self.report);
        paths.ends.extend(ends);
        Ok(paths)
    }

    /// Lists all four-bars: follows the paths that are missing, and those again that have no end of
    /// their own.
    ///
    /// The same points always give the same listing, whatever the number of threads and parts.
    ///
    /// # Errors
    ///
    /// `OtherProblem`, `Repeated`; `Stopped` by [`progress`](Self::progress).
    pub fn run(mut self) -> Result<NinePoints, Unsolved> {
        let known = self.merged()?.ends;
        let search = SolutionSearch::run(&self.task, &self.starts, &known, &mut self.report)?;
        Ok(listing(&self.task, &search.found))
    }

    fn merged(&self) -> Result<NinePointsPart, Unsolved> {
        let mut all = NinePointsPart {
            points: self.points,
            ends: Ends::new(),
        };
        self.known.iter().try_for_each(|part| all.merge(part))?;
        Ok(all)
    }
}

/// Ends of some paths of a search through nine points. [`NinePointsSearch::follow`] computes them,
/// in any process; [`NinePointsSearch::known`] takes them, so that these paths are not followed
/// again.
///
/// Parts may come in any number and order: the four-bars are equal to those of one search, to the
/// last bit on equal processors. Each end has its certificate.
#[derive(Clone, Debug, PartialEq)]
pub struct NinePointsPart {
    points: [[f64; 2]; 9],
    /// By the numbers of the paths.
    pub(super) ends: Ends,
}

impl NinePointsPart {
    /// Adds the paths of another part of the same points.
    ///
    /// # Errors
    ///
    /// `OtherProblem` if the points differ; `Repeated` if both have a path. Nothing changes then.
    pub fn merge(&mut self, part: &Self) -> Result<(), Unsolved> {
        if self.points != part.points {
            return Err(Unsolved::OtherProblem);
        }
        match unite(&mut self.ends, &part.ends) {
            true => Ok(()),
            false => Err(Unsolved::Repeated),
        }
    }

    /// The number of paths that have been followed.
    #[must_use]
    pub fn done(&self) -> usize {
        self.ends.len()
    }

    /// The number of all paths.
    #[must_use]
    pub const fn count(&self) -> usize {
        super::TRIPLES
    }
}
