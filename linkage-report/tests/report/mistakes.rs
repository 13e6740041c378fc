//! What does not fit together.

use crate::fixture::{FourBar, PHI, quick_return};
use crate::four_bar;
use linkage_report::{BandKind, Mistake, Plot, Report, ReportError};
use linkage_runtime::{Dimensions, Parameter};

fn mistakes(error: ReportError) -> Vec<Mistake> {
    match error {
        ReportError::Mistakes(mistakes) => mistakes,
        other => panic!("{other:?}"),
    }
}

/// A mechanism with fewer dimensions than the four-bar's sensitivities tell.
struct Other;

impl Dimensions<1> for Other {
    const PARAMETERS: &'static [Parameter] = &[Parameter {
        name: "length",
        unit: "mm",
        nominal: 1.0,
        tolerance: 0.1,
    }];

    fn from_values(_: &[f64; 1]) -> Self {
        Self
    }

    fn values(&self) -> [f64; 1] {
        [1.0]
    }
}

#[test]
fn all_mistakes_are_told_at_once() {
    let phi = PHI.positions(37);
    let few = PHI.positions(19);
    let report = Report::new("wrong", &PHI, &phi)
        .dimensions(&Other)
        .table(&FourBar::NOMINAL.motion(&few))
        .table(&FourBar::NOMINAL.picture(&phi))
        .table(&quick_return(&phi))
        .table(&FourBar::NOMINAL.accuracy(&phi))
        .trace("nobody");
    let error = report.json().unwrap_err();
    assert_eq!(
        error.to_string(),
        "table `motion` has 19 rows, the report 37 positions; sweep the positions that the report was made with\n\
         table `pictured` was added twice; add it once, or write a report for each of the mechanisms\n\
         several tables have a picture: `pictured`, `pictured`; keep one of them\n\
         no point `nobody`; there is `pivot_a`, `pivot_d`, `a`, `b`, `tracer`\n\
         column `e[coupler].x` is a sensitivity to parameter 1, beyond the 1 of the dimensions; give `dimensions` the mechanism that was swept\n\
         column `e[coupler].y` is a sensitivity to parameter 1, beyond the 1 of the dimensions; give `dimensions` the mechanism that was swept\n\
         column `alone[coupler].x` is a sensitivity to parameter 1, beyond the 1 of the dimensions; give `dimensions` the mechanism that was swept"
    );
    let all = mistakes(error);
    for error in [
        report.html(),
        report.csv("motion"),
        report.write("nowhere").map(|_| String::new()),
    ] {
        assert_eq!(mistakes(error.unwrap_err()), all);
    }
    assert_eq!(mistakes(report.drawing().unwrap_err()), all);
    assert_eq!(mistakes(report.plot(["v.x"]).unwrap_err()), all);
    assert!(!std::path::Path::new("nowhere").exists());
}

#[test]
fn names_that_are_not_there_are_answered_with_those_that_are() {
    let phi = PHI.positions(37);
    let report = Report::new("small", &PHI, &phi)
        .table(&FourBar::NOMINAL.motion(&phi))
        .speed(2.0, 0.0);
    let error = report.plot(["v.x", "speed", "w"]).unwrap_err().to_string();
    let known = "there is `tracer.x`, `tracer.y`, `v.x`, `v.y`, `a.x`, `a.y`, `psi`, `v.x [mm/s]`, `v.y [mm/s]`, \
                 `a.x [mm/s^2]`, `a.y [mm/s^2]`";
    assert_eq!(
        error,
        format!("no column `speed`; {known}\nno column `w`; {known}")
    );
    assert_eq!(
        report.csv("path").unwrap_err().to_string(),
        "no table `path`; there is `motion`"
    );
    assert_eq!(
        report.drawing().unwrap_err().to_string(),
        "a drawing needs a picture, and no table has one (`motion`); add the sweep of a function with `picture()`"
    );
    assert_eq!(
        report.trace("p").json().unwrap_err().to_string(),
        "the path of `p` needs a picture, and no table has one (`motion`); add the sweep of a function with `picture()`"
    );
}

