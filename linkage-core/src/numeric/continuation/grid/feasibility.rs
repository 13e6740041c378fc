//! A test in a few places of the ranges, before all of them are divided: whether they can be served
//! at all, and the cell size for it.

use super::super::cell::Frame;
use super::super::follow::Follower;
use super::counts::{CELLS, MISSED, longest, scales};
use super::fit::Fit;
use super::layout::{Layout, Places};
use super::left_out::LeftOut;
use super::node::Node;
use super::path::{PathEnd, follow};
use super::served::served;
use super::slopes::slopes;
use super::walk::{NEAR, Solution};
use crate::math;
use alloc::vec;
use alloc::vec::Vec;

/// Cells that are looked at, spread over the ranges.
const LOOKS: usize = 16;

/// The limit for the smallest possible cells: those that leave out more at the tested places do not
/// serve all but half a percent of the ranges. The chance of an error is one in a hundred million,
/// if the gaps can be anywhere.
const HOPELESS: f64 = 0.3;

/// The limit for cells of one size, twice the allowed share: where the tested places leave out
/// more, the whole grid would leave out too much, too. It is not filled: that takes ten to a
/// hundred times the corrections of a test.
const COARSE: f64 = 2.0 * MISSED;

/// Corrections on the way to a place that is missed, at least, when a grid is filled.
const WAY: usize = 8;

/// The spacing of places along an input, as shares of its range: square roots of primes, so that
/// the places never repeat.
const PRIMES: [f64; 8] = [2.0, 3.0, 5.0, 7.0, 11.0, 13.0, 17.0, 19.0];

/// A solution at a place.
#[derive(Clone)]
struct Known {
    at: Vec<f64>,
    state: Vec<f64>,
    determinant: f64,
}

/// The looks at cells of one size.
#[derive(Default)]
struct Looks {
    /// Places on borders, and those that evaluators do not reach.
    places: usize,
    missed: usize,
    /// The centres of cells of which places are missed, each with the first of these.
    examples: Vec<(Known, Vec<f64>)>,
    /// The second differences of the state along the cells, input by input.
    bends: Vec<f64>,
    /// Corrections to fill one cell.
    each: usize,
}

/// The result of the test.
pub(super) enum Feasibility {
    /// The part that cells of the smallest size would leave out, at least, if that is much.
    Hopeless(LeftOut),
    /// Cells along each input of which no larger ones would do.
    From(Vec<u32>),
}

/// Tests cells of so many along each input, then smaller ones. Where a boundary of the solution is
/// met, which changes the meaning of left out, the counts stay.
pub(super) fn feasibility(
    follower: &mut Follower<'_>,
    ranges: &[(Frame, bool)],
    counts: &[u32],
    with: (&Places, &Fit),
    reference: &Solution<'_>,
) -> Feasibility {
    looked(follower, ranges, counts.to_vec(), with, reference)
        .unwrap_or_else(|| Feasibility::From(counts.to_vec()))
}

fn looked(
    follower: &mut Follower<'_>,
    ranges: &[(Frame, bool)],
    mut counts: Vec<u32>,
    with: (&Places, &Fit),
    reference: &Solution<'_>,
) -> Option<Feasibility> {
    let mut known = starts(follower, ranges, reference)?;
    loop {
        let axes = scales(ranges, &counts);
        let layout = Layout(&axes);
        let looks = examine(follower, &layout, with, reference, &mut known)?;
        let share = looks.missed as f64 / looks.places as f64;
        if share <= COARSE {
            return Some(Feasibility::From(counts));
        }
        if share <= HOPELESS && !regular(follower, reference, &looks.examples) {
            return None;
        }
        let next = 2 * layout.cells();
        // All cells of all sizes before take as much again as those of the last one.
        let affordable = 2 * next * looks.each <= follower.left();
        match longest(&looks.bends, &counts) {
            Some(axis) if next <= CELLS && affordable => counts[axis] *= 2,
            _ if share <= HOPELESS => return Some(Feasibility::From(counts)),
            _ => {
                return hopeless(follower, reference, share, &looks.examples)
                    .map(Feasibility::Hopeless);
            }
        }
    }
}

