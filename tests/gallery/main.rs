//! Reports of real mechanisms: for each an interactive page, a drawing to scale, plots, and all data, and an index page
//! over them. The tests of pages look at what this program writes to `target/gallery`.
//!
//! Each mechanism is compared with known answers as well.

#[path = "../../examples/check/comparison.rs"]
mod check;
#[path = "../programs/digits.rs"]
mod digits;
mod double_wishbone;
mod drawings;
mod eye_needle;
mod favorit;
mod favorit_forces;
mod five_link_axle;
#[path = "../programs/folders.rs"]
mod folders;
mod knitting_machine;
mod mcpherson;
mod reports;
mod spatial_crank_rocker;
mod suspension;
mod two_crank_triad;

use linkage::report::{Index, Report};
use reports::TEMPLATES;
use std::error::Error;
use std::io::Write;
use std::path::Path;
use std::time::Instant;

/// The folder of a report and what makes it.
type Job = (&'static str, fn() -> Result<Report, Box<dyn Error>>);

/// A function that makes a report.
type Make = Box<dyn Fn() -> Result<Report, Box<dyn Error>>>;

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

/// Writes all reports, and the page that leads to them.
fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    let mut index = Index::new("Gallery of mechanisms");
    let jobs = JOBS.map(|(name, make)| (name.to_owned(), Box::new(make) as Make));
    let templates = TEMPLATES.iter().map(|(name, text)| {
        let make = || reports::report(text);
        (format!("template_{name}"), Box::new(make) as Make)
    });
    let count = JOBS.len() + TEMPLATES.len();
    for (number, (name, make)) in (1..).zip(jobs.into_iter().chain(templates)) {
        let start = Instant::now();
        print!("[{number}/{count}] {name}: ");
        std::io::stdout().flush()?;
        let report = make()?;
        let files = report.write(folder.join(&name))?;
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
        index = index.report(&name, &report);
    }
    let page = index.write(folder)?;
    println!("Open {}", page.display());
    Ok(())
}

/// The tests of pages look at what it writes.
#[test]
fn reports_of_all_mechanisms_are_written() -> Result<(), Box<dyn Error>> {
    write(&folders::target("gallery"))
}
