//! Slides on all kinds of guides: a slider-crank, an oscillating cylinder, a block on a link.

use linkage_report::Report;
use linkage_runtime::{Drive, DriveOn, GuideOn, GuideShape, Heading, Meaning, Picture, PointKind};

use super::pictures::{EMPTY, drawn, guide, link, point, turn};
use super::sheet::{PHI, Sheet, column, flat, shown};

static PICTURE: Picture = Picture {
    points: &[
        point("main", PointKind::Ground),
        point("big", PointKind::Joint),
        point("small", PointKind::Joint),
        point("base", PointKind::Ground),
        point("block", PointKind::Joint),
        point("hang", PointKind::Ground),
        point("far", PointKind::Construction),
    ],
    directions: &["stroke", "cylinder", "rod"],
    links: &[
        link("crank", &[0, 1]),
        link("conrod", &[1, 2]),
        link("follower", &[4, 5]),
    ],
    guides: &[
        guide("x", [6, 0, 2], GuideOn::Frame, GuideShape::Slot),
        guide("s", [3, 1, 1], GuideOn::Itself, GuideShape::Slot),
        guide("t", [1, 2, 4], GuideOn::Link(1), GuideShape::Slot),
    ],
    drives: &[
        turn([0, 1]),
        Drive {
            input: 0,
            on: DriveOn::Slide(0),
        },
    ],
    ..EMPTY
};

static VIEW: Heading = Heading {
    function: "view",
    arguments: &["phi"],
    columns: &[
        shown("picture[main].x", "m"),
        shown("picture[main].y", "m"),
        shown("picture[big].x", "m"),
        shown("picture[big].y", "m"),
        shown("picture[small].x", "m"),
        shown("picture[small].y", "m"),
        shown("picture[base].x", "m"),
        shown("picture[base].y", "m"),
        shown("picture[block].x", "m"),
        shown("picture[block].y", "m"),
        shown("picture[hang].x", "m"),
        shown("picture[hang].y", "m"),
        shown("picture[far].x", "m"),
        shown("picture[far].y", "m"),
        shown("picture[stroke].x", ""),
        shown("picture[stroke].y", ""),
        shown("picture[cylinder].x", ""),
        shown("picture[cylinder].y", ""),
        shown("picture[rod].x", ""),
        shown("picture[rod].y", ""),
        column("x", "m", Meaning::Value),
    ],
    picture: drawn(&PICTURE),
};

const CRANK: f64 = 0.035;
const ROD: f64 = 0.13;
const FOLLOWER: f64 = 0.11;
const BASE: [f64; 2] = [-0.06, 0.08];
const HANG: [f64; 2] = [0.09, 0.08];

/// On the line of the frame's guide, far from everything that is drawn.
const FAR: [f64; 2] = [-3.0, 0.0];

/// The report about them, in metres, every three degrees.
#[must_use]
pub fn sliders() -> Report {
    let positions = PHI.positions(121);
    Report::new("Slides", &PHI, &positions)
        .about("A guide on the frame, one on a link, one that is a link itself.")
        .table(&Sheet::new(&VIEW, &positions, row))
        .trace("block")
}

fn row(phi: f64) -> [f64; 21] {
    let big = [CRANK * phi.cos(), CRANK * phi.sin()];
    let x = big[0] + (ROD * ROD - big[1] * big[1]).sqrt();
    let small = [x, 0.0];
    let cylinder = unit(BASE, big);
    let rod = unit(big, small);
    let block = on_rod(big, rod);
    let joined = [
        [0.0, 0.0],
        big,
        small,
        BASE,
        block,
        HANG,
        FAR,
        [1.0, 0.0],
        cylinder,
        rod,
    ];
    flat(&joined, x)
}

fn unit(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let (x, y) = (to[0] - from[0], to[1] - from[1]);
    let length = x.hypot(y);
    [x / length, y / length]
}

/// The point of the rod's line, behind its foot, that the follower reaches.
fn on_rod(big: [f64; 2], rod: [f64; 2]) -> [f64; 2] {
    let from = [HANG[0] - big[0], HANG[1] - big[1]];
    let foot = from[0] * rod[0] + from[1] * rod[1];
    let aside = from[0] * rod[1] - from[1] * rod[0];
    let s = foot - (FOLLOWER * FOLLOWER - aside * aside).sqrt();
    [big[0] + s * rod[0], big[1] + s * rod[1]]
}
