//! A cam at as many positions as a test wants.

use linkage_report::Report;
use linkage_runtime::{Heading, Meaning};

use super::sheet::{PHI, Sheet, column};

static CAM: Heading = Heading {
    function: "cam",
    arguments: &["phi"],
    columns: &[
        column("lift", "mm", Meaning::Value),
        column("force", "N", Meaning::Value),
    ],
    picture: None,
};

/// Lift `8 sin phi` and force `5 cos phi` over a turn.
#[must_use]
pub fn many(count: usize) -> Report {
    cam(&PHI.positions(count))
}

/// The same, from a whole turn down to zero.
#[must_use]
pub fn falling(count: usize) -> Report {
    let mut positions = PHI.positions(count);
    positions.reverse();
    cam(&positions)
}

fn cam(positions: &[f64]) -> Report {
    let row = |phi: f64| [8.0 * phi.sin(), 5.0 * phi.cos()];
    Report::new("Cam", &PHI, positions).table(&Sheet::new(&CAM, positions, row))
}
