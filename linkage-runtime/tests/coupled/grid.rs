//! Prepared states over several inputs.

use crate::triads::EyeNeedle;
use crate::{TURN, range, root};
use linkage_random::Random;
use linkage_runtime::numeric::continuation::{Correction, Grid, Range, Refusal, Step, Terms};

/// The steps of evaluators, four from slopes, at random places: how many are certified, how many of those are not solutions, how many are
/// refused.
fn survey(grid: &Grid, correction: &mut dyn Correction, ranges: &[Range]) -> [usize; 3] {
    survey_of(4, grid, correction, ranges)
}

/// The same of so many steps.
fn survey_of(
    steps: usize,
    grid: &Grid,
    correction: &mut dyn Correction,
    ranges: &[Range],
) -> [usize; 3] {
    let mut random = Random::new(5);
    let mut state = vec![0.0; grid.width()];
    let mut counts = [0; 3];
    for _ in 0..20_000 {
        let x: Vec<f64> = ranges
            .iter()
            .map(|range| random.between(range.low, range.high))
            .collect();
        let floor = grid.state(&x, &mut state);
        let mut step = Step {
            size: 0.0,
            determinant: 0.0,
        };
        for _ in 0..steps {
            step = correction.correct(&x, &mut state);
        }
        if step.size < 1e-7 && step.determinant * floor >= floor * floor {
            counts[0] += 1;
            let last = correction.correct(&x, &mut state);
            counts[1] += usize::from(last.size > 1e-13);
        } else {
            counts[2] += 1;
        }
    }
    counts
}

/// A platform on three legs of variable length.
fn platform(x: &[f64], state: &mut [f64]) -> Step {
    let mut triad = EyeNeedle {
        legs: [x[0], x[1], x[2]],
        ..EyeNeedle::MACHINE
    };
    triad.correct(&[0.0], state)
}

/// The states of the eye needle's drive, with slopes.
fn started(correction: &mut dyn Correction, at: &[f64], ranges: &[Range]) -> Grid {
    Grid::build(correction, at, &EyeNeedle::start(), ranges, Terms::Slopes).unwrap()
}

#[test]
fn a_platform_of_three_inputs() {
    let at = EyeNeedle::MACHINE.legs;
    for (part, most) in [(0.02, 0), (0.1, 0), (0.2, 400)] {
        let ranges = at.map(|leg| range(leg * (1.0 - part), leg * (1.0 + part)));
        let grid = started(&mut platform, &at, &ranges);
        let [_, wrong, refused] = survey(&grid, &mut platform, &ranges);
        // The legs do not reach each other everywhere in the widest ranges, and cells at the border that do not share all of it with
        // their neighbours are left out: two percent of the positions at most.
        assert!(wrong == 0 && refused <= most, "{part}: {refused}");
    }
}

#[test]
fn cells_out_of_reach_are_empty() {
    let at = EyeNeedle::MACHINE.legs;
    let ranges = at.map(|leg| range(0.6 * leg, 1.4 * leg));
    let grid = started(&mut platform, &at, &ranges);
    assert!(grid.reached() < grid.cells() && grid.reached() > grid.cells() / 2);
    let [certified, wrong, _] = survey(&grid, &mut platform, &ranges);
    assert!(wrong == 0 && certified > 15_000);
}

#[test]
fn a_crank_and_a_leg() {
    let mut correct = |x: &[f64], state: &mut [f64]| {
        let mut triad = EyeNeedle::MACHINE;
        triad.legs[2] = x[1];
        triad.correct(&x[..1], state)
    };
    let at = [0.0, 261.0];
    let ranges = [TURN, range(255.0, 265.0)];
    let grid = started(&mut correct, &at, &ranges);
    let counts = survey(&grid, &mut correct, &[range(-20.0, 20.0), ranges[1]]);
    assert_eq!(counts, [20_000, 0, 0]);
    let lookup = grid.lookup::<2, 4, 3>().unwrap();
    let mut random = Random::new(2);
    for _ in 0..1000 {
        let x = [random.between(-9.0, 9.0), random.between(250.0, 270.0)];
        let mut state = [0.0; 4];
        let floor = grid.state(&x, &mut state);
        assert_eq!(
            format!("{:?}", lookup.at_with::<false>(x)),
            format!("{:?}", (state, floor))
        );
    }
    for x in [
        [f64::NAN, 260.0],
        [0.0, f64::INFINITY],
        [1.0, 245.0],
        [1.0, 275.1],
        [f64::NEG_INFINITY, f64::NAN],
    ] {
        assert!(lookup.at_with::<false>(x).1.is_nan(), "{x:?}");
    }
    assert!(grid.lookup::<1, 4, 2>().is_none() && grid.lookup::<2, 5, 3>().is_none());
}

