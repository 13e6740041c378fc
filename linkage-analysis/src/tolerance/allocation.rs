//! Tolerances for an allowed error.

use alloc::vec::Vec;
use core::array;

use super::cost::{self, Term};
use super::{Addition, Grade, Requirement, Sizes, ToleranceError, Tolerances};
use linkage_runtime::Parameter;

/// The share by which tolerances stay below the limit, so that rounding does not exceed it: a few
/// roundoffs.
const SPARE: f64 = 8.0 * f64::EPSILON;

/// Rules that divide an allowed error among parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AllocationRule<const N: usize> {
    /// Each parameter may cause the same error, at the position where it causes most.
    EqualEffect,
    /// In proportion to these tolerances: all of them changed by one factor.
    Proportional([f64; N]),
    /// All lengths have the same tolerance; angles and numbers that of their levers.
    EqualTolerance(Sizes<N>),
    /// In proportion to the standard tolerance factor of ISO 286: equal effort for each size.
    StandardFactor(Sizes<N>),
    /// The coarsest grade of ISO 286 that holds the limit for all parameters.
    StandardGrade(Sizes<N>),
    /// The least cost, where a tolerance `t` costs `c / t^k`.
    LeastCost(Costs<N>),
}

/// Costs of tolerances: `cost / t^exponent` with `t` in the unit of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs<const N: usize> {
    /// The cost at a tolerance of 1.
    pub cost: [f64; N],
    /// The exponent; 1 or 2 is usual.
    pub exponent: [f64; N],
}

/// Tolerances that hold an allowed error.
#[derive(Clone, Debug, PartialEq)]
pub struct Allocation<const N: usize> {
    /// The tolerances.
    pub tolerances: Tolerances<N>,
    /// The error that they give, not above the limit: found by a new analysis.
    pub error: f64,
    /// The grade, for `StandardGrade`.
    pub grade: Option<Grade>,
    /// The cost, for `LeastCost`.
    pub cost: Option<f64>,
    /// A bound for `LeastCost`: no tolerances that hold the limit cost less.
    pub least_possible_cost: Option<f64>,
}

impl<const N: usize, const K: usize> Requirement<N, K> {
    /// Divides the allowed error among the parameters: [`Dimensions::parameters`] of the mechanism
    /// whose sensitivities were given, with its dimensions. Printed, the tolerances are next to
    /// those; their own tolerances do not matter.
    ///
    /// [`Dimensions::parameters`]: linkage_runtime::Dimensions::parameters
    ///
    /// The result is analysed again and satisfies the limit at every position. With all rules but
    /// `StandardGrade` it uses the limit up, to within rounding at the tightest position;
    /// `LeastCost` to about `1e-7`.
    ///
    /// # Errors
    ///
    /// `Limit`, `Nothing` without positions, `Count`, `NoEffect` where a rule leaves a tolerance
    /// free, `Cost`, `NoSize`, `SizeOutOfRange`, `NoGrade`.
    pub fn allocate(
        &self,
        parameters: &[Parameter],
        rule: &AllocationRule<N>,
    ) -> Result<Allocation<N>, ToleranceError> {
        self.check()?;
        match rule {
            AllocationRule::EqualEffect => {
                let effects = self.effective(parameters)?;
                self.scaled(parameters, &effects.map(|effect| self.limit() / effect))
            }
            AllocationRule::Proportional(shape) => self.scaled(parameters, shape),
            AllocationRule::EqualTolerance(sizes) => self.scaled(parameters, &sizes.equal()?),
            AllocationRule::StandardFactor(sizes) => self.scaled(parameters, &sizes.factors()?),
            AllocationRule::StandardGrade(sizes) => self.coarsest_grade(parameters, sizes),
            AllocationRule::LeastCost(costs) => self.least_cost(parameters, costs),
        }
    }

