//! Plots as SVG.

use crate::fixture::FourBar;
use crate::four_bar;
use crate::picture::{classed, corners, lines, number, words};
use linkage_report::{BandKind, Plot};
use roxmltree::Document;

fn plotted(columns: &[&str]) -> String {
    let report = four_bar(FourBar::NOMINAL).speed(20.0, 0.0);
    report.plot(columns.iter().copied()).unwrap().svg().unwrap()
}

#[test]
fn curves_of_one_unit_share_a_panel_with_legend_and_title() {
    let svg = plotted(&["motion.tracer.x", "psi", "motion.tracer.y", "v.x [mm/s]"]);
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(classed(&svg, "panel").len(), 3);
    assert_eq!(lines(&svg, "curve").len(), 4);
    assert_eq!(
        words(&svg, "axis"),
        [
            "tracer.x, tracer.y [mm]",
            "psi [deg]",
            "v.x [mm/s]",
            "phi [deg]"
        ]
    );
    assert_eq!(words(&svg, "legend"), ["tracer.x", "tracer.y"]);
    assert!(words(&svg, "note").is_empty() && classed(&svg, "gap").is_empty());
}

#[test]
fn ticks_stand_where_their_numbers_are() {
    let svg = plotted(&["tracer.x"]);
    let svg = Document::parse(&svg).unwrap();
    let labels = words(&svg, "tick");
    let turn = ["0", "45", "90", "135", "180", "225", "270", "315", "360"];
    assert_eq!(labels[..9], turn);
    // The curve runs through the ticks' places: its first point is at phi = 0, its last one at 360.
    let line = corners(lines(&svg, "curve")[0]);
    assert_eq!(line.len(), 361);
    let ticks = classed(&svg, "tick");
    assert!((number(ticks[0], "x") - line[0][0]).abs() < 1e-3);
    assert!((number(ticks[8], "x") - line[360][0]).abs() < 1e-3);
    assert!((number(ticks[2], "x") - line[90][0]).abs() < 1e-3);
    // Upwards, the numbers at the axis tell the curve's values.
    let place = |label: &str| {
        let tick = ticks.iter().skip(9).find(|tick| tick.text() == Some(label));
        number(*tick.unwrap(), "y") - 4.0
    };
    let (zero, forty) = (place("0"), place("40"));
    let value = |row: usize| 40.0 * (line[row][1] - zero) / (forty - zero);
    for row in [0, 77, 200] {
        let expected = FourBar::NOMINAL.points((row as f64).to_radians())[4][0];
        assert!(
            (value(row) - expected).abs() < 1e-3,
            "{} {expected}",
            value(row)
        );
    }
}

#[test]
fn curves_break_at_gaps_which_are_named() {
    let report = four_bar(FourBar::GAPPED);
    let svg = report
        .plot(["tracer.x", "tracer.y"])
        .unwrap()
        .svg()
        .unwrap();
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(lines(&svg, "curve").len(), 4, "two pieces each");
    assert_eq!(classed(&svg, "gap").len(), 1);
    assert_eq!(
        words(&svg, "note"),
        [
            "Gaps at phi = 133 to 227 deg: the mechanism cannot be assembled there, or a value is infinite."
        ]
    );
}

#[test]
fn a_single_point_between_gaps_is_a_dot() {
    let x = [0.0, 1.0, 2.0, 3.0, 4.0];
    let y = [1.0, f64::NAN, 2.0, f64::INFINITY, 3.0];
    let svg = Plot::new("s", "mm", &x).curve("y", "N", &y).svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    assert!(lines(&svg, "curve").is_empty());
    let dots = svg.descendants().filter(|node| node.has_tag_name("circle"));
    assert_eq!(dots.count(), 3);
    assert_eq!(classed(&svg, "gap").len(), 2);
}

#[test]
fn curves_of_one_name_are_told_apart_by_their_function() {
    let svg = plotted(&["motion.tracer.x", "tracer.x", "v.x", "v.x [mm/s]"]);
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(
        words(&svg, "legend"),
        [
            "tracer.x",
            "accuracy.tracer.x",
            "accuracy.tracer.x \u{b1} worst case",
            "accuracy.tracer.x \u{b1} statistical"
        ]
    );
    assert_eq!(words(&svg, "axis")[1..3], ["v.x [mm/rad]", "v.x [mm/s]"]);
}

#[test]
fn bands_are_filled_about_their_curve() {
    let svg = plotted(&["accuracy.tracer.x"]);
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(classed(&svg, "band").len(), 2);
    assert_eq!(
        words(&svg, "legend"),
        [
            "tracer.x",
            "tracer.x \u{b1} worst case",
            "tracer.x \u{b1} statistical"
        ]
    );
    let (x, y, half) = ([0.0, 1.0], [10.0, 20.0], [5.0, 5.0]);
    let plot = Plot::new("s", "mm", &x)
        .curve("y", "N", &y)
        .band("y", BandKind::WorstCase, &half);
    let svg = plot.svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let (band, line) = (
        corners(classed(&svg, "band")[0]),
        corners(lines(&svg, "curve")[0]),
    );
    assert_eq!(band.len(), 4);
    let unit = (line[0][1] - line[1][1]) / 10.0;
    assert!(
        (line[0][1] - band[0][1] - 5.0 * unit).abs() < 1e-3,
        "5 above at the start"
    );
    assert!(
        (band[3][1] - line[0][1] - 5.0 * unit).abs() < 1e-3,
        "5 below"
    );
}

