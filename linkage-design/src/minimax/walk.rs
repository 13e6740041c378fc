//! A search in progress: steps within a box, the price of violations, and the test for an optimum.

use std::vec::Vec;

use super::super::limits::Limits;
use super::curvature::Curvature;
use super::rows::{Groups, SearchSettings};
use super::step::{Aim, Plan, fall, step};

/// A step that gains less than this part of its promise is taken back; the smallest part that keeps
/// searches from stalling.
const TAKEN: f64 = 1e-4;
/// Gains below the first part of the promise make the box smaller, above the second one larger
/// (Fletcher's).
const POOR: f64 = 0.25;
const GOOD: f64 = 0.75;
/// Little promise within a box shorter than this may be due to the box alone.
const SHORT: f64 = 0.01;
/// A box of this part of the first one is nothing but rounding.
const STUCK: f64 = 1e-12;
/// A variable is at a bound if it is nearer than this part of its first step: the programs are
/// solved to some hundred roundoffs.
const BESIDE: f64 = 1e-11;
/// The rounding of a merit: some hundred roundoffs.
const ROUNDING: f64 = 1e-14;
/// A price above this leaves nothing of the objective in double precision.
const HIGHEST: f64 = 1e9;

/// Why a search ends by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// The first-order conditions hold.
    Stationary,
    /// They do not, but no step leads on.
    Stuck,
}

/// A search on its way.
pub(super) struct Walk<'w, E> {
    limits: &'w Limits,
    search: &'w SearchSettings,
    evaluate: E,
    pub(super) x: Vec<f64>,
    pub(super) here: Groups,
    curvature: Curvature,
    radius: f64,
    price: f64,
    pub(super) evaluations: usize,
    /// True if no step was taken since the curvature was begun.
    fresh: bool,
}

impl<'w, E: FnMut(&[f64]) -> Option<Groups>> Walk<'w, E> {
    /// Begins at a place, with its groups.
    pub(super) fn new(
        (start, here): (&[f64], Groups),
        limits: &'w Limits,
        search: &'w SearchSettings,
        evaluate: E,
    ) -> Self {
        let mut curvature = Curvature::new(&search.reach);
        curvature.see(&here);
        Self {
            limits,
            search,
            evaluate,
            x: start.to_vec(),
            here,
            curvature,
            radius: 1.0,
            price: 1.0,
            evaluations: 1,
            fresh: true,
        }
    }

