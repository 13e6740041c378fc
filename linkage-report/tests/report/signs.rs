//! Signs of joints, cylinders, arrows, and what can be asked for beside the mechanism.

use crate::fixture::{FourBar, PHI, quick_return, spatial};
use crate::four_bar;
use crate::picture::{classed, corners, number, words};
use linkage_report::{Drawing, Report};
use linkage_runtime::Table;
use roxmltree::{Document, Node};

fn drawn(drawing: &Drawing<'_>) -> String {
    drawing.svg().expect("a drawing")
}

/// The drawing at 1 rad, at half its size.
fn half_size(report: &Report) -> Drawing<'_> {
    let drawing = report.drawing().expect("a picture");
    drawing.scale(0.5).position(1.0)
}

fn point(svg: &Document<'_>, name: &str) -> [f64; 2] {
    let points = classed(svg, "point").into_iter();
    let mut named = points.filter(|node| node.attribute("data-point") == Some(name));
    let point = named.next().expect("the point");
    [number(point, "cx"), number(point, "cy")]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn ends(line: Node<'_, '_>) -> [[f64; 2]; 2] {
    [["x1", "y1"], ["x2", "y2"]].map(|end| end.map(|name| number(line, name)))
}

#[test]
fn a_cylinder_is_a_barrel_with_a_rod() {
    let phi = PHI.positions(73);
    let report = Report::new("Shaper", &PHI, &phi).table(&quick_return(&phi));
    let mut lengths = Vec::new();
    for at in [0.2, 1.5, 3.0, 4.5] {
        let svg = drawn(&report.drawing().expect("a picture").scale(0.2).position(at));
        let svg = Document::parse(&svg).expect("SVG");
        let [barrel] = classed(&svg, "barrel")[..] else {
            panic!()
        };
        let [a, mouth, _, d] = corners(barrel)[..] else {
            panic!()
        };
        let (foot, eye) = (point(&svg, "rest"), point(&svg, "pin"));
        let middle = [0, 1].map(|k| 0.5 * (a[k] + d[k]));
        assert!(distance(middle, foot) < 1e-3, "{middle:?} {foot:?}");
        // The rod reaches the pin, out of the barrel.
        for rod in classed(&svg, "rod") {
            let [from, to] = ends(rod);
            assert!(distance(from, foot) < 1e-3 && distance(to, eye) < 1e-3);
        }
        let length = distance(a, mouth);
        assert!(length < distance(foot, eye));
        lengths.push(length);
    }
    assert!(
        lengths
            .iter()
            .all(|length| (length - lengths[0]).abs() < 1e-3)
    );
}

#[test]
fn joints_in_space_differ() {
    let phi = PHI.positions(73);
    let report = Report::new("RSSR", &PHI, &phi).table(&spatial(&phi));
    let svg = drawn(&report.drawing().expect("a picture"));
    let svg = Document::parse(&svg).expect("SVG");
    let counts = ["hinge", "ball", "universal"].map(|sign| classed(&svg, sign).len());
    assert_eq!(counts, [2, 1, 1]);
    let [ball] = classed(&svg, "ball")[..] else {
        panic!()
    };
    assert_eq!(ball.attribute("data-name"), Some("p"));
    // In the plane all of them are pins.
    let report = four_bar(FourBar::NOMINAL);
    let plane = drawn(&report.drawing().expect("a picture"));
    assert!(classed(&Document::parse(&plane).expect("SVG"), "joint").is_empty());
}

#[test]
fn space_has_a_sign_of_its_axes_and_no_scale() {
    let phi = PHI.positions(73);
    let report = Report::new("RSSR", &PHI, &phi).table(&spatial(&phi));
    let drawing = report.drawing().expect("a picture");
    // From the front: x to the right, z up, y at the reader's back.
    let svg = drawn(&drawing.view(-std::f64::consts::FRAC_PI_2, 0.0));
    let svg = Document::parse(&svg).expect("SVG");
    assert_eq!(words(&svg, "caption"), ["phi = 30 deg"]);
    let [axes] = classed(&svg, "axes")[..] else {
        panic!()
    };
    let lines = axes.children().filter(|node| node.has_tag_name("line"));
    let steps = lines.map(|line| {
        let [from, to] = ends(line);
        [to[0] - from[0], to[1] - from[1]]
    });
    let steps: Vec<_> = steps.collect();
    assert!(steps[0][0] > 1.0 && steps[0][1].abs() < 1e-3);
    assert!(distance(steps[1], [0.0; 2]) < 1e-3);
    assert!(steps[2][0].abs() < 1e-3 && steps[2][1] < -1.0);
}

#[test]
fn an_arrow_shows_the_way_of_the_input() {
    let report = four_bar(FourBar::NOMINAL);
    let svg = drawn(&report.drawing().expect("a picture"));
    let svg = Document::parse(&svg).expect("SVG");
    let [drive] = classed(&svg, "drive")[..] else {
        panic!()
    };
    let mut lines = drive
        .children()
        .filter(|node| node.has_tag_name("polyline"));
    let arc = corners(lines.next().expect("an arc"));
    let centre = point(&svg, "pivot_a");
    let angles: Vec<f64> = arc
        .iter()
        .map(|at| (centre[1] - at[1]).atan2(at[0] - centre[0]))
        .collect();
    assert!(
        arc.iter()
            .all(|at| (distance(*at, centre) - distance(arc[0], centre)).abs() < 1e-3)
    );
    assert!(
        angles.windows(2).all(|pair| pair[1] > pair[0]),
        "to the left: {angles:?}"
    );
    // A crank that turns the other way as its input grows.
    let phi: Vec<f64> = PHI.positions(73).iter().map(|phi| -phi).collect();
    let report =
        Report::new("Back", &PHI, &PHI.positions(73)).table(&FourBar::NOMINAL.picture(&phi));
    let svg = drawn(&report.drawing().expect("a picture"));
    let svg = Document::parse(&svg).expect("SVG");
    let mut lines = classed(&svg, "drive")[0]
        .children()
        .filter(|node| node.has_tag_name("polyline"));
    let arc = corners(lines.next().expect("an arc"));
    let centre = point(&svg, "pivot_a");
    let [a, b] = [arc[0], arc[3]].map(|at| (centre[1] - at[1]).atan2(at[0] - centre[0]));
    assert!(b < a);
}

#[test]
fn vectors_are_as_long_as_is_said() {
    let report = four_bar(FourBar::NOMINAL);
    let drawing = half_size(&report);
    let svg = drawn(&drawing.vector("tracer", "v", 0.8));
    let svg = Document::parse(&svg).expect("SVG");
    let [vector] = classed(&svg, "vector")[..] else {
        panic!()
    };
    let mut lines = vector.children().filter(|node| node.has_tag_name("line"));
    let [from, to] = ends(lines.next().expect("a line"));
    let phi = 1f64.to_degrees().round().to_radians();
    let motion = FourBar::NOMINAL.motion(&[phi]);
    let [vx, vy] = [2, 3].map(|column| motion.column(column)[0]);
    assert!(distance(from, point(&svg, "tracer")) < 1e-3);
    assert!(((to[0] - from[0]) - 0.5 * 0.8 * vx).abs() < 1e-3);
    assert!(((from[1] - to[1]) - 0.5 * 0.8 * vy).abs() < 1e-3);
    let said = vector
        .descendants()
        .find_map(|node| node.text().filter(|text| text.contains("v =")));
    assert!(said.expect("words").ends_with("mm/rad"));

    let wrong = report
        .drawing()
        .expect("a picture")
        .vector("traces", "w", 1.0);
    let error = wrong.svg().expect_err("neither is there").to_string();
    assert!(
        error.contains("no point `traces`; there is `pivot_a`"),
        "{error}"
    );
    assert!(
        error.contains("no vector `w`; there is `tracer`, `v`, `a`"),
        "{error}"
    );
}

#[test]
fn paths_have_points_at_equal_steps() {
    let report = four_bar(FourBar::NOMINAL);
    let svg = drawn(&report.drawing().expect("a picture").scale(0.5).ticks(12));
    let svg = Document::parse(&svg).expect("SVG");
    let ticks = classed(&svg, "tick");
    assert_eq!(ticks.len(), 12);
    let places: Vec<[f64; 2]> = ticks
        .iter()
        .map(|own| [number(*own, "cx"), number(*own, "cy")])
        .collect();
    let pivot = point(&svg, "pivot_a");
    for (step, place) in places.iter().enumerate() {
        let [x, y] = FourBar::NOMINAL.points(step as f64 * std::f64::consts::TAU / 12.0)[4];
        let expected = [pivot[0] + 0.5 * x, pivot[1] - 0.5 * y];
        assert!(distance(*place, expected) < 1e-3, "{place:?} {expected:?}");
    }
}

#[test]
fn bars_have_dimension_lines_if_wanted() {
    let report = four_bar(FourBar::NOMINAL);
    let svg = drawn(&report.drawing().expect("a picture").dimensions(true));
    let svg = Document::parse(&svg).expect("SVG");
    let all = classed(&svg, "dimension").into_iter();
    let said: Vec<&str> = all
        .filter_map(|own| {
            own.descendants()
                .find_map(|node| node.text().filter(|text| text.contains('=')))
        })
        .collect();
    // The coupler is a plate.
    assert_eq!(said, ["crank = 50 mm", "rocker = 100 mm"]);
    let plain = drawn(&report.drawing().expect("a picture"));
    assert!(classed(&Document::parse(&plain).expect("SVG"), "dimension").is_empty());
}

#[test]
fn ellipses_are_what_tolerances_do() {
    let report = four_bar(FourBar::NOMINAL);
    let drawing = half_size(&report);
    let svg = drawn(&drawing.tolerances(200.0));
    let svg = Document::parse(&svg).expect("SVG");
    let [ellipse] = classed(&svg, "tolerance")[..] else {
        panic!()
    };
    let caption = words(&svg, "caption");
    assert!(
        caption[0].contains("tolerances enlarged 200 times"),
        "{caption:?}"
    );
    let phi = 1f64.to_degrees().round().to_radians();
    let accuracy = FourBar::NOMINAL.accuracy(&[phi]);
    let effect = |first: usize, tolerance: f64| {
        [0, 1].map(|k| accuracy.column(first + k)[0] * tolerance * 200.0 * 0.5)
    };
    let [crank, coupler] = [effect(2, 0.012), effect(4, 0.02)];
    // Area and sum of squares of the half axes, by the two errors.
    let area = (crank[0] * coupler[1] - crank[1] * coupler[0]).abs();
    let squares: f64 = [crank, coupler].concat().iter().map(|x| x * x).sum();
    let [long, short] = ["rx", "ry"].map(|name| number(ellipse, name));
    assert!(
        (long * short - area).abs() < 1e-3 * area,
        "{long} {short} {area}"
    );
    assert!((long * long + short * short - squares).abs() < 1e-3 * squares);

    let untold = report.drawing().expect("a picture");
    let phi = PHI.positions(19);
    let without = Report::new("Bare", &PHI, &phi).table(&FourBar::NOMINAL.picture(&phi));
    assert!(classed(&Document::parse(&drawn(&untold)).expect("SVG"), "tolerance").is_empty());
    let error = without
        .drawing()
        .expect("a picture")
        .tolerances(100.0)
        .svg();
    let error = error.expect_err("no sensitivities").to_string();
    assert!(error.contains("`tracer`"), "{error}");
}
