//! Drawings as SVG.

use crate::fixture::{FourBar, PHI, curved_slots, quick_return, spatial};
use crate::four_bar;
use crate::picture::{classed, corners, lines, number, words};
use linkage_report::{Report, ReportError};
use roxmltree::{Document, Node};
use std::f64::consts::TAU;

fn point(svg: &Document<'_>, name: &str) -> [f64; 2] {
    let points = classed(svg, "point");
    let point = points
        .iter()
        .find(|node| node.attribute("data-point") == Some(name))
        .unwrap();
    [number(*point, "cx"), number(*point, "cy")]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn millimetres(svg: &Document<'_>, attribute: &str) -> f64 {
    let size = svg.root_element().attribute(attribute).unwrap();
    size.strip_suffix("mm").unwrap().parse().unwrap()
}

fn named<'a>(nodes: &[Node<'a, 'a>], name: &str) -> Node<'a, 'a> {
    *nodes
        .iter()
        .find(|node| node.attribute("data-name") == Some(name))
        .unwrap()
}

#[test]
fn it_is_to_scale_and_upright() {
    let report = four_bar(FourBar::NOMINAL);
    for scale in [1.0, 0.5, 2.0] {
        let svg = report
            .drawing()
            .unwrap()
            .scale(scale)
            .position(1.0)
            .svg()
            .unwrap();
        let svg = Document::parse(&svg).unwrap();
        // The picture's unit is a millimetre on paper.
        let view: Vec<f64> = svg
            .root_element()
            .attribute("viewBox")
            .unwrap()
            .split(' ')
            .map(|x| x.parse().unwrap())
            .collect();
        assert_eq!(
            view[2..],
            [millimetres(&svg, "width"), millimetres(&svg, "height")]
        );
        let on_paper = |a: &str, b: &str| distance(point(&svg, a), point(&svg, b)) / scale;
        assert!((on_paper("pivot_a", "a") - 50.0).abs() < 1e-3);
        assert!((on_paper("a", "b") - 120.0).abs() < 1e-3);
        assert!((on_paper("b", "pivot_d") - 100.0).abs() < 1e-3);
        assert!((on_paper("pivot_a", "pivot_d") - 140.0).abs() < 1e-3);
        // Turned to the left, as seen: y is up.
        let row = (1f64.to_degrees().round()).to_radians();
        let [x, y] = [0, 1].map(|k| point(&svg, "a")[k] - point(&svg, "pivot_a")[k]);
        assert!(
            (x / scale - 50.0 * row.cos()).abs() < 1e-3
                && (-y / scale - 50.0 * row.sin()).abs() < 1e-3
        );
    }
}

#[test]
fn the_scale_bar_is_as_long_as_it_says() {
    let report = four_bar(FourBar::NOMINAL);
    let svg = report.drawing().unwrap().svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let bar = classed(&svg, "scale")[0];
    let line = bar
        .descendants()
        .find(|node| node.has_tag_name("line"))
        .unwrap();
    let length = number(line, "x2") - number(line, "x1");
    let said = bar
        .descendants()
        .find_map(|node| node.text().filter(|text| text.contains("mm")))
        .unwrap();
    assert_eq!(said.trim(), "50 mm");
    let coupler = distance(point(&svg, "a"), point(&svg, "b"));
    assert!((length / coupler - 50.0 / 120.0).abs() < 1e-5);
    assert_eq!(words(&svg, "caption"), ["phi = 29 deg, scale 1:2"]);
}

#[test]
fn links_pivots_paths_and_names_are_drawn() {
    let report = four_bar(FourBar::NOMINAL);
    let svg = report
        .drawing()
        .unwrap()
        .ghosts(6)
        .trace("b")
        .svg()
        .unwrap();
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(classed(&svg, "link").len(), 3);
    let plate = named(&classed(&svg, "link"), "coupler")
        .children()
        .find(|node| node.has_tag_name("polygon"));
    assert_eq!(corners(plate.unwrap()).len(), 3);
    assert_eq!(classed(&svg, "pivot").len(), 2);
    let strokes = classed(&svg, "hatching")
        .into_iter()
        .map(|node| node.children().filter(Node::is_element).count());
    assert!(strokes.clone().count() == 2 && strokes.into_iter().all(|count| count >= 4));
    let names: Vec<_> = classed(&svg, "path")
        .iter()
        .map(|node| node.attribute("data-name").unwrap())
        .collect();
    assert_eq!(names, ["tracer", "b"]);
    assert_eq!(
        words(&svg, "name"),
        ["pivot_a", "pivot_d", "a", "b", "tracer"]
    );
    let ghosts = classed(&svg, "ghosts")[0]
        .children()
        .filter(|node| node.has_tag_name("polygon"));
    assert_eq!(ghosts.count(), 6 * 3);
    // The path goes through the point.
    let path = corners(lines(&svg, "path")[0]);
    assert_eq!(path.len(), 361);
    assert!(
        path.iter()
            .any(|at| distance(*at, point(&svg, "tracer")) < 1e-3)
    );
}

