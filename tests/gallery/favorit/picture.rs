//! The drive as a drawing that moves.

use super::Favorit;
use crate::folders;
use linkage::report::Report;
use std::error::Error;

/// Positions of its cycle of two turns, one for each four degrees.
const POSITIONS: usize = 181;
/// Seconds of a cycle: slow enough for both cranks to be followed.
const CYCLE: f64 = 6.0;

fn moving() -> Result<String, Box<dyn Error>> {
    let linkage = Favorit::default().assemble()?;
    let phi = Favorit::INPUTS[0].positions(POSITIONS);
    let shapes = linkage.picture_sweep(&phi);
    let report = Report::new("Hook-needle drive", &Favorit::INPUTS[0], &phi).table(&shapes);
    Ok(report.drawing()?.trace("p10").moving(CYCLE).svg()?)
}

/// The README shows this drawing; `UPDATE=1` writes it.
#[test]
fn the_picture_of_the_readme_is_current() -> Result<(), Box<dyn Error>> {
    let drawn = moving()?;
    let file = folders::docs("favorit.svg");
    if folders::is_update() {
        std::fs::write(&file, &drawn)?;
    }
    assert!(
        drawn == std::fs::read_to_string(file)?,
        "docs/favorit.svg is not current"
    );
    // Of a page that is read over the network.
    assert!(drawn.len() < 60_000, "{} bytes", drawn.len());
    Ok(())
}
