//! `linkage page`: the report of all functions.

mod functionless;
mod report;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, SystemTime, UNIX_EPOCH};

use clap::{Args, value_parser};
use linkage_engine::{Mechanism, Source};
use linkage_report::{Index, Report, ReportError};

use super::arguments_given::{refuse_unknown, takes};
use super::choose::Chosen;
use super::output::print;
use super::replaced::refuse_page;
use super::sweep::runs;
use super::values::{Dimensions, parts};
use crate::failure::Failure;
use crate::normal::normal;
use functionless::with_functions;
use report::{ReportOptions, report};

/// Options of the command.
#[derive(Debug, Args)]
pub(super) struct Options {
    #[command(flatten)]
    chosen: Chosen,
    /// The folder; by default one with the name of the file and `_page`
    #[arg(short, long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// How many positions over the range of the first input
    #[arg(long, default_value_t = 361, value_name = "COUNT", value_parser = value_parser!(u32).range(2..))]
    steps: u32,
    /// Another argument of functions, as `omega=20rad/s`
    #[arg(long = "at", value_name = "NAME=VALUE", value_parser = normal)]
    at: Vec<String>,
    #[command(flatten)]
    dimensions: Dimensions,
    /// Writes the page anew whenever the file changes; the open page follows
    #[arg(long)]
    watch: bool,
    /// Shows the page in the browser
    #[arg(long)]
    open: bool,
}

/// Interval between checks of a watched file.
const LOOK_EVERY: Duration = Duration::from_millis(200);

/// Writes the page, again and again if the file is watched.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let file = options.chosen.file();
    let folder = options.output.clone().unwrap_or_else(|| {
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        PathBuf::from(format!("{stem}_page"))
    });
    let page = folder.join("index.html");
    let mut seen = changed(file);
    let written = write(options, &folder);
    if options.open && written.is_ok() {
        open(&page)?;
    }
    if !options.watch {
        return written;
    }
    let tell = |written: Result<(), Failure>| {
        if let Err(failure) = written {
            eprint!("{failure}");
        }
    };
    tell(written);
    loop {
        sleep(LOOK_EVERY);
        let now = changed(file);
        // A file that an editor is just rewriting is not there for a moment.
        if now.is_some() && now != seen {
            seen = now;
            tell(write(options, &folder));
        }
    }
}

/// When a file was changed last, and how long it is.
fn changed(file: &Path) -> Option<(SystemTime, u64)> {
    let data = fs::metadata(file).ok()?;
    Some((data.modified().ok()?, data.len()))
}

fn write(options: &Options, folder: &Path) -> Result<(), Failure> {
    refuse_page(folder, options.chosen.file())?;
    let source = Source::read(options.chosen.file())?;
    let mut all = moving(options.chosen.all_of(&source)?)?;
    let notes = add_functions(&source, &mut all);
    options.dimensions.known_to_any(&all)?;
    check_arguments(&all, &options.at)?;
    for mechanism in &mut all {
        options.dimensions.known_to(mechanism).tolerate(mechanism)?;
    }
    let report_options = ReportOptions {
        dimensions: &options.dimensions,
        at: &options.at,
        steps: options.steps,
        version: options.watch.then(milliseconds),
    };
    let reports: Vec<Report> = all
        .iter()
        .zip(notes)
        .map(|(mechanism, note)| {
            let report = report(&report_options, mechanism)?;
            Ok::<_, Failure>(note.into_iter().fold(report, Report::note))
        })
        .collect::<Result<_, _>>()?;
    match &reports[..] {
        [only] => {
            only.write(folder).map_err(failure_of_report)?;
        }
        several => {
            let title = options.chosen.file().file_stem().unwrap_or_default();
            let mut index = Index::new(title.to_string_lossy());
            for (report, mechanism) in several.iter().zip(&all) {
                report
                    .write(folder.join(mechanism.name()))
                    .map_err(failure_of_report)?;
                index = index.report(mechanism.name(), report);
            }
            index.write(folder).map_err(failure_of_report)?;
        }
    }
    print(&format!("{}\n", folder.join("index.html").display()))
}

fn failure_of_report(error: ReportError) -> Failure {
    Failure::Told(error.to_string())
}

/// The mechanisms with an input.
fn moving(all: Vec<Mechanism>) -> Result<Vec<Mechanism>, Failure> {
    let (moving, still): (Vec<_>, Vec<_>) = all
        .into_iter()
        .partition(|mechanism| !mechanism.inputs().is_empty());
    let text =
        |mechanism: &Mechanism| format!("{} has no input: nothing of it moves", mechanism.name());
    match (&moving[..], &still[..]) {
        ([], [first, ..]) => Err(Failure::Told(text(first))),
        _ => {
            still
                .iter()
                .for_each(|still| eprintln!("note: {}", text(still)));
            Ok(moving)
        }
    }
}

/// Gives mechanisms without functions those for their unknowns and their drawing; returns the note
/// about each.
fn add_functions(source: &Source, all: &mut [Mechanism]) -> Vec<Option<String>> {
    let note = |mechanism: &mut Mechanism| {
        if !mechanism.headings().is_empty() {
            return None;
        }
        *mechanism = with_functions(source, mechanism)?;
        let note = "there are no functions: the page shows all unknowns";
        eprintln!("note: {}: {note}", mechanism.name());
        Some(note.to_owned())
    };
    all.iter_mut().map(note).collect()
}

/// Fails at the first argument that no function takes, or that runs wherever it is taken.
fn check_arguments(all: &[Mechanism], given: &[String]) -> Result<(), Failure> {
    refuse_unknown(all, given)?;
    for given in given {
        let (name, _) = parts("--at", given)?;
        let mut taking = all.iter().filter(|mechanism| takes(mechanism, name));
        if taking.all(|mechanism| mechanism.inputs()[0].name == name) {
            return Err(runs(name));
        }
    }
    Ok(())
}

/// A number that later versions exceed.
fn milliseconds() -> u64 {
    let since = SystemTime::now().duration_since(UNIX_EPOCH);
    since.map_or(0, |since| since.as_millis() as u64)
}

/// Shows a page by the system's way of opening files.
fn open(page: &Path) -> Result<(), Failure> {
    let mut command = match () {
        () if cfg!(target_os = "macos") => Command::new("open"),
        () if cfg!(windows) => Command::new("explorer"),
        () => Command::new("xdg-open"),
    };
    let started = command
        .arg(page)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn();
    match started {
        Ok(_) => Ok(()),
        Err(error) => Err(Failure::file("show", page, &error)),
    }
}
