//! Relations of the user, and lengths of a catalogue, against other ways to the same optimum.

use super::{Rocker, design, figure, speed, tip};
use linkage::design::{CycleDesign, DesignError, Figure, Peak, Relation, Stroke};
use std::f64::consts::TAU;

/// The crank's length over the rocker's is bounded: as a nonlinear relation, and as a linear one.
#[test]
fn a_relation_is_the_same_in_both_ways() -> Result<(), DesignError> {
    let problem = || design().want(Stroke(tip()).greatest());
    let freely = problem().run()?;
    let ratio = 0.45;
    assert!(freely.mechanism.crank > ratio * freely.mechanism.rocker);
    let straight = Relation::at_most([("crank", 1.0), ("rocker", -ratio)], 0.0);
    let straight = problem().hold(straight).run()?;
    let quotient = |rocker: &Rocker| {
        let Rocker {
            crank: a,
            rocker: b,
            ..
        } = *rocker;
        (ratio - a / b, [0.0, -1.0 / b, 0.0, a / (b * b), 0.0])
    };
    let curved = problem().hold_that("crank over rocker", quotient).run()?;
    assert!(straight.converged && curved.converged);
    assert!((straight.goal - curved.goal).abs() < 1e-6 * straight.goal);
    assert!((curved.mechanism.crank / curved.mechanism.rocker - ratio).abs() < 1e-9);
    Ok(())
}

/// A relation and its opposite are an equation.
#[test]
fn two_relations_are_an_equation() -> Result<(), DesignError> {
    let problem = || design().want(Peak(speed()).least());
    let line = |sign: f64| {
        move |rocker: &Rocker| {
            let value = rocker.crank - 0.5 * rocker.rocker + 1.0;
            (sign * value, [0.0, sign, 0.0, -0.5 * sign, 0.0])
        }
    };
    let both = problem()
        .hold_that("no less", line(1.0))
        .hold_that("no more", line(-1.0))
        .run()?;
    let straight = Relation::exactly([("crank", 1.0), ("rocker", -0.5)], -1.0);
    let straight = problem().hold(straight).run()?;
    assert!(both.converged && straight.converged);
    assert!((both.goal - straight.goal).abs() < 1e-6 * straight.goal);
    assert!(line(1.0)(&both.mechanism).0.abs() < 1e-6);
    // Without it another mechanism is better.
    assert!(problem().run()?.goal < straight.goal);
    Ok(())
}

/// Two lengths within an ellipse: the optimum is where a line of equal goal touches it.
#[test]
fn a_curved_relation_is_touched() -> Result<(), DesignError> {
    let problem = CycleDesign::new(
        Rocker::default(),
        Rocker::assemble,
        Rocker::assemble_from,
        Rocker::circuits,
    )?;
    let ellipse = |rocker: &Rocker| {
        let (a, b) = ((rocker.crank - 50.0) / 3.0, (rocker.rocker - 100.0) / 8.0);
        let slopes = [0.0, -2.0 * a / 3.0, 0.0, -2.0 * b / 8.0, 0.0];
        (1.0 - a * a - b * b, slopes)
    };
    let found = problem
        .vary("crank", 45.0, 55.0)
        .vary("rocker", 90.0, 110.0)
        .hold_that("lengths of the ellipse", ellipse)
        .want(Peak(speed()).least())
        .run()?;
    assert!(found.converged && ellipse(&found.mechanism).0.abs() < 1e-8);
    let at = |i: i32| {
        let (sin, cos) = (TAU * f64::from(i) / 720.0).sin_cos();
        let rocker = Rocker {
            crank: 50.0 + 3.0 * cos,
            rocker: 100.0 + 8.0 * sin,
            ..Rocker::default()
        };
        figure(&Peak(speed()), &rocker).0
    };
    let least = (0..720).map(at).fold(f64::INFINITY, f64::min);
    // Between two of 720 places the goal falls by less than this.
    assert!(
        (-1e-5..=1e-9).contains(&(found.goal / least - 1.0)),
        "{} {least}",
        found.goal
    );
    Ok(())
}

/// What cannot hold is told with its title.
#[test]
fn a_relation_out_of_reach() {
    let none = |rocker: &Rocker| (rocker.crank - 60.0, [0.0, 1.0, 0.0, 0.0, 0.0]);
    let run = design()
        .hold_that("a long crank", none)
        .want(Peak(speed()).least())
        .run();
    let text = run.expect_err("its bound is 55").to_string();
    assert!(
        text.starts_with("a long crank: missed by 5 ") && text.contains(", with crank"),
        "{text}"
    );
}

#[test]
fn lengths_of_a_catalogue() -> Result<(), DesignError> {
    let (cranks, couplers) = ([46.0, 48.5, 51.0, 54.0], [110.0, 118.0, 127.0]);
    let stroke = 84.0;
    let problem = || {
        CycleDesign::new(
            Rocker::default(),
            Rocker::assemble,
            Rocker::assemble_from,
            Rocker::circuits,
        )
        .map(|design| {
            design
                .vary_by("rocker", 0.1)
                .want(Peak(speed()).least())
                .want(Stroke(tip()).at_least(stroke))
        })
    };
    let found = problem()?
        .catalogue("crank", cranks)
        .catalogue("coupler", couplers)
        .run()?;
    let Rocker { crank, coupler, .. } = found.mechanism;
    assert!(cranks.contains(&crank) && couplers.contains(&coupler));
    // Every pair for itself.
    let mut least = f64::INFINITY;
    for crank in cranks {
        for coupler in couplers {
            let alone = problem()?.vary("crank", crank, crank);
            if let Ok(alone) = alone.vary("coupler", coupler, coupler).run() {
                least = least.min(alone.goal);
            }
        }
    }
    assert!(
        (found.goal - least).abs() < 1e-6 * least,
        "{} {least}",
        found.goal
    );
    // Between its values the goal is better.
    let freely = problem()?
        .vary("crank", 46.0, 54.0)
        .vary("coupler", 110.0, 127.0);
    assert!(freely.run()?.goal < found.goal);

    // No crank of these gives the stroke, but one between them would.
    let far = problem()?.catalogue("crank", [40.0, 41.0]);
    let text = far.run().expect_err("too short").to_string();
    assert!(text.contains("stroke of at least 84: missed by"), "{text}");
    Ok(())
}
