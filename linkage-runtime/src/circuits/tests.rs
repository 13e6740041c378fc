//! Curves whose shape is known by a formula, and the places in them that decide something.

use super::curve::{Node, SolutionCurve};
use super::parts::parts;
use super::search::sample;
use super::slab::Slab;
use super::stretches::{Border, Slack, stretches};
use super::trace::{CurveEnd, Strand};
use alloc::vec::Vec;
use linkage_core::numeric::continuation::{Correction, Step};
use linkage_core::numeric::roots::Variable;
use linkage_core::{Cycle, Enclosure, Scalar};

#[test]
fn samples_are_even_and_reach_both_ends() {
    let (low, high) = (-1.0, 3.0);
    let (angle, samples) = (false, 5);
    let cycle = Cycle {
        low,
        high,
        angle,
        samples,
    };
    let inputs = [0, 1, 2, 3, 4].map(|index| sample(&cycle, index));
    assert_eq!(inputs, [-1.0, 0.0, 1.0, 2.0, 3.0]);
}

const SLAB: Slab = Slab {
    low: -2.0,
    high: 2.0,
};

/// Newton's step for an equation with this value and derivative.
fn newton(state: &mut [f64], (value, determinant): (f64, f64)) -> Step {
    let change = -value / determinant;
    state[0] += change;
    let size = change.abs();
    Step { size, determinant }
}

fn curve(correction: &mut dyn Correction) -> SolutionCurve<'_> {
    SolutionCurve {
        correction,
        variables: &[Variable::Length],
        slab: SLAB,
        left: 100_000,
    }
}

/// An ellipse comes back to where it began, once, and turns where its inputs end: a circle, and a
/// needle that is followed from a point near its tip.
#[test]
fn an_ellipse_is_two_strands_between_its_turning_points() {
    for (width, x) in [(1.0_f64, 0.3_f64), (2e-3, 1.0 - 1e-6)] {
        let mut ellipse = |at: &[f64], state: &mut [f64]| {
            let (x, s) = (at[0], state[0]);
            newton(state, (s * s - width * width * (1.0 - x * x), 2.0 * s))
        };
        expect_round(&mut ellipse, x, 0.98 * width * (1.0 - x * x).sqrt());
    }
}

fn expect_round(ellipse: &mut dyn Correction, x: f64, s: f64) {
    let mut curve = curve(ellipse);
    let start = curve
        .node(SLAB.parameter(x), &[s])
        .expect("near the ellipse");
    let mut turning = 0;
    let strands = curve.strands(start, &mut turning);
    assert_eq!((strands.len(), turning), (2, 2));
    for strand in &strands {
        for (k, input) in strand.inputs(&SLAB).into_iter().enumerate() {
            assert!(
                matches!(strand.ends[k], CurveEnd::Turning(_)),
                "{:?}",
                strand.ends
            );
            let expected = [-1.0, 1.0][k];
            assert!((input - expected).abs() < 1e-10, "{input}");
        }
        let side = strand.best().state[0].signum();
        let inner = &strand.nodes[1..strand.nodes.len() - 1];
        assert!(inner.iter().all(|node| node.state[0] * side > 0.0));
        // No part of it is left out, and the last step is no longer than others.
        let mut pairs = strand.nodes.windows(2);
        let length = |a: &Node, b: &Node| (b.u - a.u).hypot(b.state[0] - a.state[0]);
        assert!(pairs.all(|pair| length(&pair[0], &pair[1]) < 0.0605));
    }
    let [one, other] = [0, 1].map(|k| strands[k].best().state[0]);
    assert!(one * other < 0.0);
}

/// A solution aside of the straight way by more than a tenth of the step is not the next one,
/// though it points the same way.
#[test]
fn a_node_is_not_reached_across_a_ledge() {
    fn ledge(x: f64) -> f64 {
        0.15 * (1.0 + (x / 0.05).tanh())
    }
    let mut correction = |at: &[f64], state: &mut [f64]| {
        let miss = state[0] - ledge(at[0]);
        newton(state, (miss, 1.0))
    };
    let mut curve = curve(&mut correction);
    let before = curve
        .node(SLAB.parameter(-0.5), &[0.0])
        .expect("a solution");
    assert!(curve.step_along(&before, 0.05).is_some());
    assert!(curve.step_along(&before, 0.9).is_none());
}

