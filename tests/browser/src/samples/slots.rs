//! Curved slots: one in a lever, one in the frame, and a ring in the frame.

use linkage_report::Report;
use linkage_runtime::{
    Guide, GuideOn, GuideShape, Heading, Input, Meaning, Picture, PictureColumns, PictureLink,
    PicturePart, PicturePoint, PointKind,
};

use super::sheet::{Sheet, column, shown};

const INPUT: Input = Input {
    name: "phi",
    unit: "rad",
    reference: 0.0,
    range: None,
};

const fn point(name: &'static str, kind: PointKind) -> PicturePoint {
    PicturePoint { name, kind }
}

const fn arc(name: &'static str, [origin, direction, slider]: [usize; 3], on: GuideOn) -> Guide {
    Guide {
        name,
        origin,
        direction,
        slider,
        on,
        shape: GuideShape::Arc,
    }
}

static PICTURE: Picture = Picture {
    dimension: 2,
    points: &[
        point("trunnion", PointKind::Ground),
        point("end", PointKind::Tip),
        point("middle", PointKind::Construction),
        point("pin", PointKind::Joint),
        point("centre", PointKind::Construction),
        point("die", PointKind::Joint),
        point("hub", PointKind::Construction),
        point("runner", PointKind::Joint),
    ],
    directions: &["lever", "frame"],
    links: &[
        PictureLink {
            name: "lever",
            points: &[0, 1, 2],
        },
        PictureLink {
            name: "rod",
            points: &[3, 5],
        },
    ],
    guides: &[
        arc("slot", [2, 0, 3], GuideOn::Link(0)),
        arc("way", [4, 1, 5], GuideOn::Frame),
        arc("ring", [6, 1, 7], GuideOn::Frame),
    ],
    axes: &[],
    joints: &[],
    gears: &[],
    drives: &[],
    undrawn: &[],
    // Pages of machines are seen from links, too.
    parts: &[
        PicturePart {
            name: "link",
            points: &[0, 1, 2, 3, 4, 5],
            links: &[0, 1],
            guides: &[0, 1],
        },
        PicturePart {
            name: "wheel",
            points: &[6, 7],
            links: &[],
            guides: &[2],
        },
    ],
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
    picture: Some(PictureColumns {
        first: 0,
        picture: &PICTURE,
    }),
};

const CENTRE: [f64; 2] = [60.0, 190.0];
const HUB: [f64; 2] = [-90.0, 40.0];

/// The report about them, in millimetres, every three degrees.
#[must_use]
pub fn slots() -> Report {
    let positions = INPUT.positions(121);
    Report::new("Slots", &INPUT, &positions)
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
    let mut all = [lever; 21];
    for (number, value) in all.iter_mut().zip(joined.into_iter().flatten()) {
        *number = value;
    }
    all
}

fn reached([x, y]: [f64; 2], length: f64, angle: f64) -> [f64; 2] {
    [x + length * angle.cos(), y + length * angle.sin()]
}
