//! Designs that were found.

use core::fmt;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use linkage_core::format::rounded;
use linkage_runtime::{Dimensions, Parameter};

/// A local optimum that holds all that must hold.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundDesign<M, A> {
    /// Its dimensions.
    pub mechanism: M,
    /// Assembled on the circuit that runs through the whole range.
    pub assembly: A,
    /// The sum of the squares of all weighted residuals.
    pub sum: f64,
    /// The titles of the objectives in messages.
    pub objectives: Vec<String>,
    /// The rows of each objective: weighted residuals, or the values of a condition.
    pub residuals: Vec<Vec<f64>>,
    /// The largest miss of each objective, as text; `None` for a condition.
    pub farthest: Vec<Option<String>>,
    /// The free inputs of each objective, in their order.
    pub inputs: Vec<Vec<f64>>,
    /// Its smallest margin over the range, 0 at a dead point.
    pub margin: f64,
    /// The input where the margin is smallest.
    pub margin_at: f64,
    /// Names of the parameters that are at a bound, with the bound.
    pub at_bound: Vec<(&'static str, f64)>,
    /// Gradient of half the sum by the parameters that are at a bound, in the same order: how much
    /// is to be gained beyond it.
    pub bound_slopes: Vec<f64>,
    /// The units of the parameters that are at a bound, in the same order.
    pub bound_units: Vec<&'static str>,
    /// The linear relations that are in the way, as text: those that are not equalities and would
    /// be broken beyond.
    pub active_relations: Vec<String>,
    /// The conditions that are in the way, by their titles.
    pub active_conditions: Vec<String>,
    /// True for a local optimum; `false` where the descent had used up its steps, or led to nothing
    /// better that meets all conditions.
    pub converged: bool,
    /// The start that led here; that after the last one is the declared mechanism, where no start
    /// leads to a smaller sum.
    pub start: usize,
    /// The number of starts that led here.
    pub hits: usize,
}

/// The result of a search.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignSearch<M, A> {
    /// All distinct local optima, the least sum first.
    pub designs: Vec<FoundDesign<M, A>>,
    /// Starts that were tried.
    pub starts: usize,
    /// Starts that relations refuse.
    pub refused: usize,
    /// Starts that do not assemble where something is wanted, in the modes of no assembly.
    pub open: usize,
    /// Starts that end where a condition does not hold.
    pub broken: usize,
    /// Distinct optima that were refused since they do not run through the whole range on one
    /// circuit.
    pub not_whole: usize,
    /// Distinct optima that violate a condition or a relation in the assembly that would be
    /// returned.
    pub unverified: usize,
    /// Distinct optima that are not listed, although some of them may run through the range: the
    /// list was full, or the search was to end. Their sums are not less than those of the designs.
    pub left_out: usize,
    /// Evaluations of mechanisms with derivatives.
    pub evaluations: usize,
    /// True if time limit or cancellation ended it before all starts were done, or before all
    /// optima were checked.
    pub ended_early: bool,
    /// Residuals and variables: with more variables than residuals a design is one of many.
    pub residuals: usize,
    /// Variables, free inputs among them.
    pub variables: usize,
}

impl<M, A> DesignSearch<M, A> {
    /// The design with the least sum.
    #[must_use]
    pub fn best(&self) -> &FoundDesign<M, A> {
        &self.designs[0]
    }

    /// The same search with other objects as its mechanisms, such as lists of dimensions.
    #[must_use]
    pub fn map<B>(self, mechanism: impl Fn(M) -> B) -> DesignSearch<B, A> {
        let designs = self.designs.into_iter();
        DesignSearch {
            designs: designs.map(|design| design.map(&mechanism)).collect(),
            starts: self.starts,
            refused: self.refused,
            open: self.open,
            broken: self.broken,
            not_whole: self.not_whole,
            unverified: self.unverified,
            left_out: self.left_out,
            evaluations: self.evaluations,
            ended_early: self.ended_early,
            residuals: self.residuals,
            variables: self.variables,
        }
    }
}

