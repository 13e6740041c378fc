//! Newton steps of a core, from a state to the next, and what a solution must stand.

use crate::algebra::elimination;
use crate::algebra::pivots;
use crate::solve::iterated::state;
use linkage_core::numeric::continuation::{
    ALLOWED_CONTRACTION, FIRST_CORRECTION, STEPS_BESIDE, Terms,
};
use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, substitute};

use crate::algebra::InOrder;
use crate::solve::Solver;

use super::equations::Equations;
use super::state::Part;

/// Steps of the inverse root before the one that each step begins with, for unit vectors that were extrapolated in a cell of a grid. They
/// bring a length that is off by a quarter to rounding; a length that is off by more than the correction would make the
/// next correction the larger one.
const LENGTHS: usize = 3;

/// How a solution is reached.
#[derive(Clone, Copy)]
pub(super) struct Plan {
    steps: usize,
    /// The largest first correction.
    first: Option<f64>,
    /// The determinant must keep half of its least size near the state, beside its sign.
    half: bool,
    /// Steps of the inverse root that unit vectors need.
    lengths: usize,
}

impl Plan {
    /// From a table over one input or polynomials over two, whose error is known.
    const FROM_TABLE: Self = Self {
        steps: 1,
        first: None,
        half: true,
        lengths: 0,
    };

    /// From such a table for dimensions, derivatives or digits that it does not know.
    const BESIDE_TABLE: Self = Self {
        steps: STEPS_BESIDE,
        first: Some(FIRST_CORRECTION),
        half: false,
        lengths: 0,
    };

    /// From the nearest of prepared states over several inputs.
    const FROM_GRID: Self = Self {
        steps: STEPS_BESIDE,
        first: None,
        half: false,
        lengths: LENGTHS,
    };

    /// For calls and for sweeps over dimensions, if the group depends on so many inputs.
    pub(super) fn of(inputs: usize, in_cells: Terms) -> [Self; 2] {
        match (inputs, in_cells) {
            (1, _) => [Self::FROM_TABLE, Self::BESIDE_TABLE],
            (_, Terms::Polynomials) => [Self::FROM_TABLE, Self::FROM_GRID],
            (_, Terms::Slopes) => [Self::FROM_GRID, Self::FROM_GRID],
        }
    }

    /// The state that steps begin with, from the one that was looked up.
    pub(super) fn start<'m>(&self, looked_up: &[Part<'m>]) -> Vec<Part<'m>> {
        let mut state = looked_up.to_vec();
        for _ in 0..self.lengths {
            state = state.into_iter().map(Part::unit_length).collect();
        }
        state
    }
}

/// A step from a state.
pub(super) struct Step<'m> {
    /// The state with unit vectors of length 1, as the corrections apply to it.
    start: Vec<Part<'m>>,
    pub(super) corrections: Vec<Ex<'m>>,
    /// The sum of the squares of the corrections; of a body, of its turns and of what its directions missed.
    pub(super) size2: Ex<'m>,
    pub(super) determinant: Ex<'m>,
}

impl<'m> Step<'m> {
    /// The next state, by these corrections.
    pub(super) fn corrected(&self, corrections: &[Ex<'m>]) -> Vec<Part<'m>> {
        let parts = self.start.iter().zip(corrections);
        parts.map(|(part, &own)| part.corrected(own)).collect()
    }
}

/// The correction of a state.
pub(super) fn step<'m>(
    solver: &Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
    state: &[Part<'m>],
) -> Step<'m> {
    let mut start: Vec<Part> = state.iter().map(|part| part.unit_length()).collect();
    let missed = match &equations.large {
        Some(large) => large.straighten(&mut start),
        None => Vec::new(),
    };
    let meanings = state::meanings(solver, &start, equations.unit).into_iter();
    let here = meanings.map(|own| (own.symbol, own.value)).collect();
    let (residuals, matrix) = match &equations.large {
        Some(large) => (&large.residuals, &large.matrix),
        None => (&equations.residuals, &equations.matrix),
    };
    let count = residuals.len();
    let all = [&residuals[..], &matrix.concat()].concat();
    let all = substitute(&all, &here);
    let (residuals, entries) = all.split_at(count);
    let matrix: Vec<Vec<Ex>> = entries.chunks(count).map(<[_]>::to_vec).collect();

    let (freedoms, determinant): (Vec<Ex>, Ex) = match &equations.large {
        Some(large) => {
            let solved =
                pivots::solve_once_in_order(solver.algebra, &large.order, &matrix, residuals);
            let InOrder {
                solution,
                determinant,
            } = solved;
            let freedoms = solution.into_iter().map(|own| -own).collect();
            (freedoms, large.share * determinant)
        }
        None => {
            let (numerators, determinant) = elimination::cramer(solver.algebra, &matrix, residuals);
            let corrections = numerators.into_iter().map(|own| -(own / determinant));
            (corrections.collect(), determinant)
        }
    };
    let algebra = &solver.algebra;
    Step {
        size2: elimination::product_sum(algebra, &freedoms, &freedoms)
            + elimination::product_sum(algebra, &missed, &missed),
        corrections: match &equations.large {
            Some(large) => large.corrections(&start, &freedoms),
            None => freedoms,
        },
        start,
        determinant,
    }
}

/// The state after some steps, NaN unless the first correction is within the plan's limit, the last one tiny, every one much
/// smaller than the one before, and the determinant keeps its sign and, from a table, half of its size. `floor` is half of its
/// least value near the state.
pub(super) fn solution<'m>(
    solver: &Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
    state: &[Part<'m>],
    floor: Ex<'m>,
    plan: Plan,
) -> Vec<Part<'m>> {
    let tiny = solver.algebra.source(Source::Limit).square();
    let mut state = state.to_vec();
    let mut guard: Option<Ex> = None;
    let mut before: Option<Ex> = None;
    for index in 0..plan.steps {
        let step = step(solver, equations, &state);
        let last = index + 1 == plan.steps;
        let sound = match plan.half {
            true => step.determinant * floor - floor.square(),
            false => step.determinant * floor,
        };
        let allowed = match before {
            _ if last => Some(tiny),
            Some(before) => Some((ALLOWED_CONTRACTION * ALLOWED_CONTRACTION * before).max(tiny)),
            None => plan.first.map(|first| tiny.number(first * first)),
        };
        let small = allowed.map(|allowed| allowed - step.size2);
        let conditions = [guard, Some(sound), small].into_iter().flatten();
        guard = conditions.reduce(Ex::min);
        let corrections = match guard.filter(|_| last) {
            Some(guard) => {
                let nan = guard.number(f64::NAN);
                let own = step.corrections.iter();
                own.map(|&own| guard.select(own, nan)).collect()
            }
            None => step.corrections.clone(),
        };
        state = step.corrected(&corrections);
        before = Some(step.size2);
    }
    state
}
