//! Errors that tolerances cause, as figures: against `Effects` and `Budget`, over the whole range against samples.

use super::optima::slopes_agree;
use super::{
    N, Rocker, RockerAssembly, course, design, effects, errors, errors_within, figure, one_sided,
    second, tip, tolerances,
};
use linkage::Vector2;
use linkage::design::{CycleDesign, DesignError, ErrorOf, Figure, Stroke};
use linkage::tolerance::{Distribution, Effects, Tolerances, Uncertainties};
use std::f64::consts::TAU;

type Errors = ErrorOf<'static, RockerAssembly, N>;

/// Dimensions that are turned on one machine go together.
fn correlated() -> Uncertainties<N> {
    let pairs = [
        (Rocker::INDEX_CRANK, Rocker::INDEX_COUPLER, 0.7),
        (Rocker::INDEX_ROCKER, Rocker::INDEX_COUPLER, -0.4),
    ];
    let all = Uncertainties::new(&one_sided(), Distribution::Uniform);
    all.correlations(&pairs).expect("they fit together")
}

fn rates(rocker: &RockerAssembly, phi: f64) -> [[f64; N]; 2] {
    let slopes = rocker.slopes(phi);
    [slopes.ev, slopes.ea]
}

fn of_point(rocker: &RockerAssembly, phi: f64) -> [Vector2<f64>; N] {
    rocker.spread(phi).e
}

fn second_of_point(rocker: &RockerAssembly, phi: f64) -> [[Vector2<f64>; N]; N] {
    rocker.spread(phi).h
}

fn rates_of_point(rocker: &RockerAssembly, phi: f64) -> [[Vector2<f64>; N]; 2] {
    let spread = rocker.spread(phi);
    [spread.ev, spread.ea]
}

const NOWHERE: [f64; 0] = [];
const SOMEWHERE: [f64; 3] = [0.4, 2.0, 4.4];

/// Errors of the tip and of the point, at given inputs and over the range.
fn all() -> Vec<Errors> {
    let mut all = Vec::new();
    for tolerances in [tolerances(), one_sided()] {
        for inputs in [&SOMEWHERE[..], &NOWHERE] {
            let inputs = || inputs.iter().copied();
            let mut pair = vec![
                ErrorOf::worst_case(effects, second, &tolerances, inputs()),
                ErrorOf::root_sum_square(effects, second, &tolerances, inputs()),
                ErrorOf::standard(effects, second, &correlated(), inputs()),
            ];
            let mut vectors = vec![
                ErrorOf::worst_case(of_point, second_of_point, &tolerances, inputs()),
                ErrorOf::root_sum_square(of_point, second_of_point, &tolerances, inputs()),
                ErrorOf::standard(of_point, second_of_point, &correlated(), inputs()),
            ];
            if inputs().count() == 0 {
                pair = pair
                    .into_iter()
                    .map(|one| one.over_the_range(rates))
                    .collect();
                let over = |one: Errors| one.over_the_range(rates_of_point);
                vectors = vectors.into_iter().map(over).collect();
            }
            all.append(&mut pair);
            all.append(&mut vectors);
        }
    }
    all
}

#[test]
fn slopes_of_errors_are_those_of_differences() {
    let all = all();
    assert_eq!(all.len(), 24);
    all.iter().for_each(slopes_agree);
    slopes_agree(&errors(true));
    slopes_agree(&errors(false));
    slopes_agree(&errors_within(&one_sided(), true));
}

/// The largest of 5,000 samples.
fn sampled(error: impl Fn(&RockerAssembly, f64) -> f64) -> f64 {
    let assembly = Rocker::default().assemble().expect("assembles");
    let at = |i: i32| error(&assembly, TAU * f64::from(i) / 5_000.0);
    (0..5_000).map(at).fold(0.0, f64::max)
}

#[test]
fn the_largest_over_the_range_is_that_of_samples() {
    let value = |errors: Errors| figure(&errors, &Rocker::default()).0;
    for tolerances in [tolerances(), one_sided()] {
        let over = ErrorOf::worst_case(effects, second, &tolerances, NOWHERE).over_the_range(rates);
        let known =
            sampled(|rocker, phi| tolerances.effects(&rocker.slopes(phi).e).worst_case()[0]);
        let over = value(over);
        assert!(
            over >= known * (1.0 - 1e-6) && over < known * 1.005,
            "{over} {known}"
        );
        let of_point = ErrorOf::worst_case(of_point, second_of_point, &tolerances, NOWHERE);
        let over = value(of_point.over_the_range(rates_of_point));
        let known =
            sampled(|rocker, phi| tolerances.effects(&rocker.spread(phi).e).worst_modulus());
        assert!((over / known - 1.0).abs() < 1e-6, "{over} {known}");
    }
    let over = ErrorOf::standard(effects, second, &correlated(), NOWHERE).over_the_range(rates);
    let known = sampled(|rocker, phi| correlated().budget(&rocker.slopes(phi).e).standard()[0]);
    assert!((value(over) / known - 1.0).abs() < 1e-6);
    let over = ErrorOf::standard(of_point, second_of_point, &correlated(), NOWHERE);
    let over = value(over.over_the_range(rates_of_point));
    let known = sampled(|rocker, phi| {
        let [x, y] = correlated().budget(&rocker.spread(phi).e).standard();
        x.hypot(y)
    });
    assert!((over / known - 1.0).abs() < 1e-6, "{over} {known}");
    // Correlations matter here: without them it is another number.
    let free = Uncertainties::new(&one_sided(), Distribution::Uniform);
    let free = value(ErrorOf::standard(effects, second, &free, NOWHERE).over_the_range(rates));
    let with =
        value(ErrorOf::standard(effects, second, &correlated(), NOWHERE).over_the_range(rates));
    assert!((free / with - 1.0).abs() > 0.05, "{free} {with}");
}

