//! `linkage page`: the report of all functions.

mod banner;
mod report;
mod watched;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{SystemTime, UNIX_EPOCH};

use clap::{Args, value_parser};
use linkage_engine::{Mechanism, Source};
use linkage_page::{Missing, with_functions};
use linkage_report::{Index, Report, ReportError};

use super::arguments_given::{refuse_unknown, takes};
use super::choose::{Chosen, mistakes};
use super::output::print;
use super::replaced::refuse_page;
use super::sweep::runs;
use super::values::{Dimensions, parts};
use crate::failure::Failure;
use crate::normal::normal;
use report::{ReportOptions, report};
use watched::{Stamp, follow};

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

/// Writes the page, again and again if the file is watched.
pub(super) fn run(options: &Options) -> Result<(), Failure> {
    let folder = options
        .output
        .clone()
        .unwrap_or_else(|| PathBuf::from(format!("{}_page", options.title())));
    if options.watch {
        return watch(options, &folder);
    }
    write(options, &folder)?;
    match options.open {
        true => open(&folder.join("index.html")),
        false => Ok(()),
    }
}

/// Writes the page after each change of the file. Mistakes are reported, also on the open page.
fn watch(options: &Options, folder: &Path) -> Result<(), Failure> {
    let file = options.chosen.file();
    let stamp = Stamp::of_file(file);
    let mut pages = vec![folder.to_owned()];
    let mut put = || match write(options, folder) {
        Ok(written) => pages = written,
        Err(failure) => {
            eprint!("{failure}");
            if let Err(error) = banner::show(&pages, file, &failure) {
                eprint!("{}", failure_of_report(error));
            }
        }
    };
    if refuse_page(folder, file).is_ok() {
        let waiting = banner::write_waiting_page(folder, &options.title(), milliseconds());
        waiting.map_err(failure_of_report)?;
    }
    put();
    if options.open {
        open(&folder.join("index.html"))?;
    }
    let is_sound = || Source::read(file).is_ok_and(|source| mistakes(&source).is_empty());
    follow(file, stamp, is_sound, put)
}

impl Options {
    /// The name of the file without its ending.
    fn title(&self) -> String {
        let stem = self.chosen.file().file_stem().unwrap_or_default();
        stem.to_string_lossy().into_owned()
    }
}

/// Writes the page, and returns the folders of its parts.
fn write(options: &Options, folder: &Path) -> Result<Vec<PathBuf>, Failure> {
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
        file: options.chosen.file(),
        dimensions: &options.dimensions,
        at: &options.at,
        steps: options.steps,
        version: options.watch.then(milliseconds),
    };
    let reports = all.iter().zip(notes).map(|(mechanism, note)| {
        let report = report(&report_options, mechanism)?;
        Ok::<_, Failure>(note.into_iter().fold(report, Report::note))
    });
    let reports: Vec<Report> = reports.collect::<Result<_, _>>()?;
    let named = all.iter().map(Mechanism::name).zip(reports).collect();
    let written = write_reports(folder, named, &options.title(), report_options.version);
    let folders = written.map_err(failure_of_report)?;
    print(&format!("{}\n", folder.join("index.html").display()))?;
    Ok(folders)
}

/// Writes one report into the folder, or several into folders in it, with a page that leads to
/// them. Returns all folders with a page.
fn write_reports(
    folder: &Path,
    named: Vec<(&str, Report)>,
    title: &str,
    version: Option<u64>,
) -> Result<Vec<PathBuf>, ReportError> {
    let mut folders = vec![folder.to_owned()];
    if let [(_, only)] = &named[..] {
        only.write(folder)?;
        return Ok(folders);
    }
    let mut index = Index::new(title);
    for (name, report) in named {
        let report = report.index(title);
        report.write(folder.join(name))?;
        folders.push(folder.join(name));
        index = index.report(name, &report);
    }
    if let Some(version) = version {
        index = index.version(version);
    }
    index.write(folder)?;
    Ok(folders)
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

/// Gives mechanisms the functions that their pages lack: those for the drawing, and for the
/// unknowns if there are no functions. Returns the note about each.
fn add_functions(source: &Source, all: &mut [Mechanism]) -> Vec<Option<String>> {
    let note = |mechanism: &mut Mechanism| {
        let missing = Missing::in_mechanism(mechanism);
        *mechanism = with_functions(source, mechanism, missing)?;
        if missing != Missing::All {
            return None;
        }
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
