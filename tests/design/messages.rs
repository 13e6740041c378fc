//! What is told of wrong problems, with numbers.

use super::{FourBar, FourBarAssembly, FourBarDesign, evenly, points, problem};
use linkage::design::{Design, DesignError, Interrupted, Interruption, Relation, Targets, Timing};
use linkage::mechanism;
use std::f64::consts::TAU;

mechanism! {
    /// A slide over a part of a turn.
    struct Slider {
        unit mm;
        param crank = 20mm;
        param rod = 50mm;
        input phi = 0.2rad in -0.1rad..1rad;
        unknown theta = -5deg;
        unknown s = 70mm;
        loop polar(crank, phi) + polar(rod, theta) = (s, 0);
    }
    impl Slider {
        fn way(phi) -> Way { s, e: sensitivity(s) }
    }
}

fn wish(inputs: &[f64]) -> Targets {
    Targets::new("tracer", points(inputs)).at_inputs(inputs.iter().copied())
}

#[test]
fn all_mistakes_at_once() {
    let targets = wish(&[0.5, 1.0]).at_inputs([0.5]);
    let design = problem()
        .vary("crnk", 1.0, 2.0)
        .vary("crank", 4.0, 5.0)
        .vary("tilt", 2.0, 1.0);
    let error = design
        .want(targets.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()
        .expect_err("it is wrong");
    let text = error.to_string();
    for part in [
        "4 mistakes",
        "no parameter `crnk`; the mechanism has frame, crank, coupler, rocker, arm.x, arm.y, base.x, base.y, tilt",
        "`crank` is listed twice",
        "bounds of `tilt` contradict each other: from 2 to 1",
        "targets of tracer: 1 inputs, where 2 are needed",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
}

#[test]
fn functions_that_lack_something() {
    let free = wish(&[0.5, 1.0]).timing(Timing::InOrder);
    let error = problem()
        .want(free.computed_by(FourBarAssembly::poor_sweep_sets_into))
        .run()
        .expect_err("it is poor");
    let text = error.to_string();
    assert!(
        text.contains("`poor` has no derivative of `tracer` by the input"),
        "{text}"
    );
    assert!(
        text.contains("no derivatives of `tracer` by frame, rocker, which may vary"),
        "{text}"
    );
    let other = Targets::new("trace", [[1.0, 2.0]]).at_inputs([0.1]);
    let error = problem()
        .want(other.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()
        .expect_err("no such");
    assert!(
        error.to_string().contains("`path` has no quantity `trace`"),
        "{error}"
    );
    let short = Targets::new("tracer", [[1.0]]).at_inputs([0.1]);
    let error = problem()
        .want(short.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()
        .expect_err("no such");
    assert!(
        error
            .to_string()
            .contains("1 numbers of a target, where 2 are needed"),
        "{error}"
    );
}

#[test]
fn nothing_to_do() {
    let error = problem().run().expect_err("nothing is wanted");
    assert!(error.to_string().contains("nothing is wanted"), "{error}");
}

/// A mistake of each kind that has no other case, in full.
#[test]
fn mistakes_in_full() {
    let run = |targets: Targets| {
        let design = problem().want(targets.computed_by(FourBarAssembly::path_sweep_sets_into));
        design.run().expect_err("it is wrong").to_string()
    };
    let broken = Targets::new("tracer", [[1.0, f64::NAN], [2.0, 3.0]]);
    assert_eq!(run(broken), "targets of tracer: NaN is no finite number");
    let heavy = wish(&[0.5, 1.0]).weights([1.0, f64::INFINITY]);
    assert_eq!(run(heavy), "targets of tracer: inf is no finite number");
    let design = problem().starts(0);
    let design = design.want(wish(&[0.5]).computed_by(FourBarAssembly::path_sweep_sets_into));
    let text = design.run().expect_err("no starts").to_string();
    assert_eq!(text, "a design problem: no starts");

    let design = Design::new(
        Slider::default(),
        Slider::assemble,
        Slider::assemblies,
        Slider::circuits,
    );
    let wish = Targets::new("s", [[40.0], [50.0]]).at_inputs([0.5, 2.0]);
    let design = design.expect("it assembles").vary("rod", 40.0, 60.0);
    let error = design
        .want(wish.computed_by(SliderAssembly::way_sweep_sets_into))
        .run();
    assert_eq!(
        error.expect_err("it is outside").to_string(),
        "targets of s: the input 2 is outside of the mechanism's range from -0.1 to 1; change it, or the range of the input"
    );
}

/// Why an optimum is refused, each in its words.
#[test]
fn interruptions_in_full() {
    let told = |why: Interruption| Interrupted { sum: 0.25, why }.to_string();
    let begin = "the best of these, with a sum of squares of 0.25, ";
    assert_eq!(
        told(Interruption::DeadPoint(1.5)),
        format!("{begin}has a dead point at input 1.5")
    );
    assert_eq!(
        told(Interruption::Other),
        format!("{begin}is in another assembly after a full turn of the input")
    );
}

#[test]
fn a_start_that_does_not_assemble() {
    let broken = FourBar {
        crank: 500.0,
        ..FourBar::default()
    };
    let design = Design::<_, FourBarAssembly, 9>::new(
        broken,
        FourBar::assemble,
        FourBar::assemblies,
        FourBar::circuits,
    );
    let inputs = evenly(0.2, 0.4, 3);
    let run = design.and_then(|design| {
        design
            .vary("crank", 5.0, 6.0)
            .want(wish(&inputs).computed_by(FourBarAssembly::path_sweep_sets_into))
            .run()
    });
    let text = run.expect_err("its crank is too long").to_string();
    // From the end of the crank to the other pivot, less coupler and rocker in a line.
    let (sin, cos) = 30_f64.to_radians().sin_cos();
    let miss = (500.0 * cos - 40.0).hypot(500.0 * sin) - 65.0;
    assert!(
        text.contains(&format!("it misses by {miss:.3} mm")),
        "{text}"
    );
}

/// Its links are too long to turn: told is where the best design would have to stop.
#[test]
fn what_does_not_turn_says_how_far_it_goes() {
    let swinging = FourBar {
        crank: 47.0,
        ..FourBar::default()
    };
    let design = Design::<_, FourBarAssembly, 9>::new(
        swinging,
        FourBar::assemble,
        FourBar::assemblies,
        FourBar::circuits,
    );
    let inputs = evenly(0.4, 0.2, 3);
    let run = design.and_then(|design| {
        design
            .vary("arm.x", 5.0, 60.0)
            .want(wish(&inputs).computed_by(FourBarAssembly::path_sweep_sets_into))
            .starts(4)
            .run()
    });
    let text = run.expect_err("it does not turn").to_string();
    // Where coupler and rocker are in a line, 65 mm long.
    let end =
        ((47.0_f64.powi(2) + 40.0_f64.powi(2) - 65.0_f64.powi(2)) / (2.0 * 47.0 * 40.0)).acos();
    let told = format!(
        "assembles only between the inputs 0 and {end:.5}, and between {:.5} and 6.28319",
        TAU - end
    );
    assert!(text.contains(&told), "{told}\n{text}");
}

/// Each start counts once, and what refused it is named.
#[test]
fn what_refuses_the_starts_is_counted() {
    let refusals = |design: FourBarDesign| {
        let design =
            design.want(wish(&[0.2, 1.0]).computed_by(FourBarAssembly::path_sweep_sets_into));
        match design.starts(64).run() {
            Err(DesignError::NotFound(refusals)) => *refusals,
            other => panic!("{:?}", other.map(|found| found.designs.len())),
        }
    };
    // Only its bound holds the first relation; the second one refuses about half of the starts.
    let why = refusals(
        problem()
            .hold(Relation::at_most([("crank", 1.0)], 5.0))
            .hold(Relation::at_least([("rocker", 1.0)], 32.5)),
    );
    assert_eq!((why.starts, why.refused, why.ended), (64, 64, 0));
    let by = |name: &str| {
        let mut all = why.relations.iter();
        all.find(|(own, _)| own == name)
            .map_or(0, |(_, count)| *count)
    };
    assert_eq!(by("crank <= 5"), 64);
    // A sequence of low discrepancy has as many points in each half, but for one or two.
    assert!(
        (30..=34).contains(&by("-rocker <= -32.5")),
        "{:?}",
        why.relations
    );
    let text = why.to_string();
    assert!(
        text.contains("none of 64 starts") && text.contains(": 64 contradict relations ("),
        "{text}"
    );
    assert!(
        text.contains("64 `crank <= 5`") && !text.contains("0 end"),
        "{text}"
    );

    // The bound of the crank is 5.
    let none = |bar: &FourBar| {
        let mut slopes = [0.0; 9];
        slopes[1] = -1.0;
        (4.0 - bar.crank, slopes)
    };
    let why = refusals(problem().hold_that("a short crank", none));
    assert!(why.refused > 0 && why.broken > 0 && why.ended == 0);
    assert_eq!(why.refused + why.open + why.broken, 64);
    assert_eq!(why.conditions, [("a short crank".to_string(), why.broken)]);
    let text = why.to_string();
    let told = format!(
        "{} end where a condition does not hold ({} `a short crank`)",
        why.broken, why.broken
    );
    assert!(text.contains(&told), "{text}");
}

/// One point less than there are variables for.
#[test]
fn as_many_targets_as_can_be_met() {
    let one = wish(&[0.4]).computed_by(FourBarAssembly::path_sweep_sets_into);
    let found = problem()
        .want(one)
        .starts(256)
        .run()
        .expect("it can be met");
    assert!(found.best().sum < 1e-12);
    assert!(
        found
            .to_string()
            .contains("2 residuals, 4 variables: all can be met exactly"),
        "{found}"
    );
}