impl<M, A> FoundDesign<M, A> {
    fn map<B>(self, mechanism: impl Fn(M) -> B) -> FoundDesign<B, A> {
        FoundDesign {
            mechanism: mechanism(self.mechanism),
            assembly: self.assembly,
            sum: self.sum,
            objectives: self.objectives,
            residuals: self.residuals,
            farthest: self.farthest,
            inputs: self.inputs,
            margin: self.margin,
            margin_at: self.margin_at,
            at_bound: self.at_bound,
            bound_slopes: self.bound_slopes,
            bound_units: self.bound_units,
            active_relations: self.active_relations,
            active_conditions: self.active_conditions,
            converged: self.converged,
            start: self.start,
            hits: self.hits,
        }
    }

    /// The parameters with the design's dimensions.
    #[must_use]
    pub fn parameters<const N: usize>(&self) -> [Parameter; N]
    where
        M: Dimensions<N>,
    {
        self.mechanism.parameters()
    }
}

/// The figures in a few lines: by how much it misses each objective at most, and which bounds are
/// in the way.
impl<M, A> fmt::Display for FoundDesign<M, A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "sum of squares {:.6e}, least margin {}",
            self.sum,
            rounded(self.margin)
        )?;
        for (objective, farthest) in self.objectives.iter().zip(&self.farthest) {
            if let Some(farthest) = farthest {
                writeln!(f, "{objective}: farthest {farthest}")?;
            }
        }
        let bounds = self.at_bound.iter().zip(&self.bound_units);
        for (((name, bound), unit), slope) in bounds.zip(&self.bound_slopes) {
            let (bound, per) = match *unit {
                "rad" => (format!("{} deg", rounded(bound.to_degrees())), "rad"),
                "" => (rounded(*bound).to_string(), "unit"),
                unit => (format!("{} {unit}", rounded(*bound)), unit),
            };
            // The slope is that of half the sum.
            let gain = rounded(2.0 * slope.abs());
            writeln!(
                f,
                "{name} is at its bound {bound}: beyond it the sum falls by {gain} per {per}"
            )?;
        }
        for relation in &self.active_relations {
            writeln!(f, "the relation {relation} is in the way")?;
        }
        for condition in &self.active_conditions {
            writeln!(f, "the condition `{condition}` is in the way")?;
        }
        match self.converged {
            true => Ok(()),
            false => writeln!(f, "no local optimum: the descent used up its steps"),
        }
    }
}

/// The figures in a few lines, then a line for each design.
impl<M, A> fmt::Display for DesignSearch<M, A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let freedom = match self.residuals > self.variables {
            true => "more than can be met exactly: the least sum of squares is found",
            false => "all can be met exactly, if bounds and relations allow it",
        };
        writeln!(
            f,
            "{} residuals, {} variables: {freedom}",
            self.residuals, self.variables
        )?;
        writeln!(
            f,
            "{} starts: {} against relations, {} do not assemble, {} end where a condition does not hold",
            self.starts, self.refused, self.open, self.broken
        )?;
        writeln!(f, "{} evaluations", self.evaluations)?;
        writeln!(
            f,
            "{} optima that do not run through the range",
            self.not_whole
        )?;
        if self.unverified > 0 {
            writeln!(
                f,
                "{} optima that violate what must hold once they are assembled",
                self.unverified
            )?;
        }
        if self.left_out > 0 {
            writeln!(f, "{} optima with larger sums are left out", self.left_out)?;
        }
        if self.ended_early {
            writeln!(f, "ended early, by time limit or cancellation")?;
        }
        writeln!(f, "design  sum          margin    starts")?;
        for (index, design) in self.designs.iter().enumerate() {
            let margin = rounded(design.margin).to_string();
            writeln!(
                f,
                "{:<6}  {:<11.5e}  {margin:<8}  {}",
                index + 1,
                design.sum,
                design.hits
            )?;
        }
        Ok(())
    }
}
