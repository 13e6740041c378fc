//! The page of the machine.

use crate::drives::{KnittingMachine, KnittingMachineAssembly};
use crate::organs::CYCLE;
use linkage::cyclogram::Cyclogram;
use linkage::report::Report;
use linkage::summary::Course;
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

/// Every degree.
const POSITIONS: usize = 361;

/// Writes the report into a folder, and a view of the front as `front.svg`.
pub(crate) fn write(
    machine: &KnittingMachineAssembly,
    cyclogram: &Cyclogram,
    folder: &Path,
) -> Result<(), Box<dyn Error>> {
    let input = KnittingMachine::INPUTS[0];
    let shaft = input.positions(POSITIONS);
    let distance = Course::of(CYCLE, 90, |x| {
        let m = machine.seen(x);
        [m.seen.norm(), m.seen.dot(&m.v) / m.seen.norm()]
    })?;
    let report = Report::new("Knitting machine", &input, &shaft)
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
        .trace("hook.p10")
        .trace("eye.p8")
        .cyclogram(cyclogram)
        .course("distance of the needles", "mm", &distance);
    report.write(folder)?;
    // Seen along the shafts: x to the right, y upwards.
    let front = report.drawing()?.view(-TAU / 4.0, TAU / 4.0);
    let front = front
        .names(false)
        .trace("eye.p8")
        .write(folder.join("front.svg"))?;
    println!("       {}", front.display());
    println!("       {}", folder.join("index.html").display());
    Ok(())
}
