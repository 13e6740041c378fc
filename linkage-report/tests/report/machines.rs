//! Machines: what is drawn of their parts, and their cyclogram.

use crate::fixture::pictures::{EMPTY, link, part, point};
use crate::fixture::{FourBar, PHI, Sweep, drawn_columns, picture_heading, polar};
use crate::picture::{classed, words};
use dxf::entities::EntityType;
use linkage_analysis::cyclogram::{Band, Cyclogram, Member};
use linkage_analysis::summary::Curve;
use linkage_report::Report;
use linkage_runtime::{Column, Heading, Input, Picture, PointKind};
use roxmltree::Document;
use serde_json::{Value, json};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_6, TAU};

const COLUMNS: [Column; 8] = drawn_columns(8);

/// Two cranks on one pivot, and an arm of the machine itself.
static PICTURE: Picture = Picture {
    points: &[
        point("hook.pivot", PointKind::Ground),
        point("hook.pin", PointKind::Tip),
        point("eye.pin", PointKind::Joint),
        point("end", PointKind::Tip),
    ],
    links: &[
        link("arm", &[2, 3]),
        link("eye.crank", &[0, 2]),
        link("hook.crank", &[0, 1]),
    ],
    parts: &[
        part("hook", &[0, 1], &[2], &[]),
        part("eye", &[0, 2], &[1], &[]),
    ],
    ..EMPTY
};

static HEADING: Heading = picture_heading(&COLUMNS, &PICTURE);

fn cyclogram(names: [&str; 2]) -> Cyclogram {
    let members = names.map(|name| {
        let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos(), -40.0 * phi.sin()];
        let course = Curve::new((0.0, TAU), 90, yoke).unwrap();
        Member::new(name, &course, &[Band::Top(5.0)]).unwrap()
    });
    Cyclogram::new(members).unwrap()
}

fn machine() -> Report {
    let phi = PHI.positions(37);
    let sweep = Sweep::new(&HEADING, &phi, |phi| {
        let (hook, eye) = (polar(50.0, phi), polar(80.0, phi + FRAC_PI_2));
        let end = [eye[0] + 30.0, eye[1]];
        [[0.0; 2], hook, eye, end].concat()
    });
    Report::new("Machine", &PHI, &phi).table(&sweep)
}

/// The colours of the links' insides, by their names.
fn colours(svg: &Document<'_>) -> Vec<(String, String)> {
    let links = classed(svg, "link").into_iter();
    let links = links.map(|link| {
        let body = link.last_element_child().unwrap();
        let fill = body.attribute("class").unwrap().split(' ');
        let fill = fill.clone().find(|word| word.starts_with("f-"));
        let name = link.attribute("data-name").unwrap();
        (name.to_string(), fill.unwrap().to_string())
    });
    let mut all: Vec<_> = links.collect();
    all.sort();
    all
}

/// What a part has alone is switched off with its layer; what parts share, and what the machine adds, stays.
#[test]
fn each_part_has_a_layer_of_its_own() {
    let text = machine().drawing().unwrap().dxf().unwrap();
    let drawing = dxf::Drawing::load(&mut text.as_bytes()).expect("a program reads it");
    let hues: Vec<_> = drawing
        .layers()
        .map(|layer| (layer.name.clone(), layer.color.index()))
        .collect();
    let [hook, eye] = ["part_hook", "part_eye"].map(|name| {
        let mut own = hues.iter().filter(|(other, _)| other == name);
        own.next().unwrap_or_else(|| panic!("{hues:?}")).1
    });
    assert_ne!(hook, eye);
    let on = |layer: &str| {
        let own = drawing.entities().filter(|own| own.common.layer == layer);
        let told = own.map(|own| match &own.specific {
            EntityType::Line(line) => {
                format!("line to {} {}", line.p2.x.round(), line.p2.y.round())
            }
            EntityType::ModelPoint(at) => {
                format!("{} {}", at.location.x.round(), at.location.y.round())
            }
            EntityType::Circle(_) => "circle".to_owned(),
            other => panic!("{other:?}"),
        });
        told.collect::<Vec<_>>()
    };
    // At the position next to the input's reference, 30 degrees: 50 mm there, 80 mm a quarter of a turn ahead.
    let (sin, cos) = FRAC_PI_6.sin_cos();
    let pin = [50.0 * cos, 50.0 * sin].map(f64::round);
    let other = [-80.0 * sin, 80.0 * cos].map(f64::round);
    let [x, y] = pin;
    assert_eq!(
        on("part_hook"),
        [format!("line to {x} {y}"), format!("{x} {y}")]
    );
    let [x, y] = other;
    let at = format!("{x} {y}");
    assert_eq!(
        on("part_eye"),
        [format!("line to {at}"), at, "circle".to_owned()]
    );
    assert_eq!(on("links").len(), 1);
    assert_eq!(on("joints"), ["0 0", "circle", &on("joints")[2]]);
}

