//! A judge of the claims of searches: positions of the mechanisms that they return, and random problems.

use super::drives::{Needle, NeedleAssembly, Press, PressAssembly};
use super::{Rocker, RockerAssembly};
use linkage::Dimensions;
use linkage::design::{BestCycle, Curve, CycleDesign, DesignError, Dwell, Figure, Peak, Stroke};
use linkage::summary;
use linkage_random::Random;
use std::f64::consts::TAU;

/// Positions at which a judge evaluates a quantity over an interval.
const POSITIONS: u32 = 4000;

/// Positions at which it settles a doubt: beside a dead point a limit is narrow.
const IN_DOUBT: u32 = 400_000;

/// The goal of a random problem.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Goal {
    Longest(f64),
    Narrowest(f64),
    LeastPeak,
}

/// The condition on the stroke.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Keep {
    Nothing,
    Stroke(f64),
    AtLeast(f64),
}

#[derive(Debug, Default)]
pub(crate) struct Tally {
    pub(crate) results: usize,
    pub(crate) errors: usize,
    /// Results that claim what does not hold.
    pub(crate) false_claims: usize,
    pub(crate) worse_than_start: usize,
    pub(crate) worse_than_half: usize,
}

macro_rules! problems {
    // A drive of which one function gives all.
    ($name:ident, $mechanism:ident, $assembly:ident) => {
        problems!(
            $name,
            $mechanism,
            $assembly,
            |of, phi| {
                let m = of.motion(phi);
                [m.way, m.v, m.a, m.j]
            },
            {
                let m = of.motion(phi);
                [m.s, m.sv]
            }
        );
    };
    ($name:ident, $mechanism:ident, $assembly:ident, |$of:ident, $phi:ident| $jet:expr, $slopes:expr) => {
        pub(crate) mod $name {
            use super::*;

            pub(crate) const N: usize = $mechanism::PARAMETERS.len();

            fn jet($of: &$assembly, $phi: f64) -> [f64; 4] {
                $jet
            }

            fn way() -> Curve<'static, $assembly, N> {
                Curve::new(
                    |of, phi| {
                        let [way, v, a, _] = jet(of, phi);
                        [way, v, a]
                    },
                    |$of: &$assembly, $phi: f64| $slopes[0],
                )
            }

            fn speed() -> Curve<'static, $assembly, N> {
                Curve::new(
                    |of, phi| {
                        let [_, v, a, j] = jet(of, phi);
                        [v, a, j]
                    },
                    |$of: &$assembly, $phi: f64| $slopes[1],
                )
            }

            /// The largest and the smallest value of the quantity (0) or its speed (1) over an interval.
            fn ends(of: &$assembly, [from, length]: [f64; 2], order: usize, positions: u32) -> [f64; 2] {
                let value = |k: u32| {
                    jet(of, from + length * f64::from(k) / f64::from(positions))[order]
                };
                let fold = |[high, low]: [f64; 2], x: f64| [high.max(x), low.min(x)];
                (0..=positions).map(value).fold([f64::MIN, f64::MAX], fold)
            }

            fn change(of: &$assembly, interval: [f64; 2]) -> f64 {
                let [high, low] = ends(of, interval, 0, POSITIONS);
                high - low
            }

            fn peak(of: &$assembly) -> f64 {
                let [high, low] = ends(of, [0.0, TAU], 1, POSITIONS);
                high.max(-low)
            }

            fn dwell(of: &$assembly, band: f64) -> f64 {
                let course = summary::Curve::new((0.0, TAU), 721, |phi| jet(of, phi)).expect("a turn");
                let longest = course.longest_dwell(band);
                longest.map_or(0.0, |dwell| dwell.interval.range)
            }

            fn stroke(of: &$assembly) -> f64 {
                change(of, [0.0, TAU])
            }

            /// A value of the goal that is greater where it is better.
            fn worth(of: &$assembly, goal: Goal) -> f64 {
                match goal {
                    Goal::Longest(band) => dwell(of, band),
                    Goal::LeastPeak => -peak(of),
                    Goal::Narrowest(length) => {
                        let beginnings = (0..240).map(|k| TAU * f64::from(k) / 240.0);
                        let narrowest = beginnings.map(|from| change(of, [from, length]));
                        -narrowest.fold(f64::INFINITY, f64::min)
                    }
                }
            }

            /// Lists reasons why the claim of a result does not hold, by positions that know nothing of the search.
            fn refuted(best: &BestCycle<$mechanism, $assembly>, goal: Goal, keep: Keep) -> Vec<String> {
                let of = &best.assembly;
                let kept = |stroke: f64| match keep {
                    Keep::Nothing => true,
                    Keep::Stroke(wanted) => (stroke - wanted).abs() < 1e-5 * wanted,
                    Keep::AtLeast(least) => stroke > least * (1.0 - 1e-5),
                };
                let finely = || {
                    let [high, low] = ends(of, [0.0, TAU], 0, IN_DOUBT);
                    high - low
                };
                let kept = kept(stroke(of)) || kept(finely());
                let interval = || [best.auxiliary[0][0], best.auxiliary[0][1]];
                let rounding = 1e-11 * stroke(of);
                let mut reasons = Vec::new();
                let mut must = |holds: bool, reason: String| {
                    if !holds {
                        reasons.push(reason);
                    }
                };
                must(kept, format!("the stroke is {}", stroke(of)));
                match goal {
                    Goal::Longest(band) => {
                        // The claim of a search may be modest: the interval is longer, to its precision.
                        let more = interval()[1] - best.goal;
                        must((-1e-12..1e-6).contains(&more), format!("its length is {more} more"));
                        let change = change(of, interval());
                        must(change <= band + rounding, format!("it changes by {change}"));
                        let longest = dwell(of, band);
                        must(longest > best.goal - 1e-5, format!("the longest dwell is {longest}"));
                    }
                    Goal::Narrowest(_) => {
                        let change = change(of, interval());
                        must(change <= best.goal + rounding, format!("it changes by {change}"));
                    }
                    Goal::LeastPeak => {
                        let peak = peak(of);
                        let near = (peak - best.goal).abs() < 1e-5 * best.goal;
                        must(near, format!("the peak is {peak}"));
                    }
                }
                reasons
            }

            pub(crate) fn problem(
                from: $mechanism,
                (goal, keep): (Goal, Keep),
                part: f64,
            ) -> Result<BestCycle<$mechanism, $assembly>, DesignError> {
                let design = CycleDesign::new(
                    from,
                    $mechanism::assemble,
                    $mechanism::assemble_from,
                    $mechanism::circuits,
                )?;
                let design = match goal {
                    Goal::Longest(band) => design.want(Dwell::longest(way(), band)),
                    Goal::Narrowest(length) => design.want(Dwell::narrowest(way(), length)),
                    Goal::LeastPeak => design.want(Peak(speed()).least()),
                };
                let design = match keep {
                    Keep::Nothing => design,
                    Keep::Stroke(wanted) => design.want(Stroke(way()).equal(wanted)),
                    Keep::AtLeast(least) => design.want(Stroke(way()).at_least(least)),
                };
                let names = $mechanism::PARAMETERS.iter().map(|parameter| parameter.name);
                names.fold(design, |design, name| design.vary_by(name, part)).run()
            }

            /// Judges a problem within bounds, and returns the worth of its result.
            pub(crate) fn judge(
                from: $mechanism,
                wanted: (Goal, Keep),
                part: f64,
                tally: &mut Tally,
            ) -> Option<f64> {
                let start = worth(&from.assemble().ok()?, wanted.0);
                let best = match problem(from, wanted, part) {
                    Ok(best) => best,
                    Err(error) => {
                        println!("{error}\n  {:?} {wanted:?} {part}", from.values());
                        tally.errors += 1;
                        return None;
                    }
                };
                tally.results += 1;
                let told = |what: &str| {
                    println!("{what}: {best}  {:?} {wanted:?} {part}", from.values());
                };
                let refuted = refuted(&best, wanted.0, wanted.1);
                if !refuted.is_empty() {
                    tally.false_claims += 1;
                    told(&format!("false, {}", refuted.join(", ")));
                }
                let worth = match wanted.0 {
                    Goal::Longest(_) => best.goal,
                    _ => -best.goal,
                };
                if worth < start - 1e-4 * start.abs() {
                    tally.worse_than_start += 1;
                    told("worse than the start");
                }
                Some(worth)
            }

            /// A random problem whose start holds all conditions, within bounds and within half of them.
            pub(crate) fn random(random: &mut Random, tally: &mut Tally) {
                let mut values = $mechanism::default().values();
                values.iter_mut().for_each(|x| *x *= random.between(0.92, 1.08));
                let from = $mechanism::from_values(&values);
                let whole = from.circuits().is_ok_and(|circuits| {
                    circuits.whole().any(|branch| branch.margin > 1e-3)
                });
                let Some(of) = from.assemble().ok().filter(|_| whole) else {
                    return;
                };
                let stroke = stroke(&of);
                let band = stroke * 10_f64.powf(random.between(-4.0, -1.3));
                let length = (dwell(&of, band) * random.between(0.8, 2.0)).clamp(0.02, 4.0);
                let goal = *random.pick(&[
                    Goal::Longest(band),
                    Goal::Longest(band),
                    Goal::Narrowest(length),
                    Goal::LeastPeak,
                ]);
                let keep = *random.pick(&[
                    Keep::Nothing,
                    Keep::Stroke(stroke),
                    Keep::AtLeast(0.99 * stroke),
                ]);
                let part = random.between(0.01, 0.16);
                let half = judge(from, (goal, keep), 0.5 * part, tally);
                let full = judge(from, (goal, keep), part, tally);
                if let (Some(half), Some(full)) = (half, full) {
                    if full < half - 1e-4 * half.abs() {
                        tally.worse_than_half += 1;
                        println!("{half} within half of the bounds, {full} within {part}: {values:?} {goal:?} {keep:?}");
                    }
                }
            }
        }
    };
}

problems!(needle, Needle, NeedleAssembly);
problems!(press, Press, PressAssembly);
problems!(
    rocker,
    Rocker,
    RockerAssembly,
    |of, phi| {
        let m = of.tip(phi);
        [m.tip, m.v, m.a, m.j]
    },
    {
        let m = of.slopes(phi);
        [m.e, m.ev]
    }
);
