//! An RSSR: a crank about z, a rocker about x, between them a link with two ball joints.

use linkage_report::Report;
use linkage_runtime::{Heading, Meaning, Picture, PointKind};

use super::pictures::{RSSR, axis, drawn, link, part, point};
use super::sheet::{PHI, Sheet, column, flat, shown};

static PICTURE: Picture = Picture {
    points: &[
        point("shaft", PointKind::Ground),
        point("pivot", PointKind::Ground),
        point("p", PointKind::Joint),
        point("q", PointKind::Joint),
        point("tip", PointKind::Tip),
    ],
    directions: &["crank_axis", "rocker_axis"],
    links: &[
        link("crank", &[0, 2]),
        link("link", &[2, 3]),
        link("rocker", &[1, 3, 4]),
    ],
    axes: &[
        axis(0, 0),
        axis(1, 1),
        // Those of the joint at q, as if they did not move.
        axis(3, 0),
        axis(3, 1),
    ],
    ..RSSR
};

static VIEW: Heading = Heading {
    function: "view",
    arguments: &["phi"],
    columns: &[
        shown("picture[shaft].x", "mm"),
        shown("picture[shaft].y", "mm"),
        shown("picture[shaft].z", "mm"),
        shown("picture[pivot].x", "mm"),
        shown("picture[pivot].y", "mm"),
        shown("picture[pivot].z", "mm"),
        shown("picture[p].x", "mm"),
        shown("picture[p].y", "mm"),
        shown("picture[p].z", "mm"),
        shown("picture[q].x", "mm"),
        shown("picture[q].y", "mm"),
        shown("picture[q].z", "mm"),
        shown("picture[tip].x", "mm"),
        shown("picture[tip].y", "mm"),
        shown("picture[tip].z", "mm"),
        shown("picture[crank_axis].x", ""),
        shown("picture[crank_axis].y", ""),
        shown("picture[crank_axis].z", ""),
        shown("picture[rocker_axis].x", ""),
        shown("picture[rocker_axis].y", ""),
        shown("picture[rocker_axis].z", ""),
        column("psi", "rad", Meaning::Value),
    ],
    picture: drawn(&PICTURE),
};

/// The same as a machine of two parts.
static OF_PARTS: Picture = Picture {
    parts: &[
        part("drive", &[0, 2], &[0], &[]),
        part("output", &[1, 2, 3, 4], &[1, 2], &[]),
    ],
    ..PICTURE
};

static VIEW_OF_PARTS: Heading = Heading {
    picture: drawn(&OF_PARTS),
    ..VIEW
};

const CRANK: f64 = 40.0;
const LINK: f64 = 130.0;
const ROCKER: f64 = 70.0;
const PIVOT: [f64; 3] = [60.0, 90.0, 10.0];

/// The report about it, every two degrees.
#[must_use]
pub fn spatial() -> Report {
    report(&VIEW)
}

/// The same as a machine of two parts.
#[must_use]
pub fn spatial_machine() -> Report {
    report(&VIEW_OF_PARTS)
}

fn report(heading: &'static Heading) -> Report {
    let positions = PHI.positions(181);
    Report::new("Crank and rocker in space", &PHI, &positions)
        .about("RSSR, the axes at right angles.")
        .table(&Sheet::new(heading, &positions, row))
        .trace("tip")
}

fn row(phi: f64) -> [f64; 22] {
    let p = [CRANK * phi.cos(), CRANK * phi.sin(), 0.0];
    let psi = rocking(p);
    let (s, c) = psi.sin_cos();
    // The rocker turns about the axis through the pivot along x.
    let out = |x: f64, y: f64, z: f64| {
        [
            PIVOT[0] + x,
            PIVOT[1] + y * c - z * s,
            PIVOT[2] + y * s + z * c,
        ]
    };
    let q = out(0.0, 0.0, ROCKER);
    let tip = out(25.0, 20.0, ROCKER + 15.0);
    let joined = [[0.0; 3], PIVOT, p, q, tip, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    flat(&joined, psi)
}

/// The rocker's angle: `|pivot + turned - p| = LINK` is `A cos psi + B sin psi = C`.
fn rocking(p: [f64; 3]) -> f64 {
    let d = [PIVOT[0] - p[0], PIVOT[1] - p[1], PIVOT[2] - p[2]];
    let square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    let (a, b) = (2.0 * ROCKER * d[2], -2.0 * ROCKER * d[1]);
    let c = LINK * LINK - ROCKER * ROCKER - square;
    b.atan2(a) + (c / a.hypot(b)).acos()
}
