//! A page with the drives over each other.

use crate::drive::{BAND, EyeNeedle, EyeNeedleAssembly, course};
use linkage::report::{Aim, Compared, Comparison, Report};
use std::error::Error;
use std::path::{Path, PathBuf};

/// A drive that the page shows.
pub(crate) struct Design<'a> {
    pub(crate) name: &'static str,
    pub(crate) assembly: &'a EyeNeedleAssembly,
    /// Where it dwells, and for how long.
    pub(crate) rest: [f64; 2],
    /// The widest band over the dwell of drives that are built within the tolerances, in mm.
    pub(crate) band: f64,
}

/// Writes the page; the first drive is what the others are compared with.
pub(crate) fn compared(designs: &[Design<'_>], folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let mut reports = Vec::new();
    for design in designs {
        reports.push(report(design)?);
    }
    let about = format!(
        "No length differs by more than 2 % from the published drive, and the stroke is kept. The dwell is where the way of \
         the needle stays within {BAND} mm; built with tolerances of 20 um on all dimensions a drive needs the wider band."
    );
    let comparison = designs
        .iter()
        .zip(&reports)
        .fold(
            Comparison::new("A longer dwell").about(about),
            |all, (design, report)| {
                let compared = Compared::new(design.name, report)
                    .figure("dwell", design.rest[1].to_degrees(), "deg")
                    .figure("band when it is built", design.band, "mm");
                all.design(compared)
            },
        )
        .curves(["way", "v", "a"])
        .front([Aim::most("dwell"), Aim::least("band when it is built")]);
    Ok(comparison.write(folder)?)
}

fn report(design: &Design<'_>) -> Result<Report, Box<dyn Error>> {
    let input = &EyeNeedle::INPUTS[0];
    let phi = input.positions(361);
    let assembly = design.assembly;
    Ok(Report::new(design.name, input, &phi)
        .dimensions(assembly.mechanism())
        .structure(EyeNeedle::STRUCTURE)
        .table(&assembly.motion_sweep(&phi))
        .table(&assembly.picture_sweep(&phi))
        .trace("p8")
        .course("way", "mm", &course(assembly)?))
}
