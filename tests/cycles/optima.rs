//! Figures and their optima: derivatives against differences, optima and compromises against other ways to them.

use super::{
    N, Rocker, RockerAssembly, asked, changed, course, design, distance, figure, margin,
    slopes_of_pieces_agree, speed, tip,
};
use linkage::design::{
    Curve, CycleDesign, DesignError, Dwell, Figure, Highest, Lowest, Peak, RootMeanSquare, Stroke,
    TimeRatio,
};
use linkage::{Dimensions, mechanism};
use std::f64::consts::TAU;

// Optima against other ways to them.

#[test]
fn a_longest_dwell_is_that_of_the_narrowest_band() -> Result<(), DesignError> {
    let stroke = course(&Rocker::default()).position().stroke();
    let before = course(&Rocker::default())
        .longest_dwell(1.0)
        .expect("a dwell")
        .interval
        .range;
    let longest = design()
        .want(Dwell::longest(tip(), 1.0))
        .want(Stroke(tip()).equal(stroke))
        .run()?;
    let after = course(&longest.mechanism);
    assert!(longest.converged && longest.goal > 1.02 * before);
    assert!(
        (after.longest_dwell(1.0).expect("a dwell").interval.range - longest.goal).abs() < 1e-5
    );
    assert!((after.position().stroke() - stroke).abs() < 1e-6);

    // The other way round: the band over that length.
    let narrowest = design()
        .want(Dwell::narrowest(tip(), longest.goal))
        .want(Stroke(tip()).equal(stroke))
        .run()?;
    assert!((narrowest.goal - 1.0).abs() < 1e-4, "{}", narrowest.goal);
    for (a, b) in longest
        .mechanism
        .values()
        .into_iter()
        .zip(narrowest.mechanism.values())
    {
        assert!((a - b).abs() < 1e-2, "{a} {b}");
    }
    Ok(())
}

#[test]
fn figures_are_led_to_limits_and_goals() -> Result<(), DesignError> {
    let ratio = TimeRatio::new(tip(), |rocker: &RockerAssembly, phi| rocker.slopes(phi).ev);
    let found = design()
        .want(Peak(speed()).least())
        .want(ratio.equal(1.1))
        .want(Lowest(margin()).at_least(0.55))
        .run()?;
    let after = course(&found.mechanism);
    let strokes = after.time_ratio().expect("two strokes");
    assert!((strokes.rise / strokes.fall - 1.1).abs() < 1e-6);
    assert!((after.velocity().largest().value.abs() - found.goal).abs() < 1e-6 * found.goal);
    assert!(found.margin > 0.55 - 1e-6);
    let freely = design().want(Peak(speed()).least()).run()?;
    assert!(freely.goal < found.goal);
    let greatest = design().want(Stroke(tip()).greatest()).run()?;
    let (large, _) = figure(&Stroke(tip()), &greatest.mechanism);
    assert!((greatest.goal - large).abs() < 1e-9 * large);
    assert!(large > figure(&Stroke(tip()), &Rocker::default()).0);
    assert!(!greatest.at_bound.is_empty());
    Ok(())
}

// Compromises of two goals.

/// A large stroke costs speed: each compromise is the best mechanism for its stroke, and the ends are those of each goal alone.
#[test]
fn compromises_are_optima_of_their_limits() -> Result<(), DesignError> {
    let problem = || design().want(Lowest(margin()).at_least(0.4));
    let front = problem().front(Peak(speed()).least(), Stroke(tip()).greatest(), 6)?;
    assert_eq!(front.len(), 6);
    let alone = problem().want(Peak(speed()).least()).run()?;
    assert_eq!(front[0].best.goal, alone.goal);
    let most = problem().want(Stroke(tip()).greatest()).run()?.goal;
    assert!((front[5].other / most - 1.0).abs() < 1e-3 && front[5].other <= most);
    let step = (most - front[0].other) / 5.0;
    for (k, pair) in front.windows(2).enumerate() {
        let [one, next] = pair else { unreachable!() };
        assert!(one.best.goal < next.best.goal && one.other < next.other);
        let rest = next.other - one.other - step;
        assert!(k == 4 || rest.abs() < 1e-6 * step, "{k}: {rest}");
        let (peak, stroke) = (
            figure(&Peak(speed()), &next.best.mechanism).0,
            figure(&Stroke(tip()), &next.best.mechanism).0,
        );
        assert!(
            (peak - next.best.goal).abs() < 1e-9 * peak
                && (stroke - next.other).abs() < 1e-9 * stroke
        );
        let limited = problem()
            .want(Peak(speed()).least())
            .want(Stroke(tip()).at_least(next.other * (1.0 - 1e-9)))
            .run()?;
        assert!(
            next.best.goal <= limited.goal * (1.0 + 1e-5),
            "{k}: {} {}",
            next.best.goal,
            limited.goal
        );
    }
    Ok(())
}