#[test]
fn parts_have_their_colours_and_a_legend() {
    let svg = machine().drawing().unwrap().svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let expected = [
        ("arm", "f-link2"),
        ("eye.crank", "f-link1"),
        ("hook.crank", "f-link0"),
    ];
    let expected = expected.map(|(name, colour)| (name.to_string(), colour.to_string()));
    assert_eq!(colours(&svg), expected);
    let entries = classed(&svg, "part");
    let told = entries.iter().map(|entry| {
        let swatch = entry.first_element_child().unwrap();
        let words = entry.last_element_child().unwrap();
        (words.text().unwrap(), swatch.attribute("class").unwrap())
    });
    let told: Vec<_> = told.collect();
    assert_eq!(told[0].0, "hook");
    assert!(told[0].1.contains("f-link0"), "{told:?}");
    assert_eq!(told[1].0, "eye");
    assert!(told[1].1.contains("f-link1"), "{told:?}");
    // Without parts there is no legend, and each link has its own colour.
    let alone = crate::four_bar(FourBar::NOMINAL)
        .drawing()
        .unwrap()
        .svg()
        .unwrap();
    let alone = Document::parse(&alone).unwrap();
    assert!(classed(&alone, "part").is_empty());
}

#[test]
fn data_tell_of_parts_and_organs() {
    let data = machine().cyclogram(&cyclogram(["other", "eye.needle"]));
    let data: Value = serde_json::from_str(&data.json().unwrap()).unwrap();
    assert_eq!(
        data["picture"]["parts"],
        json!([
            { "name": "hook", "points": [0, 1], "links": [2], "guides": [] },
            { "name": "eye", "points": [0, 2], "links": [1], "guides": [] },
        ])
    );
    // An organ of a part has its colour, others those behind all parts.
    let hues = data["cyclogram"]["organs"].as_array().unwrap();
    let hues: Vec<_> = hues.iter().map(|member| &member["colour"]).collect();
    assert_eq!(hues, [&json!(2), &json!(1)]);
    let at = data["cyclogram"]["organs"][0]["events"][0]["at"].as_f64();
    assert!((at.unwrap() - (35.0f64 / 40.0).asin()).abs() < 1e-15);
    let alone = crate::four_bar(FourBar::NOMINAL).json().unwrap();
    let alone: Value = serde_json::from_str(&alone).unwrap();
    assert!(alone.get("cyclogram").is_none() && alone["picture"].get("parts").is_none());
}

#[test]
fn a_cyclogram_is_written_with_the_colours_of_the_parts() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("report/machine");
    let report = machine().cyclogram(&cyclogram(["eye", "hook"]));
    let files = report.write(&folder).unwrap();
    for name in [
        "cyclogram.svg",
        "cyclogram.csv",
        "cyclogram-order.csv",
        "cyclogram-overlaps.csv",
    ] {
        assert!(files.contains(&folder.join(name)), "{files:?}");
    }
    let svg = std::fs::read_to_string(folder.join("cyclogram.svg")).unwrap();
    let svg = Document::parse(&svg).unwrap();
    assert_eq!(words(&svg, "name"), ["eye", "hook"]);
    let bars: Vec<_> = classed(&svg, "dwell")
        .iter()
        .map(|bar| bar.attribute("class").unwrap().to_string())
        .collect();
    assert!(
        bars[0].contains("f-link1") && bars[1].contains("f-link0"),
        "{bars:?}"
    );
    let csv = std::fs::read_to_string(folder.join("cyclogram.csv")).unwrap();
    assert!(csv.starts_with("organ,motion,band,from [rad],"), "{csv}");
}

#[test]
fn a_cyclogram_needs_a_shaft_and_a_file_of_its_own() {
    const STROKE: Input = Input {
        name: "s",
        unit: "mm",
        ..PHI
    };
    const HEADING: Heading = Heading {
        function: "cyclogram",
        arguments: &["s"],
        columns: &[crate::fixture::value("x", "mm")],
        picture: None,
    };
    let s = STROKE.positions(3);
    let report = Report::new("Press", &STROKE, &s)
        .table(&Sweep::new(&HEADING, &s, |s| vec![s]))
        .cyclogram(&cyclogram(["eye\u{7}", "hook"]));
    assert_eq!(
        report.json().unwrap_err().to_string(),
        "the name of an organ has the control character U+0007 after \"eye\", which pictures and pages cannot show; leave it out\n\
         a cyclogram is over an angle in rad, and the input `s` is in mm; give the report the shaft as its input\n\
         the table of `cyclogram` and the cyclogram would both be `cyclogram.csv`; give the function another name"
    );
}