/// The last correction counts where rounding keeps corrections from vanishing.
#[test]
fn a_node_is_found_in_spite_of_noise() {
    let mut calls = 0;
    // Two for each correction: one for the rate.
    let mut noisy = |_: &[f64], state: &mut [f64]| {
        let sign = [1.0, -1.0][calls / 2 % 2];
        calls += 1;
        let miss = state[0] - 0.5 - sign * 4e-8;
        newton(state, (miss, 1.0))
    };
    // The second correction is more than the part of the first that it might be.
    let start = 0.5 + 4e-8 - 1.5e-7;
    let node = curve(&mut noisy).node(0.0, &[start]);
    let node = node.expect("rounding is no obstacle");
    assert!((node.state[0] - 0.5).abs() < 5e-8, "{}", node.state[0]);
}

/// A table is prepared from between the ends, where input and determinant both change fast.
#[test]
fn the_best_node_is_far_from_singular() {
    let node = |(u, determinant): (f64, f64)| Node {
        u,
        state: Vec::new(),
        determinant,
        direction: Vec::new(),
    };
    let nodes = [
        (-0.995, 900.0),
        (-0.99, 2.0),
        (0.0, 0.1),
        (0.5, -1.0),
        (0.7, 900.0),
    ];
    let strand = Strand {
        nodes: nodes.map(node).into(),
        ends: [CurveEnd::Slab; 2],
    };
    assert_eq!(strand.best().u, 0.5);
}

/// The stretches with a positive slack, by 8 samples and, if given, by bounds: of functions of the
/// parameter and of the input.
fn found(at: &dyn Fn(f64) -> f64, over: Option<&dyn Fn(Enclosure) -> Enclosure>) -> Vec<[f64; 2]> {
    let input = |border: Border, end: f64| match border {
        Border::Slab => end,
        Border::Root(x) => x,
        Border::Broken(_) => f64::NAN,
    };
    let [by_parameter, by_input] = [false, true].map(|smooth| {
        let slack = Slack {
            at,
            over,
            single: false,
            served: true,
            smooth,
        };
        let found = stretches(&SLAB, 8, &slack).into_iter();
        let inputs = found.map(|[from, to]| [input(from, SLAB.low), input(to, SLAB.high)]);
        inputs.collect::<Vec<_>>()
    });
    expect(&by_parameter, &by_input, 1e-14);
    by_parameter
}

fn expect(found: &[[f64; 2]], stretches: &[[f64; 2]], within: f64) {
    assert_eq!(found.len(), stretches.len(), "{found:?}");
    for (found, expected) in found.iter().zip(stretches) {
        for (found, expected) in found.iter().zip(expected) {
            assert!((found - expected).abs() <= within, "{found} {expected}");
        }
    }
}

/// Gaps and islands between two samples.
#[test]
fn what_happens_between_samples_is_seen() {
    let gap = found(&|x| (x - 0.31).powi(2) - 1e-4, None);
    expect(&gap, &[[-2.0, 0.3], [0.32, 2.0]], 1e-9);
    let island = found(&|x| 1e-4 - (x - 0.31).powi(2), None);
    expect(&island, &[[0.3, 0.32]], 1e-9);
}

/// A slack that rises except for a notch, so narrow that its samples only rise.
fn notch<T: Scalar>(x: T, width: f64) -> T {
    let [centre, one, fifth] = [0.317, 1.0, 0.2].map(T::from_f64);
    let far = (x - centre) * T::from_f64(1.0 / width);
    one + fifth * x - (one + one) / (one + far * far)
}

