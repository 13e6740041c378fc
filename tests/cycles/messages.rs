//! What is wrong is told with numbers.

use super::{N, Rocker, RockerAssembly, design, figure, margin, speed, tip};
use linkage::design::{
    CycleDesign, DesignError, Dwell, Figure, Interruption, Lowest, Peak, Relation, Stroke,
    TimeRatio,
};
use std::f64::consts::TAU;

#[test]
fn what_is_wrong_is_told_with_numbers() {
    let message = |design: CycleDesign<'_, Rocker, RockerAssembly, N>| match design.run() {
        Ok(found) => panic!("found {found}"),
        Err(error) => error.to_string(),
    };
    let two = design()
        .want(Dwell::longest(tip(), 1.0))
        .want(Peak(speed()).least());
    let text = "2 goals: longest dwell within 1, least peak; keep one, and make conditions of the others with `at_most` or `at_least`";
    assert_eq!(message(two), text);
    let none = design()
        .vary("cranck", 1.0, 2.0)
        .want(Lowest(margin()).at_least(0.2));
    let text = message(none);
    assert!(
        text.starts_with(
            "2 mistakes\n- there is no parameter `cranck`; the mechanism has frame, crank,"
        ),
        "{text}"
    );
    assert!(
        text.ends_with("\n- no wish is a goal; one is to be least, greatest, longest or narrowest"),
        "{text}"
    );

    // The stroke grows with the crank, and shrinks with the coupler and the rocker's radius is the arm.
    let far = design()
        .want(Peak(speed()).least())
        .want(Stroke(tip()).at_least(200.0));
    let text = message(far);
    assert!(
        text.starts_with("stroke of at least 200: missed by "),
        "{text}"
    );
    assert!(
        text.contains("crank") && text.ends_with(" at a bound; widen these, or ask for less"),
        "{text}"
    );
}

/// Of several starts each counts once; the first one tells its numbers.
#[test]
fn what_refuses_the_starts_is_counted() {
    let run = design()
        .want(Peak(speed()).least())
        .want(Stroke(tip()).at_least(200.0))
        .starts(3)
        .run();
    let Err(DesignError::NotFound(why)) = run else {
        panic!("{run:?}");
    };
    assert_eq!((why.starts, why.open + why.broken + why.not_whole), (3, 3));
    assert_eq!(
        why.conditions,
        [("stroke of at least 200".to_string(), why.broken)]
    );
    let text = why.to_string();
    assert!(
        text.contains("; the first start: stroke of at least 200: missed by "),
        "{text}"
    );
}

/// Between two values of a catalogue the condition can be held, at none of them.
#[test]
fn values_of_a_catalogue_that_do_not_do() {
    let between = |rocker: &Rocker| {
        let aside = rocker.crank - 50.5;
        let mut slopes = [0.0; N];
        slopes[1] = -2.0 * aside;
        (0.01 - aside * aside, slopes)
    };
    let design = CycleDesign::new(
        Rocker::default(),
        Rocker::assemble,
        Rocker::assemble_from,
        Rocker::circuits,
    );
    let run = design
        .expect("assembles")
        .catalogue("crank", [48.0, 49.0, 50.0, 51.0, 52.0])
        .vary_by("rocker", 0.1)
        .want(Peak(speed()).least())
        .hold_that("a crank of 50.5 mm, about", between)
        .run();
    let error = run.expect_err("there is none");
    assert_eq!(
        error,
        DesignError::NoValues {
            parameters: vec!["crank".to_string()]
        }
    );
    assert_eq!(
        error.to_string(),
        "no values of the catalogues of crank near the best mechanism between them hold all conditions; offer more values, or ask for less"
    );
}

/// A problem of another mechanism, with the crank free between two lengths.
fn from(rocker: Rocker, crank: [f64; 2]) -> CycleDesign<'static, Rocker, RockerAssembly, N> {
    let design = CycleDesign::new(
        rocker,
        Rocker::assemble,
        Rocker::assemble_from,
        Rocker::circuits,
    );
    design
        .expect("assembles at the reference input")
        .vary("crank", crank[0], crank[1])
}

