//! The methods that are compared.

use crate::objective::{Objective, Trace, VARIABLES, problem};
use argmin::core::{CostFunction, Error, Executor, Gradient};
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::particleswarm::ParticleSwarm;
use argmin::solver::quasinewton::LBFGS;
use linkage_random::Random;
use metaheuristics_nature::{Bounded, De, ObjFunc, Solver};
use rand::SeedableRng;
use std::cell::Cell;
use std::rc::Rc;
use std::sync::Mutex;
use std::time::{Duration, Instant};

type Method = fn(u64, Duration) -> Trace;

pub(crate) const METHODS: [(&str, Method); 5] = [
    ("linkage::design", design),
    ("argmin L-BFGS, our gradients", |seed, limit| {
        quasi_newton(seed, limit, true)
    }),
    ("argmin L-BFGS, finite differences", |seed, limit| {
        quasi_newton(seed, limit, false)
    }),
    ("metaheuristics-nature, differential evolution", evolution),
    ("argmin, particle swarm", swarm),
];

/// Blocks of starts, one after the other, until the time is over.
fn design(seed: u64, limit: Duration) -> Trace {
    let began = Instant::now();
    let mut notes = Vec::new();
    let design = problem()
        .design()
        .expect("it assembles")
        .seed(seed)
        .time_limit(limit);
    let search =
        design.progress(|progress| notes.push((began.elapsed().as_secs_f64(), progress.least)));
    search.run().expect("it is found");
    Trace::of(notes)
}

/// The objective as `argmin` asks for it.
#[derive(Clone)]
struct Smooth {
    objective: Rc<Objective>,
    exact: bool,
    /// Calls that are left to this start: a line search may go on for ever where there are no values.
    left: Rc<Cell<usize>>,
}

impl Smooth {
    fn new(objective: &Rc<Objective>, exact: bool, calls: usize) -> Self {
        let (objective, left) = (Rc::clone(objective), Rc::new(Cell::new(calls)));
        Self {
            objective,
            exact,
            left,
        }
    }

    fn call(&self) -> Result<(), Error> {
        let left = self.left.get();
        if left == 0 || self.objective.is_over() {
            return Err(Error::msg("no calls are left"));
        }
        self.left.set(left - 1);
        Ok(())
    }
}

/// Calls of a start of a method that descends.
const CALLS: usize = 2000;

impl CostFunction for Smooth {
    type Param = Vec<f64>;
    type Output = f64;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, Error> {
        self.call()?;
        Ok(self.objective.at(x).0)
    }
}

impl Gradient for Smooth {
    type Param = Vec<f64>;
    type Gradient = Vec<f64>;

    fn gradient(&self, x: &Vec<f64>) -> Result<Vec<f64>, Error> {
        self.call()?;
        if self.exact {
            return Ok(self.objective.at(x).1.to_vec());
        }
        let difference = |j: usize| {
            let step = 1e-6 * (1.0 + x[j].abs());
            let at = |by: f64| {
                let mut x = x.clone();
                x[j] += by;
                self.objective.at(&x).0
            };
            (at(step) - at(-step)) / (2.0 * step)
        };
        Ok((0..VARIABLES).map(difference).collect())
    }
}

/// From random starts, spread as those of `linkage::design` are.
fn quasi_newton(seed: u64, limit: Duration, exact: bool) -> Trace {
    let objective = Rc::new(Objective::new(limit));
    let mut random = Random::new(seed);
    while !objective.is_over() {
        let start: Vec<f64> = objective
            .bounds
            .iter()
            .map(|[low, high]| match *low > 0.0 {
                true => random.ratio(*low, *high),
                false => random.between(*low, *high),
            })
            .collect();
        let solver = LBFGS::new(MoreThuenteLineSearch::new(), 8);
        let smooth = Smooth::new(&objective, exact, CALLS);
        // A line search that fails ends a start.
        let _ = Executor::new(smooth, solver)
            .configure(|state| state.param(start).max_iters(300))
            .run();
    }
    Rc::into_inner(objective)
        .expect("all runs are over")
        .trace()
}

fn swarm(seed: u64, limit: Duration) -> Trace {
    let objective = Rc::new(Objective::new(limit));
    let mut random = Random::new(seed);
    while !objective.is_over() {
        let bounds = objective.bounds.map(|[low, high]| (low, high));
        let bounds = (
            bounds.iter().map(|b| b.0).collect(),
            bounds.iter().map(|b| b.1).collect(),
        );
        let generator = rand::rngs::StdRng::seed_from_u64(random.bits());
        let solver = ParticleSwarm::new(bounds, 60).with_rng_generator(generator);
        let smooth = Smooth::new(&objective, true, usize::MAX);
        let _ = Executor::new(smooth, solver)
            .configure(|state| state.max_iters(2000))
            .run();
    }
    Rc::into_inner(objective)
        .expect("all runs are over")
        .trace()
}

/// The objective as `metaheuristics-nature` asks for it: shared between threads, though there is one.
struct Population<'a> {
    objective: &'a Mutex<Objective>,
    bounds: [[f64; 2]; VARIABLES],
}

impl Bounded for Population<'_> {
    fn bound(&self) -> &[[f64; 2]] {
        &self.bounds
    }
}

impl ObjFunc for Population<'_> {
    type Ys = f64;

    fn fitness(&self, x: &[f64]) -> f64 {
        self.objective.lock().expect("one thread").at(x).0
    }
}

fn evolution(seed: u64, limit: Duration) -> Trace {
    let objective = Mutex::new(Objective::new(limit));
    let mut random = Random::new(seed);
    let over = || objective.lock().expect("one thread").is_over();
    while !over() {
        let bounds = objective.lock().expect("one thread").bounds;
        let _ = Solver::build(
            // Of its strategies, factors and populations that were tried those that come nearest soonest.
            De::new().f(0.8),
            Population {
                objective: &objective,
                bounds,
            },
        )
        .seed(random.bits())
        .pop_num(40)
        .task(|context| context.r#gen >= 2000 || over())
        .solve();
    }
    objective.into_inner().expect("one thread").trace()
}