#[test]
fn no_input_and_inputs_without_ranges() {
    let start = EyeNeedle::start();
    let mut fixed = |_: &[f64], state: &mut [f64]| { EyeNeedle::MACHINE }.correct(&[0.0], state);
    let grid = Grid::build(&mut fixed, &[], &start, &[], Terms::Slopes).unwrap();
    assert_eq!((grid.cells(), grid.reached()), (1, 1));
    let (state, floor) = grid.lookup::<0, 4, 1>().unwrap().at_with::<false>([]);
    assert!(floor > 0.0);
    for (a, b) in state.iter().zip(&start) {
        assert!((a - b).abs() < 1e-15);
    }
    let one = range(0.0, 0.0);
    let grid = Grid::build(
        &mut { EyeNeedle::MACHINE },
        &[0.0],
        &start,
        &[one],
        Terms::Slopes,
    )
    .unwrap();
    assert_eq!(grid.cells(), 1);
    let (near, _) = grid.lookup::<1, 4, 2>().unwrap().at_with::<false>([0.1]);
    assert_eq!(near, state);
}

#[test]
fn what_is_no_solution_is_refused() {
    let mut triad = EyeNeedle::MACHINE;
    let start = EyeNeedle::start();
    let none = Grid::build(
        &mut triad,
        &[0.0],
        &[1.0, 0.0, -1.0, 0.0],
        &[TURN],
        Terms::Slopes,
    );
    assert_eq!(none, Err(Refusal::NotASolution));
    let none = Grid::build(&mut triad, &[f64::NAN], &start, &[TURN], Terms::Slopes);
    assert_eq!(none, Err(Refusal::NotFinite));
    let none = Grid::build(
        &mut triad,
        &[0.0],
        &start,
        &[range(0.0, f64::INFINITY)],
        Terms::Slopes,
    );
    assert_eq!(none, Err(Refusal::NotFinite));
    let mut fixed = |_: &[f64], state: &mut [f64]| { EyeNeedle::MACHINE }.correct(&[0.0], state);
    let most = Grid::build(
        &mut fixed,
        &[0.0; 8],
        &start,
        &[range(0.0, 1.0); 8],
        Terms::Slopes,
    )
    .unwrap();
    assert_eq!(most.reached(), most.cells());
    let none = Grid::build(
        &mut fixed,
        &[0.0; 9],
        &start,
        &[range(0.0, 1.0); 9],
        Terms::Slopes,
    );
    assert_eq!(none, Err(Refusal::NotConverging { at: 0.0 }));
}

/// A length that is the root of a function of two inputs, and how often it is corrected.
struct Length<F> {
    square: F,
    corrected: usize,
}

impl<F: Fn(f64, f64) -> f64> Correction for Length<F> {
    fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step {
        self.corrected += 1;
        root(|_| (self.square)(x[0], x[1])).correct(x, state)
    }
}

fn length(square: impl Fn(f64, f64) -> f64, half: f64) -> (Result<Grid, Refusal>, usize) {
    built(square, half, false)
}

fn built(square: impl Fn(f64, f64) -> f64, half: f64, all: bool) -> (Result<Grid, Refusal>, usize) {
    let start = square(0.0, 0.0).sqrt();
    let mut length = Length {
        square,
        corrected: 0,
    };
    let ranges = [range(-half, half); 2];
    let grid = match all {
        true => Grid::build_all(&mut length, &[0.0; 2], &[start], &ranges, Terms::Slopes),
        false => Grid::build(&mut length, &[0.0; 2], &[start], &ranges, Terms::Slopes),
    };
    (grid, length.corrected)
}

