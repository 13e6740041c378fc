//! The page of the axle: the usual curves over the travel, the rack in the middle.

use crate::{FiveLinkAxle, FiveLinkAxleAssembly, roll_centre};
use linkage::report::Report;
use linkage::{Column, Heading, Meaning, Table};
use std::error::Error;
use std::path::Path;

/// Every two millimetres.
const POSITIONS: usize = 81;

/// A curve that follows from several quantities of the axle.
struct RollCentre(Vec<f64>);

impl Table for RollCentre {
    fn heading(&self) -> &'static Heading {
        &Heading {
            function: "roll",
            arguments: &["travel", "rack"],
            columns: &[Column {
                name: "roll_centre",
                unit: "mm",
                meaning: Meaning::Value,
            }],
            picture: None,
        }
    }

    fn rows(&self) -> usize {
        self.0.len()
    }

    fn column(&self, _: usize) -> &[f64] {
        &self.0
    }
}

/// Writes the report into a folder.
pub(crate) fn write(axle: &FiveLinkAxleAssembly, folder: &Path) -> Result<(), Box<dyn Error>> {
    let input = &FiveLinkAxle::<f64>::INPUTS[0];
    let travel = input.positions(POSITIONS);
    let roll = RollCentre(travel.iter().map(|&z| roll_centre(axle, z, 0.0)).collect());
    let wheel = axle.wheel_sweep(&travel, &[0.0]);
    let report = Report::new("Five-link axle", input, &travel)
        .about("A wheel carrier on five rods over the travel of the wheel.")
        .note("Toe-in and a top that leans outwards are positive. Base is where the wheel stands on the road, forwards.")
        .structure(FiveLinkAxle::<f64>::STRUCTURE)
        .dimensions(axle.mechanism())
        .table(&wheel)
        .table(&roll)
        .table(&axle.motion_sweep(&travel, &[0.0]))
        .table(&axle.shape_sweep(&travel, &[0.0]));
    report.write(folder)?;
    // Lengths of different sizes, each in a panel of its own.
    let angles = report.plot(["toe", "camber"])?;
    let lengths = angles
        .panel()
        .curve("track", "mm", wheel.track())
        .panel()
        .curve("base", "mm", wheel.base())
        .panel()
        .curve("roll centre", "mm", &roll.0);
    lengths.write(folder.join("curves.svg"))?;
    println!("       {}", folder.join("index.html").display());
    Ok(())
}
