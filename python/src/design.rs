//! Design problems, and the designs that are found.

use std::sync::Arc;
use std::time::Duration;

use linkage_design::{FoundDesign, Relation, Targets, Timing};
use linkage_engine::{DesignProblem, Designs, Variable};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::assembly::{Assembly, Cell};
use crate::mechanism::Mechanism;
use crate::raised::raised;
use crate::searches::{Progress, searched};

/// Name, kind and numbers of a dimension that may change: `between` with two bounds, `by` with a
/// part, or `one of` with all values.
type VariableOf = (String, String, Vec<f64>);

/// Names with factors, the bound of their sum, and true for an equality.
type RelationOf = (Vec<(String, f64)>, f64, bool);

/// Function, quantities, rows of wanted numbers, weights, and the kind of timing with its numbers.
type TargetsOf = (
    usize,
    Vec<String>,
    Vec<Vec<f64>>,
    Option<Vec<f64>>,
    String,
    Vec<f64>,
);

/// Starts, steps, seed, designs that are listed, and seconds.
type Settings = (
    Option<usize>,
    Option<usize>,
    u64,
    Option<usize>,
    Option<f64>,
);

/// Dimensions, sum, residuals, inputs, the least margin and its input,
/// names at bounds with the bound and the gain beyond it, whether it is a local optimum, its start,
/// the number of starts, relations in the way, and the text.
type DesignOf = (
    Vec<f64>,
    f64,
    Vec<Vec<f64>>,
    Vec<Vec<f64>>,
    (f64, f64),
    Vec<(&'static str, f64, f64)>,
    bool,
    usize,
    usize,
    Vec<String>,
    String,
);

/// Residuals and variables; starts, those against relations, those that do not assemble; optima
/// that are not whole, left out; evaluations, and whether the search ended early.
type Figures = ([usize; 8], bool);

/// The text, the figures, all designs and their assemblies.
type Found = (String, Figures, Vec<DesignOf>, Vec<Assembly>);

/// Searches for designs.
#[pyfunction]
#[allow(
    clippy::too_many_arguments,
    reason = "all of them are plain data of Python"
)]
pub(crate) fn design(
    py: Python<'_>,
    mechanism: &Mechanism,
    dimensions: Vec<f64>,
    variables: Vec<VariableOf>,
    relations: Vec<RelationOf>,
    targets: Vec<TargetsOf>,
    settings: Settings,
    threads: usize,
    shown: Option<Py<PyAny>>,
) -> PyResult<Found> {
    let problem = problem(variables, relations, targets, settings)?;
    let compiled = mechanism.compiled();
    let mut text = String::new();
    let mut figures = ([0; 8], false);
    let mut all = Vec::new();
    let made = searched(py, threads, shown.as_ref(), |watched| {
        let report = |progress: linkage_design::Progress| {
            let seen: Progress = (progress.done, progress.count, progress.least);
            watched.report(seen);
        };
        Cell::try_new(Arc::clone(compiled), |mechanism| {
            let found = mechanism.design(&dimensions, &problem, &watched.stopped, report)?;
            text = found.to_string();
            figures = figures_of(&found);
            all = found.designs.iter().map(described).collect();
            let designs = found.designs.into_iter();
            Ok::<_, linkage_engine::DesignError>(designs.map(|one| one.assembly).collect())
        })
    })?;
    let cell = made.map_err(|error| raised(py, "DesignError", (error.to_string(),)))?;
    Ok((text, figures, all, Assembly::all(&Arc::new(cell))))
}

fn problem(
    variables: Vec<VariableOf>,
    relations: Vec<RelationOf>,
    targets: Vec<TargetsOf>,
    (starts, steps, seed, listed, seconds): Settings,
) -> PyResult<DesignProblem> {
    let variables = variables.into_iter().map(variable);
    let relations = relations.into_iter().map(relation);
    let targets = targets.into_iter().map(wanted);
    let time_limit = seconds.map(Duration::try_from_secs_f64).transpose();
    Ok(DesignProblem {
        variables: variables.collect::<PyResult<_>>()?,
        relations: relations.collect(),
        targets: targets.collect::<PyResult<_>>()?,
        starts,
        steps,
        seed,
        listed,
        time_limit: time_limit.map_err(|error| PyValueError::new_err(error.to_string()))?,
    })
}

fn variable((name, kind, numbers): VariableOf) -> PyResult<Variable> {
    match (&kind[..], &numbers[..]) {
        ("between", &[low, high]) => Ok(Variable::Between(name, low, high)),
        ("by", &[part]) => Ok(Variable::By(name, part)),
        ("one of", _) => Ok(Variable::OneOf(name, numbers)),
        _ => Err(PyValueError::new_err(format!(
            "no variable of kind `{kind}`"
        ))),
    }
}

fn relation((terms, most, equality): RelationOf) -> Relation {
    let terms = terms.iter().map(|(name, factor)| (&name[..], *factor));
    match equality {
        true => Relation::exactly(terms, most),
        false => Relation::at_most(terms, most),
    }
}

fn wanted(
    (function, quantities, rows, weights, kind, numbers): TargetsOf,
) -> PyResult<(usize, Targets)> {
    let timing = match (&kind[..], &numbers[..]) {
        ("given", _) => Timing::Given(numbers),
        ("in order", []) => Timing::InOrder,
        ("backwards", []) => Timing::Backwards,
        ("free", []) => Timing::Free,
        ("evenly", &[step]) => Timing::Evenly(step),
        _ => return Err(PyValueError::new_err(format!("no timing `{kind}`"))),
    };
    let quantities = quantities.iter().map(String::as_str);
    let targets = Targets::of_rows(quantities, rows).timing(timing);
    Ok((
        function,
        match weights {
            Some(weights) => targets.weights(weights),
            None => targets,
        },
    ))
}

fn figures_of(found: &Designs<'_>) -> Figures {
    let figures = [
        found.residuals,
        found.variables,
        found.starts,
        found.refused,
        found.open,
        found.not_whole,
        found.left_out,
        found.evaluations,
    ];
    (figures, found.ended_early)
}

fn described<A>(found: &FoundDesign<Vec<f64>, A>) -> DesignOf {
    let bounds = found.at_bound.iter().zip(&found.bound_slopes);
    // The slope is that of half the sum.
    let bounds = bounds.map(|(&(name, bound), slope)| (name, bound, 2.0 * slope.abs()));
    (
        found.mechanism.clone(),
        found.sum,
        found.residuals.clone(),
        found.inputs.clone(),
        (found.margin, found.margin_at),
        bounds.collect(),
        found.converged,
        found.start,
        found.hits,
        found.active_relations.clone(),
        found.to_string(),
    )
}
