//! Machines of more parts than there are listed colours.

use crate::fixture::pictures::{EMPTY, link, part, point};
use crate::fixture::{PHI, Sweep, drawn_columns, picture_heading, polar};
use crate::picture::classed;
use linkage_analysis::cyclogram::{Band, Cyclogram, Member};
use linkage_analysis::summary::Curve;
use linkage_report::Report;
use linkage_runtime::{
    Column, Heading, Picture, PictureLink, PicturePart, PicturePoint, PointKind,
};
use roxmltree::Document;
use std::collections::BTreeSet;
use std::f64::consts::TAU;

const COLUMNS: [Column; 20] = drawn_columns(20);

const fn pin(name: &'static str) -> PicturePoint {
    point(name, PointKind::Tip)
}

/// Cranks on one pivot.
static POINTS: [PicturePoint; 10] = [
    pin("pivot"),
    pin("p0.pin"),
    pin("p1.pin"),
    pin("p2.pin"),
    pin("p3.pin"),
    pin("p4.pin"),
    pin("p5.pin"),
    pin("p6.pin"),
    pin("p7.pin"),
    pin("p8.pin"),
];

static LINKS: [PictureLink; 9] = [
    link("p0.crank", &[0, 1]),
    link("p1.crank", &[0, 2]),
    link("p2.crank", &[0, 3]),
    link("p3.crank", &[0, 4]),
    link("p4.crank", &[0, 5]),
    link("p5.crank", &[0, 6]),
    link("p6.crank", &[0, 7]),
    link("p7.crank", &[0, 8]),
    link("p8.crank", &[0, 9]),
];

static PARTS: [PicturePart; 9] = [
    part("p0", &[0, 1], &[0], &[]),
    part("p1", &[0, 2], &[1], &[]),
    part("p2", &[0, 3], &[2], &[]),
    part("p3", &[0, 4], &[3], &[]),
    part("p4", &[0, 5], &[4], &[]),
    part("p5", &[0, 6], &[5], &[]),
    part("p6", &[0, 7], &[6], &[]),
    part("p7", &[0, 8], &[7], &[]),
    part("p8", &[0, 9], &[8], &[]),
];

const fn picture(parts: &'static [PicturePart]) -> Picture {
    Picture {
        points: &POINTS,
        links: &LINKS,
        parts,
        ..EMPTY
    }
}

static NINE: Heading = picture_heading(&COLUMNS, &picture(&PARTS));
/// What the other cranks are belongs to the machine itself, in the sixth colour.
static FIVE: Heading = picture_heading(&COLUMNS, &picture(PARTS.split_at(5).0));
static NONE: Heading = picture_heading(&COLUMNS, &picture(&[]));

fn report(heading: &'static Heading) -> Report {
    let phi = PHI.positions(37);
    let sweep = Sweep::new(heading, &phi, |phi| {
        let pins = (0..9).map(|k| polar(50.0, phi + 0.6 * f64::from(k)));
        [[0.0; 2]].into_iter().chain(pins).flatten().collect()
    });
    Report::new("Cranks", &PHI, &phi).table(&sweep)
}

fn cyclogram() -> Cyclogram {
    let members = PARTS.iter().map(|part| {
        let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos()];
        let course = Curve::new((0.0, TAU), 90, yoke).unwrap();
        Member::new(part.name, &course, &[Band::Top(5.0)]).unwrap()
    });
    Cyclogram::new(members).unwrap()
}

/// The colours that a drawing fills things of a class with on light ground.
fn fills(svg: &str, class: &str) -> Vec<String> {
    let svg = Document::parse(svg).unwrap();
    let things = classed(&svg, class).into_iter();
    let fill = things.map(|own| own.last_element_child().unwrap_or(own));
    fill.map(|own| own.attribute("fill").unwrap().to_string())
        .collect()
}

#[test]
fn each_of_nine_parts_has_a_colour_of_its_own() {
    let report = report(&NINE).cyclogram(&cyclogram());
    let drawing = report.drawing().unwrap().svg().unwrap();
    let bodies = fills(&drawing, "link");
    assert_eq!(bodies.iter().collect::<BTreeSet<_>>().len(), 9);
    // The bars have the colours of the bodies, and lines those of no other organ.
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("report/nine");
    report.write(&folder).unwrap();
    let bars = std::fs::read_to_string(folder.join("cyclogram.svg")).unwrap();
    assert_eq!(fills(&bars, "dwell"), bodies);
    for word in ["f-link8", "f-rim8", "s-rim8"] {
        assert!(bars.contains(&format!(".{word}{{")), "{word}");
    }
    // Dark rules are there for what is drawn, and for nothing else.
    assert!(drawing.contains(".f-link8{fill:#") && !drawing.contains("link9{"));
    assert!(!drawing.contains("rim"));
    let page = report.html().unwrap();
    assert!(page.contains("--link-8: light-dark(#") && !page.contains("--link-10:"));
}

/// Parts within the listed colours, and links without parts, have no rules of others.
#[test]
fn no_drawing_has_colours_that_it_does_not_need() {
    for heading in [&FIVE, &NONE] {
        let report = report(heading);
        let drawing = report.drawing().unwrap().svg().unwrap();
        assert!(drawing.contains("link5{") && !drawing.contains("link6"));
        assert!(!report.html().unwrap().contains("--link-6: "));
        assert_eq!(
            fills(&drawing, "link")
                .iter()
                .collect::<BTreeSet<_>>()
                .len(),
            6
        );
    }
}
