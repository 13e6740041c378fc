//! Mechanisms that do not run through their whole range, each refused for what it is.

use super::{FourBar, FourBarAssembly, points};
use linkage::design::{Design, DesignError, Interruption, Targets};
use linkage::mechanism;

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