#[test]
fn bands_break_where_they_are_not_finite() {
    let (x, y) = ([0.0, 1.0, 2.0, 3.0, 4.0], [1.0; 5]);
    let half = [0.1, 0.1, f64::NAN, 0.1, 0.1];
    let plot = Plot::new("s", "mm", &x)
        .curve("y", "N", &y)
        .band("y", BandKind::Statistical, &half);
    let svg = plot.svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(classed(&svg, "band").len(), 2);
    assert_eq!(lines(&svg, "curve").len(), 1);
}

#[test]
fn curves_differ_in_line_and_colour() {
    let x = [0.0, 1.0];
    let names: Vec<String> = (0..12).map(|i| format!("q{i}")).collect();
    let plot = names
        .iter()
        .enumerate()
        .fold(Plot::new("s", "mm", &x), |plot, (i, name)| {
            plot.curve(name, "N", &[0.0, i as f64])
        });
    let svg = plot.svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let mut styles: Vec<_> = lines(&svg, "curve")
        .iter()
        .map(|line| {
            (
                line.attribute("stroke").unwrap(),
                line.attribute("stroke-dasharray"),
            )
        })
        .collect();
    styles.sort();
    styles.dedup();
    assert_eq!(styles.len(), 12);
}

#[test]
fn sections_keep_curves_of_a_unit_apart() {
    let x = [0.0, 1.0];
    let plot = Plot::new("s", "mm", &x)
        .curve("a", "N", &x)
        .panel()
        .curve("b", "N", &x);
    let svg = plot.svg().unwrap();
    assert_eq!(classed(&Document::parse(&svg).unwrap(), "panel").len(), 2);
}

#[test]
fn strange_numbers_and_words_make_a_picture_too() {
    let x = [0.0, 1.0, 2.0];
    for y in [
        [0.0; 3],
        [5.0; 3],
        [-1e308, 0.0, 1e308],
        [1e-310, 0.0, 2e-310],
        [f64::NAN; 3],
        [1.0, 1.0 + 1e-15, 1.0],
    ] {
        let plot = Plot::new("<s>", "\"&", &x)
            .title("a < b")
            .curve("'q' & \"r\"", "N^2*m", &y);
        let svg = plot.svg().unwrap();
        let wrong = ["NaN", "\"inf", "\"-inf", ",inf", ",-inf"];
        assert!(!wrong.iter().any(|word| svg.contains(word)), "{y:?}");
        let svg = Document::parse(&svg).unwrap();
        let titles = words(&svg, "axis");
        assert!(titles[0].starts_with("'q' & \"r\" ["), "{titles:?}");
        assert!(titles[0].ends_with("N\u{b2}\u{b7}m]"), "{titles:?}");
        assert_eq!(titles[1], "<s> [\"&]");
    }
}

#[test]
fn bands_are_in_the_unit_that_the_curve_was_given_in() {
    let x = [0.0, 1.0, 2.0];
    let high = |unit: &str, values: [f64; 3], half: [f64; 3]| {
        let plot = Plot::new("x", "mm", &x).curve("y", unit, &values);
        let svg = plot.band("y", BandKind::WorstCase, &half).svg().unwrap();
        let svg = Document::parse(&svg).unwrap();
        let band = corners(classed(&svg, "band")[0]);
        let line = corners(lines(&svg, "curve")[0]);
        let places = band.iter().map(|at| at[1]);
        let [low, high] = places.fold([f64::MAX, f64::MIN], |[a, b], y| [a.min(y), b.max(y)]);
        (high - low) / (line[0][1] - line[2][1]).abs()
    };
    let degrees = high("deg", [0.0, 10.0, 20.0], [1.0; 3]);
    let radians = high(
        "rad",
        [0.0, 10f64.to_radians(), 20f64.to_radians()],
        [1f64.to_radians(); 3],
    );
    assert!(
        (degrees - 1.1).abs() < 1e-2 && (radians - degrees).abs() < 1e-3,
        "{degrees} {radians}"
    );
}

#[test]
fn a_plot_grows_with_its_legend() {
    let x = [0.0, 1.0];
    let names: Vec<String> = (0..20)
        .map(|k| format!("a curve with a long name {k}"))
        .collect();
    let plot = Plot::new("x", "mm", &x).size(320.0, 80.0);
    let plot = names
        .iter()
        .fold(plot, |plot, name| plot.curve(name, "mm", &[0.0, 1.0]));
    let svg = plot.svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let line = corners(lines(&svg, "curve")[0]);
    assert!(line[1][0] - line[0][0] >= 100.0, "{line:?}");
    let size = svg.root_element().attribute("viewBox").unwrap();
    let height: f64 = size.split(' ').nth(3).unwrap().parse().unwrap();
    assert!(height > 20.0 * 19.0, "{size}");
}