/// A wish with variables of its own may be the first goal. Where both agree, one mechanism is all of the front.
#[test]
fn a_front_of_one() -> Result<(), DesignError> {
    let front = design().front(Dwell::longest(tip(), 1.0), Stroke(tip()).greatest(), 4)?;
    assert!(front.len() > 1 && front[0].best.goal > front[front.len() - 1].best.goal);
    let same = design().front(Stroke(tip()).least(), Stroke(tip()).least(), 3)?;
    assert_eq!(same.len(), 1);

    let none = design().front(Stroke(tip()).least(), Peak(speed()).least(), 1);
    let text = none.expect_err("one is no front").to_string();
    assert_eq!(text, "a front: less than two compromises");
    let two =
        design()
            .want(Peak(speed()).least())
            .front(Stroke(tip()).least(), Peak(speed()).least(), 2);
    let text = two.expect_err("a goal more").to_string();
    assert!(
        text.starts_with("2 goals: least peak, least stroke;"),
        "{text}"
    );
    Ok(())
}

// An input that is a length, over a range that is as long as a turn is in radians.

mechanism! {
    /// A lever that a cylinder turns; its length happens to grow by 2 pi.
    #[derive(Clone, Copy)]
    struct Lever {
        unit mm;
        param arm = 40mm;
        input x = 53mm in 50mm..56.283185307179586mm;
        unknown theta = 40deg;
        unknown psi = 120deg;
        loop polar(x, theta) = (60mm, 0mm) + polar(arm, psi);
    }
    impl Lever {
        fn turning(x) -> LeverTurning { psi, v: velocity(psi), a: acceleration(psi) }
        fn accuracy(x) -> LeverAccuracy { e: sensitivity(psi) }
    }
}

/// The mean over a length, with both of its ends, whatever the number is by which it grows.
#[test]
fn a_length_does_not_turn() {
    let jet = |lever: &LeverAssembly, x| {
        let turning = lever.turning(x);
        [turning.psi, turning.v, turning.a]
    };
    let psi = Curve::new(jet, |lever: &LeverAssembly, x| lever.accuracy(x).e);
    let design = CycleDesign::new(
        Lever::default(),
        Lever::assemble,
        Lever::assemble_from,
        Lever::circuits,
    );
    let design = design.expect("assembles").vary("arm", 39.0, 41.0);
    let found = design.want(RootMeanSquare(psi).least()).run();
    let found = found.expect("a lever within the bounds");
    // By the law of cosines, in the middle of many short steps.
    let arm = found.mechanism.arm;
    let square = |k: i32| {
        let x = 50.0 + TAU * (f64::from(k) + 0.5) / 10_000.0;
        let cosine = (x * x - 3600.0 - arm * arm) / (120.0 * arm);
        cosine.acos().powi(2) / 10_000.0
    };
    let mean = (0..10_000).map(square).sum::<f64>().sqrt();
    assert!(
        (found.goal - mean).abs() < 1e-5 * mean,
        "{} and {mean}",
        found.goal
    );
}

// Derivatives of all figures against differences.

pub(super) fn slopes_agree(what: &impl Figure<RockerAssembly, N>) {
    const STEP: f64 = 1e-3;
    let (value, slopes) = figure(what, &Rocker::default());
    assert!(
        value != 0.0 && slopes.iter().any(|slope| slope.abs() > 1e-6 * value.abs()),
        "{}",
        what.title()
    );
    for (k, slope) in slopes.into_iter().enumerate() {
        let [up, down] = [STEP, -STEP].map(|step| figure(what, &changed(k, step)).0);
        let difference = (up - down) / (2.0 * STEP);
        let size = slopes
            .iter()
            .fold(0.0, |most: f64, slope| most.max(slope.abs()));
        assert!(
            (slope - difference).abs() < 1e-6 * size,
            "{} by {k}: {slope} and {difference}",
            what.title()
        );
    }
}

#[test]
fn slopes_of_figures_are_those_of_differences() {
    slopes_agree(&Highest(tip()));
    slopes_agree(&Lowest(tip()));
    slopes_agree(&Stroke(tip()));
    slopes_agree(&Peak(speed()));
    slopes_agree(&Highest(distance()));
    slopes_agree(&Lowest(margin()));
    slopes_agree(&RootMeanSquare(speed()));
    slopes_agree(&TimeRatio::new(tip(), |rocker: &RockerAssembly, phi| {
        rocker.slopes(phi).ev
    }));
}

#[test]
fn slopes_of_a_dwell_are_those_of_differences() {
    let limit = course(&Rocker::default()).position().highest;
    let own = [limit.at - 0.3, 0.8, limit.value - 2.0, 3.0];
    let dwell = Dwell::longest(tip(), own[3]);
    let nominal = Rocker::default().values();
    let place: [f64; N + 4] = std::array::from_fn(|k| if k < N { nominal[k] } else { own[k - N] });
    // What is sampled, above and below, the limit above, and the goal.
    let count = asked(&dwell, &place).len();
    assert_eq!(count, 2 * Dwell::<RockerAssembly, N>::SAMPLES + 2);
    slopes_of_pieces_agree(&dwell, &place);
    // Within given inputs there is a condition more, as a condition itself no goal.
    let window = Dwell::longest(tip(), own[3]).between(limit.at - 0.4, limit.at + 0.6);
    assert_eq!(asked(&window, &place).len(), count + 1);
    slopes_of_pieces_agree(&window, &place);
    let condition = Dwell::at_least(tip(), own[3], own[1]);
    assert_eq!(asked(&condition, &place).len(), count - 1);
    slopes_of_pieces_agree(&condition, &place);
}
