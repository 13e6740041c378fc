//! The page of a wheel suspension: the usual curves over the travel of the wheel.

use crate::folders;
use linkage::Input;
use linkage::report::Report;
use std::error::Error;

/// Every two millimetres.
const POSITIONS: usize = 81;

/// The travels at which a page shows its wheel.
pub(crate) fn travels(input: &Input) -> Vec<f64> {
    input.positions(POSITIONS)
}

/// A page without its tables.
pub(crate) fn of(title: &str, about: &str, input: &Input, travels: &[f64]) -> Report {
    Report::new(title, input, travels).about(about).note(
        "Toe-in and a top that leans outwards are positive. x points forwards, y outwards, z up.",
    )
}

/// Writes a page, and the curves of its columns `toe` and `camber` with lengths below each other into `curves.svg`, into
/// this folder of `target`.
pub(crate) fn write(
    report: &Report,
    lengths: &[(&str, &[f64])],
    folder: &str,
) -> Result<(), Box<dyn Error>> {
    let folder = folders::target(folder);
    report.write(&folder)?;
    // Lengths of different sizes, each in a panel of its own.
    let angles = report.plot(["toe", "camber"])?;
    let all = lengths.iter().fold(angles, |plot, (name, values)| {
        plot.panel().curve(name, "mm", values)
    });
    all.write(folder.join("curves.svg"))?;
    println!("       {}", folder.join("index.html").display());
    Ok(())
}
