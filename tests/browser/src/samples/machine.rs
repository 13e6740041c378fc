//! A machine of three parts on one shaft, two of which turn on one pivot.

use linkage_analysis::cyclogram::{Band, Cyclogram, Member};
use linkage_analysis::summary::Curve;
use linkage_report::Report;
use linkage_runtime::{GuideOn, GuideShape, Heading, Meaning, Picture, PointKind};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, TAU};

use super::four_bar::FourBar;
use super::pictures::{EMPTY, drawn, guide, link, part, point, turn};
use super::sheet::{SHAFT, Sheet, column, flat, shown};

static PICTURE: Picture = Picture {
    points: &[
        point("hook.pivot", PointKind::Ground),
        point("hook.pin", PointKind::Joint),
        point("hook.needle", PointKind::Joint),
        point("press.pin", PointKind::Joint),
        point("press.plate", PointKind::Joint),
        point("eye.pivot", PointKind::Ground),
        point("eye.a", PointKind::Joint),
        point("eye.b", PointKind::Joint),
        point("eye.post", PointKind::Ground),
        point("eye.tip", PointKind::Tip),
    ],
    directions: &["along hook.lift", "along press.way"],
    links: &[
        link("hook.crank", &[0, 1]),
        link("hook.rod", &[1, 2]),
        link("press.crank", &[0, 3]),
        link("press.rod", &[3, 4]),
        link("eye.crank", &[5, 6]),
        link("eye.coupler", &[6, 7, 9]),
        link("eye.rocker", &[8, 7]),
    ],
    guides: &[
        guide("hook.lift", [0, 0, 2], GuideOn::Frame, GuideShape::Slot),
        guide("press.way", [0, 1, 4], GuideOn::Frame, GuideShape::Slot),
    ],
    drives: &[turn([0, 1]), turn([5, 6])],
    parts: &[
        part("hook", &[0, 1, 2], &[0, 1], &[0]),
        part("eye", &[5, 6, 7, 8, 9], &[4, 5, 6], &[]),
        part("press", &[0, 3, 4], &[2, 3], &[1]),
    ],
    ..EMPTY
};

static VIEW: Heading = Heading {
    function: "view",
    arguments: &["shaft"],
    columns: &[
        shown("picture[hook.pivot].x", "mm"),
        shown("picture[hook.pivot].y", "mm"),
        shown("picture[hook.pin].x", "mm"),
        shown("picture[hook.pin].y", "mm"),
        shown("picture[hook.needle].x", "mm"),
        shown("picture[hook.needle].y", "mm"),
        shown("picture[press.pin].x", "mm"),
        shown("picture[press.pin].y", "mm"),
        shown("picture[press.plate].x", "mm"),
        shown("picture[press.plate].y", "mm"),
        shown("picture[eye.pivot].x", "mm"),
        shown("picture[eye.pivot].y", "mm"),
        shown("picture[eye.a].x", "mm"),
        shown("picture[eye.a].y", "mm"),
        shown("picture[eye.b].x", "mm"),
        shown("picture[eye.b].y", "mm"),
        shown("picture[eye.post].x", "mm"),
        shown("picture[eye.post].y", "mm"),
        shown("picture[eye.tip].x", "mm"),
        shown("picture[eye.tip].y", "mm"),
        shown("picture[along hook.lift].x", ""),
        shown("picture[along hook.lift].y", ""),
        shown("picture[along press.way].x", ""),
        shown("picture[along press.way].y", ""),
        column("lift", "mm", Meaning::Value),
        column("plate", "mm", Meaning::Value),
    ],
    picture: drawn(&PICTURE),
};

/// Of the part whose name it begins with.
static LOAD: Heading = Heading {
    function: "eye_load",
    arguments: &["shaft"],
    columns: &[column("load", "N", Meaning::Value)],
    picture: None,
};

const CRANK: f64 = 40.0;
const ROD: f64 = 130.0;
/// By how much the crank of the press is behind that of the hook.
const BEHIND: f64 = FRAC_PI_3;
/// Where the four-bar of the eye needle stands.
const EYE: [f64; 2] = [-190.0, 30.0];

/// The lift of the hook at an angle of the shaft with its first two derivatives.
#[must_use]
pub fn lift(shaft: f64) -> [f64; 3] {
    let (s, c) = shaft.sin_cos();
    let across = (ROD * ROD - CRANK * CRANK * c * c).sqrt();
    // Half the derivative of what is below the root.
    let bend = CRANK * CRANK * s * c;
    let second = CRANK * CRANK * (c * c - s * s) / across - bend * bend / across.powi(3);
    [
        CRANK * s + across,
        CRANK * c + bend / across,
        second - CRANK * s,
    ]
}

/// The report about it, in millimetres, every three degrees, with the cyclogram of hook and press.
///
/// # Panics
/// If there is no cyclogram.
#[must_use]
pub fn machine() -> Report {
    let positions = SHAFT.positions(121);
    let hook = Curve::new((0.0, TAU), 120, lift).expect("a cycle");
    let press = Curve::new((0.0, TAU), 120, |shaft| lift(shaft - BEHIND + FRAC_PI_2));
    let press = press.expect("a cycle");
    let bands = [Band::Top(3.0), Band::Bottom(4.0)];
    let hook = Member::new("hook.needle", &hook, &bands).expect("two dwells");
    let press = Member::new("press", &press, &bands).expect("two dwells");
    let cyclogram = Cyclogram::new([press.unit("mm"), hook.unit("mm")]).expect("one shaft");
    Report::new("Machine", &SHAFT, &positions)
        .about("Hook needle, eye needle and press on one shaft.")
        .table(&Sheet::new(&VIEW, &positions, row))
        .table(&Sheet::new(&LOAD, &positions, |x: f64| [10.0 * x.sin()]))
        .cyclogram(&cyclogram)
        .trace("hook.needle")
        .trace("eye.tip")
}

fn row(shaft: f64) -> [f64; 26] {
    let pin = |angle: f64| [CRANK * angle.cos(), CRANK * angle.sin()];
    let needle = lift(shaft)[0];
    let behind = shaft - BEHIND;
    // Lying on its side: the lift of a quarter of a turn later.
    let plate = lift(behind + FRAC_PI_2)[0];
    let four_bar = FourBar::TURNING;
    let at = |[x, y]: [f64; 2]| [x + EYE[0], y + EYE[1]];
    let [a, b, tip] = four_bar.points(shaft).map(at);
    let places = [
        [0.0, 0.0],
        pin(shaft),
        [0.0, needle],
        pin(behind),
        [plate, 0.0],
        EYE,
        a,
        b,
        at([four_bar.frame, 0.0]),
        tip,
        [0.0, 1.0],
        [1.0, 0.0],
        [needle, plate],
    ];
    flat(&places, 0.0)
}
