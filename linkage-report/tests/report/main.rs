//! Reports of mechanisms whose sweeps are written by hand: data, plots, drawings, mistakes.

mod closing;
mod colours;
mod csv;
mod data;
mod drawings;
mod dxf_files;
mod fixture;
mod folder;
mod machines;
mod many_parts;
mod mistakes;
mod moving;
mod once;
mod packed;
mod picture;
mod plots;
mod signs;
mod thinning;
mod tolerances;

use fixture::{FourBar, PHI};
use linkage_report::Report;

/// The four-bar with everything.
fn four_bar(mechanism: FourBar) -> Report {
    let phi = PHI.positions(361);
    Report::new("Crank-rocker", &PHI, &phi)
        .about("A four-bar with a coupler point.")
        .dimensions(&mechanism)
        .table(&mechanism.motion(&phi))
        .table(&mechanism.accuracy(&phi))
        .table(&mechanism.picture(&phi))
}