#[test]
fn paths_have_gaps_and_the_drawing_says_so() {
    let report = four_bar(FourBar::GAPPED);
    let svg = report.drawing().unwrap().ghosts(5).svg().unwrap();
    assert!(!svg.contains("NaN"));
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(lines(&svg, "path").len(), 2);
    assert_eq!(
        words(&svg, "note"),
        ["It cannot be assembled at 95 of 361 positions."]
    );
}

#[test]
fn sliders_lie_on_their_guides() {
    let phi = PHI.positions(73);
    let report = Report::new("Shaper", &PHI, &phi).table(&quick_return(&phi));
    let svg = report.drawing().unwrap().scale(0.2).svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let blocks = classed(&svg, "slider");
    assert_eq!(blocks.len(), 2);
    let middle = |node| {
        let corners = corners(node);
        [0, 1].map(|k| corners.iter().map(|corner| corner[k]).sum::<f64>() / 4.0)
    };
    assert!(distance(middle(named(&blocks, "way")), point(&svg, "ram")) < 1e-3);
    let slot = corners(named(&blocks, "slot"));
    let lever = [0, 1].map(|k| point(&svg, "end")[k] - point(&svg, "foot")[k]);
    let side = [0, 1].map(|k| slot[0][k] - slot[3][k]);
    assert!(
        (lever[0] * side[1] - lever[1] * side[0]).abs() < 0.01,
        "along the lever"
    );
    // The guide of the frame is hatched; that of the lever is a body.
    assert_eq!(classed(&svg, "guide").len(), 1);
    let names: Vec<_> = classed(&svg, "link")
        .iter()
        .map(|node| node.attribute("data-name").unwrap())
        .collect();
    assert_eq!(names, ["crank", "lever", "rod", "slot"]);
    // The point that only says where the frame's guide is does not show.
    assert_eq!(classed(&svg, "pivot").len(), 3);
    assert_eq!(
        words(&svg, "name"),
        ["pivot", "foot", "rest", "pin", "end", "ram"]
    );
}

/// Slots have their pins between their ends, and a lever is drawn around its slot.
#[test]
fn curved_slots_are_arcs() {
    let phi = PHI.positions(73);
    let report = Report::new("Slots", &PHI, &phi).table(&curved_slots(&phi));
    let drawing = report.drawing().unwrap().scale(1.0).position(phi[9]);
    let svg = drawing.svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let arcs = classed(&svg, "arc");
    let names: Vec<_> = arcs.iter().map(|arc| arc.attribute("data-name")).collect();
    assert_eq!(names, [Some("way"), Some("ring"), Some("slot")]);
    let lever = 0.3 * phi[9].sin();
    let [of_lever, of_frame] = curved_slots::PINS;
    let spans = [2.0 * of_frame[1], TAU, 2.0 * of_lever[1]];
    let radii = curved_slots::RADII;
    let radii = [radii[1], radii[2], radii[0]];
    for (((arc, pin), span), radius) in arcs
        .iter()
        .zip(["die", "runner", "pin"])
        .zip(spans)
        .zip(radii)
    {
        let mut line = arc.children().filter(|node| node.has_tag_name("polyline"));
        let line = corners(line.next_back().unwrap());
        let length: f64 = line.windows(2).map(|ends| distance(ends[0], ends[1])).sum();
        let near = (length - span * radius).abs() < 1e-3 * length;
        assert!(near, "{pin}: {length} mm on paper");
        let pin = point(&svg, pin);
        let nearest = line.iter().map(|at| distance(*at, pin));
        assert!(nearest.fold(f64::INFINITY, f64::min) < 0.04 * radius);
    }
    // Below the pin's rod, and in front of the plate.
    let bodies = classed(&svg, "link");
    let names: Vec<_> = bodies
        .iter()
        .map(|body| body.attribute("data-name"))
        .collect();
    assert_eq!(names, [Some("lever"), Some("slot"), Some("rod")]);
    // The plate has the slot, and not its centre.
    let plate = corners(bodies[0].first_element_child().unwrap());
    let from_trunnion = point(&svg, "trunnion");
    let beside_lever = plate.iter().map(|corner| {
        let [x, y] = [0, 1].map(|k| corner[k] - from_trunnion[k]);
        -x * lever.sin() - y * lever.cos()
    });
    let farthest = beside_lever.fold(f64::NEG_INFINITY, f64::max);
    assert!(
        (farthest - curved_slots::RADII[0]).abs() < 0.1,
        "{farthest}"
    );
    assert!(plate.len() > 10);
}

