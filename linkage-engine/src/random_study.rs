//! Random mechanisms within their tolerances, of mechanisms that are compiled at run time.
//!
//! The studies of `linkage-analysis` have types with the numbers of dimensions and of results. Here
//! they are behind one type: dimensions are filled up with exact ones that no function has.

use std::time::Duration;

use linkage_analysis::tolerance::{Distribution, MonteCarlo, Study};
use linkage_runtime::Table;

use crate::columns::Columns;
use crate::compiled::Assembly;
use crate::error::ToleranceError;
use crate::random_results::{Filled, RandomResults, Streamed, text};
use crate::tolerance_effects::filled_up;

/// The most results of a study.
const MOST_NUMBERS: usize = 4;

/// A study of mechanisms whose dimensions are drawn within their tolerances, each with the results
/// of a function at one position.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyPlan {
    /// The number of mechanisms.
    pub count: u64,
    /// Another seed gives other mechanisms.
    pub seed: u64,
    /// The distribution of dimensions without one of their own.
    pub distribution: Distribution,
    /// Distributions of dimensions by their index.
    pub exceptions: Vec<(usize, Distribution)>,
    /// The part of the study that is evaluated, counted from 0, and the number of parts.
    pub part: [u64; 2],
    /// The function, by its number.
    pub function: usize,
    /// Its arguments.
    pub arguments: Vec<f64>,
    /// Its columns that are counted, at most 4.
    pub columns: Vec<usize>,
}

/// A study that goes on step by step. The mechanisms are those of the macro's study with equal
/// seed, to the last bit, for every number of threads and parts.
pub struct RandomStudy<'a> {
    study: Box<dyn Continued + 'a>,
}

impl<'a> RandomStudy<'a> {
    /// Begins a study with random mechanisms in the modes of an assembly. Their mean dimensions
    /// are those of the assembly, the tolerances are declared. The first 4096 mechanisms are
    /// evaluated now: they set the bins of the histogram. `progress` gets the numbers of
    /// mechanisms that are done and to be done, on this thread.
    ///
    /// # Errors
    ///
    /// For a study without mechanisms or numbers, with more than 4 numbers or 512 dimensions, for
    /// tolerances that are negative or no numbers, and for a part that does not exist.
    ///
    /// # Panics
    ///
    /// If the function takes another number of arguments, or there is no such function or column.
    pub fn new(
        assembly: &'a Assembly<'_>,
        plan: &StudyPlan,
        progress: impl FnMut(usize, usize) + 'a,
    ) -> Result<Self, ToleranceError> {
        match assembly.dimensions().len() {
            0..=8 => sized::<8>(assembly, plan, progress),
            9..=32 => sized::<32>(assembly, plan, progress),
            33..=128 => sized::<128>(assembly, plan, progress),
            129..=512 => sized::<512>(assembly, plan, progress),
            count => Err(ToleranceError(format!(
                "{count} dimensions, where a study has 512 at most; this is a limit of linkage"
            ))),
        }
    }

    /// Evaluates more mechanisms on all threads of rayon's current pool, for about this time.
    pub fn advance(&mut self, time: Duration) {
        self.study.advance(time);
    }

    /// True if all mechanisms of the study, or of its part, are evaluated.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.study.is_done()
    }

    /// Returns the number of mechanisms that are evaluated.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.study.done()
    }

    /// Returns the results up to now.
    #[must_use]
    pub fn results(&self) -> RandomResults {
        RandomResults::new(self.study.results())
    }
}

fn sized<'a, const N: usize>(
    assembly: &'a Assembly<'_>,
    plan: &StudyPlan,
    progress: impl FnMut(usize, usize) + 'a,
) -> Result<RandomStudy<'a>, ToleranceError> {
    match plan.columns[..] {
        [a] => begun::<N, 1>(assembly, plan, progress, [a]),
        [a, b] => begun::<N, 2>(assembly, plan, progress, [a, b]),
        [a, b, c] => begun::<N, 3>(assembly, plan, progress, [a, b, c]),
        [a, b, c, d] => begun::<N, 4>(assembly, plan, progress, [a, b, c, d]),
        _ => Err(ToleranceError(format!(
            "{} numbers, where a study has 1 to {MOST_NUMBERS}",
            plan.columns.len()
        ))),
    }
}

fn begun<'a, const N: usize, const K: usize>(
    assembly: &'a Assembly<'_>,
    plan: &StudyPlan,
    mut progress: impl FnMut(usize, usize) + 'a,
    wanted: [usize; K],
) -> Result<RandomStudy<'a>, ToleranceError> {
    let parameters = assembly.mechanism().parameters();
    let tolerances = filled_up::<N>(parameters)?;
    let mut nominal = [0.0; N];
    nominal[..parameters.len()].copy_from_slice(assembly.dimensions());
    let StudyPlan {
        count,
        seed,
        distribution,
        ref exceptions,
        part: [part, of],
        function,
        ..
    } = *plan;
    let mut study = MonteCarlo::new(count as usize)
        .seed(seed)
        .distribution(distribution)
        .part(part, of)
        .progress(move |seen| progress(seen.done, seen.count));
    for &(index, distribution) in exceptions {
        study = study.distribution_of(index, distribution);
    }
    let (used, arguments) = (parameters.len(), plan.arguments.clone());
    let evaluate = move |dimensions: [&[f64]; N], numbers: [&mut [f64]; K]| {
        let arguments: Vec<&[f64]> = arguments.chunks(1).collect();
        let mut columns = Columns::default();
        assembly.sweep_sets_into(function, &dimensions[..used], &arguments, &mut columns);
        for (numbers, column) in numbers.into_iter().zip(wanted) {
            match columns.column(column) {
                // Nothing varies.
                [only] => numbers.fill(*only),
                column => numbers.copy_from_slice(column),
            }
        }
    };
    let study = study.start_columns(&nominal, &tolerances, evaluate);
    Ok(RandomStudy {
        study: Box::new(Filled {
            inner: study.map_err(text)?,
            used,
        }),
    })
}

/// The methods of studies of all sizes.
trait Continued {
    fn advance(&mut self, time: Duration);
    fn is_done(&self) -> bool;
    fn done(&self) -> u64;
    fn results(&self) -> Box<dyn Streamed + Send + Sync>;
}

impl<const N: usize, const K: usize> Continued for Filled<Study<'_, N, K>> {
    fn advance(&mut self, time: Duration) {
        self.inner.advance(time);
    }

    fn is_done(&self) -> bool {
        self.inner.is_done()
    }

    fn done(&self) -> u64 {
        self.inner.results().done()
    }

    fn results(&self) -> Box<dyn Streamed + Send + Sync> {
        Box::new(Filled {
            inner: self.inner.results().clone(),
            used: self.used,
        })
    }
}
