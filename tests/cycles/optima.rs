//! Optima against other ways to them.

use super::{Rocker, RockerAssembly, course, design, figure, margin, speed, tip};
use linkage::Dimensions;
use linkage::design::{DesignError, Dwell, Figure, Lowest, Peak, Stroke, TimeRatio};

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
