//! Random mechanisms within their tolerances.

use std::sync::atomic::Ordering;
use std::time::Duration;

use linkage_analysis::tolerance::{Distribution, Estimate, Statistics};
use linkage_engine::{ExtremeMechanism, RandomResults, RandomStudy, StudyPlan, ToleranceError};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::assembly::Assembly;
use crate::raised::no_figures;
use crate::searches::searched;

/// The time from one look at the order to end to the next: a step begins with small rounds.
const STEP: Duration = Duration::from_millis(500);

/// A value with the lower and the upper end of its interval.
type EstimateOf = (f64, f64, f64);

/// The number of values, mean, deviation, skewness, least and largest value.
type StatisticsOf = (usize, EstimateOf, EstimateOf, f64, f64, f64);

/// Value, number of the mechanism, and its dimensions.
type ExtremeOf = (f64, u64, Vec<f64>);

/// Function, its arguments, and its columns that are counted.
type Function = (usize, Vec<f64>, Vec<usize>);

/// Mechanisms, seed, distribution, those of some dimensions, part, and number of parts.
type Draw = (u64, u64, String, Vec<(usize, String)>, u64, u64);

/// The results of a study.
#[pyclass(frozen, module = "linkage._linkage")]
pub(crate) struct Study {
    results: RandomResults,
}

/// Draws the mechanisms of a study and evaluates them.
#[pyfunction]
pub(crate) fn random_study(
    py: Python<'_>,
    assembly: &Assembly,
    function: Function,
    draw: Draw,
    threads: usize,
    shown: Option<Py<PyAny>>,
) -> PyResult<Study> {
    let plan = plan(function, draw)?;
    let found = searched(py, threads, shown.as_ref(), |watched| {
        let report = |done, count| watched.report((done, count, f64::NAN));
        let mut study = RandomStudy::new(assembly.get(), &plan, report)?;
        while !study.is_done() && !watched.stopped.load(Ordering::Relaxed) {
            study.advance(STEP);
        }
        Ok(study.results())
    })?;
    study(py, found)
}

/// Reads the results of a study.
#[pyfunction]
pub(crate) fn read_study(
    py: Python<'_>,
    assembly: &Assembly,
    function: Function,
    draw: Draw,
    bytes: &[u8],
) -> PyResult<Study> {
    let plan = plan(function, draw)?;
    let found = py.detach(|| {
        let study = RandomStudy::new(assembly.get(), &plan, |_, _| ())?;
        study.results().read(bytes)
    });
    study(py, found)
}

#[pymethods]
impl Study {
    #[getter]
    fn done(&self) -> u64 {
        self.results.done()
    }

    #[getter]
    fn missing(&self) -> u64 {
        self.results.missing()
    }

    fn to_bytes<'py>(&self, py: Python<'py>) -> Bound<'py, PyBytes> {
        PyBytes::new(py, &self.results.to_bytes())
    }

    /// The results together with those of other parts.
    fn merged(&self, py: Python<'_>, others: Vec<Vec<u8>>) -> PyResult<Self> {
        let found = py.detach(|| {
            let mut all = self.results.read(&self.results.to_bytes())?;
            for bytes in &others {
                all.merge(bytes)?;
            }
            Ok(all)
        });
        study(py, found)
    }

    fn statistics(&self, number: usize) -> StatisticsOf {
        let Statistics {
            count,
            mean,
            deviation,
            skewness,
            min,
            max,
            ..
        } = self.results.statistics(number);
        (
            count,
            estimate(mean),
            estimate(deviation),
            skewness,
            min,
            max,
        )
    }

    fn percentile(&self, number: usize, part: f64, confidence: f64) -> EstimateOf {
        estimate(self.results.percentile(number, part, confidence))
    }

    fn part_within(&self, number: usize, low: f64, high: f64, confidence: f64) -> EstimateOf {
        estimate(self.results.part_within(number, [low, high], confidence))
    }

    fn histogram(&self, number: usize, low: f64, high: f64, bins: usize) -> Vec<f64> {
        self.results.histogram(number, [low, high], bins)
    }

    fn extremes(&self, number: usize) -> Option<Vec<ExtremeOf>> {
        let extremes = self.results.extremes(number)?.into_iter();
        let one = |extreme: ExtremeMechanism| (extreme.value, extreme.number, extreme.dimensions);
        Some(extremes.map(one).collect())
    }
}

fn estimate(estimate: Estimate) -> EstimateOf {
    (estimate.value, estimate.low, estimate.high)
}

fn study(py: Python<'_>, found: Result<RandomResults, ToleranceError>) -> PyResult<Study> {
    match found {
        Ok(results) => Ok(Study { results }),
        Err(error) => Err(no_figures(py, error.to_string())),
    }
}

fn plan(
    (function, arguments, columns): Function,
    (count, seed, named, exceptions, part, of): Draw,
) -> PyResult<StudyPlan> {
    let exceptions = exceptions.into_iter();
    let exceptions = exceptions.map(|(index, name)| Ok((index, distribution(&name)?)));
    Ok(StudyPlan {
        count,
        seed,
        distribution: distribution(&named)?,
        exceptions: exceptions.collect::<PyResult<_>>()?,
        part: [part, of],
        function,
        arguments,
        columns,
    })
}

fn distribution(name: &str) -> PyResult<Distribution> {
    match name {
        "normal" => Ok(Distribution::Normal),
        "uniform" => Ok(Distribution::Uniform),
        "triangular" => Ok(Distribution::Triangular),
        "arcsine" => Ok(Distribution::Arcsine),
        "truncated normal" => Ok(Distribution::TruncatedNormal),
        other => Err(PyValueError::new_err(format!(
            "no distribution `{other}`\nhelp: write `normal`, `uniform`, `triangular`, `arcsine` or \
             `truncated normal`"
        ))),
    }
}