/// An optimum over the range, in the worst case of a vector: no rocker of a grid has a smaller error.
#[test]
fn the_least_error_of_a_vector_over_the_range() -> Result<(), DesignError> {
    let error = || {
        ErrorOf::worst_case(of_point, second_of_point, &one_sided(), NOWHERE)
            .over_the_range(rates_of_point)
    };
    let problem = CycleDesign::new(
        Rocker::default(),
        Rocker::assemble,
        Rocker::assemble_from,
        Rocker::circuits,
    )?;
    let found = problem
        .vary("coupler", 110.0, 130.0)
        .vary("rocker", 90.0, 110.0)
        .want(error().least())
        .run()?;
    let at = |i: i32, j: i32| {
        let rocker = Rocker {
            coupler: 110.0 + f64::from(i),
            rocker: 90.0 + f64::from(j),
            ..Rocker::default()
        };
        figure(&error(), &rocker).0
    };
    let pairs = (0..=20).flat_map(|i| (0..=20).map(move |j| (i, j)));
    let least = pairs.map(|(i, j)| at(i, j)).fold(f64::INFINITY, f64::min);
    assert!(
        (-0.02..=1e-9).contains(&(found.goal / least - 1.0)),
        "{} {least}",
        found.goal
    );
    assert!(found.goal < 0.99 * figure(&error(), &Rocker::default()).0);
    Ok(())
}

/// Whether zones lie about the nominal dimensions or beside them.
#[test]
fn errors_are_those_of_effects() {
    let assembly = Rocker::default().assemble().expect("assembles");
    for tolerances in [tolerances(), one_sided()] {
        let largest = |error: &dyn Fn(&Effects<N, 1>) -> f64| {
            let at = |i: i32| error(&tolerances.effects(&assembly.slopes(0.5 * f64::from(i)).e));
            (0..12).map(at).fold(0.0, f64::max)
        };
        let of = |worst_case: bool| {
            let errors = errors_within(&tolerances, worst_case);
            figure(&errors, &Rocker::default()).0
        };
        let (worst, exact) = (of(true), largest(&|effects| effects.worst_case()[0]));
        assert!(worst >= exact && worst < exact * 1.005, "{worst} {exact}");
        let root = largest(&|effects| effects.root_sum_square()[0]);
        assert!((of(false) - root).abs() < 1e-12);
    }
    // The shift counts: it is more than the smoothing could hide.
    let [about, beside] = [tolerances(), one_sided()].map(|tolerances| {
        let halves = Tolerances::new(Rocker::PARAMETERS, &tolerances.values()).expect("as many");
        let of = |tolerances| figure(&errors_within(tolerances, true), &Rocker::default()).0;
        of(&tolerances) / of(&halves)
    });
    assert!(about == 1.0 && beside > 1.1, "{about} {beside}");
}

#[test]
fn an_error_is_made_small() -> Result<(), DesignError> {
    let (before, _) = figure(&errors(true), &Rocker::default());
    let stroke = course(&Rocker::default()).position().stroke();
    let found = design()
        .want(errors(true).least())
        .want(Stroke(tip()).equal(stroke))
        .run()?;
    assert!(found.goal < 0.99 * before, "{} {before}", found.goal);
    assert!((figure(&errors(true), &found.mechanism).0 - found.goal).abs() < 1e-9);
    Ok(())
}

/// The root of the sum of squares as a goal: over one length it is the least of a grid.
#[test]
fn the_least_root_sum_square() -> Result<(), DesignError> {
    let problem = CycleDesign::new(
        Rocker::default(),
        Rocker::assemble,
        Rocker::assemble_from,
        Rocker::circuits,
    )?;
    let found = problem
        .vary("rocker", 80.0, 120.0)
        .want(errors(false).least())
        .run()?;
    let at = |i: i32| {
        let rocker = Rocker {
            rocker: 80.0 + 0.1 * f64::from(i),
            ..Rocker::default()
        };
        figure(&errors(false), &rocker).0
    };
    let least = (0..=400).map(at).fold(f64::INFINITY, f64::min);
    assert!(
        (-1e-4..=1e-9).contains(&(found.goal / least - 1.0)),
        "{} {least}",
        found.goal
    );
    Ok(())
}
