//! The paper of a drawing, and values as text.

use linkage_compiler::ir::{Picture, PointKind};

/// The largest size in pixels, with the margin for pivots and names.
const SIZE: [f64; 2] = [400.0, 260.0];
const MARGIN: f64 = 34.0;

/// The background of the page for rustdoc, which shows through pins.
pub(super) const BACKGROUND: &str = "var(--main-background-color,#fff)";

/// Places and directions on the paper, in pixels from its upper left corner.
pub(super) struct Sheet {
    pub(super) points: Vec<[f64; 2]>,
    pub(super) directions: Vec<[f64; 2]>,
    pub(super) size: [f64; 2],
}

impl Sheet {
    /// `None` if a point is nowhere, or if all are in one place.
    pub(super) fn new(picture: &Picture) -> Option<Self> {
        let flat: Vec<[f64; 2]> = picture
            .reference
            .iter()
            .map(|position| projected(position))
            .collect();
        if flat.is_empty() || !flat.iter().flatten().all(|x| x.is_finite()) {
            return None;
        }
        let (points, directions) = flat.split_at(picture.points.len());
        let drawn = picture.points.iter().zip(points);
        let drawn = drawn.filter(|(point, _)| point.kind != PointKind::Construction);
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for (_, position) in drawn {
            for axis in 0..2 {
                low[axis] = low[axis].min(position[axis]);
                high[axis] = high[axis].max(position[axis]);
            }
        }
        let scales = [0, 1].map(|axis| (SIZE[axis] - 2.0 * MARGIN) / (high[axis] - low[axis]));
        let scale = scales[0].min(scales[1]);
        if !(scale > 0.0 && scale.is_finite()) {
            return None;
        }
        let on_paper =
            |position: &[f64; 2]| [0, 1].map(|axis| MARGIN + scale * (position[axis] - low[axis]));
        Some(Self {
            points: points.iter().map(on_paper).collect(),
            directions: directions.to_vec(),
            size: [0, 1].map(|axis| 2.0 * MARGIN + scale * (high[axis] - low[axis])),
        })
    }
}

/// A vector on the paper, whose second axis points down. Space is seen from above, between two of
/// its axes, as in reports.
fn projected(vector: &[f64]) -> [f64; 2] {
    match *vector {
        [x, y, z] => {
            let (sa, ca) = (-60f64).to_radians().sin_cos();
            let (se, ce) = 25f64.to_radians().sin_cos();
            [-sa * x + ca * y, se * (ca * x + sa * y) - ce * z]
        }
        [x, y] => [x, -y],
        _ => [f64::NAN; 2],
    }
}

pub(super) fn polyline(points: &[[f64; 2]]) -> String {
    let corners = points.iter().map(|position| position.map(number).join(" "));
    format!("M{}", corners.collect::<Vec<_>>().join("L"))
}

/// A tenth of a pixel.
pub(super) fn number(x: f64) -> String {
    let text = format!("{x:.1}");
    text.strip_suffix(".0").unwrap_or(&text).to_owned()
}

pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('"', "&quot;")
}