#[test]
fn space_is_seen_to_scale_along_any_direction() {
    let phi = PHI.positions(73);
    let report = Report::new("RSSR", &PHI, &phi).table(&spatial(&phi));
    let top = std::f64::consts::FRAC_PI_2;
    let svg = report
        .drawing()
        .unwrap()
        .scale(1.0)
        .view(-top, top)
        .svg()
        .unwrap();
    let svg = Document::parse(&svg).unwrap();
    // From above, with x to the right: the crank's circle.
    assert!((distance(point(&svg, "origin"), point(&svg, "p")) - 30.0).abs() < 1e-3);
    let [x, y] = [0, 1].map(|k| point(&svg, "pivot")[k] - point(&svg, "origin")[k]);
    assert!(
        (x - 60.0).abs() < 1e-3 && (y + 100.0).abs() < 1e-3,
        "{x} {y}"
    );
    // From the front, z is up.
    let svg = report
        .drawing()
        .unwrap()
        .scale(1.0)
        .view(-top, 0.0)
        .svg()
        .unwrap();
    let svg = Document::parse(&svg).unwrap();
    let [x, y] = [0, 1].map(|k| point(&svg, "q")[k] - point(&svg, "origin")[k]);
    assert!((x - 60.0).abs() < 1e-3 && y.abs() > 1.0);
    assert_eq!(classed(&svg, "axis").len(), 2);
}

/// On its page and in its drawings; what is not finite changes nothing.
#[test]
fn a_report_says_from_where_space_is_seen_at_first() {
    let phi = PHI.positions(73);
    let report = || Report::new("RSSR", &PHI, &phi).table(&spatial(&phi));
    let seen = report().view(-1.5, 0.25);
    let svg = |report: &Report| report.drawing().unwrap().svg().unwrap();
    let (plain, from) = (report(), report());
    let from = from.drawing().unwrap().view(-1.5, 0.25).svg().unwrap();
    assert!(svg(&seen) == from && svg(&plain) != from);
    let data = |report: &Report| -> serde_json::Value {
        serde_json::from_str(&report.json().unwrap()).unwrap()
    };
    assert_eq!(
        data(&seen)["picture"]["view"],
        serde_json::json!([-1.5, 0.25])
    );
    for none in [plain, report().view(f64::NAN, 0.25)] {
        assert!(data(&none)["picture"].get("view").is_none());
        assert_ne!(svg(&none), from);
    }
}

#[test]
fn the_reference_position_is_shown_unless_another_one_is_wanted() {
    let drawn = |mechanism: FourBar, at: Option<f64>| {
        let report = four_bar(mechanism);
        let drawing = report.drawing().unwrap();
        at.map_or(drawing.clone(), |at| drawing.position(at)).svg()
    };
    let caption = |svg: String| words(&Document::parse(&svg).unwrap(), "caption")[0].to_string();
    assert!(caption(drawn(FourBar::NOMINAL, None).unwrap()).starts_with("phi = 29 deg"));
    assert!(caption(drawn(FourBar::NOMINAL, Some(3.2)).unwrap()).starts_with("phi = 183 deg"));
    let error = drawn(FourBar::GAPPED, Some(3.2)).unwrap_err();
    assert!(matches!(error, ReportError::Mistakes(_)));
    assert_eq!(
        error.to_string(),
        "the mechanism cannot be drawn at phi = 3.2 rad, since it cannot be assembled there; draw another position"
    );
}
