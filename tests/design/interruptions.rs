//! Ranges of inputs: evenly spaced positions, and mechanisms that do not run through their range.

use super::{FourBar, FourBarAssembly, points};
use linkage::design::{Design, DesignError, Interruption, Targets, Timing};
use linkage::mechanism;

// Mechanisms that do not run through their whole range, each refused for what it is.

mechanism! {
    /// Its crank makes half a turn in a turn of the input.
    struct Geared {
        unit mm;
        param crank = 20mm;
        param rod = 50mm;
        input phi = 0.2rad in 0rad..360deg;
        unknown theta = -5deg;
        unknown s = 70mm;
        loop polar(crank, phi / 2) + polar(rod, theta) = (s, 0);
    }
    impl Geared {
        fn way(phi) -> Way { s, e: sensitivity(s) }
    }
}

/// Why the best of a search is refused.
fn why<F>(run: Result<F, DesignError>) -> (Interruption, String) {
    match run.map(|_| "a design") {
        Err(DesignError::NotFound(refusals)) => {
            let text = refusals.to_string();
            let best = refusals.nearest.unwrap_or_else(|| panic!("{text}"));
            (best.why, text)
        }
        other => panic!("{other:?}"),
    }
}

/// After a turn of the input it is at the other end of its stroke.
#[test]
fn what_is_elsewhere_after_a_turn() {
    let design = Design::new(
        Geared::default(),
        Geared::assemble,
        Geared::assemblies,
        Geared::circuits,
    );
    let wish = Targets::new("s", [[68.0], [60.0]]).at_inputs([0.5, 2.0]);
    let run = design.expect("it assembles").vary("rod", 40.0, 60.0);
    let run = run
        .want(wish.computed_by(GearedAssembly::way_sweep_sets_into))
        .starts(4)
        .run();
    let (why, text) = why(run);
    assert_eq!(why, Interruption::Other);
    assert!(
        text.contains("is in another assembly after a full turn of the input"),
        "{text}"
    );
}

/// Frame less crank is coupler less rocker: at 0 all links are in a line, elsewhere it runs.
#[test]
fn what_passes_a_dead_point() {
    let line = FourBar {
        frame: 40.0,
        crank: 10.0,
        coupler: 60.0,
        rocker: 30.0,
        ..FourBar::default()
    };
    let design = Design::<_, FourBarAssembly, 9>::new(
        line,
        FourBar::assemble,
        FourBar::assemblies,
        FourBar::circuits,
    );
    let inputs = [0.6, 1.4, 2.2];
    let wish = Targets::new("tracer", points(&inputs)).at_inputs(inputs);
    let run = design.and_then(|design| {
        design
            .vary("arm.x", 5.0, 60.0)
            .want(wish.computed_by(FourBarAssembly::path_sweep_sets_into))
            .starts(4)
            .run()
    });
    let (why, text) = why(run);
    let Interruption::DeadPoint(input) = why else {
        panic!("{text}");
    };
    let turn = std::f64::consts::TAU;
    assert!(input.min(turn - input).abs() < 1e-6, "{input}");
    assert!(text.contains("has a dead point at input "), "{text}");
}

// Evenly spaced positions of an input that does not turn: they have the room of its range, and no more.

mechanism! {
    /// A lever that a cylinder turns.
    struct Lever {
        unit mm;
        param arm = 40mm;
        param frame = 60mm;
        input x = 52mm in 50mm..55.2mm;
        unknown theta = 40deg;
        unknown psi = 120deg;
        loop polar(x, theta) = (frame, 0mm) + polar(arm, psi);
    }
    impl Lever {
        fn angle(x) -> LeverAngle { psi, v: velocity(psi), s: sensitivity(psi) }
    }
}

/// The range, as it is rounded.
const RANGE: f64 = 55.2 - 50.0;

/// Angles of a lever whose arm is a little longer, evenly spaced from a first length.
fn search(from: f64, step: f64, count: usize) -> Result<(f64, f64), DesignError> {
    let other = Lever {
        arm: 41.0,
        ..Lever::default()
    };
    let other = other.assemble().expect("it assembles");
    let angles = (0..count).map(|i| [other.angle(from + step * i as f64).psi]);
    let wish = Targets::new("psi", angles)
        .timing(Timing::Evenly(step))
        .computed_by(LeverAssembly::angle_sweep_sets_into);
    let design = Design::new(
        Lever::default(),
        Lever::assemble,
        Lever::assemblies,
        Lever::circuits,
    )?;
    let found = design.vary("arm", 38.0, 42.0).want(wish).starts(8).run()?;
    let best = found.best();
    Ok((best.mechanism.arm, best.inputs[0][0]))
}

#[test]
fn positions_that_are_longer_than_the_range() {
    let text = |step: f64, count: usize| {
        let error = search(50.0, step, count).expect_err("too long");
        error.to_string()
    };
    let told = "targets of psi: 17 positions every 0.4 take 6.4, the range is 5.2; take a shorter step or fewer positions, or widen the \
                range of the input";
    assert_eq!(text(0.4, 17), told);
    assert!(text(-0.4, 17).contains("17 positions every -0.4 take 6.4, the range is 5.2"));
}

/// As long as the range, or longer by what a step is rounded by, they begin at its end; shorter ones are found where they are.
#[test]
fn positions_that_fill_the_range() -> Result<(), DesignError> {
    let step = (RANGE / 13.0).next_up();
    assert!(13.0 * step > RANGE);
    let (arm, first) = search(50.0, step, 14)?;
    assert!((arm - 41.0).abs() < 1e-6 && first == 50.0, "{arm} {first}");
    let (arm, first) = search(55.2, -step, 14)?;
    assert!(
        (arm - 41.0).abs() < 1e-6 && (first - 55.2).abs() < 1e-12,
        "{arm} {first}"
    );
    let (arm, first) = search(51.0, 0.3, 14)?;
    assert!(
        (arm - 41.0).abs() < 1e-6 && (first - 51.0).abs() < 1e-6,
        "{arm} {first}"
    );
    Ok(())
}