#[test]
fn an_accelerating_input_needs_first_derivatives() {
    use crate::fixture::{Sweep, column};
    use linkage_runtime::{Heading, Meaning};
    const ALONE: Heading = Heading {
        function: "alone",
        arguments: &["phi"],
        columns: &[column(
            "a",
            "mm/rad^2",
            Meaning::Rate { order: 2, of: None },
        )],
        picture: None,
    };
    let sweep = Sweep::new(&ALONE, &[0.0, 1.0], |phi| vec![phi]);
    let report = || Report::new("alone", &PHI, &[0.0, 1.0]).table(&sweep);
    assert_eq!(
        report().speed(2.0, 0.5).json().unwrap_err().to_string(),
        "the true acceleration of `a` needs the first derivative of the same quantity, since the input accelerates; \
         add it to the function, or give `speed` the acceleration 0"
    );
    let steady = report().speed(2.0, 0.0).csv("alone").unwrap();
    assert_eq!(
        steady,
        "phi [rad],a [mm/rad^2],a [mm/s^2]\r\n0,0,0\r\n1,1,4\r\n"
    );
}

#[test]
fn a_report_needs_a_range() {
    let error = Report::new("nothing", &PHI, &[1.0]).json().unwrap_err();
    assert_eq!(
        error.to_string(),
        "a report needs two positions or more, and has 1; `Input::positions` gives evenly spaced ones"
    );
}

#[test]
fn plots_tell_what_does_not_fit() {
    let x = [0.0, 1.0, 2.0];
    assert_eq!(
        Plot::new("s", "mm", &x).svg().unwrap_err().to_string(),
        "the plot has no curve; add one with `curve`"
    );
    let plot = Plot::new("s", "mm", &x)
        .curve("a", "N", &[1.0])
        .band("b", BandKind::WorstCase, &x);
    assert_eq!(
        plot.svg().unwrap_err().to_string(),
        "`a` has 1 values, the abscissa 3; give one for each\nno curve `b`; there is `a`"
    );
}

#[test]
fn drawings_tell_what_does_not_fit() {
    let report = four_bar(FourBar::NOMINAL);
    let drawing = report.drawing().unwrap().scale(0.0).trace("z");
    assert_eq!(
        drawing.svg().unwrap_err().to_string(),
        "0 is no scale; give a positive number, 1 for the true size\n\
         no point `z`; there is `pivot_a`, `pivot_d`, `a`, `b`, `tracer`"
    );
    let phi = PHI.positions(37);
    let never = FourBar {
        coupler: 500.0,
        ..FourBar::NOMINAL
    };
    let report = Report::new("never", &PHI, &phi).table(&never.picture(&phi));
    assert_eq!(
        report.drawing().unwrap().svg().unwrap_err().to_string(),
        "the mechanism cannot be drawn, since it cannot be assembled at any position; check its dimensions"
    );
}

#[test]
fn pictures_have_known_endings() {
    let x = [0.0, 1.0];
    let plot = Plot::new("s", "mm", &x).curve("a", "N", &x);
    let error = plot.write("plot.jpeg").unwrap_err();
    assert!(
        matches!(&error, ReportError::Ending { path } if path.as_os_str() == "plot.jpeg"),
        "{error}"
    );
    assert!(
        error
            .to_string()
            .starts_with("cannot write plot.jpeg: pictures are written as .svg"),
        "{error}"
    );
}

#[test]
fn arguments_are_those_of_functions_and_numbers() {
    let report = four_bar(FourBar::NOMINAL).argument("omega", f64::NAN);
    assert_eq!(
        report.json().unwrap_err().to_string(),
        "no argument `omega`; there is nothing\nthe argument `omega` is NaN; give a finite number"
    );
}

#[test]
fn positions_and_speeds_are_numbers_that_differ() {
    let still = Report::new("still", &PHI, &[1.0, 1.0, 1.0]);
    let told = "`phi` is 1 at all positions; give the input a range, or the report other positions";
    assert_eq!(still.json().unwrap_err().to_string(), told);
    let lost = Report::new("lost", &PHI, &[0.0, f64::NAN]).speed(f64::INFINITY, 0.0);
    assert_eq!(
        lost.json().unwrap_err().to_string(),
        "position 1 of `phi` is NaN; give a finite number\nthe speed of `phi` is inf; give a finite number"
    );
    let empty = Plot::new("s", "mm", &[]).curve("y", "mm", &[]);
    let told = "the plot is over no value of `s`; give some";
    assert_eq!(empty.svg().unwrap_err().to_string(), told);
}

