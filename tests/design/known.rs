//! Problems whose answers are known.

use super::{FourBar, FourBarAssembly, evenly, points, problem};
use linkage::Dimensions;
use linkage::design::{Relation, Targets, Timing};

const PATH: fn(&FourBarAssembly, &[FourBar], &[f64], &mut super::PathColumns) =
    FourBarAssembly::path_sweep_sets_into;

/// The path of a mechanism is found again, and with it the mechanism.
#[test]
fn a_path_is_found_again() {
    let inputs = evenly(0.3, 0.5, 12);
    let wish = Targets::new("tracer", points(&inputs))
        .at_inputs(inputs)
        .computed_by(PATH);
    let found = problem()
        .vary("arm.x", -40.0, 40.0)
        .vary("arm.y", -40.0, 40.0)
        .want(wish)
        .starts(128)
        .run();
    let found = found.expect("it can be found");
    let best = found.best();
    assert!(best.sum < 1e-20, "{:e}", best.sum);
    let known = FourBar::default();
    for (value, known) in best.mechanism.values().iter().zip(known.values()) {
        assert!((value - known).abs() < 1e-9, "{value} and {known}");
    }
    assert_eq!((found.residuals, found.variables), (24, 6));
    assert!(best.converged && best.hits > 1 && best.margin > 0.1);
    // Every design runs through the turn on one circuit.
    for design in &found.designs {
        let circuits = design.mechanism.circuits().expect("it assembles");
        assert!(
            circuits
                .whole()
                .any(|branch| branch.closed && branch.margin == design.margin)
        );
        assert!(
            design.inputs[0]
                .iter()
                .all(|&phi| design.assembly.path(phi).tracer.x.is_finite())
        );
    }
    assert!(
        found
            .designs
            .windows(2)
            .all(|pair| pair[0].sum <= pair[1].sum)
    );
}

/// Free inputs stay in order and within a turn, in both senses.
#[test]
fn inputs_are_in_order() {
    let mut inputs = evenly(0.3, 0.8, 6);
    for timing in [Timing::InOrder, Timing::Backwards] {
        let wish = Targets::new("tracer", points(&inputs))
            .timing(timing.clone())
            .computed_by(PATH);
        let found = problem()
            .want(wish)
            .starts(64)
            .run()
            .expect("it can be found");
        assert!(found.best().sum < 1e-18, "{:e}", found.best().sum);
        let sign = if timing == Timing::InOrder { 1.0 } else { -1.0 };
        for design in &found.designs {
            let all = &design.inputs[0];
            assert!(
                all.windows(2)
                    .all(|pair| sign * (pair[1] - pair[0]) >= -1e-12),
                "{all:?}"
            );
            assert!((all[5] - all[0]).abs() < std::f64::consts::TAU + 1e-9);
        }
        inputs.reverse();
    }
}

/// The velocity of the rocker at two inputs, and a pose between them, all at once.
#[test]
fn several_wishes_together() {
    let linkage = FourBar::default().assemble().expect("it assembles");
    let speeds = [0.6, 2.0, 4.0].map(|phi| [linkage.speed(phi).v]);
    let pose = linkage.pose(1.3);
    let speed = Targets::new("v", speeds)
        .weights([30.0])
        .at_inputs([0.6, 2.0, 4.0]);
    let pose = Targets::of_all(
        ["tracer", "theta"],
        [[pose.tracer.x, pose.tracer.y, pose.theta]],
    )
    .at_inputs([1.3]);
    let design = problem()
        .want(speed.computed_by(FourBarAssembly::speed_sweep_sets_into))
        .want(pose.computed_by(FourBarAssembly::pose_sweep_sets_into));
    let found = design.starts(64).run().expect("it can be found");
    assert_eq!(found.residuals, 6);
    assert!(found.best().sum < 1e-20, "{:e}", found.best().sum);
}

/// Relations and a condition hold for all designs; an equality exactly.
#[test]
fn what_must_hold_holds() {
    let inputs = evenly(0.3, 0.5, 6);
    let wish = Targets::new("tracer", points(&inputs))
        .at_inputs(inputs)
        .computed_by(PATH);
    let ratio = |m: &FourBar| {
        // The product of crank and rocker is at least 700 square millimetres.
        let mut slopes = [0.0; 9];
        (slopes[FourBar::INDEX_CRANK], slopes[FourBar::INDEX_ROCKER]) = (m.rocker, m.crank);
        (m.crank * m.rocker - 700.0, slopes)
    };
    let found = problem()
        .hold(Relation::exactly([("coupler", 1.0), ("rocker", -1.0)], 0.0))
        .hold(Relation::at_least([("frame", 1.0)], 42.0))
        .hold_that("crank times rocker", ratio)
        .want(wish)
        .starts(256)
        .run()
        .expect("it can be found");
    for design in &found.designs {
        let m = design.mechanism;
        assert!((m.coupler - m.rocker).abs() < 1e-9, "{m:?}");
        assert!(
            m.frame > 42.0 - 1e-9 && m.crank * m.rocker > 700.0 - 1e-4,
            "{m:?}"
        );
    }
    // The best one without the condition has 639, so it is active at the best one.
    let best = found.best().mechanism;
    assert!(
        (best.crank * best.rocker - 700.0).abs() < 1e-4,
        "{}",
        best.crank * best.rocker
    );
}

/// Lengths of a catalogue: compared with every combination, each optimised alone.
#[test]
fn lengths_of_a_catalogue() {
    let inputs = evenly(0.3, 0.5, 8);
    let wish = || {
        Targets::new("tracer", points(&inputs))
            .at_inputs(inputs.clone())
            .computed_by(PATH)
    };
    let list = [12.0, 14.0, 16.0, 18.0];
    let rest = || {
        let design = linkage::design::Design::new(
            FourBar::default(),
            FourBar::assemble,
            FourBar::assemblies,
            FourBar::circuits,
        );
        let design = design
            .expect("it assembles")
            .hold(Relation::crank_turns(super::LENGTHS, 0.0));
        design
            .vary("frame", 5.0, 60.0)
            .vary("coupler", 20.0, 60.0)
            .starts(64)
    };
    let found = rest()
        .catalogue("crank", list)
        .catalogue("rocker", [25.0, 28.0, 33.0])
        .want(wish())
        .run();
    let found = found.expect("it can be found");
    let mut least = f64::INFINITY;
    for crank in list {
        for rocker in [25.0, 28.0, 33.0] {
            let alone = rest()
                .vary("crank", crank, crank)
                .vary("rocker", rocker, rocker)
                .want(wish())
                .run();
            least = alone.map_or(least, |alone| least.min(alone.best().sum));
        }
    }
    let best = found.best();
    assert!(
        list.contains(&best.mechanism.crank) && [25.0, 28.0, 33.0].contains(&best.mechanism.rocker)
    );
    assert!(
        (best.sum - least).abs() < 1e-9 * least,
        "{} and {least}",
        best.sum
    );
}
