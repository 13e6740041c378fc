//! Dwells in the worst case, as conditions, and between given inputs, against courses and all corners.

use super::{N, Rocker, course, design, speed, tip};
use linkage::Dimensions;
use linkage::design::{DesignError, Dwell, Figure, Peak, Stroke};
use linkage::summary::Curve;
use linkage::tolerance::Tolerances;
use std::f64::consts::TAU;

/// What the tip changes by over an interval.
fn band(mechanism: &Rocker, [from, length]: [f64; 2]) -> f64 {
    let assembly = mechanism.assemble().expect("assembles");
    let jet = |phi| {
        let tip = assembly.tip(phi);
        [tip.tip, tip.v, tip.a]
    };
    let course = Curve::new((from, from + length), 60, jet).expect("an interval");
    course.position().stroke()
}

/// The widest band over an interval at all corners of tolerances, given by their limits.
fn widest(mechanism: &Rocker, tolerances: &Tolerances<N>, interval: [f64; 2]) -> f64 {
    let (values, halves) = (mechanism.values(), tolerances.values());
    let corner = |corner: u32| {
        let sign = |k: usize| f64::from(corner >> k & 1) * 2.0 - 1.0;
        let value = |k: usize| values[k] + tolerances.middles()[k] + sign(k) * halves[k];
        band(&Rocker::from_values(&std::array::from_fn(value)), interval)
    };
    (0..1 << N).map(corner).fold(0.0, f64::max)
}

#[test]
fn a_dwell_in_the_worst_case_holds_for_all_corners() -> Result<(), DesignError> {
    let wide = Tolerances::new(Rocker::PARAMETERS, &[0.05; N]).expect("as many");
    // Cranks and couplers that may only be longer, and only be shorter, by far more.
    let beside = wide.limits(Rocker::INDEX_CRANK, 0.0, 0.6);
    let beside = beside.and_then(|all| all.limits(Rocker::INDEX_COUPLER, -0.5, -0.1));
    let nominal = design().want(Dwell::longest(tip(), 1.0)).run()?;
    for tolerances in [wide, beside.expect("the lower ones come first")] {
        let found = design()
            .want(Dwell::longest(tip(), 1.0).in_worst_case(&tolerances))
            .run()?;
        assert!(found.goal < nominal.goal - 1e-3, "{}", found.goal);
        let interval = [found.auxiliary[0][0], found.auxiliary[0][1]];
        let band = widest(&found.mechanism, &tolerances, interval);
        assert!((1.0 - 1e-4..=1.0).contains(&band), "{band}");
    }
    Ok(())
}

/// A dwell beside another goal: it is as long as was asked for, and no longer.
#[test]
fn a_dwell_is_a_condition() -> Result<(), DesignError> {
    let freely = design().want(Stroke(tip()).greatest()).run()?;
    let dwell = |rocker: &Rocker| {
        let dwell = course(rocker).longest_dwell(1.0).expect("a dwell");
        dwell.interval.range
    };
    let longest = design().want(Dwell::longest(tip(), 1.0)).run()?.goal;
    let length = 0.5 * (dwell(&freely.mechanism) + longest);
    assert!(
        length > dwell(&freely.mechanism) + 0.01,
        "{length} {longest}"
    );
    let found = design()
        .want(Stroke(tip()).greatest())
        .want(Dwell::at_least(tip(), 1.0, length))
        .run()?;
    assert!(found.converged && found.goal < freely.goal * (1.0 - 1e-3));
    let after = dwell(&found.mechanism);
    assert!((after - length).abs() < 1e-5, "{after} {length}");

    let far = design()
        .want(Peak(speed()).least())
        .want(Dwell::at_least(tip(), 1.0, 2.0))
        .run();
    let text = far.expect_err("too long").to_string();
    assert!(
        text.starts_with("dwell over 2 within 1: missed by "),
        "{text}"
    );
    Ok(())
}

/// Between given inputs the dwell is another one than the longest: that at the other limit.
#[test]
fn a_dwell_between_inputs() -> Result<(), DesignError> {
    let limit = course(&Rocker::default()).position().lowest.at;
    let (from, to) = (limit - 0.7, limit + 0.5);
    let longest = design().want(Dwell::longest(tip(), 1.0)).run()?;
    let beside = longest.auxiliary[0][0];
    let inside =
        |from: f64| (from - limit).rem_euclid(TAU) < 0.5 || (limit - from).rem_euclid(TAU) < 0.7;
    assert!(!inside(beside), "{beside} {limit}");
    let found = design()
        .want(Dwell::longest(tip(), 1.0).between(from, to))
        .want(Stroke(tip()).at_least(80.0))
        .run()?;
    let [start, length] = [found.auxiliary[0][0], found.auxiliary[0][1]];
    assert!(start >= from && start + length <= to + 1e-9 && found.goal == length);
    assert!((band(&found.mechanism, [start, length]) - 1.0).abs() < 1e-4);
    // Exactly there, the band over the same interval is the narrowest one.
    let there = design()
        .want(Dwell::narrowest(tip(), length).between(start, start + length))
        .want(Stroke(tip()).at_least(80.0))
        .run()?;
    assert_eq!(
        [there.auxiliary[0][0], there.auxiliary[0][1]],
        [start, length]
    );
    assert!((there.goal - 1.0).abs() < 1e-4, "{}", there.goal);

    let none = design()
        .want(Dwell::narrowest(tip(), 1.5).between(from, to))
        .run();
    let text = none.expect_err("too long").to_string();
    assert!(
        text.contains("an interval of 1.5 does not fit between")
            && text.contains("which are 1.2 apart"),
        "{text}"
    );
    Ok(())
}
