//! Dimensions for requirements: the searches of `linkage-design` for mechanisms that are compiled
//! at run time.
//!
//! The searches have types with the number of dimensions. Here lists of dimensions are filled up
//! with numbers that no function has.

use std::sync::atomic::AtomicBool;
use std::time::Duration;

use linkage_design::{Design, DesignSearch, Progress, Relation, Targets};
use linkage_runtime::{DimensionSet, Parameter};

use crate::columns::Columns;
use crate::compiled::Assembly;
use crate::error::DesignError;
use crate::mechanism::Mechanism;

/// A design problem: variables, relations and targets. A setting that is `None` is that of
/// `linkage_design::Design`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DesignProblem {
    /// The dimensions that may change.
    pub variables: Vec<Variable>,
    /// Relations that must hold.
    pub relations: Vec<Relation>,
    /// Targets, each with the number of the function that has the quantities and their derivatives.
    pub targets: Vec<(usize, Targets)>,
    /// The number of starts.
    pub starts: Option<usize>,
    /// The most evaluations of a descent.
    pub steps: Option<usize>,
    /// Another seed gives other starts.
    pub seed: u64,
    /// The most designs that are listed.
    pub listed: Option<usize>,
    /// The time after which no starts are begun.
    pub time_limit: Option<Duration>,
}

/// A dimension that may change, by its name.
#[derive(Clone, Debug, PartialEq)]
pub enum Variable {
    /// Between bounds.
    Between(String, f64, f64),
    /// By a part of its size.
    By(String, f64),
    /// It has one of these values.
    OneOf(String, Vec<f64>),
}

/// The result of a search: mechanisms as lists of their dimensions.
pub type Designs<'m> = DesignSearch<Vec<f64>, Assembly<'m>>;

/// A mechanism as numbers: those after its parameters have no meaning.
#[derive(Clone, Copy, Debug)]
struct Numbers<'m, const N: usize> {
    parameters: &'m [Parameter],
    numbers: [f64; N],
}

impl<'m, const N: usize> Numbers<'m, N> {
    fn new(parameters: &'m [Parameter], dimensions: &[f64]) -> Self {
        let mut numbers = [0.0; N];
        numbers[..dimensions.len()].copy_from_slice(dimensions);
        Self {
            parameters,
            numbers,
        }
    }

    fn used(&self) -> &[f64] {
        &self.numbers[..self.parameters.len()]
    }
}

impl<const N: usize> DimensionSet<N> for Numbers<'_, N> {
    fn declared(&self) -> &[Parameter] {
        self.parameters
    }

    fn numbers(&self) -> [f64; N] {
        self.numbers
    }

    fn with_numbers(&self, numbers: &[f64; N]) -> Self {
        Self {
            numbers: *numbers,
            ..*self
        }
    }
}

impl Mechanism {
    /// Searches for dimensions, beginning with these. The result is that of the macro's mechanism
    /// for the same problem.
    ///
    /// The search ends early once `cancel` is true. `progress` is called on this thread.
    ///
    /// # Errors
    ///
    /// All mistakes of the problem at once, and searches without a design, with the text of
    /// `linkage_design::DesignError`; mechanisms without loops or with several inputs; functions
    /// with other arguments than the input; more than 128 dimensions.
    ///
    /// # Panics
    ///
    /// If there is another number of dimensions, or no such function.
    pub fn design(
        &self,
        dimensions: &[f64],
        problem: &DesignProblem,
        cancel: &AtomicBool,
        progress: impl FnMut(Progress),
    ) -> Result<Designs<'_>, DesignError> {
        assert_eq!(dimensions.len(), self.parameters().len(), "its dimensions");
        if self.inputs().len() != 1 || self.structure().groups.is_empty() {
            return Err(DesignError(format!(
                "a search is for mechanisms with one input and loops: {} has {} inputs and {} groups",
                self.name(),
                self.inputs().len(),
                self.structure().groups.len()
            )));
        }
        match dimensions.len() {
            0..=8 => search::<8>(self, dimensions, problem, cancel, progress),
            9..=32 => search::<32>(self, dimensions, problem, cancel, progress),
            33..=128 => search::<128>(self, dimensions, problem, cancel, progress),
            count => Err(DesignError(format!(
                "{count} dimensions, where a search has 128 at most; this is a limit of linkage"
            ))),
        }
    }
}

fn search<'m, const N: usize>(
    mechanism: &'m Mechanism,
    dimensions: &[f64],
    problem: &DesignProblem,
    cancel: &AtomicBool,
    progress: impl FnMut(Progress),
) -> Result<Designs<'m>, DesignError> {
    let nominal = Numbers::<N>::new(mechanism.parameters(), dimensions);
    let mut design = Design::new(
        nominal,
        |one: &Numbers<'m, N>| mechanism.assemble(one.used()),
        |one| mechanism.assemblies(one.used(), &mechanism.reference()),
        |one| {
            let found = mechanism.circuits(one.used());
            found.expect("one input and loops")
        },
    )
    .map_err(text)?;
    design = design.seed(problem.seed).cancel(cancel).progress(progress);
    for variable in &problem.variables {
        design = match variable {
            Variable::Between(name, low, high) => design.vary(name, *low, *high),
            Variable::By(name, part) => design.vary_by(name, *part),
            Variable::OneOf(name, values) => design.catalogue(name, values.iter().copied()),
        };
    }
    design = design.hold(problem.relations.clone());
    for (function, targets) in &problem.targets {
        let function = *function;
        let heading = mechanism.headings()[function];
        if heading.arguments != [mechanism.inputs()[0].name] {
            return Err(DesignError(format!(
                "targets are those of a function of the input `{}`: `{}` takes `{}`",
                mechanism.inputs()[0].name,
                heading.function,
                heading.arguments.join("`, `")
            )));
        }
        let sweep = move |assembly: &Assembly<'m>,
                          all: &[Numbers<'m, N>],
                          inputs: &[f64],
                          columns: &mut Columns| {
            let column = |k| all.iter().map(|one| one.numbers[k]).collect();
            let numbers: Vec<Vec<f64>> = (0..mechanism.parameters().len()).map(column).collect();
            let numbers: Vec<&[f64]> = numbers.iter().map(Vec::as_slice).collect();
            assembly.sweep_sets_into(function, &numbers, &[inputs], columns);
        };
        let targets = targets.clone();
        design = design.want(targets.computed_into(move || Columns::empty(heading), sweep));
    }
    if let Some(starts) = problem.starts {
        design = design.starts(starts);
    }
    if let Some(steps) = problem.steps {
        design = design.steps(steps);
    }
    if let Some(listed) = problem.listed {
        design = design.listed(listed);
    }
    if let Some(time) = problem.time_limit {
        design = design.time_limit(time);
    }
    let found = design.run().map_err(text)?;
    Ok(found.map(|one| one.used().to_vec()))
}

fn text(error: linkage_design::DesignError) -> DesignError {
    DesignError(error.to_string())
}
