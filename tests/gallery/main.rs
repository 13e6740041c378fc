//! Reports of the real mechanisms among the examples: for each an interactive page, a drawing to scale, plots, and all data,
//! and an index page over them.
//!
//! `cargo run --release --example gallery` writes them to `target/gallery`, or to the folder that is given behind `--`.

#[path = "double_wishbone.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    clippy::duplicate_mod,
    reason = "a program of its own, here a module"
)]
mod double_wishbone;
#[cfg(test)]
#[path = "gallery/drawings.rs"]
mod drawings;
#[path = "eye_needle.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    reason = "a program of its own, here a module"
)]
mod eye_needle;
#[path = "favorit.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    clippy::duplicate_mod,
    reason = "a program of its own, here a module"
)]
mod favorit;
#[path = "favorit_forces.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    clippy::duplicate_mod,
    reason = "a program of its own, here a module"
)]
mod favorit_forces;
#[path = "five_link_axle.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    clippy::duplicate_mod,
    reason = "a program of its own, here a module"
)]
mod five_link_axle;
#[path = "knitting_machine.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    clippy::duplicate_mod,
    reason = "a program of its own, here a module"
)]
mod knitting_machine;
#[path = "mcpherson.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    clippy::duplicate_mod,
    reason = "a program of its own, here a module"
)]
mod mcpherson;
#[path = "gallery/reports.rs"]
mod reports;
#[path = "spatial_crank_rocker.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    clippy::duplicate_mod,
    reason = "a program of its own, here a module"
)]
mod spatial_crank_rocker;
#[path = "two_crank_triad.rs"]
#[allow(
    dead_code,
    unreachable_pub,
    clippy::duplicate_mod,
    reason = "a program of its own, here a module"
)]
mod two_crank_triad;

use linkage::report::{Index, Report};
use std::error::Error;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The folder of a report and what makes it.
type Job = (&'static str, fn() -> Result<Report, Box<dyn Error>>);

const JOBS: [Job; 9] = [
    ("favorit", reports::favorit),
    ("eye_needle", reports::eye_needle),
    ("two_crank_triad", reports::two_crank_triad),
    ("spatial_crank_rocker", reports::spatial_crank_rocker),
    ("five_link_axle", five_link_axle::report),
    ("double_wishbone", double_wishbone::report),
    ("mcpherson", mcpherson::report),
    ("knitting_machine", knitting_machine::report),
    ("beyond_reach", reports::beyond_reach),
];

/// Where reports are written if no folder is given.
const FOLDER: &str = "target/gallery";

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1);
    write(&folder.map_or_else(|| PathBuf::from(FOLDER), PathBuf::from))
}

/// Writes all reports, and the page that leads to them.
fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let mut index = Index::new("Gallery of mechanisms");
    for (number, (name, make)) in (1..).zip(JOBS) {
        let start = Instant::now();
        print!("[{number}/{}] {name}: ", JOBS.len());
        std::io::stdout().flush()?;
        let report = make()?;
        let files = report.write(folder.join(name))?;
        let size: u64 = files
            .iter()
            .filter_map(|file| file.metadata().ok())
            .map(|data| data.len())
            .sum();
        println!(
            "{} files, {:.1} MB, {:.2} s",
            files.len(),
            size as f64 * 1e-6,
            start.elapsed().as_secs_f64()
        );
        index = index.report(name, &report);
    }
    let page = index.write(folder)?;
    println!("Open {}", page.display());
    Ok(())
}

/// The tests of pages look at what it writes.
#[test]
fn reports_of_all_mechanisms_are_written() -> Result<(), Box<dyn Error>> {
    write(Path::new(FOLDER))
}