    fn aim(&self) -> Aim<'w> {
        Aim {
            limits: self.limits,
            reach: &self.search.reach,
            radius: self.radius,
            price: self.price,
        }
    }

    /// Makes a step, or prepares one.
    pub(super) fn round(&mut self) -> Option<End> {
        let aim = self.aim();
        let Some(plan) = step(&self.x, &self.here, Some(&self.curvature), &aim) else {
            // Rounding: a shorter step is better conditioned.
            self.radius *= POOR;
            return (self.radius <= STUCK).then_some(End::Stuck);
        };
        if plan.excess > self.search.tolerance && self.is_cheap(&plan) {
            self.price *= 10.0;
            return None;
        }
        let now = self.here.merit(self.price);
        let promise = now - plan.merit;
        let nothing = promise <= ROUNDING * now.abs() || self.radius <= STUCK;
        if nothing || promise <= self.search.precision {
            if self.here.excess() > self.search.tolerance && self.leads_back() {
                return None;
            }
            let fall = fall(&self.x, &self.here, &aim);
            if fall.is_some_and(|fall| fall <= self.search.slope) {
                return Some(End::Stationary);
            }
            if nothing || self.radius < SHORT {
                return self.begin_anew();
            }
        }
        self.advance(&plan, now, promise);
        None
    }

    /// Returns true if a violation costs too little: a step removes less than half of the removable
    /// part of all violations within the box.
    ///
    /// A price that is raised only then stays as low as can be, and the objective is seen beside
    /// it: R. H. Byrd, J. Nocedal, R. A. Waltz, "Steering exact penalty methods for nonlinear
    /// programming", Optimization Methods and Software 23 (2008).
    fn is_cheap(&self, plan: &Plan) -> bool {
        let Some(back) = back(&self.x, &self.here, &self.aim()) else {
            return false;
        };
        let missed = self.here.missed();
        let [removed, most] = [plan.missed, back.missed].map(|left| missed - left);
        self.price < HIGHEST && most > self.search.tolerance && removed < 0.5 * most
    }

    /// Goes straight back to the conditions, of which too little is violated for a price to show
    /// it; whether that removes most of it.
    fn leads_back(&mut self) -> bool {
        let Some(plan) = back(&self.x, &self.here, &self.aim()) else {
            return false;
        };
        let x = moved(&self.x, &plan.d, self.limits, &self.search.reach);
        self.evaluations += 1;
        let there = (self.evaluate)(&x);
        let better = there.filter(|there| there.excess() < 0.5 * self.here.excess());
        let led = better.is_some();
        if let Some(there) = better {
            self.go(x, there);
        }
        led
    }

    /// Restarts curvature and box, which are wrong where little is promised but slopes promise
    /// more, unless they were just restarted.
    fn begin_anew(&mut self) -> Option<End> {
        if self.fresh {
            return Some(End::Stuck);
        }
        self.curvature = Curvature::new(&self.search.reach);
        self.curvature.see(&self.here);
        self.radius = 1.0;
        self.fresh = true;
        None
    }

    /// Tries a step, and a second one back to the conditions; takes it if it gains.
    fn advance(&mut self, plan: &Plan, now: f64, promise: f64) {
        let aim = self.aim();
        let mut trial = moved(&self.x, &plan.d, self.limits, &self.search.reach);
        let mut there = (self.evaluate)(&trial);
        self.evaluations += 1;
        let gain = |there: &Option<Groups>| {
            there.as_ref().map_or(f64::NEG_INFINITY, |groups| {
                (now - groups.merit(aim.price)) / promise
            })
        };
        let mut part = gain(&there);
        if let Some(out) = there
            .as_ref()
            .filter(|out| part < GOOD && out.excess() > self.search.tolerance)
        {
            let x = back(&trial, out, &aim)
                .map(|back| moved(&trial, &back.d, self.limits, &self.search.reach));
            let again = x.as_deref().and_then(&mut self.evaluate);
            self.evaluations += 1;
            if gain(&again) > part {
                part = gain(&again);
                trial = x.unwrap_or(trial);
                there = again;
            }
        }
        if let Some(there) = &there {
            let places = [&self.x[..], &trial];
            self.curvature
                .update(places, [&self.here, there], &plan.multipliers);
        }
        if part < POOR {
            self.radius = POOR * plan.length;
        } else if part > GOOD && plan.length > 0.9 * self.radius {
            self.radius *= 2.0;
        }
        if let Some(there) = there.filter(|_| part > TAKEN) {
            self.go(trial, there);
            self.fresh = false;
        }
    }

    fn go(&mut self, x: Vec<f64>, there: Groups) {
        self.curvature.see(&there);
        (self.x, self.here) = (x, there);
    }
}

/// The shortest way back to the conditions within the box.
fn back(x: &[f64], groups: &Groups, aim: &Aim<'_>) -> Option<Plan> {
    let price = HIGHEST;
    step(x, groups, None, &Aim { price, ..*aim })
}

/// Returns the place after a step. The rest of the distance to a bound within rounding is none.
fn moved(x: &[f64], d: &[f64], limits: &Limits, reach: &[f64]) -> Vec<f64> {
    let mut moved: Vec<f64> = x.iter().zip(d).map(|(x, d)| x + d).collect();
    for (j, x) in moved.iter_mut().enumerate() {
        let bounds = [limits.lower[j], limits.upper[j]];
        let near = |bound: &f64| (*x - bound).abs() <= BESIDE * reach[j];
        *x = bounds.into_iter().find(near).unwrap_or(*x);
    }
    limits.clamp(&mut moved);
    moved
}
