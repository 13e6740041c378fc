//! The page of the axle: the usual curves over the travel, the rack in the middle.

use crate::{FiveLinkAxle, FiveLinkAxleAssembly};
use linkage::report::Report;
use std::error::Error;
use std::path::Path;

/// Every two millimetres.
const POSITIONS: usize = 81;

/// Writes the report into a folder.
pub(crate) fn write(axle: &FiveLinkAxleAssembly, folder: &Path) -> Result<(), Box<dyn Error>> {
    let input = &FiveLinkAxle::<f64>::INPUTS[0];
    let travel = input.positions(POSITIONS);
    let roll = axle.roll_sweep(&travel, &[0.0]);
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
        .curve("roll centre", "mm", roll.roll_centre());
    lengths.write(folder.join("curves.svg"))?;
    println!("       {}", folder.join("index.html").display());
    Ok(())
}
