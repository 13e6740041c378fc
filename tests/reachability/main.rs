//! A position is NaN where the mechanism cannot close, and only there: cases that an interval
//! solver judged.
//!
//! `judged.csv` has random four-bars and slider-cranks, half of the positions next to a limit of
//! the crank, each with a proof by codac that it closes or that it cannot. The script
//! `benches/other_tools/judge_cases.py` writes it.

use linkage::mechanism;

mechanism! {
    /// One RRR dyad.
    pub struct FourBar {
        unit mm;
        param crank = 50mm;
        param coupler = 120mm;
        param rocker = 100mm;
        param base = 140mm;
        input phi = 60deg;
        unknown theta = 20deg;
        unknown psi = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) = (base, 0) + polar(rocker, psi);
    }
    impl FourBar {
        pub fn angles(phi) -> FourBarAngles { theta, psi }
    }
}

mechanism! {
    /// One RRP dyad.
    pub struct SliderCrank {
        unit mm;
        param crank = 50mm;
        param rod = 120mm;
        param offset = 10mm;
        input phi = 60deg;
        unknown theta = -20deg;
        unknown slide = 140mm;
        loop polar(crank, phi) + polar(rod, theta) = (slide, offset);
    }
    impl SliderCrank {
        pub fn angles(phi) -> SliderCrankAngles { theta, slide }
    }
}

/// Roundings of one number of a case, in units of the last place, that may decide it at a limit.
const ROUNDINGS: f64 = 8.0;

struct Case {
    line: String,
    values: Vec<f64>,
    closes: bool,
}

/// Returns whether all numbers are there, whether none is, or fails: one alone must not be NaN.
fn verdict(numbers: [f64; 2], line: &str) -> bool {
    let missing = numbers.map(f64::is_nan);
    assert_eq!(missing[0], missing[1], "{line}: {numbers:?}");
    !missing[0]
}

fn four_bar(values: &[f64], line: &str) -> bool {
    let &[crank, coupler, rocker, base, phi] = values else {
        panic!("{line}: four dimensions and an angle");
    };
    let linkage = FourBar {
        crank,
        coupler,
        rocker,
        base,
    };
    let linkage = linkage
        .assemble()
        .unwrap_or_else(|error| panic!("{line}: {error}"));
    let found = linkage.angles(phi);
    verdict([found.theta, found.psi], line)
}

fn slider_crank(values: &[f64], line: &str) -> bool {
    let &[crank, rod, offset, phi] = values else {
        panic!("{line}: three dimensions and an angle");
    };
    let linkage = SliderCrank { crank, rod, offset };
    let linkage = linkage
        .assemble()
        .unwrap_or_else(|error| panic!("{line}: {error}"));
    let found = linkage.angles(phi);
    verdict([found.theta, found.slide], line)
}

fn has_numbers(case: &Case, values: &[f64]) -> bool {
    if case.line.starts_with("FourBar") {
        four_bar(values, &case.line)
    } else {
        slider_crank(values, &case.line)
    }
}

fn cases() -> Vec<Case> {
    let lines = include_str!("judged.csv").lines().skip(1);
    lines
        .map(|line| {
            let mut cells: Vec<&str> = line.split(',').collect();
            let closes = match cells.pop() {
                Some("closes") => true,
                Some("cannot close") => false,
                other => panic!("{line}: {other:?}"),
            };
            let numbers = cells[1..].iter().filter(|cell| !cell.is_empty());
            let values = numbers
                .map(|cell| cell.parse().expect("a number"))
                .collect();
            Case {
                line: line.to_string(),
                values,
                closes,
            }
        })
        .collect()
}

/// Returns whether a change of one number by a few roundings turns the verdict: the case is at the
/// limit itself.
fn is_within_roundings(case: &Case) -> bool {
    (0..case.values.len()).any(|index| {
        [-1.0, 1.0].into_iter().any(|sign| {
            let mut values = case.values.clone();
            values[index] *= 1.0 + sign * ROUNDINGS * f64::EPSILON;
            has_numbers(case, &values) == case.closes
        })
    })
}

#[test]
fn numbers_are_missing_where_nothing_closes() {
    let cases = cases();
    let differing: Vec<&Case> = cases
        .iter()
        .filter(|case| has_numbers(case, &case.values) != case.closes)
        .collect();
    for case in &differing {
        assert!(is_within_roundings(case), "{}", case.line);
    }
    let open = cases.iter().filter(|case| !case.closes).count();
    println!(
        "{} cases, {open} cannot close, {} differ within roundings",
        cases.len(),
        differing.len()
    );
    assert!(
        cases.len() >= 1000 && open * 4 > cases.len(),
        "{} cases, {open} open",
        cases.len()
    );
    assert!(
        differing.len() * 100 < cases.len(),
        "{} differ",
        differing.len()
    );
}
