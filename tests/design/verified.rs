//! Results are verified without the search: what must hold holds, sums are those of the assemblies, nothing is worse than the start.
//!
//! Random problems are compared with numbers of single calls. `LINKAGE_LONG=1` does so for 10,000 of them.

use super::{FourBar, FourBarAssembly, FourBarDesign, LENGTHS, evenly, problem_of_nothing};
use linkage::Dimensions;
use linkage::design::{DesignError, FoundDesign, Relation, Targets};
use linkage_random::Random;
use std::f64::consts::TAU;

const PATH: fn(&FourBarAssembly, &[FourBar], &[f64], &mut super::PathColumns) =
    FourBarAssembly::path_sweep_sets_into;

/// The coupler point of a mechanism at some inputs.
fn points_of(mechanism: FourBar, inputs: &[f64]) -> Vec<[f64; 2]> {
    let linkage = mechanism.assemble().expect("it assembles");
    let points = inputs.iter().map(|&phi| linkage.path(phi).tracer.into());
    points.collect()
}

/// The sum of squares by single calls.
fn sum_of(linkage: &FourBarAssembly, points: &[[f64; 2]], inputs: &[f64]) -> f64 {
    let square = |(phi, [x, y]): (&f64, &[f64; 2])| {
        let tracer = linkage.path(*phi).tracer;
        (tracer.x - x).powi(2) + (tracer.y - y).powi(2)
    };
    inputs.iter().zip(points).map(square).sum()
}

/// The height of a triangle with a base of 40 mm is missed, however steep it is where the triangle is flat.
#[test]
fn a_condition_is_not_compared_with_its_derivative() {
    const BASE: f64 = 20.0;
    // Below the base the height is negative, so that it has a value everywhere.
    let height = |m: &FourBar| {
        let square = m.crank * m.crank - BASE * BASE;
        let height = square.abs().sqrt();
        let mut slopes = [0.0; 9];
        slopes[FourBar::INDEX_CRANK] = m.crank / height;
        (height.copysign(square) - 0.1, slopes)
    };
    let inputs = evenly(0.3, 0.7, 6);
    let longer = FourBar {
        crank: 24.0,
        ..FourBar::default()
    };
    // The bound allows a height of a millionth of a millimetre.
    let run = problem_of_nothing()
        .vary("crank", 5.0, BASE.next_up())
        .hold_that("a height of 0.1 mm", height)
        .want(
            Targets::new("tracer", points_of(longer, &inputs))
                .at_inputs(inputs)
                .computed_by(PATH),
        )
        .starts(16)
        .run();
    let Err(DesignError::NotFound(refusals)) = run else {
        let found = run.map(|found| found.best().mechanism.crank);
        panic!("the height is missed by 0.1 mm: {found:?}");
    };
    let (what, by) = refusals.missed.clone().expect("the condition is named");
    assert_eq!(what, "a height of 0.1 mm");
    assert!((by - 0.1).abs() < 1e-3, "{by}");
    let text = refusals.to_string();
    assert!(
        text.contains("; the nearest misses `a height of 0.1 mm` by 0.09999"),
        "{text}"
    );
}

/// An angle with room for a whole turn has no bounds, but a relation of it may: then it is not turned back into them.
#[test]
fn a_relation_of_an_angle_holds_in_the_result() {
    let inputs = evenly(0.3, 0.7, 6);
    let turned = FourBar {
        tilt: -0.3,
        ..FourBar::default()
    };
    let design = || -> FourBarDesign<'_> {
        let points = points_of(turned, &inputs);
        let wish = Targets::new("tracer", points).at_inputs(inputs.clone());
        problem_of_nothing()
            .vary("tilt", 0.0, TAU)
            .want(wish.computed_by(PATH))
            .starts(64)
    };
    let below = |m: &FourBar| {
        let mut slopes = [0.0; 9];
        slopes[FourBar::INDEX_TILT] = -1.0;
        (1.0 - m.tilt, slopes)
    };
    let linear = design().hold(Relation::at_most([("tilt", 1.0)], 1.0));
    for design in [linear, design().hold_that("a small tilt", below)] {
        let found = design.run().expect("it can be found");
        for own in &found.designs {
            assert!(own.mechanism.tilt <= 1.0 + 1e-9, "{}", own.mechanism.tilt);
        }
        assert!(found.best().sum < 1e-18, "{found}");
        assert!((found.best().mechanism.tilt + 0.3).abs() < 1e-9);
    }
}

/// A random problem near the declared mechanism, with a condition that this holds.
struct Posed {
    points: Vec<[f64; 2]>,
    inputs: Vec<f64>,
    /// The product of crank and rocker is at least this.
    product: f64,
}