#[test]
fn bounds_see_what_no_sample_falls_into() {
    for width in [1e-2, 1e-4, 1e-6] {
        let at = |x: f64| notch(x, width);
        let bounds = |x: Enclosure| notch(x, width);
        let edge = |side: f64| {
            let (mut inside, mut outside) = (0.317, 0.317 + side * 3.0 * width);
            for _ in 0..70 {
                let middle = 0.5 * (inside + outside);
                if at(middle) < 0.0 {
                    inside = middle
                } else {
                    outside = middle
                }
            }
            outside
        };
        let [low, high] = [edge(-1.0), edge(1.0)];
        expect(&found(&at, None), &[[-2.0, 2.0]], 0.0);
        let seen = [[-2.0, low], [high, 2.0]];
        expect(&found(&at, Some(&bounds)), &seen, 1e-14);
        // And an island.
        let at = |x: f64| -notch(x, width);
        let bounds = |x: Enclosure| -notch(x, width);
        expect(&found(&at, None), &[], 0.0);
        expect(&found(&at, Some(&bounds)), &[[low, high]], 1e-14);
    }
}

/// Two roots that differ by rounding only are no gap, with bounds as without.
#[test]
fn what_touches_zero_goes_on() {
    fn touching<T: Scalar>(x: T) -> T {
        let far = x - T::from_f64(0.317);
        far * far
    }
    expect(&found(&touching::<f64>, None), &[[-2.0, 2.0]], 0.0);
    let over = touching::<Enclosure>;
    expect(&found(&touching::<f64>, Some(&over)), &[[-2.0, 2.0]], 0.0);
}

/// A mechanism of which only the margin is used: it has none in some gaps.
struct Gaps(&'static [[f64; 2]]);

impl super::Levels for Gaps {
    type Assembly = ();
    type Survey = [f64; 1];
    type Programs = crate::support::NoPrograms;

    fn searched(&self) -> super::Searched {
        unreachable!("nothing is searched")
    }

    fn surveyor(&self, _: &super::Chosen, _: f64) {}

    fn survey(&self, (): &(), at: f64) -> [f64; 1] {
        let within = |[low, high]: &[f64; 2]| *low < at && at < *high;
        if self.0.iter().any(within) {
            [f64::NAN]
        } else {
            [1.0 + (at - 1.5).powi(2)]
        }
    }

    fn assembled(&self, _: &super::Chosen, _: f64) -> Result<(), crate::error::AssemblyError> {
        Ok(())
    }

    fn check(&self, _: f64) -> Result<(), crate::error::AssemblyError> {
        Ok(())
    }
}

/// An assembly ends at an input without a margin, on the side of the known input; of several such
/// inputs the nearest one counts.
#[test]
fn an_assembly_ends_where_it_has_no_margin() {
    use super::branch::BranchEnd::{Lost, Range};
    let gaps = Gaps(&[[0.2, 0.4], [2.0, 2.5], [3.0, 3.7]]);
    let whole = [Range(0.0), Range(4.0)];
    let ends = |known: f64, lost: f64| super::margins::up_to(&gaps, &(), whole, [known, lost]);
    let near = |a: f64, b: f64| (a - b).abs() < 1e-12;
    for lost in [0.3, 2.2, 3.2] {
        let (ends, at, least) = ends(1.0, lost);
        assert!(
            matches!(ends, [Lost(low), Lost(high)] if near(low, 0.4) && near(high, 2.0)),
            "{ends:?}"
        );
        assert!(near(least, 1.0) && (at - 1.5).abs() < 1e-6, "{at} {least}");
    }
    let (ends, ..) = ends(3.9, 2.1);
    assert!(
        matches!(ends, [Lost(low), Range(4.0)] if near(low, 3.7)),
        "{ends:?}"
    );
}

/// Bounds show it in few steps, and say where they do not.
#[test]
fn parts_are_shown_or_not() {
    let wave = |u: Enclosure| (u * Enclosure::from_f64(20.0)).sin_cos().0;
    let shown = parts(&wave, false, -1e-14);
    assert!(
        shown.shown && shown.ends.len() < 200,
        "{}",
        shown.ends.len()
    );
    let broken = |u: Enclosure| Enclosure::from_f64(1.0) / (u * u);
    assert!(!parts(&broken, false, -1e-14).shown);
    assert!(!parts(&broken, true, -1e-14).shown);
}