/// Solutions at places all over the ranges, each brought there from the nearest one that is known.
fn starts(
    follower: &mut Follower<'_>,
    ranges: &[(Frame, bool)],
    reference: &Solution<'_>,
) -> Option<Vec<Known>> {
    let mut known: Vec<Known> = Vec::with_capacity(LOOKS + 1);
    known.push(Known {
        at: reference.at.to_vec(),
        state: reference.state.to_vec(),
        determinant: reference.determinant,
    });
    for look in 0..LOOKS {
        let along = |((frame, _), prime): (&(Frame, bool), &f64)| {
            let share = (look as f64 + 0.5) * math::double::sqrt(*prime);
            frame.x(share % 1.0 - 0.5)
        };
        let to: Vec<f64> = ranges.iter().zip(&PRIMES).map(along).collect();
        let distance = |one: &Known| -> f64 {
            let pairs = one.at.iter().zip(&to).zip(ranges);
            let part = |((a, b), (frame, _)): ((&f64, &f64), &(Frame, bool))| {
                (frame.position(*a) - frame.position(*b)).abs()
            };
            pairs.map(part).sum()
        };
        let nearest = |a: &&Known, b: &&Known| distance(a).total_cmp(&distance(b));
        let from = known.iter().min_by(nearest)?;
        known.push(from.moved(follower, reference, to)?);
    }
    Some(known.split_off(1))
}

impl Known {
    /// Brought to another place; `None` if a boundary is met or near, or if it is not reached.
    fn moved(
        &self,
        follower: &mut Follower<'_>,
        reference: &Solution<'_>,
        to: Vec<f64>,
    ) -> Option<Self> {
        let mut state = self.state.clone();
        let determinants = [self.determinant, reference.determinant];
        match follow(follower, &self.at, &to, &mut state, determinants) {
            PathEnd::Reached(determinant)
                if determinant.abs() >= NEAR * reference.determinant.abs() =>
            {
                Some(Self {
                    at: to,
                    state,
                    determinant,
                })
            }
            PathEnd::Reached(_) | PathEnd::DeadPoint | PathEnd::Lost => None,
        }
    }
}

/// Looks at the cells of a layout in which the known solutions are, and moves these to the centres.
fn examine(
    follower: &mut Follower<'_>,
    layout: &Layout<'_>,
    (places, fit): (&Places, &Fit),
    reference: &Solution<'_>,
    known: &mut [Known],
) -> Option<Looks> {
    let before = follower.left();
    let mut looks = Looks {
        bends: vec![0.0; layout.0.len()],
        ..Looks::default()
    };
    for one in known.iter_mut() {
        *one = one.moved(follower, reference, layout.centre(&layout.cell(&one.at)))?;
        let (slopes, bends) = slopes(follower, layout, &one.at, &one.state);
        let sums = looks.bends.iter_mut().zip(bends);
        sums.for_each(|(sum, bend)| *sum += bend);
        let mut node = Node::with_slopes(&one.state, &slopes, one.determinant, fit.terms());
        fit.refine(follower, layout, &one.at, &mut node);
        let mut example = None;
        let mut near = one.state.clone();
        for offsets in &places.offsets {
            let x = layout.moved(&one.at, offsets);
            node.state::<false>(offsets, &mut near);
            let settled = served(follower, fit.terms(), &x, &mut near);
            if settled.is_none() {
                looks.missed += 1;
                example.get_or_insert(x);
            }
        }
        looks.places += places.offsets.len();
        let example = example.map(|x| (one.clone(), x));
        looks.examples.extend(example);
    }
    let ways = WAY * looks.missed;
    looks.each = (before - follower.left() + ways) / known.len();
    Some(looks)
}

/// The answer, unless solutions end at one of the examples.
fn hopeless(
    follower: &mut Follower<'_>,
    reference: &Solution<'_>,
    share: f64,
    examples: &[(Known, Vec<f64>)],
) -> Option<LeftOut> {
    let at = examples.first()?.1.clone();
    regular(follower, reference, examples).then_some(LeftOut { share, at })
}

/// Returns whether the solution exists at all examples, away from its boundary.
fn regular(
    follower: &mut Follower<'_>,
    reference: &Solution<'_>,
    examples: &[(Known, Vec<f64>)],
) -> bool {
    let mut exists = |(centre, x): &(Known, Vec<f64>)| {
        let there = centre.moved(follower, reference, x.clone());
        there.is_some()
    };
    examples.iter().all(&mut exists)
}
