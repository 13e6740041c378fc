//! Quantities that are constant but for the last bit, and zeros of both signs.

use linkage_report::Report;
use linkage_runtime::{Heading, Meaning};

use super::sheet::{PHI, Sheet, column};

// Each has a unit, and so an axis, of its own.
static GUIDED: Heading = Heading {
    function: "guided",
    arguments: &["phi"],
    columns: &[
        column("slider.y", "mm", Meaning::Value),
        column("share", "", Meaning::Value),
        column("across", "N", Meaning::Value),
    ],
    picture: None,
};

/// The report about what a straight guide gives.
#[must_use]
pub fn roundoff() -> Report {
    let positions = PHI.positions(37);
    Report::new("Roundoff", &PHI, &positions).table(&Sheet::new(&GUIDED, &positions, row))
}

/// The one number and the next, in turn, every ten degrees.
fn row(phi: f64) -> [f64; 3] {
    let tens = (phi.to_degrees() / 10.0).round();
    if tens % 2.0 > 0.5 {
        [8.0, 0.5, -0.0]
    } else {
        [8.0_f64.next_up(), 0.5_f64.next_up(), 0.0]
    }
}