    /// These tolerances times the factor that uses up the limit.
    fn scaled(
        &self,
        parameters: &[Parameter],
        shape: &[f64; N],
    ) -> Result<Allocation<N>, ToleranceError> {
        let error = self.error_of(&Tolerances::new(parameters, shape)?);
        if error == 0.0 {
            let first = parameters.first();
            let none = ToleranceError::Nothing {
                what: "no parameters",
            };
            return Err(first.map_or(none, |p| ToleranceError::NoEffect { name: p.name }));
        }
        let factor = self.limit() / error * (1.0 - SPARE);
        self.analysed(parameters, &shape.map(|tolerance| factor * tolerance))
    }

    fn analysed(
        &self,
        parameters: &[Parameter],
        values: &[f64; N],
    ) -> Result<Allocation<N>, ToleranceError> {
        let tolerances = Tolerances::new(parameters, values)?;
        Ok(Allocation {
            tolerances,
            error: self.error_of(&tolerances),
            grade: None,
            cost: None,
            least_possible_cost: None,
        })
    }

    fn coarsest_grade(
        &self,
        parameters: &[Parameter],
        sizes: &Sizes<N>,
    ) -> Result<Allocation<N>, ToleranceError> {
        let finest = sizes.finest();
        for grade in Grade::all().rev().take_while(|&grade| grade >= finest) {
            let allocation = self.analysed(parameters, &sizes.grade(grade)?)?;
            if allocation.error <= self.limit() {
                return Ok(Allocation {
                    grade: Some(grade),
                    ..allocation
                });
            }
        }
        let finest = self.analysed(parameters, &sizes.grade(finest)?)?.error;
        Err(ToleranceError::NoGrade {
            finest,
            limit: self.limit(),
        })
    }

    fn least_cost(
        &self,
        parameters: &[Parameter],
        costs: &Costs<N>,
    ) -> Result<Allocation<N>, ToleranceError> {
        let effects = self.effective(parameters)?;
        let start = self.scaled(parameters, &effects.map(|effect| self.limit() / effect))?;
        // Statistical conditions are linear in the squares of tolerances.
        let power = match self.addition() {
            Addition::WorstCase => 1.0,
            Addition::Statistical => 2.0,
        };
        let terms: Vec<Term> = (0..N)
            .map(|i| Term {
                cost: costs.cost[i],
                exponent: costs.exponent[i] / power,
            })
            .collect();
        for (term, parameter) in terms.iter().zip(parameters) {
            let positive = |x: f64| x > 0.0 && x.is_finite();
            if !(positive(term.cost) && positive(term.exponent)) {
                return Err(ToleranceError::Cost {
                    name: parameter.name,
                    cost: term.cost,
                    exponent: term.exponent * power,
                });
            }
        }
        let root = |u: f64| if power == 2.0 { u.sqrt() } else { u };
        let tolerances_of = |u: &[f64]| array::from_fn(|i| root(u[i]));
        let start = start.tolerances.values().map(|t: f64| t.powf(power));
        let best = cost::cheapest(&terms, &start, &mut |u| self.conditions(&tolerances_of(u)));
        let allocation = self.scaled(parameters, &tolerances_of(&best.values))?;
        let values = allocation.tolerances.values();
        let paid = (0..N)
            .map(|i| costs.cost[i] / values[i].powf(costs.exponent[i]))
            .sum();
        Ok(Allocation {
            cost: Some(paid),
            least_possible_cost: Some(best.bound.min(paid)),
            ..allocation
        })
    }

    /// The largest effects, where each parameter must have one.
    fn effective(&self, parameters: &[Parameter]) -> Result<[f64; N], ToleranceError> {
        let tolerances = Tolerances::<N>::declared(parameters)?;
        let effects = self.largest_effects();
        match effects.iter().position(|&effect| effect == 0.0) {
            Some(index) => Err(ToleranceError::NoEffect {
                name: tolerances.parameters()[index].name,
            }),
            None => Ok(effects),
        }
    }
}
