//! Curved slots: one in a lever, one in the frame, and a ring in the frame.

use linkage_report::Report;
use linkage_runtime::{GuideOn, GuideShape, Heading, Meaning, Picture};

use super::pictures::{CURVED_SLOTS, drawn, guide, part};
use super::sheet::{PHI, Sheet, column, flat, shown};

static PICTURE: Picture = Picture {
    directions: &["lever", "frame"],
    guides: &[
        guide("slot", [2, 0, 3], GuideOn::Link(0), GuideShape::Arc),
        guide("way", [4, 1, 5], GuideOn::Frame, GuideShape::Arc),
        guide("ring", [6, 1, 7], GuideOn::Frame, GuideShape::Arc),
    ],
    // Pages of machines are seen from links, too.
    parts: &[
        part("link", &[0, 1, 2, 3, 4, 5], &[0, 1], &[0, 1]),
        part("wheel", &[6, 7], &[], &[2]),
    ],
    ..CURVED_SLOTS
};

static VIEW: Heading = Heading {
    function: "view",
    arguments: &["phi"],
    columns: &[
        shown("picture[trunnion].x", "mm"),
        shown("picture[trunnion].y", "mm"),
        shown("picture[end].x", "mm"),
        shown("picture[end].y", "mm"),
        shown("picture[middle].x", "mm"),
        shown("picture[middle].y", "mm"),
        shown("picture[pin].x", "mm"),
        shown("picture[pin].y", "mm"),
        shown("picture[centre].x", "mm"),
        shown("picture[centre].y", "mm"),
        shown("picture[die].x", "mm"),
        shown("picture[die].y", "mm"),
        shown("picture[hub].x", "mm"),
        shown("picture[hub].y", "mm"),
        shown("picture[runner].x", "mm"),
        shown("picture[runner].y", "mm"),
        shown("picture[lever].x", ""),
        shown("picture[lever].y", ""),
        shown("picture[frame].x", ""),
        shown("picture[frame].y", ""),
        column("turn", "rad", Meaning::Value),
    ],
    picture: drawn(&PICTURE),
};

const CENTRE: [f64; 2] = [60.0, 190.0];
const HUB: [f64; 2] = [-90.0, 40.0];

/// The report about them, in millimetres, every three degrees.
#[must_use]
pub fn slots() -> Report {
    let positions = PHI.positions(121);
    Report::new("Slots", &PHI, &positions)
        .about("A slot in a lever, one in the frame, and a ring.")
        .table(&Sheet::new(&VIEW, &positions, row))
}

fn row(phi: f64) -> [f64; 21] {
    let lever = 0.3 * phi.sin();
    let middle = reached([0.0, 0.0], 90.0, lever);
    let joined = [
        [0.0, 0.0],
        reached([0.0, 0.0], 140.0, lever),
        middle,
        reached(middle, 60.0, lever + 1.2 + 0.5 * phi.sin()),
        CENTRE,
        reached(CENTRE, 80.0, -1.7 + 0.4 * phi.cos()),
        HUB,
        reached(HUB, 25.0, phi),
        reached([0.0, 0.0], 1.0, lever),
        [1.0, 0.0],
    ];
    flat(&joined, lever)
}

fn reached([x, y]: [f64; 2], length: f64, angle: f64) -> [f64; 2] {
    [x + length * angle.cos(), y + length * angle.sin()]
}