#[test]
fn what_is_served_is_the_part_where_the_solution_exists() {
    // Inside a circle, in a square around it.
    let (grid, corrected) = length(|x, y| 1.0 - x * x - y * y, 1.0);
    let grid = grid.unwrap();
    let circle = std::f64::consts::FRAC_PI_4;
    assert!(
        grid.served() < circle && grid.served() > 0.95 * circle,
        "{}",
        grid.served()
    );
    // The boundary is the mechanism's own.
    assert_eq!(grid.left_out(), None);
    assert!(corrected < 1_000_000, "{corrected}");

    let (grid, _) = length(|x, y| 3.0 + x + y, 1.0);
    let grid = grid.unwrap();
    assert!(grid.served() == 1.0 && grid.left_out().is_none());
}

#[test]
fn what_is_left_out_away_from_boundaries_is_told() {
    // More waves than there can be cells.
    let wave = |x: f64, y: f64| 1.2 + (300.0 * x).sin() * (290.0 * y).cos();
    let (grid, corrected) = length(wave, 1.0);
    let grid = grid.unwrap();
    let left_out = grid.left_out().expect("too many waves");
    assert!(left_out.share > 0.3 && grid.served() < 0.7, "{left_out:?}");
    assert!(left_out.at.iter().all(|x| x.abs() <= 1.0), "{left_out:?}");
    let [x, y] = [left_out.at[0], left_out.at[1]];
    let mut state = [0.0];
    grid.state(&[x, y], &mut state);
    let off = state[0] - wave(x, y).sqrt();
    assert!(off.is_nan() || off.abs() > 1e-3, "{left_out:?}: {off:e}");
    assert!(corrected <= 2_000_000, "{corrected}");
    // Nothing is known but beside the reference, and that is no dead point.
    let known = |x: f64, _| if x.abs() < 1e-8 { 4.0 + x } else { f64::NAN };
    let (grid, _) = length(known, 1.0);
    let grid = grid.unwrap();
    assert_eq!((grid.reached(), grid.served()), (0, 0.0));
    assert_eq!(grid.left_out().map(|left_out| left_out.share), Some(1.0));
}

#[test]
fn ranges_without_hope_are_refused_after_a_look() {
    let wave = |x: f64, y: f64| 1.2 + (300.0 * x).sin() * (290.0 * y).cos();
    let (whole, corrected) = length(wave, 1.0);
    let (looked, few) = built(wave, 1.0, true);
    let [whole, looked] = [whole, looked].map(|grid| grid.unwrap().left_out().cloned().unwrap());
    assert!(
        (whole.share - looked.share).abs() < 0.2,
        "{whole:?} {looked:?}"
    );
    assert!(few < 60_000 && 5 * few < corrected, "{few} of {corrected}");
    assert!(looked.at.iter().all(|x| x.abs() <= 1.0), "{looked:?}");
    // Waves that need all cells, and ranges with a boundary, are as without a look. Cells that would be too large are not filled to learn it.
    let waves = |x: f64, y: f64| 1.5 + (18.0 * x).sin() * (17.0 * y).cos();
    let (grid, few) = built(waves, 1.0, true);
    let grid = grid.unwrap();
    assert!(grid.cells() > 1000 && grid.served() > 0.995, "{grid:?}");
    let (whole, corrected) = length(waves, 1.0);
    assert_eq!(grid, whole.unwrap());
    assert!(3 * few < 2 * corrected, "{few} of {corrected}");
    let circle = |x: f64, y: f64| 1.0 - x * x - y * y;
    assert_eq!(built(circle, 1.0, true).0, length(circle, 1.0).0);
}

