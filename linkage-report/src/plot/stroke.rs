//! Lines and bands on paper.

use crate::accuracy::BandKind;
use crate::palette::Style;
use linkage_formats::svg::Element;

/// The line of a curve.
pub(super) fn dashed(line: Element, style: Style) -> Element {
    match style.dash {
        0 => line,
        1 => line.set("stroke-dasharray", "9 4"),
        2 => line.set("stroke-dasharray", "2.5 3"),
        _ => line.set("stroke-dasharray", "10 3 2.5 3"),
    }
}

/// Returns the opacity of a band.
pub(super) const fn shade(kind: BandKind) -> f64 {
    match kind {
        BandKind::WorstCase => 0.18,
        BandKind::Statistical => 0.32,
    }
}
