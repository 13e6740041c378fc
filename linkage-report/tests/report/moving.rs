//! Drawings that move: at their key positions they are the drawings of these positions.

use crate::fixture::{FourBar, PHI, quick_return, spatial};
use crate::four_bar;
use crate::picture::{classed, words};
use linkage_report::{Drawing, Report};
use linkage_runtime::Input;
use roxmltree::{Document, Node};

/// The attributes of an element that move, each with its values.
fn moves<'a>(node: Node<'a, 'a>) -> Vec<(&'a str, Vec<&'a str>)> {
    let animations = node.children().filter(|node| node.has_tag_name("animate"));
    let moves = animations.map(|node| {
        assert_eq!(node.attribute("dur"), Some("4s"));
        assert_eq!(node.attribute("repeatCount"), Some("indefinite"));
        let values = node.attribute("values").unwrap().split(';');
        (node.attribute("attributeName").unwrap(), values.collect())
    });
    moves.collect()
}

fn numbers(values: &str) -> Vec<f64> {
    let numbers = values.split([' ', ',']).map(|x| x.parse().unwrap());
    numbers.collect()
}

/// Compares each moving attribute with that of the drawing at the same position, and returns how many there are.
fn compare(drawing: &Drawing<'_>, positions: &[f64], step: usize) -> usize {
    let moving = drawing.clone().names(false).moving(4.0).svg().unwrap();
    let moving = Document::parse(&moving).unwrap();
    let mut count = 0;
    for (key, at) in positions.iter().step_by(step).enumerate() {
        let still = drawing.clone().names(false).position(*at).svg().unwrap();
        let still = Document::parse(&still).unwrap();
        for class in ["link", "slider", "point", "pivot"] {
            let (run, stand) = (classed(&moving, class), classed(&still, class));
            assert_eq!(run.len(), stand.len());
            for (run, stand) in run.into_iter().zip(stand) {
                let run = run
                    .descendants()
                    .filter(|node| !node.has_tag_name("animate"));
                for (run, stand) in run.zip(stand.descendants()) {
                    for (name, values) in moves(run) {
                        let (mut a, mut b) = (
                            numbers(values[key]),
                            numbers(stand.attribute(name).unwrap()),
                        );
                        // A plate's corners may begin elsewhere.
                        a.sort_by(f64::total_cmp);
                        b.sort_by(f64::total_cmp);
                        assert_eq!(a.len(), b.len());
                        let near = a.iter().zip(&b).all(|(a, b)| (a - b).abs() < 0.0051);
                        assert!(near, "{class} {name} at {at}: {a:?} {b:?}");
                        count += 1;
                    }
                }
            }
        }
    }
    count
}

#[test]
fn it_is_the_mechanism_at_every_key_position() {
    let report = four_bar(FourBar::NOMINAL);
    let phi = PHI.positions(361);
    // Three links of two shapes each, two joints and a tip of two coordinates each, at 60 of 361 positions and the last.
    assert_eq!(compare(&report.drawing().unwrap(), &phi, 6), 61 * 12);
    let phi = PHI.positions(73);
    let report = Report::new("Shaper", &PHI, &phi).table(&quick_return(&phi));
    assert!(compare(&report.drawing().unwrap(), &phi, 2) > 37 * 12);
}

#[test]
fn plates_keep_their_corners() {
    let report = four_bar(FourBar::NOMINAL);
    let svg = report.drawing().unwrap().moving(4.0).svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let links = classed(&svg, "link");
    let shapes = links.into_iter().flat_map(|node| node.children());
    let mut seen = 0;
    for shape in shapes.filter(|node| node.has_tag_name("polygon")) {
        let (name, values) = &moves(shape)[0];
        assert_eq!((*name, values.len()), ("points", 61));
        let sides = |values: &&str| {
            let corners = numbers(values);
            let corners: Vec<_> = corners.chunks(2).map(|own| [own[0], own[1]]).collect();
            let next = corners.iter().cycle().skip(1);
            let sides = corners.iter().zip(next);
            let sides = sides.map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1]));
            sides.collect::<Vec<_>>()
        };
        let first = sides(&values[0]);
        for own in values.iter().map(sides) {
            // Its sides, one by one: of corners that changed places they would be others.
            assert!(own.iter().zip(&first).all(|(a, b)| (a - b).abs() < 0.03));
        }
        seen += 1;
    }
    assert_eq!(seen, 6);
}

#[test]
fn it_goes_onward_over_a_turn_and_there_and_back_over_less() {
    let report = four_bar(FourBar::NOMINAL);
    let svg = report.drawing().unwrap().moving(4.0).svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(words(&svg, "caption"), ["phi from 0 to 360 deg, scale 1:2"]);
    assert!(classed(&svg, "name").is_empty() && classed(&svg, "drive").is_empty());
    let part = Input {
        range: Some((0.2, 1.7)),
        ..PHI
    };
    let phi = part.positions(91);
    let report = Report::new("Part", &part, &phi).table(&FourBar::NOMINAL.picture(&phi));
    let svg = report.drawing().unwrap().moving(4.0).svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let points = classed(&svg, "point").into_iter().flat_map(moves);
    let mut seen = 0;
    for (_, values) in points {
        let back: Vec<_> = values.iter().rev().copied().collect();
        assert_eq!(values, back);
        assert_ne!(values[0], values[values.len() / 2]);
        seen += 1;
    }
    assert_eq!(seen, 6);
}

#[test]
fn what_cannot_move_is_refused() {
    let told = |report: &Report, seconds: f64| {
        let drawing = report.drawing().unwrap().moving(seconds);
        drawing.svg().unwrap_err().to_string()
    };
    assert_eq!(
        told(&four_bar(FourBar::NOMINAL), 0.0),
        "a cycle takes 0 s; give a positive number of seconds"
    );
    assert!(told(&four_bar(FourBar::NOMINAL), f64::NAN).contains("takes NaN s"));
    let gapped = told(&four_bar(FourBar::GAPPED), 4.0);
    assert!(gapped.contains("cannot be assembled there"), "{gapped}");
    let phi = PHI.positions(73);
    let report = Report::new("RSSR", &PHI, &phi).table(&spatial(&phi));
    assert!(told(&report, 4.0).starts_with("drawings of mechanisms in space do not move"));
}