/// What evaluators give is what the grid says they do.
#[test]
fn served_places_are_those_that_evaluators_reach() {
    let circle = |x: f64, y: f64| 1.0 - x * x - y * y;
    let grid = length(circle, 1.0).0.unwrap();
    let mut circle = |x: &[f64], state: &mut [f64]| root(|_| circle(x[0], x[1])).correct(x, state);
    let mut at = |x: f64, y: f64| grid.serves(&mut circle, &[x, y]);
    assert!(at(0.0, 0.0) && at(0.5, 0.5));
    let edge = std::f64::consts::FRAC_1_SQRT_2 - 1e-8;
    assert!(!at(0.8, 0.8) && !at(edge, edge));
}

#[test]
fn a_reference_beside_a_boundary_is_enough() {
    // The centres of the first cells are beyond the boundary.
    let strip = |x: f64, y: f64| 0.04 - (x - y) * (x - y);
    let (grid, _) = length(strip, 1.0);
    let grid = grid.unwrap();
    assert!(
        grid.served() > 0.15 && grid.served() < 0.2,
        "{}",
        grid.served()
    );
    assert_eq!(grid.left_out(), None);
}

/// A crank that turns, and a leg of variable length.
fn crank_and_leg(x: &[f64], state: &mut [f64]) -> Step {
    let mut triad = EyeNeedle::MACHINE;
    triad.legs[2] = x[1];
    triad.correct(&x[..1], state)
}

#[test]
fn polynomials_take_one_step() {
    let at = [0.0, 261.0];
    let ranges = [TURN, range(255.0, 265.0)];
    let start = EyeNeedle::start();
    let built =
        Grid::build_all(&mut crank_and_leg, &at, &start, &ranges, Terms::Polynomials).unwrap();
    assert!(
        built.served() == 1.0 && built.left_out().is_none(),
        "{built:?}"
    );
    let everywhere = [range(-20.0, 20.0), ranges[1]];
    let counts = survey_of(1, &built, &mut crank_and_leg, &everywhere);
    assert_eq!(counts, [20_000, 0, 0], "{built:?}");
    // Without a step the states are as near as polynomials may be, and not nearer than they are.
    let mut random = Random::new(3);
    let lookup = built.lookup::<2, 4, { Terms::Polynomials.count(2) }>();
    let lookup = lookup.unwrap();
    let mut most: f64 = 0.0;
    for _ in 0..1000 {
        let x = [random.between(-9.0, 9.0), random.between(250.0, 270.0)];
        let mut state = [0.0; 4];
        let floor = built.state(&x, &mut state);
        let there = lookup.at_with::<false>(x);
        assert_eq!(format!("{there:?}"), format!("{:?}", (state, floor)));
        if (255.0..265.0).contains(&x[1]) {
            most = most.max(crank_and_leg(&x, &mut state).size);
        }
    }
    assert!(most > 1e-12 && most < 3e-8, "{most:e}");
    assert!(built.lookup::<2, 4, 3>().is_none());
}

/// One step serves to about three cells from the boundary, four to one.
#[test]
fn polynomials_stay_inside_the_boundary() {
    let circle =
        |x: &[f64], state: &mut [f64]| root(|_| 1.0 - x[0] * x[0] - x[1] * x[1]).correct(x, state);
    let ranges = [range(-1.0, 1.0); 2];
    let build = |terms| Grid::build(&mut { circle }, &[0.0; 2], &[1.0], &ranges, terms).unwrap();
    let [slopes, polynomials] = [Terms::Slopes, Terms::Polynomials].map(build);
    let whole = std::f64::consts::FRAC_PI_4;
    assert!(polynomials.served() < slopes.served() && polynomials.served() > 0.88 * whole);
    let [certified, wrong, _] = survey_of(1, &polynomials, &mut { circle }, &ranges);
    assert!(wrong == 0 && certified > 13_000, "{certified} {wrong}");
}

/// Over one input, or three, there are none.
#[test]
fn polynomials_are_over_two_inputs() {
    let at = EyeNeedle::MACHINE.legs;
    let ranges = at.map(|leg| range(leg * 0.98, leg * 1.02));
    let [slopes, polynomials] = [Terms::Slopes, Terms::Polynomials]
        .map(|terms| Grid::build(&mut platform, &at, &EyeNeedle::start(), &ranges, terms).unwrap());
    assert_eq!(slopes, polynomials);
}