/// A start that does not turn is told with the inputs between which it assembles: whatever is wanted of it.
#[test]
fn a_start_that_does_not_run_through_the_turn() {
    let long = Rocker {
        crank: 90.0,
        ..Rocker::default()
    };
    // Where coupler and rocker are in a line, 220 mm long.
    let cosine = (90.0_f64.powi(2) + 140.0_f64.powi(2) - 220.0_f64.powi(2)) / (2.0 * 90.0 * 140.0);
    let end = cosine.acos();
    let told = format!(
        "the mechanism that the search begins with assembles only between the inputs 0 and {end:.5}, and between {:.5} and 6.28319; \
         begin with dimensions that run through the whole range, or narrow the range of the input",
        TAU - end
    );
    let wanted = |which: usize| {
        let design = from(long, [89.0, 91.0]);
        match which {
            0 => design.want(Peak(speed()).least()),
            1 => design.want(Dwell::longest(tip(), 1.0)),
            _ => design.want(Lowest(margin()).greatest()),
        }
    };
    for which in 0..3 {
        let error = wanted(which).run().expect_err("it does not turn");
        assert_eq!(error.to_string(), told);
        let DesignError::StartNotWhole(Interruption::Ends(intervals)) = error else {
            panic!("{error:?}");
        };
        assert!((intervals[0][1] - end).abs() < 1e-6 && intervals.len() == 2);
    }
    // Several starts count as those that do not assemble; the first one tells its numbers.
    let several = wanted(0).starts(3).run().expect_err("none turns");
    let text = several.to_string();
    assert!(
        text.contains(
            "3 do not assemble where something is wanted; the first start: the mechanism"
        ),
        "{text}"
    );

    // Bounds that exclude the mechanism itself: the nearest one within them does not assemble at all.
    let error = from(Rocker::default(), [500.0, 510.0])
        .want(Peak(speed()).least())
        .run()
        .expect_err("far too long");
    assert!(
        matches!(
            error,
            DesignError::StartNotWhole(Interruption::Unassembled(_))
        ),
        "{error:?}"
    );
    // On the way to it, from the end of the crank at the reference input to the other pivot, coupler and rocker are in a line.
    let along = 140.0 * 30_f64.to_radians().cos();
    let longest = along + (along * along + 220.0 * 220.0 - 140.0 * 140.0).sqrt();
    let part = 100.0 * (longest - 50.0) / 450.0;
    let text = error.to_string();
    assert!(
        text.contains(&format!("meets a dead point after {part:.2} %")),
        "{text}"
    );
}

/// A wish that finds nothing in a mechanism which turns says so.
#[test]
fn a_wish_that_finds_nothing() {
    let error = design().want(Dwell::longest(tip(), -1.0)).run();
    let text = error.expect_err("no band").to_string();
    let told = "longest dwell within -1: there is none in the mechanism that the search begins with; begin with another one";
    assert_eq!(text, told);
    // A crank that turns all the way has one sense only: no time ratio.
    let drag = Rocker {
        frame: 50.0,
        crank: 120.0,
        coupler: 100.0,
        rocker: 140.0,
        ..Rocker::default()
    };
    let ratio = TimeRatio::new(tip(), |rocker: &RockerAssembly, phi| rocker.slopes(phi).ev);
    let design = from(drag, [119.0, 121.0]).want(Peak(speed()).least());
    let error = design.want(ratio.equal(1.0)).run();
    let text = error.expect_err("no strokes").to_string();
    assert!(text.starts_with("time ratio of 1: there is none"), "{text}");
}

/// A goal that drives to a change point: frame and crank in a line are as long as coupler and rocker in one. What is found has a dead point
/// there, whatever the derivatives say, and is refused with its input.
#[test]
fn a_change_point_is_refused() {
    let error = from(Rocker::default(), [45.0, 80.0 * (1.0 - 1e-13)])
        .want(Stroke(tip()).greatest())
        .positions(120)
        .run()
        .expect_err("a change point");
    let DesignError::NotWhole(Interruption::DeadPoint(input)) = error else {
        panic!("{error:?}");
    };
    assert!((input - 0.5 * TAU).abs() < 1e-3, "{input}");
    let text = error.to_string();
    assert!(
        text.starts_with("the mechanism that was found has a dead point at input 3.1416;")
            || text.starts_with("the mechanism that was found has a dead point at input 3.1415"),
        "{text}"
    );
}

/// More equations than variables are counted; as many are met.
#[test]
fn more_equations_than_freedom() {
    // What a rocker with another crank and another arm has.
    let known = Rocker {
        crank: 52.0,
        arm: 74.0,
        ..Rocker::default()
    };
    let stroke = figure(&Stroke(tip()), &known).0;
    let peak = figure(&Peak(speed()), &known).0;
    let problem = || {
        from(Rocker::default(), [45.0, 55.0])
            .vary("arm", 50.0, 90.0)
            .want(Lowest(margin()).greatest())
            .want(Stroke(tip()).equal(stroke))
            .want(Peak(speed()).equal(peak))
    };
    let two = problem().run().expect("two equations, two variables");
    assert!(
        two.converged && (two.mechanism.crank - 52.0).abs() < 1e-5,
        "{two}"
    );
    let three = problem()
        .hold(Relation::exactly([("crank", 1.0), ("arm", -1.0)], -25.0))
        .run()
        .expect_err("three equations");
    let text = three.to_string();
    assert!(
        text.ends_with(
            " in the best mechanism that was found; 3 equations must hold, and what varies is 2; make limits of some, or vary more"
        ),
        "{text}"
    );
    // A parameter that its bounds hold is no variable.
    let held = from(Rocker::default(), [50.0, 50.0])
        .want(Lowest(margin()).greatest())
        .want(Stroke(tip()).equal(90.0))
        .run();
    let text = held.expect_err("nothing varies").to_string();
    assert!(
        text.contains("1 equations must hold, and what varies is 0"),
        "{text}"
    );
}
