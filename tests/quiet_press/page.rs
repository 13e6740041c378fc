//! A page of the press as it was and all compromises.

use crate::press::{Press, PressAssembly, SPEED, Trade, sampled};
use linkage::report::{Aim, Compared, Comparison, Report};
use std::error::Error;
use std::path::{Path, PathBuf};

/// Writes the page; the first press is what the others are compared with.
pub(crate) fn compared(
    first: &PressAssembly,
    front: &[Trade],
    folder: &Path,
) -> Result<PathBuf, Box<dyn Error>> {
    let presses = || core::iter::once(first).chain(front.iter().map(|found| &found.best.assembly));
    let reports: Vec<Report> = presses().map(report).collect();
    let about = "Each press has the least peak of the driving torque for what its guide bears; the stroke is kept.";
    let mut comparison = Comparison::new("A quiet press").about(about);
    for (k, (press, report)) in presses().zip(&reports).enumerate() {
        let torque = 1e-3 * sampled(|phi| press.drive(phi, SPEED).t);
        let side = sampled(|phi| press.side(phi, SPEED).f.x);
        let name = match k {
            0 => "as it was".to_string(),
            _ => format!("guide {side:.0} N"),
        };
        let compared = Compared::new(name, report)
            .figure("peak of the torque", torque, "N m")
            .figure("force on the guide", side, "N");
        comparison = comparison.design(compared);
    }
    let comparison = comparison.curves(["ram", "t"]).front([
        Aim::least("peak of the torque"),
        Aim::least("force on the guide"),
    ]);
    Ok(comparison.write(folder)?)
}

fn report(press: &PressAssembly) -> Report {
    let input = &Press::INPUTS[0];
    let phi = input.positions(361);
    Report::new("Press", input, &phi)
        .dimensions(press.mechanism())
        .structure(Press::STRUCTURE)
        .table(&press.motion_sweep(&phi))
        .table(&press.drive_sweep(&phi, &[SPEED]))
        .table(&press.picture_sweep(&phi))
}