impl Posed {
    fn new(random: &mut Random) -> Self {
        let inputs = evenly(random.between(0.0, TAU), 0.7, 6);
        let points = points_of(FourBar::default(), &inputs);
        let near =
            |[x, y]: [f64; 2]| [x + random.between(-1.0, 1.0), y + random.between(-1.0, 1.0)];
        Self {
            points: points.into_iter().map(near).collect(),
            product: random.between(300.0, 449.0),
            inputs,
        }
    }

    fn design(&self, random: &mut Random) -> FourBarDesign<'_> {
        let product = self.product;
        let condition = move |m: &FourBar| {
            let mut slopes = [0.0; 9];
            (slopes[FourBar::INDEX_CRANK], slopes[FourBar::INDEX_ROCKER]) = (m.rocker, m.crank);
            (m.crank * m.rocker - product, slopes)
        };
        let wish =
            Targets::new("tracer", self.points.iter().copied()).at_inputs(self.inputs.clone());
        let design = problem_of_nothing()
            .hold(Relation::crank_turns(LENGTHS, 0.0))
            .hold(Relation::at_most([("coupler", 1.0), ("rocker", -1.0)], 8.0))
            .hold_that("crank times rocker", condition)
            .want(wish.computed_by(PATH))
            .starts(1)
            .seed(random.bits());
        let design = design.vary("arm.x", -80.0, 80.0).vary("arm.y", -80.0, 80.0);
        LENGTHS
            .iter()
            .fold(design, |design, name| design.vary(name, 2.0, 200.0))
    }

    fn look(&self, found: &FoundDesign<FourBar, FourBarAssembly>) {
        let m = found.mechanism;
        assert!(m.crank * m.rocker > self.product * (1.0 - 1e-5), "{m:?}");
        assert!(m.coupler - m.rocker < 8.0 + 1e-6, "{m:?}");
        let lengths = LENGTHS.map(|name| {
            let index = FourBar::PARAMETERS.iter().position(|own| own.name == name);
            m.values()[index.expect("a length")]
        });
        assert!(lengths.iter().all(|x| (2.0..=200.0).contains(x)), "{m:?}");
        let [frame, crank, coupler, rocker] = lengths;
        for [other, a, b] in [
            [frame, coupler, rocker],
            [coupler, frame, rocker],
            [rocker, frame, coupler],
        ] {
            assert!(crank + other < a + b + 1e-6, "{m:?}");
        }
        let own = m.circuits().expect("it assembles");
        let modes = found.assembly.modes();
        assert!(own.whole().any(|branch| branch.assembly.modes() == modes));
        let sum = sum_of(&found.assembly, &self.points, &self.inputs);
        assert!(
            (sum - found.sum).abs() <= 1e-9 * sum + 1e-18,
            "{sum} and {}",
            found.sum
        );
    }
}

/// From one start anywhere few searches lead to what is as good as the declared mechanism, which holds all that must hold.
#[test]
fn nothing_is_worse_than_the_declared_mechanism() -> Result<(), DesignError> {
    let long = std::env::var_os("LINKAGE_LONG").is_some();
    let count = if long { 10_000 } else { 60 };
    let mut random = Random::new(7);
    let mut from_start = 0;
    for _ in 0..count {
        let posed = Posed::new(&mut random);
        let found = posed.design(&mut random).run()?;
        let declared = FourBar::default().assemble().expect("it assembles");
        let sum = sum_of(&declared, &posed.points, &posed.inputs);
        let best = found.best();
        assert!(best.sum <= sum * (1.0 + 1e-6), "{} and {sum}", best.sum);
        from_start += u32::from(best.start == 1);
        found.designs.iter().for_each(|own| posed.look(own));
        let sums: Vec<f64> = found.designs.iter().map(|own| own.sum).collect();
        assert!(sums.is_sorted(), "{sums:?}");
    }
    assert!(from_start > count / 10, "{from_start} of {count}");
    Ok(())
}

/// What does not hold in the declared mechanism is not returned with it.
#[test]
fn a_declared_mechanism_that_violates_a_condition_is_no_result() {
    let inputs = evenly(0.3, 0.7, 6);
    let points = points_of(FourBar::default(), &inputs);
    let none = |_: &FourBar| (-1e-3, [0.0; 9]);
    let run = problem_of_nothing()
        .vary("crank", 14.0, 16.0)
        .hold_that("nothing", none)
        .want(
            Targets::new("tracer", points)
                .at_inputs(inputs)
                .computed_by(PATH),
        )
        .starts(4)
        .run();
    let Err(DesignError::NotFound(refusals)) = run else {
        panic!("the condition holds nowhere");
    };
    assert_eq!(refusals.missed, Some(("nothing".to_string(), 1e-3)));
}
