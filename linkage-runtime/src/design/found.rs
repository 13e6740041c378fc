//! Designs that were found.

use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

use crate::words::rounded;
use crate::{Dimensions, Parameter};

/// A local optimum that holds all that must hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Found<M, A> {
    /// Its dimensions.
    pub mechanism: M,
    /// Assembled on the circuit that runs through the whole range.
    pub assembly: A,
    /// The sum of the squares of all weighted residuals.
    pub sum: f64,
    /// What messages call the wishes.
    pub wishes: Vec<String>,
    /// The rows of each wish: weighted residuals, or the values of a condition.
    pub residuals: Vec<Vec<f64>>,
    /// The free inputs of each wish, in their order.
    pub inputs: Vec<Vec<f64>>,
    /// Its smallest margin over the range, 0 at a dead point.
    pub margin: f64,
    /// The input where the margin is smallest.
    pub margin_at: f64,
    /// Names of the parameters that are at a bound, with the bound.
    pub at_bound: Vec<(&'static str, f64)>,
    /// Gradient of half the sum by the parameters that are at a bound, in the same order: how much is to be gained beyond it.
    pub bound_slopes: Vec<f64>,
    /// Whether it is a local optimum; `false` where the descent had used up its steps.
    pub converged: bool,
    /// The start that led here.
    pub start: usize,
    /// How many starts led here.
    pub hits: usize,
}

/// What a search found.
#[derive(Clone, Debug, PartialEq)]
pub struct Search<M, A> {
    /// All distinct local optima, the least sum first.
    pub designs: Vec<Found<M, A>>,
    /// Starts that were tried.
    pub starts: usize,
    /// Starts that relations refuse.
    pub refused: usize,
    /// Starts that do not assemble where something is wanted, in the modes of no assembly.
    pub open: usize,
    /// Starts that end where a condition does not hold.
    pub broken: usize,
    /// Distinct optima that were refused since they do not run through the whole range on one circuit.
    pub not_whole: usize,
    /// Evaluations of mechanisms with derivatives.
    pub evaluations: usize,
    /// Whether time limit or cancellation ended it before all starts were done.
    pub ended_early: bool,
    /// Residuals and variables: with more variables than residuals a design is one of many.
    pub residuals: usize,
    /// Variables, free inputs among them.
    pub variables: usize,
}

impl<M, A> Search<M, A> {
    /// The design with the least sum.
    #[must_use]
    pub fn best(&self) -> &Found<M, A> {
        &self.designs[0]
    }
}

impl<M, A> Found<M, A> {
    /// The parameters with the design's dimensions.
    #[must_use]
    pub fn parameters<const N: usize>(&self) -> [Parameter; N]
    where
        M: Dimensions<N>,
    {
        self.mechanism.parameters()
    }
}

/// The figures in a few lines: by how much it misses each wish at most, and which bounds are in the way.
impl<M, A> fmt::Display for Found<M, A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "sum of squares {:.6e}, least margin {}",
            self.sum,
            rounded(self.margin)
        )?;
        for (wish, rows) in self.wishes.iter().zip(&self.residuals) {
            let farther = |a: &(usize, &f64), b: &(usize, &f64)| a.1.abs().total_cmp(&b.1.abs());
            if let Some((row, by)) = rows.iter().enumerate().max_by(farther) {
                let (count, by) = (rows.len(), rounded(by.abs()));
                writeln!(f, "{wish}: farthest by {by} in row {} of {count}", row + 1)?;
            }
        }
        for ((name, bound), slope) in self.at_bound.iter().zip(&self.bound_slopes) {
            // The slope is that of half the sum.
            let gain = rounded(2.0 * slope.abs());
            writeln!(
                f,
                "{name} is at its bound {}: beyond it the sum falls by {gain} per unit",
                rounded(*bound)
            )?;
        }
        match self.converged {
            true => Ok(()),
            false => writeln!(f, "no local optimum: the descent used up its steps"),
        }
    }
}

/// The figures in a few lines, then a line for each design.
impl<M, A> fmt::Display for Search<M, A> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let freedom = match self.residuals > self.variables {
            true => "more than can be met exactly: the least sum of squares is found",
            false => "no more than can be met exactly, if bounds and relations allow it",
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
