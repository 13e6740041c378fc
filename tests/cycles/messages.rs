//! What is wrong is told with numbers.

use super::{N, Rocker, RockerAssembly, design, margin, speed, tip};
use linkage::design::{CycleDesign, DesignError, Dwell, Figure, Lowest, Peak, Stroke};

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
