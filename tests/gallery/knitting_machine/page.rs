//! The page of the machine.

use super::drives::{KnittingMachine, KnittingMachineAssembly};
use super::members::CYCLE;
use linkage::cyclogram::Cyclogram;
use linkage::report::Report;
use linkage::summary::Curve;
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

/// Every degree.
const POSITIONS: usize = 361;

/// What it shows: with the shifts by tolerances, if the cyclogram has them.
pub(crate) fn report(
    machine: &KnittingMachineAssembly,
    cyclogram: &Cyclogram,
) -> Result<Report, Box<dyn Error>> {
    let input = KnittingMachine::INPUTS[0];
    let shaft = input.positions(POSITIONS);
    let distance = Curve::new(CYCLE, 90, |x| {
        let m = machine.seen(x);
        [m.seen.norm(), m.seen.dot(&m.v) / m.seen.norm()]
    })?;
    Ok(Report::new("Knitting machine", &input, &shaft)
        .about("Hook needle, eye needle, sinkers and press on one shaft.")
        .note("Dimensions are those of the drives' own examples; phases and places are chosen.")
        .structure(KnittingMachine::STRUCTURE)
        .modes(machine.modes())
        .dimensions(machine.mechanism())
        .programs(KnittingMachine::PROGRAMS)
        .table(&machine.picture_sweep(&shaft))
        .table(&machine.hook_sweep(&shaft))
        .table(&machine.eye_way_sweep(&shaft))
        .table(&machine.sinker_sweep(&shaft))
        .table(&machine.press_sweep(&shaft))
        .table(&machine.seen_sweep(&shaft))
        // Along the shafts: x to the right, y upwards.
        .view(-TAU / 4.0, TAU / 4.0)
        .trace("hook.p10")
        .trace("eye.p8")
        .cyclogram(cyclogram)
        .course("distance of the needles", "mm", &distance))
}

/// Writes it into a folder, and a drawing without names as `front.svg`.
pub(crate) fn write(report: &Report, folder: &Path) -> Result<(), Box<dyn Error>> {
    report.write(folder)?;
    let front = report
        .drawing()?
        .names(false)
        .trace("eye.p8")
        .write(folder.join("front.svg"))?;
    println!("       {}", front.display());
    println!("       {}", folder.join("index.html").display());
    Ok(())
}