#[test]
fn what_is_not_drawn_has_no_path() {
    let phi = PHI.positions(37);
    let report = Report::new("shaper", &PHI, &phi)
        .table(&quick_return(&phi))
        .trace("way");
    let error = report.json().unwrap_err().to_string();
    assert!(
        error.starts_with("no point `way`; there is ") && !error.contains(", `way`"),
        "{error}"
    );
}

#[test]
fn positions_go_one_way() {
    let phi = PHI.positions(37);
    let on = |positions: &[f64]| {
        let report = Report::new("way", &PHI, positions).table(&FourBar::NOMINAL.motion(positions));
        report.json().map_err(|error| error.to_string())
    };
    let falling: Vec<f64> = phi.iter().rev().copied().collect();
    assert!(on(&phi).is_ok() && on(&falling).is_ok());
    assert_eq!(
        on(&[0.0, 0.5, 1.0, 0.75, 0.5]).unwrap_err(),
        "position 3 of `phi` is 0.75 after 1, on the way back, while the first ones rise; \
         give positions that only rise or only fall, and write a report for each such stretch"
    );
    assert_eq!(
        on(&[2.0, 1.5, 1.5, 1.0]).unwrap_err(),
        "position 2 of `phi` is 1.5 after 1.5, which is the same; give each position once"
    );
    assert_eq!(
        on(&[1.0, 1.0, 2.0]).unwrap_err(),
        "position 1 of `phi` is 1 after 1, which is the same; give each position once"
    );
    assert_eq!(
        on(&[0.0, f64::NAN, 1.0]).unwrap_err(),
        "position 1 of `phi` is NaN; give a finite number"
    );
}

#[test]
fn abscissas_are_finite() {
    let plot = Plot::new("s", "mm", &[0.0, f64::INFINITY]).curve("a", "N", &[1.0, 2.0]);
    assert_eq!(
        plot.svg().unwrap_err().to_string(),
        "value 1 of the abscissa `s` is inf; give a finite number"
    );
}

#[test]
fn control_characters_are_told() {
    let phi = PHI.positions(37);
    let report =
        |title: &str| Report::new(title, &PHI, &phi).table(&FourBar::NOMINAL.picture(&phi));
    let wrong = report("Press\u{c}2")
        .about("a\0b")
        .note("fine\tand\nwell")
        .note("\u{85}")
        .fact("Grashof", "\u{ffff}");
    assert_eq!(
        wrong.json().unwrap_err().to_string(),
        "the title has the control character U+000C after \"Press\", which pictures and pages cannot show; leave it out\n\
         the text below the title has the control character U+0000 after \"a\", which pictures and pages cannot show; leave it out\n\
         note 1 has the control character U+0085 after \"\", which pictures and pages cannot show; leave it out\n\
         fact 0 has the control character U+FFFF after \"\", which pictures and pages cannot show; leave it out"
    );
    let x = [0.0, 1.0];
    let plot = Plot::new("s", "mm", &x)
        .title("\u{1b}[1m")
        .curve("a\u{7}", "N", &x);
    assert_eq!(
        plot.svg().unwrap_err().to_string(),
        "the title has the control character U+001B after \"\", which pictures and pages cannot show; leave it out\n\
         the name of a quantity has the control character U+0007 after \"a\", which pictures and pages cannot show; leave it out"
    );
    // Line ends and tabs are spaces, and letters of any script are letters.
    let right = report("Presse\n\t\u{c4}\u{3b1}\u{4e2d} \u{1f527}");
    let svg = right.drawing().unwrap().svg().unwrap();
    let svg = roxmltree::Document::parse(&svg).unwrap();
    let title = svg.descendants().find(|node| node.has_tag_name("title"));
    assert_eq!(
        title.unwrap().text(),
        Some("Presse\n\t\u{c4}\u{3b1}\u{4e2d} \u{1f527}")
    );
}
